/* Positions: what next, back and goto reach. */
#include "fixture.h"
#include "timeline.h"

static void
test_round_has_five_phases_in_order (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  const Phase phases[]
      = { PHASE_CHOOSE, PHASE_SEE, PHASE_HORIZON, PHASE_CONE, PHASE_HAND_OVER };
  uint32_t step = trace->start_end;
  uint32_t round, i;

  for (round = 1; round <= trace->n_rounds; round++)
    for (i = 0; i < G_N_ELEMENTS (phases); i++) {
      Place place;

      step = timeline_next (trace, step, GRAIN_PHASE);
      place = timeline_place (trace, step);
      g_assert_cmpuint (place.round, ==, round);
      g_assert_cmpint (place.phase, ==, phases[i]);
    }
  g_assert_cmpuint (trace->n_rounds, ==, 4);
  g_assert_cmpuint (timeline_next (trace, step, GRAIN_PHASE), ==,
                    trace->n_events);
}

static void
check_way_back (const Fixture *fixture)
{
  Grain grain;

  for (grain = GRAIN_EVENT; grain <= GRAIN_ROUND; grain++) {
    g_autoptr (GArray) way = g_array_new (FALSE, FALSE, sizeof (uint32_t));
    uint32_t step = 0;

    for (;;) {
      const uint32_t next = timeline_next (fixture->trace, step, grain);

      g_array_append_val (way, step);
      if (next == step)
        break;
      step = next;
    }
    g_assert_cmpuint (step, ==, fixture->trace->n_events);
    for (guint i = way->len - 1; i > 0; i--) {
      step = timeline_back (fixture->trace, step, grain);
      g_assert_cmpuint (step, ==, g_array_index (way, uint32_t, i - 1));
    }
    g_assert_cmpuint (timeline_back (fixture->trace, step, grain), ==, 0);
  }
}

static void
test_back_retraces_next (void)
{
  fixture_for_each (2, 12, ORDER_FURTHEST, check_way_back);
}

static void
test_goto_lands_after_the_last_event (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  uint32_t step = 0, before = 0;

  g_assert_true (timeline_find (trace, (Place){ 3, PHASE_SEE }, FALSE, &step));
  g_assert_true (timeline_find (trace, (Place){ 3, PHASE_SEE }, TRUE, &before));
  g_assert_cmpint (trace_event (trace, step - 1).kind, ==, EVENT_VISIBLE);
  g_assert_cmpint (trace_event (trace, step).kind, ==, EVENT_HORIZON);
  g_assert_cmpint (trace_event (trace, before).kind, ==, EVENT_VISIBLE);
  g_assert_cmpint (trace_event (trace, before - 1).kind, ==, EVENT_SELECT);
  g_assert_cmpuint (step - before, ==, 3);
}

static void
test_position_that_does_not_exist_is_not_found (void)
{
  g_autoptr (Fixture) lecture = fixture_load ("lecture8", ORDER_FURTHEST);
  g_autoptr (Fixture) flat = fixture_load ("square4", ORDER_FURTHEST);
  uint32_t step = 77;

  g_assert_false (
      timeline_find (lecture->trace, (Place){ 5, PHASE_SEE }, FALSE, &step));
  g_assert_false (
      timeline_find (lecture->trace, (Place){ 0, PHASE_SEE }, FALSE, &step));
  g_assert_false (
      timeline_find (flat->trace, (Place){ 1, PHASE_CHOOSE }, FALSE, &step));
  g_assert_cmpuint (step, ==, 77);
}

static void
test_triangulation_changes_only_when_the_last_facet_retires (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;

  for (uint32_t i = 0; i < trace->n_rounds; i++) {
    const RoundRow *round = &trace->rounds[i];

    g_assert_cmpuint (trace_base (trace, round->select), ==, round->select - 1);
    g_assert_cmpuint (trace_base (trace, round->last_retire - 1), ==,
                      round->select - 1);
    g_assert_cmpuint (trace_base (trace, round->last_retire), ==,
                      round->last_retire);
  }
}

static void
test_phase_names_read_back (void)
{
  for (Phase phase = PHASE_START; phase <= PHASE_COMPLETE; phase++) {
    Phase read = PHASE_START;

    g_assert_true (phase_parse (phase_name (phase), &read));
    g_assert_cmpint (read, ==, phase);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/timeline/a-round-has-five-phases-in-order",
                   test_round_has_five_phases_in_order);
  g_test_add_func ("/timeline/back-retraces-next", test_back_retraces_next);
  g_test_add_func ("/timeline/goto-lands-after-the-last-event-of-a-phase",
                   test_goto_lands_after_the_last_event);
  g_test_add_func ("/timeline/a-position-that-does-not-exist-is-not-found",
                   test_position_that_does_not_exist_is_not_found);
  g_test_add_func ("/timeline/the-base-moves-only-when-the-last-facet-retires",
                   test_triangulation_changes_only_when_the_last_facet_retires);
  g_test_add_func ("/timeline/phase-names-read-back",
                   test_phase_names_read_back);
  return g_test_run ();
}
