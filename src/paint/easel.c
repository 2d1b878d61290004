#include "easel.h"

#include "memory.h"
#include "raster.h"

#include <stdlib.h>

struct Easel {
  Names *names;
  Drawing *drawing; /* of the picture */
  Drawing *other;   /* room for the next one */
  Raster *raster;   /* NULL before the first picture */
  Theme theme;
  Projection projection;
  double scale;
};

Easel *
easel_new (void)
{
  Easel *easel = memory_new (1, sizeof *easel);

  easel->names = names_new ();
  easel->drawing = drawing_new (easel->names);
  easel->other = drawing_new (easel->names);
  return easel;
}

void
easel_free (Easel *easel)
{
  if (easel == NULL)
    return;
  drawing_free (easel->drawing);
  drawing_free (easel->other);
  names_free (easel->names);
  raster_free (easel->raster);
  free (easel);
}

cairo_surface_t *
easel_get_surface (Easel *easel)
{
  return easel->raster == NULL ? NULL : raster_get_surface (easel->raster);
}

/* Whether the picture is seen from the same place, and its ground is as it
 * will be; else all of it has changed. */
static bool
is_same_sheet (const Easel *easel,
               const Projection *projection,
               const Theme *theme,
               double scale)
{
  return easel->raster != NULL && easel->scale == scale
         && projection_equal (&easel->projection, projection)
         && theme_equal (&easel->theme, theme);
}

static void
swap_drawings (Easel *easel)
{
  Drawing *drawing = easel->drawing;

  easel->drawing = easel->other;
  easel->other = drawing;
}

static bool
is_same_size (const Easel *easel, double scale)
{
  return easel->raster != NULL && easel->scale == scale
         && easel->drawing->width == easel->other->width
         && easel->drawing->height == easel->other->height;
}

static cairo_region_t *
paint_all (Easel *easel, double scale)
{
  cairo_surface_t *surface;
  cairo_rectangle_int_t whole = { 0 };

  if (!is_same_size (easel, scale)) {
    raster_free (easel->raster);
    easel->raster
        = raster_new (easel->drawing->width, easel->drawing->height, scale);
    easel->scale = scale;
  }
  raster_paint (easel->raster, easel->drawing, NULL);
  surface = raster_get_surface (easel->raster);
  whole.width = cairo_image_surface_get_width (surface);
  whole.height = cairo_image_surface_get_height (surface);
  return cairo_region_create_rectangle (&whole);
}

cairo_region_t *
easel_paint (Easel *easel,
             const Scene *scene,
             const Projection *projection,
             const Theme *theme,
             double scale)
{
  const bool is_same = is_same_sheet (easel, projection, theme, scale);
  cairo_region_t *region;

  easel->theme = *theme;
  easel->projection = *projection;
  swap_drawings (easel);
  drawing_set (easel->drawing, scene, projection, &easel->theme);
  if (!is_same || easel->drawing->edition != easel->other->edition)
    return paint_all (easel, scale);
  region = drawing_compare (easel->other, easel->drawing, scale);
  raster_paint (easel->raster, easel->drawing, region);
  return region;
}
