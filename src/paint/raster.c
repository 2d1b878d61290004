#include "raster.h"

#include "memory.h"
#include "raster-private.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

/* Two hands paint bands of the picture at the same time. */
#define N_HANDS 2
#define N_BANDS 6
#define MANY_PIXELS 60000 /* from so many on, … */
#define MANY_STROKES 600 /* … or with so many strokes there is work for two */

/* So few strokes are not chosen before they are painted square by square. */
#define FEW_STROKES 4000

struct Raster {
  cairo_surface_t *surface;
  Hand hands[N_HANDS];
};

Raster *
raster_new (double width, double height, double scale)
{
  Raster *raster = memory_new (1, sizeof *raster);
  const int columns = (int)ceil (width * scale);
  const int rows = (int)ceil (height * scale);
  int i;

  raster->surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, columns, rows);
  cairo_surface_set_device_scale (raster->surface, scale, scale);
  for (i = 0; i < N_HANDS; i++) {
    Hand *hand = &raster->hands[i];

    hand->scale = scale;
    hand->pixels
        = (uint32_t *)(void *)cairo_image_surface_get_data (raster->surface);
    hand->stride = cairo_image_surface_get_stride (raster->surface) / 4;
    coverage_init (&hand->coverage, columns, rows);
  }
  return raster;
}

void
raster_free (Raster *raster)
{
  int i;

  if (raster == NULL)
    return;
  cairo_surface_destroy (raster->surface);
  for (i = 0; i < N_HANDS; i++) {
    coverage_clear (&raster->hands[i].coverage);
    free (raster->hands[i].scaled);
  }
  free (raster);
}

cairo_surface_t *
raster_get_surface (Raster *raster)
{
  return raster->surface;
}

static void
paint_mask (Hand *hand,
            const NameMask *mask,
            const int at[2],
            const unsigned char *coverage,
            uint32_t colour)
{
  const PixelClip *clip = &hand->coverage.clip;
  int row, column;

  for (row = 0; row < mask->height; row++) {
    const unsigned char *parts = coverage + row * mask->stride;
    const int y = at[1] + mask->y + row;

    if (y < clip->top || y >= clip->bottom)
      continue;
    for (column = 0; column < mask->width; column++) {
      const int x = at[0] + mask->x + column;
      uint32_t *pixel;

      if (parts[column] == 0 || x < clip->left || x >= clip->right)
        continue;
      pixel = &hand->pixels[(size_t)y * (size_t)hand->stride + (size_t)x];
      *pixel = pixel_over (
          *pixel,
          pixel_scale (colour, parts[column] + (uint32_t)(parts[column] >> 7)));
    }
  }
}

static void
paint_name (Hand *hand, const Drawing *drawing, const PlacedName *placed)
{
  const NameMask *mask = names_mask (drawing->names, placed->name, hand->scale);
  const int at[2] = { (int)lround (placed->at.x * hand->scale),
                      (int)lround (placed->at.y * hand->scale) };

  paint_mask (hand, mask, at, mask->casing,
              hand_pixel (drawing->theme->background));
  paint_mask (hand, mask, at, mask->letters, hand_pixel (placed->colour));
}

static void
paint_background (Hand *hand)
{
  const PixelClip *clip = &hand->coverage.clip;
  const uint32_t pixel = hand_pixel (hand->theme->background);
  int row, column;

  for (row = clip->top; row < clip->bottom; row++)
    for (column = clip->left; column < clip->right; column++)
      hand->pixels[(size_t)row * (size_t)hand->stride + (size_t)column] = pixel;
}

/* A picture to paint, band by band. */
typedef struct Work {
  const Drawing *drawing;
  const uint32_t *strokes; /* n_strokes numbers; NULL: all from the first */
  uint32_t n_strokes;
  const PixelClip *clips;
  int n_clips, next;
} Work;

/* Paints what lies within the clip. */
static void
paint_clip (Hand *hand, const Work *work)
{
  const PixelClip *clip = &hand->coverage.clip;
  const Drawing *drawing = work->drawing;
  const double scale = hand->scale;
  const PixelBox box
      = { (float)(clip->left / scale), (float)(clip->top / scale),
          (float)(clip->right / scale), (float)(clip->bottom / scale) };
  uint32_t i;

  paint_background (hand);
  for (i = 0; i < work->n_strokes; i++) {
    const uint32_t number = work->strokes == NULL ? i : work->strokes[i];
    const Stroke *stroke = &drawing->strokes[number];

    if (stroke_meets (drawing, stroke, &box))
      hand_paint_stroke (hand, drawing, stroke);
  }
  for (i = 0; i < drawing->n_placed; i++)
    if (boxes_meet (&drawing->placed[i].box, &box))
      paint_name (hand, drawing, &drawing->placed[i]);
}

typedef struct Worker {
  Work *work;
  Hand *hand;
} Worker;

static gpointer
work_on (gpointer data)
{
  const Worker *worker = data;
  Work *work = worker->work;
  int i;

  worker->hand->theme = work->drawing->theme;
  while ((i = g_atomic_int_add (&work->next, 1)) < work->n_clips) {
    worker->hand->coverage.clip = work->clips[i];
    paint_clip (worker->hand, work);
  }
  return NULL;
}

/* Masks are made when they are first asked for: by one hand only. */
static void
make_masks (Raster *raster, const Drawing *drawing)
{
  uint32_t i;

  for (i = 0; i < drawing->n_placed; i++)
    names_mask (drawing->names, drawing->placed[i].name,
                raster->hands[0].scale);
}

static void
paint_clips (Raster *raster, Work *work, bool is_large)
{
  Worker workers[N_HANDS];
  GThread *thread = NULL;
  int i;

  for (i = 0; i < N_HANDS; i++)
    workers[i] = (Worker){ work, &raster->hands[i] };
  if (is_large)
    thread = g_thread_try_new ("raster", work_on, &workers[1], NULL);
  work_on (&workers[0]);
  if (thread != NULL)
    g_thread_join (thread);
}

static void
paint_all (Raster *raster, const Drawing *drawing)
{
  const int width = raster->hands[0].coverage.width;
  const int height = raster->hands[0].coverage.height;
  PixelClip bands[N_BANDS];
  Work work = { drawing, NULL, drawing->n_strokes, bands, N_BANDS, 0 };
  int i;

  for (i = 0; i < N_BANDS; i++)
    bands[i] = (PixelClip){ 0, height * i / N_BANDS, width,
                            height * (i + 1) / N_BANDS };
  paint_clips (raster, &work, width * height > MANY_PIXELS);
}

/* Returns: the numbers of the strokes that meet any square; free with free();
 *          NULL: all of them may. */
static uint32_t *
strokes_in (const Drawing *drawing, const Squares *squares, uint32_t *n)
{
  const PixelBox all = squares_extents (squares);
  uint32_t *strokes;
  uint32_t i;

  *n = drawing->n_strokes;
  if (drawing->n_strokes <= FEW_STROKES)
    return NULL;
  strokes = memory_new (drawing->n_strokes, sizeof *strokes);
  *n = 0;
  for (i = 0; i < drawing->n_strokes; i++)
    if (boxes_meet (&drawing->strokes[i].box, &all)
        && squares_meet (squares, &drawing->strokes[i].box))
      strokes[(*n)++] = i;
  return strokes;
}

/* Cuts clips in two, so that both hands have as much to do.
 *
 * Returns: the clips, 2 · n of them. */
static PixelClip *
halve_clips (PixelClip *clips, int n)
{
  PixelClip *halves = g_new (PixelClip, 2 * MAX (n, 1));
  int i;

  for (i = 0; i < n; i++) {
    const int middle = (clips[i].top + clips[i].bottom) / 2;

    halves[2 * i] = halves[2 * i + 1] = clips[i];
    halves[2 * i].bottom = halves[2 * i + 1].top = middle;
  }
  g_free (clips);
  return halves;
}

static PixelClip
clip_of (const Raster *raster, const cairo_region_t *region, int i)
{
  const int width = raster->hands[0].coverage.width;
  const int height = raster->hands[0].coverage.height;
  cairo_rectangle_int_t part;

  cairo_region_get_rectangle (region, i, &part);
  return (PixelClip){ MAX (part.x, 0), MAX (part.y, 0),
                      MIN (part.x + part.width, width),
                      MIN (part.y + part.height, height) };
}

static void
paint_squares (Raster *raster, const Drawing *drawing, const Squares *squares)
{
  cairo_region_t *region = squares_region (squares);
  const int n = cairo_region_num_rectangles (region);
  PixelClip *clips = g_new (PixelClip, MAX (n, 1));
  uint32_t n_strokes;
  uint32_t *strokes = strokes_in (drawing, squares, &n_strokes);
  Work work = { drawing, strokes, n_strokes, clips, n, 0 };
  int i, n_pixels = 0;
  bool is_large;

  for (i = 0; i < n; i++) {
    clips[i] = clip_of (raster, region, i);
    n_pixels
        += (clips[i].right - clips[i].left) * (clips[i].bottom - clips[i].top);
  }
  is_large = n_pixels > MANY_PIXELS || n_strokes > MANY_STROKES;
  if (is_large) {
    work.clips = clips = halve_clips (clips, n);
    work.n_clips = 2 * n;
  }
  paint_clips (raster, &work, is_large);
  cairo_region_destroy (region);
  free (strokes);
  g_free (clips);
}

void
raster_paint (Raster *raster, const Drawing *drawing, const Squares *squares)
{
  cairo_surface_flush (raster->surface);
  make_masks (raster, drawing);
  if (squares == NULL)
    paint_all (raster, drawing);
  else
    paint_squares (raster, drawing, squares);
  cairo_surface_mark_dirty (raster->surface);
}
