#include "scene.h"

#include "scene-builder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const layer_names[N_LAYERS] = {
  "hull",   "paraboloid", "delaunay", "voronoi", "circumcircles", "lifts",
  "labels", "furthest",   "tangents", "why",     "preview",
};

static const char *const focus_names[] = {
  [FOCUS_ACTIVE] = "active",   [FOCUS_NONE] = "none",
  [FOCUS_VISIBLE] = "visible", [FOCUS_HORIZON] = "horizon",
  [FOCUS_CONE] = "cone",
};

#define N_FOCUS_NAMES (sizeof focus_names / sizeof focus_names[0])

const char *
layer_name (Layer layer)
{
  int i = 0;

  while (i < N_LAYERS - 1 && 1U << i != (unsigned)layer)
    i++;
  return layer_names[i];
}

bool
layer_parse (const char *name, Layer *layer)
{
  int i;

  for (i = 0; i < N_LAYERS; i++) {
    if (strcmp (name, layer_names[i]) != 0)
      continue;
    *layer = (Layer)(1U << i);
    return true;
  }
  return false;
}

const char *
focus_name (Focus focus)
{
  return focus_names[focus];
}

bool
focus_parse (const char *name, Focus *focus)
{
  size_t i;

  for (i = 0; i < N_FOCUS_NAMES; i++) {
    if (strcmp (name, focus_names[i]) != 0)
      continue;
    *focus = (Focus)i;
    return true;
  }
  return false;
}

void
scene_look_init (SceneLook *look, const Frame *frame)
{
  *look = (SceneLook){ .layers = LAYERS_DEFAULT,
                       .focus = FOCUS_ACTIVE,
                       .extent = site_set_extent (frame->trace->set),
                       .raise = RAISE_DEFAULT,
                       .lift = 1,
                       .low = { -1, -1, 0 },
                       .high = { 1, 1, 0 } };
}

void
scene_look_fit (SceneLook *look, const Projection *projection, double inset_px)
{
  const double right = fmax (projection->width - inset_px, inset_px);
  const double bottom = fmax (projection->height - inset_px, inset_px);

  look->low = projection_unapply (projection, inset_px, bottom);
  look->high = projection_unapply (projection, right, inset_px);
}

Point3
scene_point (const SceneLook *look, const Site *site, bool lifted)
{
  const double u = (site->x - look->extent.centre.x) / look->extent.radius;
  const double v = (site->y - look->extent.centre.y) / look->extent.radius;

  return (Point3){ u, v,
                   lifted ? look->lift * (look->raise + u * u + v * v) : 0 };
}

Site
scene_site (const SceneLook *look, Point3 point)
{
  return (Site){ look->extent.centre.x + look->extent.radius * point.x,
                 look->extent.centre.y + look->extent.radius * point.y };
}

void
scene_clear (Scene *scene)
{
  free (scene->items);
  free (scene->points);
  free (scene->labels);
  free (scene->lit);
  scene_index_clear (&scene->index);
  memset (scene, 0, sizeof *scene);
}
