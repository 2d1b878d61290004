#include "gl-atlas.h"

#include "memory.h"

#include <epoxy/gl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIZE_FIRST 512

/* Where a name is in the texture; width 0: nowhere. */
typedef struct Slot {
  int x, y, width, height;
} Slot;

struct GlAtlas {
  unsigned texture;
  int size, size_most;
  int x, y, row_height; /* the place of the next name */
  Slot *slots;          /* per name */
  uint32_t n_slots;
  const Names *names; /* whose names these are, in which edition and scale */
  uint32_t edition;
  double scale;
  unsigned char *both; /* room for one name, two bytes a pixel */
  uint32_t both_room;
};

static void
set_parameters (void)
{
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri (GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/* Begins an empty texture of @size pixels squared. */
static void
empty (GlAtlas *atlas, int size)
{
  glBindTexture (GL_TEXTURE_2D, atlas->texture);
  if (size != atlas->size)
    glTexImage2D (GL_TEXTURE_2D, 0, GL_RG8, size, size, 0, GL_RG,
                  GL_UNSIGNED_BYTE, NULL);
  atlas->size = size;
  atlas->x = atlas->y = atlas->row_height = 0;
  if (atlas->n_slots > 0)
    memset (atlas->slots, 0, atlas->n_slots * sizeof *atlas->slots);
}

GlAtlas *
gl_atlas_new (void)
{
  GlAtlas *atlas = memory_new (1, sizeof *atlas);

  glGenTextures (1, &atlas->texture);
  glBindTexture (GL_TEXTURE_2D, atlas->texture);
  set_parameters ();
  glGetIntegerv (GL_MAX_TEXTURE_SIZE, &atlas->size_most);
  empty (atlas, SIZE_FIRST);
  return atlas;
}

void
gl_atlas_free (GlAtlas *atlas)
{
  if (atlas == NULL)
    return;
  glDeleteTextures (1, &atlas->texture);
  free (atlas->slots);
  free (atlas->both);
  free (atlas);
}

unsigned
gl_atlas_get_texture (const GlAtlas *atlas)
{
  return atlas->texture;
}

/* Finds a place, in rows from the top. */
static bool
find_place (GlAtlas *atlas, const NameMask *mask, Slot *slot)
{
  if (atlas->x + mask->width > atlas->size) {
    atlas->x = 0;
    atlas->y += atlas->row_height;
    atlas->row_height = 0;
  }
  if (mask->width > atlas->size || atlas->y + mask->height > atlas->size)
    return false;
  *slot = (Slot){ atlas->x, atlas->y, mask->width, mask->height };
  atlas->x += mask->width;
  if (mask->height > atlas->row_height)
    atlas->row_height = mask->height;
  return true;
}

static void
upload (GlAtlas *atlas, const NameMask *mask, const Slot *slot)
{
  const uint32_t n_bytes = 2 * (uint32_t)mask->width * (uint32_t)mask->height;
  unsigned char *to;
  int row, column;

  if (n_bytes > atlas->both_room)
    atlas->both = memory_grow (atlas->both, &atlas->both_room, n_bytes, 1);
  to = atlas->both;
  for (row = 0; row < mask->height; row++)
    for (column = 0; column < mask->width; column++) {
      *to++ = mask->casing[row * mask->stride + column];
      *to++ = mask->letters[row * mask->stride + column];
    }
  glPixelStorei (GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D (GL_TEXTURE_2D, 0, slot->x, slot->y, slot->width,
                   slot->height, GL_RG, GL_UNSIGNED_BYTE, atlas->both);
  glPixelStorei (GL_UNPACK_ALIGNMENT, 4);
}

static Slot *
get_slot (GlAtlas *atlas, uint32_t name)
{
  const uint32_t n_slots = atlas->n_slots;

  if (name >= n_slots) {
    atlas->slots = memory_grow (atlas->slots, &atlas->n_slots, name + 1,
                                sizeof *atlas->slots);
    memset (atlas->slots + n_slots, 0,
            (atlas->n_slots - n_slots) * sizeof *atlas->slots);
  }
  return &atlas->slots[name];
}

/* Returns: false when there was no room for one of them. */
static bool
put_names (GlAtlas *atlas, const Drawing *drawing, double scale)
{
  uint32_t i;

  for (i = 0; i < drawing->n_placed; i++) {
    const uint32_t name = drawing->placed[i].name;
    Slot *slot = get_slot (atlas, name);
    const NameMask *mask;

    if (slot->width > 0)
      continue;
    mask = names_mask (drawing->names, name, scale);
    if (!find_place (atlas, mask, slot))
      return false;
    upload (atlas, mask, slot);
  }
  return true;
}

/* Names that are not shown any more go when there is no room; if that does
 * not help, the texture grows. */
static void
make_ready (GlAtlas *atlas, const Drawing *drawing, double scale)
{
  glBindTexture (GL_TEXTURE_2D, atlas->texture);
  if (atlas->names != drawing->names || atlas->edition != drawing->edition
      || atlas->scale != scale)
    empty (atlas, atlas->size);
  atlas->names = drawing->names;
  atlas->edition = drawing->edition;
  atlas->scale = scale;
  if (put_names (atlas, drawing, scale))
    return;
  empty (atlas, atlas->size);
  while (!put_names (atlas, drawing, scale)
         && 2 * atlas->size <= atlas->size_most)
    empty (atlas, 2 * atlas->size);
}

static void
add_name (const GlAtlas *atlas,
          GlBatch *batch,
          const PlacedName *placed,
          const NameMask *mask)
{
  static const int corners[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const Slot *slot = &atlas->slots[placed->name];
  const GlInk ink = { .colour = placed->colour, .kind = GL_KIND_NAME };
  const long left = lround (placed->at.x * batch->scale) + mask->x;
  const long top = lround (placed->at.y * batch->scale) + mask->y;
  int i;

  for (i = 0; i < 4; i++) {
    const int x = corners[i][0] * slot->width;
    const int y = corners[i][1] * slot->height;
    const float local[3] = { (float)(slot->x + x) / (float)atlas->size,
                             (float)(slot->y + y) / (float)atlas->size, 0 };

    gl_batch_add (batch, &ink, (Pixel){ (double)(left + x), (double)(top + y) },
                  local);
  }
  gl_batch_join (batch, 4);
}

void
gl_atlas_add_names (GlAtlas *atlas, GlBatch *batch, const Drawing *drawing)
{
  uint32_t i;

  if (drawing->n_placed == 0)
    return;
  make_ready (atlas, drawing, batch->scale);
  for (i = 0; i < drawing->n_placed; i++) {
    const PlacedName *placed = &drawing->placed[i];

    if (atlas->slots[placed->name].width > 0)
      add_name (atlas, batch, placed,
                names_mask (drawing->names, placed->name, batch->scale));
  }
}
