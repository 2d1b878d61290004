#include "question-click.h"

#include "question-reason.h"
#include "scene.h"

#include <glib/gi18n.h>

/* The round that it is about. */
static const RoundRow *
round_at (const Occasion *occasion)
{
  return occasion_round (occasion);
}

static void
add (GArray *objects, ObjectKind kind, guint number)
{
  const Object object = { kind, number };

  for (guint i = 0; i < objects->len; i++)
    if (object_equal (g_array_index (objects, Object, i), object))
      return;
  g_array_append_val (objects, object);
}

#define COLLECT(name)                                                          \
  static void name (const Question *question G_GNUC_UNUSED,                    \
                    const Occasion *occasion,                                  \
                    const Frame *frame G_GNUC_UNUSED, GArray *objects)

/* The round */

COLLECT (collect_visible)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->first_visible - 1; i < round->last_visible; i++)
    add (objects, OBJECT_FACET, trace_event (occasion->trace, i).facet);
}

COLLECT (collect_dying)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->first_visible - 1; i < round->last_visible; i++) {
    const guint facet = trace_event (occasion->trace, i).facet;

    if (occasion->trace->facets[facet].facing == FACING_LOWER)
      add (objects, OBJECT_FACET, facet);
  }
}

COLLECT (collect_circles)
{
  g_autoptr (GArray) facets = g_array_new (FALSE, FALSE, sizeof (Object));

  collect_dying (question, occasion, frame, facets);
  for (guint i = 0; i < facets->len; i++) {
    Object object = g_array_index (facets, Object, i);

    if (question_takes (question, frame, &object))
      add (objects, object.kind, object.number);
  }
}

/* The row of the ridge between two sites, with @facet on one side. */
static guint
find_ridge (const Frame *frame, Event event)
{
  for (guint i = 0; i < frame->n_ridges; i++) {
    const FrameRidge *row = &frame->ridges[i];

    if ((row->site[0] == event.ridge[0] && row->site[1] == event.ridge[1])
        || (row->site[0] == event.ridge[1] && row->site[1] == event.ridge[0]))
      return row->ridge;
  }
  return INDEX_NONE;
}

COLLECT (collect_horizon)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->first_horizon - 1; i < round->last_horizon; i++)
    add (objects, OBJECT_RIDGE,
         find_ridge (frame, trace_event (occasion->trace, i)));
}

COLLECT (collect_new_triangles)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->first_cone - 1; i < round->last_cone; i++) {
    const Event event = trace_event (occasion->trace, i);

    if (occasion->trace->facets[event.facet].facing == FACING_LOWER)
      add (objects, OBJECT_RIDGE, find_ridge (frame, event));
  }
}

static void
collect_cone (const Occasion *occasion, Facing facing, GArray *objects)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->first_cone - 1; i < round->last_cone; i++) {
    const guint facet = trace_event (occasion->trace, i).facet;

    if (occasion->trace->facets[facet].facing == facing)
      add (objects, OBJECT_FACET, facet);
  }
}

COLLECT (collect_new_lower) { collect_cone (occasion, FACING_LOWER, objects); }

COLLECT (collect_new_upper) { collect_cone (occasion, FACING_UPPER, objects); }

/* Outside sets */

static void
collect_outside (const Occasion *occasion, guint facet, GArray *objects)
{
  for (guint i = 0; i < occasion->trace->n_claims; i++) {
    const ClaimRow claim = trace_claim (occasion->trace, i);

    if (claim.facet == facet && span_has (claim.span, occasion->step))
      add (objects, OBJECT_SITE, claim.site);
  }
}

COLLECT (collect_outside_set)
{
  collect_outside (occasion, question->argument.number, objects);
}

COLLECT (collect_furthest)
{
  const RoundRow *round = round_at (occasion);
  g_autoptr (GArray) waiting = g_array_new (FALSE, FALSE, sizeof (Object));
  guint best = INDEX_NONE;

  collect_outside (occasion, round->facet, waiting);
  for (guint i = 0; i < waiting->len; i++) {
    const guint site = g_array_index (waiting, Object, i).number;
    const int further
        = best == INDEX_NONE
              ? 1
              : question_further (occasion->trace, round->facet, site, best);

    if (further > 0)
      g_array_set_size (objects, 0);
    if (further >= 0) {
      add (objects, OBJECT_SITE, site);
      best = site;
    }
  }
}

COLLECT (collect_with_outside_set)
{
  for (guint i = 0; i < occasion->trace->n_claims; i++)
    if (span_has (trace_claim (occasion->trace, i).span, occasion->step))
      add (objects, OBJECT_FACET, trace_claim (occasion->trace, i).facet);
}

/* Who sees what */

COLLECT (collect_sites_that_see)
{
  for (guint i = 0; i < frame->n_sites; i++)
    if ((frame->sites[i].state == SITE_WAITING
         || frame->sites[i].state == SITE_OUTSIDE
         || frame->sites[i].state == SITE_APEX)
        && question_sees (occasion->trace, i, question->argument.number))
      add (objects, OBJECT_SITE, i);
}

COLLECT (collect_seen_by)
{
  for (guint i = 0; i < frame->n_facets; i++)
    if ((frame->facets[i].roles & FACET_STANDS)
        && question_sees (occasion->trace, question->argument.number,
                          frame->facets[i].facet))
      add (objects, OBJECT_FACET, frame->facets[i].facet);
}

/* Handing over: in a round to the cone, before the first to the simplex. */

static gboolean
is_orphan (const Occasion *occasion, guint site)
{
  const RoundRow *round = round_at (occasion);

  for (guint i = round->last_retire; i < round->end; i++)
    if (trace_event (occasion->trace, i).site == site)
      return TRUE;
  return FALSE;
}

COLLECT (collect_hand_over)
{
  const RoundRow *round = round_at (occasion);
  const guint site = question->argument.number;

  if (round == NULL) {
    collect_seen_by (question, occasion, frame, objects);
    return;
  }
  if (!is_orphan (occasion, site))
    return;
  for (guint i = round->first_cone - 1; i < round->last_cone; i++)
    if (question_sees (occasion->trace, site,
                       trace_event (occasion->trace, i).facet))
      add (objects, OBJECT_FACET, trace_event (occasion->trace, i).facet);
}

/* The hull and the diagrams */

static void
collect_facing (const Frame *frame, Facing facing, GArray *objects)
{
  for (guint i = 0; i < frame->n_facets; i++) {
    const guint facet = frame->facets[i].facet;

    if ((frame->facets[i].roles & FACET_STANDS)
        && frame->trace->facets[facet].facing == facing)
      add (objects, OBJECT_FACET, facet);
  }
}

COLLECT (collect_lower)
{
  (void)occasion;
  collect_facing (frame, FACING_LOWER, objects);
}

COLLECT (collect_upper)
{
  (void)occasion;
  collect_facing (frame, FACING_UPPER, objects);
}

COLLECT (collect_vertical)
{
  (void)occasion;
  collect_facing (frame, FACING_VERTICAL, objects);
}

COLLECT (collect_unbounded)
{
  const Delaunay *delaunay = &frame->delaunay;

  (void)occasion;
  for (guint i = 0; i < delaunay->n_boundary; i++)
    add (objects, OBJECT_SITE, delaunay->boundary[i]);
}

COLLECT (collect_corners)
{
  const Delaunay *delaunay = &frame->delaunay;

  (void)occasion;
  for (guint i = 0; i < delaunay->n_boundary; i++)
    if (delaunay_is_extreme (delaunay, i))
      add (objects, OBJECT_SITE, delaunay->boundary[i]);
}

COLLECT (collect_neighbours)
{
  const guint site = question->argument.number;

  (void)occasion;
  for (guint i = 0; i < frame->delaunay.n_edges; i++) {
    const DelaunayEdge *edge = &frame->delaunay.edges[i];

    if (!edge->is_free && (edge->site[0] == site || edge->site[1] == site))
      add (objects, OBJECT_SITE, edge->site[edge->site[0] == site ? 1 : 0]);
  }
}

COLLECT (collect_duplicates)
{
  const SiteSet *set = occasion->trace->set;

  for (guint i = 0; i < set->n_sites; i++)
    if (set->first[i] != i)
      add (objects, OBJECT_SITE, i);
}

static const ClickKind kinds[] = {
  { .name = "visible-facets",
    .target = OBJECT_FACET,
    .event = PHASE_SEE,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click **every facet that {p} sees**."),
    .collect = collect_visible,
    .why = reason_visible },
  { .name = "dying-triangles",
    .target = OBJECT_FACET,
    .event = PHASE_SEE,
    .mask = MASK_ROUND,
    .prompt = N_ ("{p} comes in. Click **every triangle that will go**."),
    .collect = collect_dying,
    .why = reason_visible },
  { .name = "circles",
    .target = OBJECT_VERTEX,
    .event = PHASE_SEE,
    .mask = MASK_ROUND,
    .item = N_ ("triangle f%u"),
    .prompt = N_ ("Click every triangle **whose circle contains {p}**."),
    .collect = collect_circles,
    .why = reason_circle },
  { .name = "dying-vertices",
    .target = OBJECT_VERTEX,
    .event = PHASE_SEE,
    .mask = MASK_ROUND,
    .prompt = N_ ("{p} comes in. Click **every Voronoi vertex that will "
                  "go**."),
    .collect = collect_circles,
    .why = reason_circle },
  { .name = "horizon",
    .target = OBJECT_RIDGE,
    .event = PHASE_HORIZON,
    .prompt = N_ ("Click **every ridge of the horizon** of {p}."),
    .collect = collect_horizon,
    .why = reason_horizon },
  { .name = "new-triangles",
    .target = OBJECT_RIDGE,
    .event = PHASE_CONE,
    .prompt = N_ ("Over each ridge of the horizon a facet will join {p}. "
                  "Click the ridges over which it is a **lower** facet, a new "
                  "triangle."),
    .collect = collect_new_triangles,
    .why = reason_new_triangle },
  { .name = "new-lower-facets",
    .target = OBJECT_FACET,
    .event = PHASE_HAND_OVER,
    .mask = MASK_FACING,
    .prompt = N_ ("Click the new facets that face **down**."),
    .collect = collect_new_lower,
    .why = reason_facing },
  { .name = "new-upper-facets",
    .target = OBJECT_FACET,
    .event = PHASE_HAND_OVER,
    .mask = MASK_FACING,
    .prompt = N_ ("Click the new facets that face **up**."),
    .collect = collect_new_upper,
    .why = reason_facing },
  { .name = "furthest-site",
    .target = OBJECT_SITE,
    .is_any = TRUE,
    .event = PHASE_CHOOSE,
    .mask = MASK_ROUND,
    .prompt = N_ ("Of the outside set of {f}, click the site that is "
                  "**furthest from {f}**."),
    .collect = collect_furthest,
    .why = reason_furthest },
  { .name = "next-facet",
    .target = OBJECT_FACET,
    .is_any = TRUE,
    .event = PHASE_CHOOSE,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click a facet that **QuickHull may take next**."),
    .collect = collect_with_outside_set,
    .why = reason_outside_set },
  { .name = "facets-with-outside-set",
    .target = OBJECT_FACET,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click every facet whose **outside set is not empty**."),
    .collect = collect_with_outside_set,
    .why = reason_outside_set },
  { .name = "hand-over",
    .argument = 's',
    .target = OBJECT_FACET,
    .is_any = TRUE,
    .event = PHASE_HAND_OVER,
    .prompt = N_ ("The facet at which {a} waits will retire. Click a new "
                  "facet to which **{a} may be handed over**."),
    .collect = collect_hand_over,
    .why = reason_hand_over },
  { .name = "outside-set",
    .argument = 'f',
    .target = OBJECT_SITE,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click every site in the **outside set of {a}**."),
    .collect = collect_outside_set,
    .why = reason_member },
  { .name = "sites-that-see",
    .argument = 'f',
    .target = OBJECT_SITE,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click every waiting site that **sees {a}**."),
    .collect = collect_sites_that_see,
    .why = reason_sees_argument },
  { .name = "facets-seen-by",
    .argument = 's',
    .target = OBJECT_FACET,
    .mask = MASK_ROUND,
    .prompt = N_ ("Click every facet that **{a} sees**."),
    .collect = collect_seen_by,
    .why = reason_argument_sees },
  { .name = "lower-facets",
    .target = OBJECT_FACET,
    .mask = MASK_FACING,
    .prompt = N_ ("Click every **lower** facet."),
    .collect = collect_lower,
    .why = reason_facing },
  { .name = "upper-facets",
    .target = OBJECT_FACET,
    .mask = MASK_FACING,
    .prompt = N_ ("Click every **upper** facet."),
    .collect = collect_upper,
    .why = reason_facing },
  { .name = "vertical-facets",
    .target = OBJECT_FACET,
    .mask = MASK_FACING,
    .prompt = N_ ("Click every **vertical** facet."),
    .collect = collect_vertical,
    .why = reason_facing },
  { .name = "unbounded-cells",
    .target = OBJECT_SITE,
    .prompt = N_ ("Click every site whose **Voronoi cell is unbounded**."),
    .collect = collect_unbounded,
    .why = reason_unbounded },
  { .name = "hull-corners",
    .target = OBJECT_SITE,
    .prompt = N_ ("Click every **corner of the hull** in the plane."),
    .collect = collect_corners,
    .why = reason_corner },
  { .name = "neighbours",
    .argument = 's',
    .target = OBJECT_SITE,
    .prompt = N_ ("Click every site whose cell has **a side in common with "
                  "that of {a}**."),
    .collect = collect_neighbours,
    .why = reason_neighbour },
  { .name = "duplicates",
    .target = OBJECT_SITE,
    .prompt = N_ ("Click every site that **equals an earlier one**."),
    .collect = collect_duplicates,
    .why = reason_duplicate },
};

const ClickKind *
click_kind_find (const char *name)
{
  for (guint i = 0; i < G_N_ELEMENTS (kinds); i++)
    if (g_str_equal (name, kinds[i].name))
      return &kinds[i];
  return NULL;
}

const char *const *
click_kind_names (void)
{
  static const char *names[G_N_ELEMENTS (kinds) + 1];

  for (guint i = 0; i < G_N_ELEMENTS (kinds); i++)
    names[i] = kinds[i].name;
  return names;
}
