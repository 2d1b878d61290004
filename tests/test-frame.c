#include "frame.h"

#include "standing.h"

#include <string.h>

/* All that a frame holds, one array after the other. */
static GBytes *
bytes_of (const Frame *frame)
{
  GByteArray *bytes = g_byte_array_new ();

#define ADD(array, n)                                                          \
  g_byte_array_append (bytes, (const guint8 *)(array),                         \
                       (guint)((n) * sizeof *(array)))
  ADD (&frame->step, 1);
  ADD (&frame->base, 1);
  ADD (&frame->place, 1);
  ADD (&frame->round, 1);
  ADD (&frame->counts, 1);
  ADD (frame->sites, frame->n_sites);
  ADD (frame->facets, frame->n_facets);
  ADD (frame->ridges, frame->n_ridges);
  ADD (frame->horizon, frame->n_horizon);
  ADD (frame->is_dying, frame->voronoi.n_vertices);
  ADD (frame->delaunay.active, frame->delaunay.n_active);
  ADD (frame->delaunay.triangles, frame->delaunay.n_triangles);
  ADD (frame->delaunay.edges, frame->delaunay.n_edges);
  ADD (frame->delaunay.boundary, frame->delaunay.n_boundary);
  ADD (frame->voronoi.vertices, frame->voronoi.n_vertices);
  ADD (frame->voronoi.edges, frame->voronoi.n_edges);
#undef ADD
  return g_byte_array_free_to_bytes (bytes);
}

typedef struct Shot {
  GBytes *bytes;
  uint64_t hash;
} Shot;

static Shot
shoot (const Trace *trace, uint32_t step)
{
  Frame frame;
  Shot shot;

  frame_init (&frame, trace, step);
  shot = (Shot){ bytes_of (&frame), frame_hash (&frame) };
  frame_clear (&frame);
  return shot;
}

static void
assert_same (const Fixture *fixture, uint32_t step, const Shot *first)
{
  const Shot shot = shoot (fixture->trace, step);

  if (!g_bytes_equal (shot.bytes, first->bytes) || shot.hash != first->hash)
    g_error ("%s: step %u differs the second time", fixture->name, step);
  g_bytes_unref (shot.bytes);
}

/* To the end, back to the start, and then anywhere. */
static void
check_every_way (const Fixture *fixture)
{
  const uint32_t n = fixture->trace->n_events + 1;
  g_autoptr (GRand) rand = g_rand_new_with_seed (n);
  g_autofree Shot *shots = g_new (Shot, n);

  for (uint32_t step = 0; step < n; step++)
    shots[step] = shoot (fixture->trace, step);
  for (uint32_t step = n; step > 0; step--)
    assert_same (fixture, step - 1, &shots[step - 1]);
  for (guint i = 0; i < 10; i++) {
    const uint32_t step = (uint32_t)g_rand_int_range (rand, 0, (gint32)n);

    assert_same (fixture, step, &shots[step]);
  }
  for (uint32_t step = 0; step < n; step++)
    g_bytes_unref (shots[step].bytes);
}

static void
test_every_way (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_every_way (fixture);
  }
  fixture_for_each (2, 20, ORDER_FURTHEST, check_every_way);
}

/* Two steps that differ in what they show have different hashes. */
static void
test_hash_tells_steps_apart (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  g_autoptr (GHashTable) hashes
      = g_hash_table_new_full (g_int64_hash, g_int64_equal, g_free, NULL);

  for (uint32_t step = 0; step <= fixture->trace->n_events; step++) {
    const Shot shot = shoot (fixture->trace, step);

    g_assert_true (g_hash_table_add (hashes, g_memdup2 (&shot.hash, 8)));
    g_bytes_unref (shot.bytes);
  }
}

typedef void (*CheckFrame) (const Frame *frame, const Standing *standing);
static CheckFrame check_frame;

/* What stands beside a frame is that of its base. */
static void
visit_steps (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);

  for (uint32_t step = 0; step <= fixture->trace->n_events; step++) {
    g_autoptr (Standing) standing = NULL;
    Frame frame;

    frame_init (&frame, fixture->trace, step);
    standing = standing_new (fixture, judge, frame.base);
    check_frame (&frame, standing);
    frame_clear (&frame);
  }
}

static void
at_every_step (gconstpointer check)
{
  check_frame = *(const CheckFrame *)check;
  fixture_for_each (4, 12, ORDER_FURTHEST, visit_steps);
}

/* The events of one kind in the current round so far. */
static uint32_t
count_events (const Frame *frame, EventKind kind)
{
  uint32_t n = 0;

  for (uint32_t step = frame->step; step > 0; step--) {
    const Event event = trace_event (frame->trace, step - 1);

    n += event.kind == kind;
    if (event.kind == EVENT_SELECT)
      return n;
  }
  return 0;
}

static void
check_round_counts (const Frame *frame, const Standing *standing)
{
  const FrameCounts *counts = &frame->counts;

  standing_assert (standing,
                   counts->visible == count_events (frame, EVENT_VISIBLE));
  standing_assert (standing,
                   counts->horizon == count_events (frame, EVENT_HORIZON));
  standing_assert (standing, counts->cone == count_events (frame, EVENT_CONE));
  standing_assert (standing,
                   counts->retired == count_events (frame, EVENT_RETIRE));
}

static void
check_kind_counts (const Frame *frame, const Standing *standing)
{
  const FrameCounts *counts = &frame->counts;

  standing_assert (standing, counts->facets == standing->n_facets);
  standing_assert (standing,
                   counts->lower == standing_count (standing, FACING_LOWER));
  standing_assert (standing,
                   counts->upper == standing_count (standing, FACING_UPPER));
  standing_assert (standing, counts->vertical
                                 == standing_count (standing, FACING_VERTICAL));
}

/* Euler, with d sites and b of them on the border. */
static void
check_diagram_counts (const Frame *frame, const Standing *standing)
{
  const FrameCounts *counts = &frame->counts;
  const uint32_t d = standing->n_active, b = standing->n_boundary;

  standing_assert (standing, frame->delaunay.n_active == d);
  if (standing->n_corners < 3) {
    standing_assert (standing, counts->triangles == 0);
    standing_assert (standing, counts->delaunay_edges == (d == 0 ? 0 : d - 1));
    return;
  }
  standing_assert (standing, counts->triangles == 2 * d - 2 - b);
  standing_assert (standing, counts->delaunay_edges == 3 * d - 3 - b);
  standing_assert (standing, counts->rays == b);
  standing_assert (standing, frame->delaunay.n_extreme == standing->n_corners);
}

static void
check_site_counts (const Frame *frame, const Standing *standing)
{
  const Trace *trace = frame->trace;
  uint32_t n_inserted = 0;

  for (uint32_t i = 0; i < frame->n_sites; i++) {
    const SiteState state = frame->sites[i].state;

    standing_assert (standing,
                     (trace->set->first[i] != i) == (state == SITE_DUPLICATE));
    n_inserted += trace->inserted[i] <= frame->step;
  }
  standing_assert (standing, frame->counts.n_inserted == n_inserted);
  standing_assert (standing, frame->counts.waiting
                                 == trace->set->n_distinct - n_inserted);
}

/* From the choice of a site to the last retirement nothing that stood before
 * the round leaves the picture and nothing joins its triangulation. */
static void
check_triangulation_waits (const Frame *frame, const Standing *standing)
{
  const RoundRow *row;
  uint32_t n_standing = 0;

  if (frame->round == INDEX_NONE)
    return;
  row = &frame->trace->rounds[frame->round];
  standing_assert (
      standing,
      frame->base
          == (frame->step < row->last_retire ? row->select - 1 : frame->step));
  for (uint32_t i = 0; i < frame->n_facets; i++)
    if (frame->facets[i].roles & FACET_STANDS) {
      standing_assert (standing,
                       frame->facets[i].facet == standing->facets[n_standing]);
      n_standing += 1;
    }
  standing_assert (standing, n_standing == standing->n_facets);
}

/* What the events so far say of a facet in the current round. */
static uint32_t
roles_by_events (const Frame *frame, uint32_t facet)
{
  uint32_t roles = 0;

  for (uint32_t step = frame->step; step > 0; step--) {
    const Event event = trace_event (frame->trace, step - 1);

    if (event.facet == facet && event.kind == EVENT_SELECT)
      roles |= FACET_SELECTED;
    if (event.facet == facet && event.kind == EVENT_VISIBLE)
      roles |= FACET_VISIBLE;
    if (event.facet == facet && event.kind == EVENT_CONE)
      roles |= FACET_CONE;
    if (event.facet == facet && event.kind == EVENT_RETIRE)
      roles |= FACET_RETIRED;
    if (event.kind == EVENT_SELECT)
      return roles;
  }
  return 0;
}

static void
check_roles (const Frame *frame, const Standing *standing)
{
  const bool is_inside = frame->base != frame->step;

  for (uint32_t facet = 0; facet < frame->trace->n_facets; facet++) {
    const uint32_t roles = frame_facet_roles (frame, facet) & ~FACET_STANDS;

    if (is_inside)
      standing_assert (standing, roles == roles_by_events (frame, facet));
    else
      standing_assert (standing, (roles & ~(uint32_t)FACET_NEW) == 0);
  }
}

/* Once all visible facets are found, the Voronoi vertices that die are those
 * whose circle holds the current site. */
static void
check_dying (const Frame *frame, const Standing *standing)
{
  const bool is_complete
      = frame->base != frame->step && frame->place.phase >= PHASE_HORIZON;

  for (uint32_t i = 0; i < frame->voronoi.n_vertices; i++) {
    const uint32_t triangle = frame->voronoi.vertices[i].triangle;
    const uint32_t *corner = frame->delaunay.triangles[triangle].site;

    if (is_complete)
      standing_assert (
          standing,
          frame->is_dying[i]
              == (judge_circle (standing->judge, corner,
                                frame->trace->rounds[frame->round].site)
                  < 0));
    else if (frame->base == frame->step)
      standing_assert (standing, !frame->is_dying[i]);
  }
}

static void
check_horizon (const Frame *frame, const Standing *standing)
{
  const RoundRow *row;

  if (frame->n_horizon == 0)
    return;
  row = &frame->trace->rounds[frame->round];
  standing_assert (standing, frame->n_horizon == frame->counts.horizon);
  for (uint32_t i = 0; i < frame->n_horizon; i++) {
    const Event event = trace_event (frame->trace, row->first_horizon - 1 + i);

    standing_assert (standing, frame->horizon[i].site[0] == event.ridge[0]);
    standing_assert (standing, frame->horizon[i].site[1] == event.ridge[1]);
    standing_assert (standing, frame->horizon[i].beyond == event.facet);
    standing_assert (standing, frame->sites[event.ridge[0]].is_changed);
  }
}

int
main (int argc, char **argv)
{
  static const struct {
    const char *name;
    CheckFrame check;
  } checks[] = {
    { "counts-of-the-round-follow-its-events", check_round_counts },
    { "counts-of-kinds-are-those-of-the-shadows", check_kind_counts },
    { "counts-of-diagrams-obey-euler", check_diagram_counts },
    { "every-distinct-site-waits-or-is-inserted", check_site_counts },
    { "the-triangulation-stays-until-the-last-retirement",
      check_triangulation_waits },
    { "roles-follow-the-events-of-the-round", check_roles },
    { "voronoi-vertices-die-whose-circle-holds-the-site", check_dying },
    { "the-horizon-grows-in-the-order-of-its-events", check_horizon },
  };

  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/frame/the-same-step-gives-the-same-bytes-from-any-way",
                   test_every_way);
  g_test_add_func ("/frame/no-two-steps-of-mixed8-have-one-hash",
                   test_hash_tells_steps_apart);
  for (guint i = 0; i < G_N_ELEMENTS (checks); i++) {
    g_autofree char *path = g_strconcat ("/frame/", checks[i].name, NULL);

    g_test_add_data_func (path, &checks[i].check, at_every_step);
  }
  return g_test_run ();
}
