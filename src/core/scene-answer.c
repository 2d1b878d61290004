/* What a person has chosen as an answer, and how right it is: marks of their
 * own over all others, in the plane and in space. What the question speaks of
 * has its name. */
#include "scene-builder.h"

#include <stdio.h>

static Role
role_of (AnswerKind kind)
{
  switch (kind) {
  case ANSWER_NAMED:
  case ANSWER_CHOSEN:
    return ROLE_ANSWER_CHOSEN;
  case ANSWER_RIGHT:
    return ROLE_ANSWER_RIGHT;
  case ANSWER_WRONG:
    return ROLE_ANSWER_WRONG;
  case ANSWER_MISSED:
    return ROLE_ANSWER_MISSED;
  }
  return ROLE_ANSWER_CHOSEN;
}

static bool
is_checked (const SceneAnswer *answer)
{
  return answer->kind == ANSWER_RIGHT || answer->kind == ANSWER_WRONG;
}

/* A sign beside the mark, so that colour alone tells nothing. */
static const char *
sign_of (SceneBuilder *builder, const SceneAnswer *answer)
{
  char number[16];

  switch (answer->kind) {
  case ANSWER_RIGHT:
    return scene_text (builder, "✓");
  case ANSWER_WRONG:
    return scene_text (builder, "✗");
  case ANSWER_NAMED:
  case ANSWER_CHOSEN:
  case ANSWER_MISSED:
    break;
  }
  if (answer->place == 0)
    return NULL;
  snprintf (number, sizeof number, "%u.", answer->place);
  return scene_text (builder, number);
}

/* Loud: it is not left out for lack of room. */
static void
add_name (SceneBuilder *builder,
          const SceneAnswer *answer,
          Point3 at,
          const char *name)
{
  if (name == NULL)
    return;
  scene_add_mark (builder, ROLE_ANSWER_NAME, answer->object, at, name);
  builder->scene->items[builder->scene->n_items - 1].emphasis = EMPHASIS_LOUD;
}

/* What is said of an answer speaks of facets by their names. Sign and name are
 * one, or each would be put where there is room for it. */
static const char *
name_of_facet (SceneBuilder *builder, const SceneAnswer *answer)
{
  const char *sign = sign_of (builder, answer);
  char name[LABEL_ROOM];

  if (!scene_has_layer (builder, LAYER_LABELS))
    return sign;
  if (sign == NULL)
    snprintf (name, sizeof name, "f%u", answer->object.number);
  else if (is_checked (answer))
    snprintf (name, sizeof name, "f%u %s", answer->object.number, sign);
  else
    snprintf (name, sizeof name, "%s f%u", sign, answer->object.number);
  return scene_text (builder, name);
}

bool
scene_has_answer (const SceneBuilder *builder, uint32_t facet)
{
  const SceneLook *look = builder->look;
  uint32_t i;

  for (i = 0; i < look->n_answers; i++) {
    const Object object = look->answers[i].object;

    if (object.kind == OBJECT_FACET && object.number == facet)
      return true;
    if (object.kind == OBJECT_VERTEX
        && scene_group (builder, object.number) != INDEX_NONE
        && scene_group (builder, object.number) == scene_group (builder, facet))
      return true;
  }
  return false;
}

/* The middle of some sites. */
static Point3
middle_of (const SceneBuilder *builder,
           const uint32_t *site,
           uint32_t n,
           bool lifted)
{
  Point3 middle = { 0, 0, 0 };
  uint32_t i;

  for (i = 0; i < n; i++) {
    const Point3 corner = scene_at (builder, site[i], lifted);

    middle.x += corner.x / n;
    middle.y += corner.y / n;
    middle.z += corner.z / n;
  }
  return middle;
}

static bool
has_shadow (const SceneBuilder *builder, uint32_t facet)
{
  return builder->frame->trace->is_flat
         || builder->frame->trace->facets[facet].facing == FACING_LOWER;
}

/* A triangle is drawn a little inside its sides: neighbours that are chosen
 * both have their own outline. */
static void
add_outline (SceneBuilder *builder,
             const SceneAnswer *answer,
             const uint32_t *site,
             Point3 middle,
             bool lifted)
{
  int k;

  scene_add (builder, SHAPE_PATH, role_of (answer->kind), answer->object);
  for (k = 0; k < 4; k++) {
    const Point3 corner = scene_at (builder, site[k % 3], lifted);

    scene_add_point (
        builder, (Point3){ corner.x + ANSWER_INSET * (middle.x - corner.x),
                           corner.y + ANSWER_INSET * (middle.y - corner.y),
                           corner.z + ANSWER_INSET * (middle.z - corner.z) });
  }
}

static void
add_facet (SceneBuilder *builder, const SceneAnswer *answer, bool lifted)
{
  const uint32_t facet = answer->object.number;
  const Frame *frame = builder->frame;
  const uint32_t n_facets = frame->trace->is_flat ? frame->delaunay.n_triangles
                                                  : frame->trace->n_facets;
  const uint32_t *site;
  Point3 middle;

  if (facet >= n_facets || (!lifted && !has_shadow (builder, facet))
      || scene_roles (builder, facet) == 0)
    return;
  site = scene_facet_sites (builder, facet);
  middle = middle_of (builder, site, 3, lifted);
  if (answer->kind != ANSWER_NAMED)
    add_outline (builder, answer, site, middle, lifted);
  add_name (builder, answer, scene_name_point (builder, facet, lifted),
            name_of_facet (builder, answer));
}

static void
add_ridge (SceneBuilder *builder, const SceneAnswer *answer, bool lifted)
{
  const Trace *trace = builder->frame->trace;
  RidgeRow row;

  if (answer->object.number >= trace->n_ridges)
    return;
  row = trace_ridge (trace, answer->object.number);
  scene_add_edge (builder, role_of (answer->kind), answer->object, row.site,
                  lifted);
  add_name (builder, answer, middle_of (builder, row.site, 2, lifted),
            sign_of (builder, answer));
}

static void
add_site (SceneBuilder *builder, const SceneAnswer *answer, bool lifted)
{
  if (answer->object.number < builder->frame->n_sites)
    scene_add_mark (builder, role_of (answer->kind), answer->object,
                    scene_at (builder, answer->object.number, lifted),
                    sign_of (builder, answer));
}

/* A Voronoi vertex is chosen by its triangle: both are marked. */
static void
add_vertex (SceneBuilder *builder, const SceneAnswer *answer, bool lifted)
{
  const uint32_t group = scene_group (builder, answer->object.number);
  const Delaunay *delaunay = &builder->frame->delaunay;
  uint32_t i;

  for (i = 0; group != INDEX_NONE && i < delaunay->n_triangles; i++) {
    SceneAnswer of_triangle = *answer;

    if (delaunay->triangles[i].group != group)
      continue;
    of_triangle.object = (Object){ OBJECT_FACET, delaunay->triangles[i].facet };
    add_facet (builder, &of_triangle, lifted);
  }
}

static void
add_answer (SceneBuilder *builder, const SceneAnswer *answer, bool lifted)
{
  if (answer->kind == ANSWER_NAMED && answer->object.kind != OBJECT_FACET)
    return;
  switch (answer->object.kind) {
  case OBJECT_FACET:
    add_facet (builder, answer, lifted);
    break;
  case OBJECT_RIDGE:
    add_ridge (builder, answer, lifted);
    break;
  case OBJECT_SITE:
    add_site (builder, answer, lifted);
    break;
  case OBJECT_VERTEX:
    add_vertex (builder, answer, lifted);
    break;
  case OBJECT_NONE:
    break;
  }
}

/* What was missed has a casing, which would cover what a person has chosen
 * where both are seen edge-on: it lies below. */
void
scene_add_answers (SceneBuilder *builder, bool lifted)
{
  uint32_t i;
  int above;

  for (above = 0; above <= 1; above++)
    for (i = 0; i < builder->look->n_answers; i++) {
      const SceneAnswer *answer = &builder->look->answers[i];

      if ((answer->kind != ANSWER_MISSED) == above)
        add_answer (builder, answer, lifted);
    }
}
