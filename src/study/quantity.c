#include "quantity.h"

#include <glib/gi18n.h>

static const char *const names[N_QUANTITIES + 1] = {
  [QUANTITY_SITES] = "sites",
  [QUANTITY_DUPLICATES] = "duplicates",
  [QUANTITY_INSERTED] = "inserted",
  [QUANTITY_WAITING] = "waiting",
  [QUANTITY_OUTSIDE_SETS] = "outside-sets",
  [QUANTITY_ROUND] = "round",
  [QUANTITY_STEP] = "step",
  [QUANTITY_FACETS] = "facets",
  [QUANTITY_LOWER] = "lower",
  [QUANTITY_UPPER] = "upper",
  [QUANTITY_VERTICAL] = "vertical",
  [QUANTITY_HULL_CORNERS] = "hull-corners",
  [QUANTITY_BOUNDARY_SITES] = "boundary-sites",
  [QUANTITY_VISIBLE] = "visible",
  [QUANTITY_DYING_TRIANGLES] = "dying-triangles",
  [QUANTITY_VISIBLE_UPPER] = "visible-upper",
  [QUANTITY_VISIBLE_VERTICAL] = "visible-vertical",
  [QUANTITY_HORIZON] = "horizon",
  [QUANTITY_CONE] = "cone",
  [QUANTITY_NEW_TRIANGLES] = "new-triangles",
  [QUANTITY_RETIRED] = "retired",
  [QUANTITY_TRIANGLES] = "triangles",
  [QUANTITY_DELAUNAY_EDGES] = "delaunay-edges",
  [QUANTITY_FREE_EDGES] = "free-edges",
  [QUANTITY_VORONOI_VERTICES] = "voronoi-vertices",
  [QUANTITY_VORONOI_EDGES] = "voronoi-edges",
  [QUANTITY_RAYS] = "rays",
  [QUANTITY_VORONOI_LINES] = "voronoi-lines",
};

static const char *const labels[N_QUANTITIES] = {
  [QUANTITY_SITES] = N_ ("sites"),
  [QUANTITY_DUPLICATES] = N_ ("duplicates"),
  [QUANTITY_INSERTED] = N_ ("sites on the hull"),
  [QUANTITY_WAITING] = N_ ("sites that wait"),
  [QUANTITY_OUTSIDE_SETS] = N_ ("outside sets that are not empty"),
  [QUANTITY_ROUND] = N_ ("number of the round"),
  [QUANTITY_STEP] = N_ ("events so far"),
  [QUANTITY_FACETS] = N_ ("facets of the hull"),
  [QUANTITY_LOWER] = N_ ("lower facets"),
  [QUANTITY_UPPER] = N_ ("upper facets"),
  [QUANTITY_VERTICAL] = N_ ("vertical facets"),
  [QUANTITY_HULL_CORNERS] = N_ ("corners of the hull in the plane"),
  [QUANTITY_BOUNDARY_SITES] = N_ ("sites on the boundary"),
  [QUANTITY_VISIBLE] = N_ ("visible facets"),
  [QUANTITY_DYING_TRIANGLES] = N_ ("triangles that die"),
  [QUANTITY_VISIBLE_UPPER] = N_ ("visible upper facets"),
  [QUANTITY_VISIBLE_VERTICAL] = N_ ("visible vertical facets"),
  [QUANTITY_HORIZON] = N_ ("ridges of the horizon"),
  [QUANTITY_CONE] = N_ ("facets of the cone"),
  [QUANTITY_NEW_TRIANGLES] = N_ ("triangles that are born"),
  [QUANTITY_RETIRED] = N_ ("facets that retire"),
  [QUANTITY_TRIANGLES] = N_ ("Delaunay triangles"),
  [QUANTITY_DELAUNAY_EDGES] = N_ ("Delaunay edges"),
  [QUANTITY_FREE_EDGES] = N_ ("free diagonals"),
  [QUANTITY_VORONOI_VERTICES] = N_ ("Voronoi vertices"),
  [QUANTITY_VORONOI_EDGES] = N_ ("Voronoi edges with two ends"),
  [QUANTITY_RAYS] = N_ ("Voronoi rays"),
  [QUANTITY_VORONOI_LINES] = N_ ("Voronoi lines"),
};

const char *
quantity_name (Quantity quantity)
{
  return names[quantity];
}

const char *const *
quantity_names (void)
{
  return names;
}

const char *
quantity_label (Quantity quantity)
{
  return _ (labels[quantity]);
}

gboolean
quantity_parse (const char *name, Quantity *quantity)
{
  for (Quantity i = 0; i < N_QUANTITIES; i++)
    if (g_str_equal (name, names[i])) {
      *quantity = i;
      return TRUE;
    }
  return FALSE;
}

QuantityScope
quantity_scope (Quantity quantity)
{
  if (quantity >= QUANTITY_VISIBLE && quantity <= QUANTITY_RETIRED)
    return SCOPE_ROUND;
  return quantity >= QUANTITY_FACETS && quantity <= QUANTITY_VERTICAL
             ? SCOPE_HULL
             : SCOPE_ALWAYS;
}

/* Sites on a line have a diagram of lines alone. */
static guint
count_lines (const Frame *frame)
{
  return frame->delaunay.dimension == 1 ? frame->counts.voronoi_edges : 0;
}

/* Of the current round so far; as the other counts of a round they stay until
 * the next begins. */
static guint
count_events (const Frame *frame, EventKind kind, Facing facing)
{
  const Trace *trace = frame->trace;
  guint n = 0;

  if (frame->round == INDEX_NONE)
    return 0;
  for (guint i = trace->rounds[frame->round].select - 1; i < frame->step; i++)
    n += trace_event (trace, i).kind == kind
         && trace->facets[trace_event (trace, i).facet].facing == facing;
  return n;
}

static guint
count_free_edges (const Frame *frame)
{
  guint n = 0;

  for (guint i = 0; i < frame->delaunay.n_edges; i++)
    n += frame->delaunay.edges[i].is_free ? 1 : 0;
  return n;
}

/* Counts what no frame has counted.
 *
 * Returns: FALSE when the frame has. */
static gboolean
count (const Frame *frame, Quantity quantity, guint *n)
{
  switch ((int)quantity) {
  case QUANTITY_DYING_TRIANGLES:
    *n = count_events (frame, EVENT_VISIBLE, FACING_LOWER);
    return TRUE;
  case QUANTITY_VISIBLE_UPPER:
    *n = count_events (frame, EVENT_VISIBLE, FACING_UPPER);
    return TRUE;
  case QUANTITY_VISIBLE_VERTICAL:
    *n = count_events (frame, EVENT_VISIBLE, FACING_VERTICAL);
    return TRUE;
  case QUANTITY_NEW_TRIANGLES:
    *n = count_events (frame, EVENT_CONE, FACING_LOWER);
    return TRUE;
  case QUANTITY_FREE_EDGES:
    *n = count_free_edges (frame);
    return TRUE;
  default:
    return FALSE;
  }
}

guint
quantity_value (const Frame *frame, Quantity quantity)
{
  const FrameCounts *counts = &frame->counts;
  guint n;
  const guint looked_up[N_QUANTITIES] = {
    [QUANTITY_SITES] = frame->n_sites,
    [QUANTITY_DUPLICATES] = frame->n_sites - frame->trace->set->n_distinct,
    [QUANTITY_INSERTED] = counts->n_inserted,
    [QUANTITY_WAITING] = counts->waiting,
    [QUANTITY_OUTSIDE_SETS] = counts->outside_sets,
    [QUANTITY_ROUND] = frame->place.round,
    [QUANTITY_STEP] = frame->step,
    [QUANTITY_FACETS] = counts->facets,
    [QUANTITY_LOWER] = counts->lower,
    [QUANTITY_UPPER] = counts->upper,
    [QUANTITY_VERTICAL] = counts->vertical,
    [QUANTITY_HULL_CORNERS] = frame->delaunay.n_extreme,
    [QUANTITY_BOUNDARY_SITES] = frame->delaunay.n_boundary,
    [QUANTITY_VISIBLE] = counts->visible,
    [QUANTITY_HORIZON] = counts->horizon,
    [QUANTITY_CONE] = counts->cone,
    [QUANTITY_RETIRED] = counts->retired,
    [QUANTITY_TRIANGLES] = counts->triangles,
    [QUANTITY_DELAUNAY_EDGES] = counts->delaunay_edges,
    [QUANTITY_VORONOI_VERTICES] = counts->voronoi_vertices,
    [QUANTITY_VORONOI_EDGES]
    = counts->voronoi_edges - counts->rays - count_lines (frame),
    [QUANTITY_RAYS] = counts->rays,
    [QUANTITY_VORONOI_LINES] = count_lines (frame),
  };

  return count (frame, quantity, &n) ? n : looked_up[quantity];
}
