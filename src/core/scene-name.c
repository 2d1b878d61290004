/* Names of facets: of that which the sentence of the step speaks of, and of
 * that which is selected. */
#include "scene-builder.h"

#include <stddef.h>

static void
add_facet_name (SceneBuilder *builder, uint32_t facet, bool lifted)
{
  const uint32_t *site = scene_facet_sites (builder, facet);
  const char *label = scene_label (builder, 'f', facet);
  Point3 middle = { 0, 0, 0 };
  int k;

  for (k = 0; k < 3; k++) {
    const Point3 corner = scene_at (builder, site[k], lifted);

    middle.x += corner.x / 3;
    middle.y += corner.y / 3;
    middle.z += corner.z / 3;
  }
  if (label != NULL)
    scene_add_mark (builder, ROLE_FACET_NAME, (Object){ OBJECT_FACET, facet },
                    middle, label);
}

/* The facet that the sentence of the step speaks of. */
static uint32_t
facet_of_step (const SceneBuilder *builder)
{
  const Event *event = builder->event;

  return event != NULL && event->kind != EVENT_HORIZON ? event->facet
                                                       : INDEX_NONE;
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

void
scene_add_step_name (SceneBuilder *builder, bool lifted)
{
  if (!lifted || scene_has_layer (builder, LAYER_HULL))
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
