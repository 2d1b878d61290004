/* Names of sites; names of facets: of that which the sentence of the step
 * speaks of, and of that which is selected. */
#include "scene-builder.h"

#include <stddef.h>

/* Of the longest side: nearer to its middle than this a corner takes the room
 * of the name. */
#define CORNER_NEAR 0.15

static Point3
weighted (const Point3 corners[3], const double weights[3])
{
  Point3 sum = { 0, 0, 0 };
  int k;

  for (k = 0; k < 3; k++) {
    sum.x += weights[k] * corners[k].x;
    sum.y += weights[k] * corners[k].y;
    sum.z += weights[k] * corners[k].z;
  }
  return sum;
}

static double
square_between (Point3 a, Point3 b)
{
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)
         + (a.z - b.z) * (a.z - b.z);
}

/* The corner opposite to the longest side. */
static int
bluntest (const Point3 corners[3], double *longest)
{
  int blunt = 0, k;

  *longest = 0;
  for (k = 0; k < 3; k++) {
    const double side
        = square_between (corners[(k + 1) % 3], corners[(k + 2) % 3]);

    if (side > *longest) {
      *longest = side;
      blunt = k;
    }
  }
  return blunt;
}

Point3
scene_name_point (const SceneBuilder *builder, uint32_t facet, bool lifted)
{
  const uint32_t *site = scene_facet_sites (builder, facet);
  double weights[3] = { 1.0 / 3, 1.0 / 3, 1.0 / 3 }, longest;
  Point3 corners[3], middle;
  int blunt, k;

  for (k = 0; k < 3; k++)
    corners[k] = scene_at (builder, site[k], lifted);
  middle = weighted (corners, weights);
  blunt = bluntest (corners, &longest);
  if (square_between (middle, corners[blunt])
      >= CORNER_NEAR * CORNER_NEAR * longest)
    return middle;
  for (k = 0; k < 3; k++)
    weights[k] = 1.0 / 6;
  k = (blunt + 1) % 3;
  if (square_between (corners[blunt], corners[(blunt + 2) % 3])
      > square_between (corners[blunt], corners[k]))
    k = (blunt + 2) % 3;
  weights[k] = 2.0 / 3;
  return weighted (corners, weights);
}

static void
add_facet_name (SceneBuilder *builder, uint32_t facet, bool lifted)
{
  const char *label = scene_label (builder, 'f', facet);

  if (label != NULL)
    scene_add_mark (builder, ROLE_FACET_NAME, (Object){ OBJECT_FACET, facet },
                    scene_name_point (builder, facet, lifted), label);
}

/* The facet that the sentence of the step speaks of. */
static uint32_t
facet_of_step (const SceneBuilder *builder)
{
  const Event *event = builder->event;

  return event != NULL ? event->facet : INDEX_NONE;
}

/* Whether the cone stands on a site, or the sentence of the step speaks of a
 * facet that has it for a corner. */
static bool
is_corner (const SceneBuilder *builder, uint32_t site)
{
  const uint32_t facet = facet_of_step (builder);
  const uint32_t *corners;

  if (builder->frame->sites[site].is_changed)
    return true;
  if (facet == INDEX_NONE || builder->frame->trace->is_flat)
    return false;
  corners = scene_facet_sites (builder, facet);
  return corners[0] == site || corners[1] == site || corners[2] == site;
}

void
scene_add_site (SceneBuilder *builder, uint32_t site, bool lifted)
{
  Scene *scene = builder->scene;

  scene_add_mark (builder, scene_site_role (builder->frame->sites[site].state),
                  (Object){ OBJECT_SITE, site },
                  scene_at (builder, site, lifted),
                  scene_label (builder, 's', site));
  scene->items[scene->n_items - 1].is_corner = is_corner (builder, site);
}

/* In the plane only a lower facet has a triangle to name. */
static void
name_facet (SceneBuilder *builder, uint32_t facet, bool lifted)
{
  if (facet != INDEX_NONE && !builder->frame->trace->is_flat
      && !scene_has_answer (builder, facet) && scene_roles (builder, facet) != 0
      && (lifted
          || builder->frame->trace->facets[facet].facing == FACING_LOWER))
    add_facet_name (builder, facet, lifted);
}

/* A lower facet beyond the horizon is quiet, and seen through those that are
 * not: in space its name would seem to be that of one of them. */
static bool
is_beyond (const SceneBuilder *builder)
{
  const Event *event = builder->event;

  return event != NULL && event->kind == EVENT_HORIZON
         && builder->frame->trace->facets[event->facet].facing == FACING_LOWER;
}

void
scene_add_step_name (SceneBuilder *builder, bool lifted)
{
  if (!lifted
      || (scene_has_layer (builder, LAYER_HULL) && !is_beyond (builder)))
    name_facet (builder, facet_of_step (builder), lifted);
}

void
scene_add_selected_name (SceneBuilder *builder, bool lifted)
{
  const Object selection = builder->look->selection;

  if (selection.kind == OBJECT_FACET
      && selection.number != facet_of_step (builder))
    name_facet (builder, selection.number, lifted);
}
