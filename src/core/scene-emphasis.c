/* What of a scene is loud: the active set of a step. */
#include "scene-builder.h"

#include <string.h>

/* The parts of the active set of a step. */
typedef enum Part {
  PART_NONE = 0,
  PART_CHOICE = 1, /* the selected facet and its outside set */
  PART_APEX = 2,
  PART_VISIBLE = 4,
  PART_HORIZON = 8,
  PART_CONE = 16,
} Part;

static const Part part_of[N_ROLES] = {
  [ROLE_SELECTED_FACET] = PART_CHOICE,
  [ROLE_DROP] = PART_CHOICE,
  [ROLE_EDGE_LINE] = PART_CHOICE | PART_VISIBLE,
  [ROLE_LIFT_OUTSIDE] = PART_CHOICE,
  [ROLE_SITE_OUTSIDE] = PART_CHOICE,
  [ROLE_SITE_APEX] = PART_APEX,
  [ROLE_LIFT_APEX] = PART_APEX,
  [ROLE_FOOT_APEX] = PART_APEX,
  [ROLE_FACET_NAME] = PART_APEX,
  [ROLE_VISIBLE] = PART_VISIBLE,
  [ROLE_VISIBLE_UPPER] = PART_VISIBLE,
  [ROLE_RETIRED] = PART_VISIBLE,
  [ROLE_CIRCLE_VISIBLE] = PART_VISIBLE,
  [ROLE_CIRCLE_UPPER] = PART_VISIBLE,
  [ROLE_VISIBLE_EDGE] = PART_VISIBLE,
  [ROLE_SEEN_EDGE] = PART_VISIBLE,
  [ROLE_VORONOI_VERTEX_DYING] = PART_VISIBLE,
  [ROLE_HORIZON] = PART_HORIZON,
  [ROLE_HORIZON_UPPER] = PART_HORIZON,
  [ROLE_HORIZON_CORNER] = PART_HORIZON,
  [ROLE_CONE] = PART_CONE,
  [ROLE_CONE_UPPER] = PART_CONE,
  [ROLE_CONE_EDGE] = PART_CONE,
};

/* The answer to what a person asked for, in whatever phase. */
static bool
is_answer (Role role)
{
  switch ((int)role) {
  case ROLE_PLANE:
  case ROLE_ELLIPSE:
  case ROLE_GAP:
  case ROLE_POWER:
  case ROLE_PREVIEW_TRIANGLE:
  case ROLE_PREVIEW_STOLEN:
  case ROLE_PREVIEW_EDGE:
  case ROLE_PREVIEW_CELL:
  case ROLE_ANSWER_CHOSEN:
  case ROLE_ANSWER_RIGHT:
  case ROLE_ANSWER_WRONG:
  case ROLE_ANSWER_MISSED:
    return true;
  default:
    return false;
  }
}

static uint32_t
parts_of_phase (Phase phase)
{
  switch (phase) {
  case PHASE_CHOOSE:
    return PART_CHOICE | PART_APEX;
  case PHASE_SEE:
    return PART_VISIBLE | PART_APEX;
  case PHASE_HORIZON:
    return PART_HORIZON | PART_VISIBLE | PART_APEX;
  case PHASE_CONE:
    return PART_CONE | PART_HORIZON | PART_APEX;
  case PHASE_HAND_OVER:
    return PART_CONE | PART_VISIBLE | PART_APEX | PART_CHOICE;
  case PHASE_START:
  case PHASE_SIMPLEX:
  case PHASE_COMPLETE:
    break;
  }
  return PART_NONE;
}

static uint32_t
loud_parts (Phase phase, Focus focus)
{
  switch (focus) {
  case FOCUS_VISIBLE:
    return PART_VISIBLE | PART_APEX;
  case FOCUS_HORIZON:
    return PART_HORIZON | PART_APEX;
  case FOCUS_CONE:
    return PART_CONE | PART_APEX;
  case FOCUS_ACTIVE:
  case FOCUS_NONE:
    break;
  }
  return parts_of_phase (phase);
}

void
scene_builder_round (SceneBuilder *builder, Phase phase)
{
  builder->is_round = true;
  builder->parts = loud_parts (phase, builder->look->focus);
  memset (builder->role_looks, 0, sizeof builder->role_looks);
}

Emphasis
scene_emphasis (const SceneBuilder *builder, Role role)
{
  const bool is_mark = role >= ROLE_PREVIEW_SITE;

  if (!builder->is_round)
    return EMPHASIS_NORMAL;
  if ((uint32_t)part_of[role] & builder->parts)
    return EMPHASIS_LOUD;
  if (builder->look->focus == FOCUS_NONE || is_mark || is_answer (role))
    return EMPHASIS_NORMAL;
  return EMPHASIS_PALE;
}
