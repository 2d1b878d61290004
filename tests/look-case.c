#include "look-case.h"

#include <stdlib.h>
#include <string.h>

const LookCase look_cases[] = {
  { .name = "lecture8-start", .sites = "lecture8" },
  { .name = "lecture8-choose",
    .sites = "lecture8",
    .place = { 1, PHASE_CHOOSE } },
  { .name = "lecture8-see", .sites = "lecture8", .place = { 4, PHASE_SEE } },
  { .name = "lecture8-horizon",
    .sites = "lecture8",
    .place = { 3, PHASE_HORIZON } },
  { .name = "lecture8-cone", .sites = "lecture8", .place = { 4, PHASE_CONE } },
  { .name = "lecture8-hand-over",
    .sites = "lecture8",
    .place = { 4, PHASE_HAND_OVER } },
  { .name = "lecture8-selected",
    .sites = "lecture8",
    .place = { 0, PHASE_COMPLETE },
    .layers = LAYER_CIRCLES,
    .selection = { OBJECT_FACET, 17 } },
  { .name = "mixed8-see-upper", .sites = "mixed8", .place = { 2, PHASE_SEE } },
  { .name = "mixed8-cone-both", .sites = "mixed8", .place = { 4, PHASE_CONE } },
  { .name = "grid9-end",
    .sites = "grid9",
    .place = { 0, PHASE_COMPLETE },
    .selection = { OBJECT_SITE, 4 } },
  { .name = "square4-end", .sites = "square4", .place = { 0, PHASE_COMPLETE } },
#define THEME_CASES(prefix, kind)                                              \
  { .name = prefix "-see",                                                     \
    .sites = "lecture8",                                                       \
    .place = { 4, PHASE_SEE },                                                 \
    .theme = (kind) },                                                         \
      { .name = prefix "-selected",                                            \
        .sites = "lecture8",                                                   \
        .place = { 0, PHASE_COMPLETE },                                        \
        .layers = LAYER_CIRCLES,                                               \
        .selection = { OBJECT_FACET, 17 },                                     \
        .theme = (kind) },                                                     \
  {                                                                            \
    .name = prefix "-cone", .sites = "mixed8", .place = { 4, PHASE_CONE },     \
    .theme = (kind)                                                            \
  }
  THEME_CASES ("paper", THEME_PAPER),
  THEME_CASES ("projector", THEME_PROJECTOR),
  THEME_CASES ("dark", THEME_DARK),
  THEME_CASES ("print", THEME_PRINT),
  THEME_CASES ("contrast", THEME_CONTRAST),
  { .name = "furthest8-furthest",
    .sites = "furthest8",
    .place = { 0, PHASE_COMPLETE },
    .layers = LAYER_FURTHEST,
    .hidden = LAYER_VORONOI | LAYER_DELAUNAY },
  { .name = "lecture8-tangents",
    .sites = "lecture8",
    .place = { 0, PHASE_COMPLETE },
    .layers = LAYER_TANGENTS,
    .hidden = LAYER_VORONOI | LAYER_HULL },
  { .name = "lecture8-why",
    .sites = "lecture8",
    .place = { 0, PHASE_COMPLETE },
    .layers = LAYER_WHY,
    .selection = { OBJECT_FACET, 17 },
    .measured = { OBJECT_SITE, 4 } },
  { .name = "mixed8-why-in-round",
    .sites = "mixed8",
    .place = { 3, PHASE_SEE },
    .layers = LAYER_WHY,
    .selection = { OBJECT_FACET, 7 } },
  { .name = "mixed8-half-lifted",
    .sites = "mixed8",
    .place = { 0, PHASE_COMPLETE },
    .unlift = 0.6 },
  { .name = "lecture8-preview",
    .sites = "lecture8",
    .place = { 0, PHASE_COMPLETE },
    .has_preview = true,
    .preview = { -0.25, -0.125 } },
  { .name = "lecture8-look-up",
    .sites = "lecture8",
    .place = { 0, PHASE_COMPLETE },
    .camera = CAMERA_LOOK_UP },
  { .name = "cross5-horizon",
    .sites = "cross5",
    .place = { 1, PHASE_HORIZON } },
  { .name = "wheel8-see", .sites = "wheel8", .place = { 4, PHASE_SEE } },
  { .name = "vertical5-see", .sites = "vertical5", .place = { 1, PHASE_SEE } },
  { .name = "tie6-end", .sites = "tie6", .place = { 0, PHASE_COMPLETE } },
  { .name = "line4-end", .sites = "line4", .place = { 0, PHASE_COMPLETE } },
};

const guint look_n_cases = G_N_ELEMENTS (look_cases);

/* As picture_paint() puts a view together. */
#define FRAME_INSET 6.0

void
look_scene_init (LookScene *look, const LookCase *what, PictureView view)
{
  Picture picture;
  uint32_t step;

  *look = (LookScene){ .theme = theme_get (what->theme) };
  look->fixture = fixture_load (what->sites, ORDER_FURTHEST);
  g_assert_true (
      timeline_find (look->fixture->trace, what->place, false, &step));
  frame_init (&look->frame, look->fixture->trace, step);
  picture_init (&picture, view, &look->frame);
  picture.look.layers |= what->layers;
  picture.look.layers &= ~what->hidden;
  picture.look.selection = what->selection;
  picture.look.measured = what->measured;
  picture.look.lift = 1 - what->unlift;
  picture.look.has_preview = what->has_preview;
  picture.look.preview = what->preview;
  camera_init (&picture.camera, what->camera);
  if (view == PICTURE_PLANE) {
    look->projection
        = plane_camera_projection (&picture.plane_camera, LOOK_SIDE, LOOK_SIDE);
    scene_look_fit (&picture.look, &look->projection, FRAME_INSET);
    scene_plane (&look->scene, &look->frame, &picture.look);
  } else {
    look->projection
        = camera_projection (&picture.camera, LOOK_SIDE, LOOK_SIDE);
    scene_space (&look->scene, &look->frame, &picture.look);
  }
}

void
look_scene_clear (LookScene *look)
{
  scene_clear (&look->scene);
  frame_clear (&look->frame);
  fixture_free (look->fixture);
}

cairo_surface_t *
look_paint (const LookCase *what, PictureView view)
{
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);
  cairo_t *cr = cairo_create (surface);
  LookScene look;

  look_scene_init (&look, what, view);
  painter_paint (cr, &look.scene, &look.projection, look.theme, 0);
  look_scene_clear (&look);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

static unsigned char *
row_of (cairo_surface_t *surface, int y)
{
  return cairo_image_surface_get_data (surface)
         + (gsize)y * (gsize)cairo_image_surface_get_stride (surface);
}

/* Whether a channel of @a at @x, @y is none of those nearby in @b. */
static gboolean
is_strange (cairo_surface_t *a, cairo_surface_t *b, const int at[3], int reach)
{
  const int width = cairo_image_surface_get_width (a);
  const int height = cairo_image_surface_get_height (a);
  const int value = row_of (a, at[1])[4 * at[0] + at[2]];
  int low = 255, high = 0, x, y;

  if (abs (value - row_of (b, at[1])[4 * at[0] + at[2]]) <= LOOK_CHANNEL)
    return FALSE;
  for (y = MAX (at[1] - reach, 0); y <= MIN (at[1] + reach, height - 1); y++)
    for (x = MAX (at[0] - reach, 0); x <= MIN (at[0] + reach, width - 1); x++) {
      low = MIN (low, row_of (b, y)[4 * x + at[2]]);
      high = MAX (high, row_of (b, y)[4 * x + at[2]]);
    }
  return value < low - LOOK_CHANNEL || value > high + LOOK_CHANNEL;
}

static gboolean
pixel_differs (cairo_surface_t *out,
               cairo_surface_t *ref,
               const int at[2],
               int reach)
{
  int k;

  if (memcmp (row_of (out, at[1]) + 4 * at[0], row_of (ref, at[1]) + 4 * at[0],
              3)
      == 0)
    return FALSE;
  for (k = 0; k < 3; k++) {
    const int channel[3] = { at[0], at[1], k };

    if (is_strange (out, ref, channel, reach)
        || is_strange (ref, out, channel, reach))
      return TRUE;
  }
  return FALSE;
}

guint
look_compare (cairo_surface_t *out,
              cairo_surface_t *ref,
              int reach,
              cairo_surface_t *diff)
{
  const int width = cairo_image_surface_get_width (out);
  const int height = cairo_image_surface_get_height (out);
  guint n = 0;
  int x, y, k;

  g_assert_cmpint (cairo_image_surface_get_width (ref), ==, width);
  g_assert_cmpint (cairo_image_surface_get_height (ref), ==, height);
  cairo_surface_flush (diff);
  for (y = 0; y < height; y++)
    for (x = 0; x < width; x++) {
      const gboolean differs
          = pixel_differs (out, ref, (const int[2]){ x, y }, reach);

      n += differs;
      for (k = 0; k < 3; k++)
        row_of (diff, y)[4 * x + k]
            = differs ? 0
                      : (unsigned char)(192 + row_of (out, y)[4 * x + k] / 4);
    }
  cairo_surface_mark_dirty (diff);
  return n;
}

void
look_check (const char *name,
            cairo_surface_t *out,
            cairo_surface_t *ref,
            LookRule rule)
{
  const int width = cairo_image_surface_get_width (out);
  const int height = cairo_image_surface_get_height (out);
  cairo_surface_t *diff
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height);
  const guint n = look_compare (out, ref, rule.reach, diff);
  const guint n_allowed = (guint)(width * height) * rule.per_thousand / 1000;

  g_test_message ("%s: %u pixels differ, %u may", name, n, n_allowed);
  if (n > n_allowed) {
    g_autofree char *out_name = g_strconcat (name, "-out.png", NULL);
    g_autofree char *diff_name = g_strconcat (name, "-diff.png", NULL);

    cairo_surface_write_to_png (out, out_name);
    cairo_surface_write_to_png (diff, diff_name);
    g_error ("%s: %u pixels differ, %u may; see %s", name, n, n_allowed,
             diff_name);
  }
  cairo_surface_destroy (diff);
}

static char *
name_of (const LookCase *what, PictureView view)
{
  return g_strconcat (what->name, view == PICTURE_PLANE ? "-plane" : "-space",
                      NULL);
}

char *
look_path (const LookCase *what, PictureView view)
{
  g_autofree char *name = name_of (what, view);

  return fixture_path ("images", name, "-ref.png");
}

void
look_check_case (const LookCase *what,
                 PictureView view,
                 const char *by,
                 cairo_surface_t *out,
                 LookRule rule)
{
  g_autofree char *path = look_path (what, view);
  g_autofree char *name = name_of (what, view);
  g_autofree char *title = g_strconcat (name, by, NULL);
  cairo_surface_t *ref = cairo_image_surface_create_from_png (path);

  if (cairo_surface_status (ref) != CAIRO_STATUS_SUCCESS)
    g_error ("%s cannot be read", path);
  look_check (title, out, ref, rule);
  cairo_surface_destroy (ref);
}
