/* The recorder: what it keeps, and what it refuses. */
#include "fixture.h"
#include "hull.h"
#include "insertion-cost.h"
#include "pseudocode.h"
#include "trace-recorder.h"

#include <string.h>

static void
check_spans (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  uint32_t i;

  for (i = 0; i < trace->n_facets; i++) {
    const FacetRow *row = &trace->facets[i];

    g_assert_cmpuint (row->span.birth, <, row->span.death);
    g_assert_cmpuint (row->span.death == STEP_NEVER, ==,
                      row->seen == STEP_NEVER);
    if (row->seen != STEP_NEVER) {
      g_assert_cmpuint (row->span.birth, <, row->seen);
      g_assert_cmpuint (row->seen, <, row->span.death);
    }
  }
  for (i = 0; i < trace->n_claims; i++)
    g_assert_cmpuint (trace_claim (trace, i).span.death, !=, STEP_NEVER);
}

static void
test_only_seen_facets_die (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_spans);
}

/* At the end of every round each standing facet has just three standing
 * pairs, each with its own edge. */
static void
check_ridges (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;

  for (uint32_t i = 0; i < trace->n_rounds; i++) {
    const uint32_t step = trace->rounds[i].end;
    g_autofree guint *n_ridges = g_new0 (guint, trace->n_facets);
    uint32_t k;

    for (k = 0; k < trace->n_ridges; k++)
      if (span_has (trace_ridge (trace, k).span, step)) {
        n_ridges[trace_ridge (trace, k).facet[0]] += 1;
        n_ridges[trace_ridge (trace, k).facet[1]] += 1;
      }
    for (k = 0; k < trace->n_facets; k++)
      g_assert_cmpuint (n_ridges[k], ==,
                        span_has (trace->facets[k].span, step) ? 3 : 0);
  }
}

static void
test_every_standing_facet_has_three_neighbours (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_ridges);
}

#define ASSERT_SAME_ROWS(a, b, rows)                                           \
  g_assert_cmpmem ((a)->rows, (a)->n_##rows * sizeof *(a)->rows, (b)->rows,    \
                   (b)->n_##rows * sizeof *(b)->rows)

/* All that a trace tells. */
static void
assert_same (const Trace *a, const Trace *b)
{
  ASSERT_SAME_ROWS (a, b, facets);
  ASSERT_SAME_ROWS (a, b, rounds);
  g_assert_cmpuint (a->n_events, ==, b->n_events);
  g_assert_cmpuint (a->n_ridges, ==, b->n_ridges);
  g_assert_cmpuint (a->n_claims, ==, b->n_claims);
  g_assert_cmpuint (a->simplex_end, ==, b->simplex_end);
  g_assert_cmpuint (a->start_end, ==, b->start_end);
  g_assert_cmpint (a->is_flat, ==, b->is_flat);
  g_assert_cmpmem (a->inserted, a->set->n_sites * sizeof *a->inserted,
                   b->inserted, b->set->n_sites * sizeof *b->inserted);
  for (uint32_t i = 0; i < a->n_events; i++) {
    const Event event = trace_event (a, i), other = trace_event (b, i);

    g_assert_cmpmem (&event, sizeof event, &other, sizeof other);
  }
}

static const char *
add (TraceRecorder *recorder, Event event)
{
  return trace_recorder_add (recorder, &event);
}

static void
test_events_fed_again_give_the_same_trace (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  TraceRecorder *recorder = trace_recorder_new (fixture->set, &trace->order);
  Trace *copy;

  for (uint32_t i = 0; i < trace->n_events; i++)
    g_assert_null (add (recorder, trace_event (trace, i)));
  copy = trace_recorder_finish (recorder);
  g_assert_nonnull (copy);
  assert_same (copy, trace);
  trace_free (copy);
}

/* The engine's own record, and that of a hook which hears each event. */
static void
check_recorded (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  TraceRecorder *recorder = trace_recorder_new (fixture->set, &trace->order);
  const HullHook hook = { trace_recorder_hook, recorder };
  Trace *heard;

  hull_build (fixture->set, &trace->order, &hook);
  heard = trace_recorder_finish (recorder);
  g_assert_nonnull (heard);
  assert_same (heard, trace);
  trace_free (heard);
}

static void
test_recorded_is_what_a_hook_hears (void)
{
  const OrderKind orders[] = { ORDER_FURTHEST, ORDER_RANDOM, ORDER_INPUT };

  for (guint i = 0; i < G_N_ELEMENTS (orders); i++)
    fixture_for_each (3, 40, orders[i], check_recorded);
}

/* What hears every event, and counts none. */
static void
on_event_kept (const Event *event, void *user)
{
  g_array_append_vals (user, event, 1);
}

/* Told from the log, an event is the one that was heard. */
static void
check_told (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  g_autoptr (GArray) events = g_array_new (FALSE, TRUE, sizeof (Event));
  const HullHook hook = { on_event_kept, events };

  hull_build (fixture->set, &trace->order, &hook);
  g_assert_cmpuint (events->len, ==, trace->n_events);
  for (guint i = 0; i < events->len; i++) {
    const Event event = trace_event (trace, i);

    g_assert_cmpmem (&event, sizeof event, &g_array_index (events, Event, i),
                     sizeof event);
  }
}

static void
test_told_is_what_was_heard (void)
{
  fixture_for_each (3, 40, ORDER_FURTHEST, check_told);
  fixture_for_each (3, 40, ORDER_HILBERT, check_told);
}

/* Feeds a trace with one event left out or doubled: every such trace breaks
 * a rule, at that event or later. */
static gboolean
is_accepted (const Fixture *fixture, uint32_t at, uint32_t n_times)
{
  const Trace *trace = fixture->trace;
  TraceRecorder *recorder = trace_recorder_new (fixture->set, &trace->order);
  const char *why = NULL;
  Trace *copy;
  gboolean is_whole;

  for (uint32_t i = 0; i < trace->n_events && why == NULL; i++)
    for (uint32_t k = 0; k < (i == at ? n_times : 1) && why == NULL; k++)
      why = add (recorder, trace_event (trace, i));
  copy = trace_recorder_finish (recorder);
  is_whole = why == NULL && copy != NULL;
  trace_free (copy);
  return is_whole;
}

static void
test_event_left_out_or_doubled_is_refused (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("grid9", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;

  g_assert_true (is_accepted (fixture, 0, 1));
  for (uint32_t i = 0; i < trace->n_events; i++) {
    g_assert_false (is_accepted (fixture, i, 2));
    g_assert_false (is_accepted (fixture, i, 0));
  }
}

static void
test_numbers_out_of_range_are_refused (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  const uint32_t wrong[] = { 9999, INDEX_NONE };

  for (uint32_t i = 0; i < trace->n_events; i++)
    for (guint k = 0; k < 2; k++) {
      TraceRecorder *recorder
          = trace_recorder_new (fixture->set, &trace->order);
      Event event = trace_event (trace, i);

      for (uint32_t before = 0; before < i; before++)
        g_assert_null (add (recorder, trace_event (trace, before)));
      if (event.kind != EVENT_COMPLETE) {
        event.facet = wrong[k];
        g_assert_nonnull (trace_recorder_add (recorder, &event));
      }
      trace_free (trace_recorder_finish (recorder));
    }
}

/* Feeds a trace with event @at changed.
 *
 * Returns: whether it is refused there. */
static gboolean
is_refused (const Fixture *fixture, uint32_t at, Event event)
{
  const Trace *trace = fixture->trace;
  TraceRecorder *recorder = trace_recorder_new (fixture->set, &trace->order);
  gboolean is_refused_there;

  for (uint32_t i = 0; i < at; i++)
    g_assert_null (add (recorder, trace_event (trace, i)));
  is_refused_there = add (recorder, event) != NULL;
  trace_free (trace_recorder_finish (recorder));
  return is_refused_there;
}

/* A facet that stands when a claim is told and is older than its round. */
static uint32_t
older_facet (const Trace *trace, uint32_t step)
{
  const uint32_t round = trace_round (trace, step) + 1;
  uint32_t facet = 0;

  while (facet < trace->n_facets
         && (trace->facets[facet].round == round
             || !span_has (trace->facets[facet].span, step)))
    facet++;
  return facet < trace->n_facets ? facet : INDEX_NONE;
}

static void
test_what_another_round_says_is_refused (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  guint n_older = 0;

  for (uint32_t i = trace->start_end; i < trace->n_events; i++) {
    Event event = trace_event (trace, i);

    if (event.kind == EVENT_VISIBLE || event.kind == EVENT_HORIZON
        || event.kind == EVENT_RETIRE) {
      event.site = (event.site + 1) % trace->set->n_sites;
      g_assert_true (is_refused (fixture, i, event));
    } else if (event.kind == EVENT_CLAIM) {
      event.facet = older_facet (trace, i);
      n_older += event.facet != INDEX_NONE;
      g_assert_true (is_refused (fixture, i, event));
    }
  }
  g_assert_cmpuint (n_older, >, 0);
}

static void
test_pseudocode_line_belongs_to_the_event (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;
  const char *word[N_EVENT_KINDS] = {
    [EVENT_SIMPLEX] = "simplex",   [EVENT_SELECT] = "furthest",
    [EVENT_VISIBLE] = "sees",      [EVENT_HORIZON] = "horizon",
    [EVENT_CONE] = "cone",         [EVENT_RETIRE] = "retire",
    [EVENT_COMPLETE] = "Delaunay",
  };
  uint32_t n_lines;
  const PseudocodeLine *lines = pseudocode_lines (&n_lines);

  g_assert_cmpuint (pseudocode_line (trace, 0), ==, INDEX_NONE);
  for (uint32_t step = 1; step <= trace->n_events; step++) {
    const EventKind kind = trace_event (trace, step - 1).kind;
    const uint32_t line = pseudocode_line (trace, step);

    g_assert_cmpuint (line, <, n_lines);
    if (word[kind] != NULL)
      g_assert_nonnull (strstr (lines[line].text, word[kind]));
    if (kind == EVENT_CLAIM)
      g_assert_nonnull (strstr (lines[line].text,
                                step <= trace->start_end ? "give" : "hand"));
  }
}

/* At every step the events so far have cost what is told of them. */
static void
check_cost (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  InsertionCost counted = { 0 };

  for (uint32_t step = 0; step <= trace->n_events; step++) {
    const InsertionCost cost = insertion_cost (trace, step);
    EventKind kind;

    g_assert_cmpuint (cost.facets_created, ==, counted.facets_created);
    g_assert_cmpuint (cost.facets_seen, ==, counted.facets_seen);
    g_assert_cmpuint (cost.redistributions, ==, counted.redistributions);
    if (step == trace->n_events)
      break;
    kind = trace_event (trace, step).kind;
    counted.facets_created += kind == EVENT_SIMPLEX || kind == EVENT_CONE;
    counted.facets_seen += kind == EVENT_VISIBLE;
    counted.redistributions += kind == EVENT_CLAIM && step >= trace->start_end;
  }
}

static void
test_cost (void)
{
  fixture_for_each (2, 20, ORDER_FURTHEST, check_cost);
  fixture_for_each (1, 20, ORDER_INPUT, check_cost);
}

/* Who listens to so many rounds and no more. */
typedef struct Listener {
  GArray *events;
  guint n_rounds, n_most;
} Listener;

static void
on_event (const Event *event, void *user)
{
  Listener *listener = user;

  listener->n_rounds += event->kind == EVENT_SELECT;
  g_array_append_val (listener->events, *event);
}

static bool
is_wanted (void *user)
{
  const Listener *listener = user;

  return listener->n_rounds < listener->n_most;
}

static void
check_given_up (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;
  g_autoptr (GArray) events = g_array_new (FALSE, TRUE, sizeof (Event));
  const HullHook hook = { on_event, &(Listener){ events, 0, 2 } };
  const gboolean is_whole
      = hull_build_while (trace->set, &trace->order, &hook, is_wanted);

  g_assert_cmpint (is_whole, ==, trace->n_rounds < 2);
  g_assert_cmpuint (events->len, ==,
                    is_whole ? trace->n_events : trace->rounds[1].end);
  for (guint i = 0; i < events->len; i++) {
    const Event *a = &g_array_index (events, Event, i);
    const Event b = trace_event (trace, i);

    g_assert_cmpint (a->kind, ==, b.kind);
    g_assert_cmpuint (a->facet, ==, b.facet);
    g_assert_cmpuint (a->site, ==, b.site);
  }
}

static void
test_given_up (void)
{
  fixture_for_each (3, 20, ORDER_FURTHEST, check_given_up);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/trace/only-seen-facets-die-and-all-claims-end",
                   test_only_seen_facets_die);
  g_test_add_func ("/trace/every-standing-facet-has-three-neighbours",
                   test_every_standing_facet_has_three_neighbours);
  g_test_add_func ("/trace/events-fed-again-give-the-same-trace",
                   test_events_fed_again_give_the_same_trace);
  g_test_add_func ("/trace/what-insertions-cost-is-what-the-events-say",
                   test_cost);
  g_test_add_func ("/trace/a-hull-that-is-given-up-ends-with-a-round",
                   test_given_up);
  g_test_add_func ("/trace/what-is-recorded-is-what-a-hook-hears",
                   test_recorded_is_what_a_hook_hears);
  g_test_add_func ("/trace/an-event-told-from-the-log-is-the-one-heard",
                   test_told_is_what_was_heard);
  g_test_add_func ("/trace/an-event-left-out-or-doubled-is-refused",
                   test_event_left_out_or_doubled_is_refused);
  g_test_add_func ("/trace/numbers-out-of-range-are-refused",
                   test_numbers_out_of_range_are_refused);
  g_test_add_func ("/trace/what-another-round-says-is-refused",
                   test_what_another_round_says_is_refused);
  g_test_add_func ("/pseudocode/the-marked-line-belongs-to-the-event",
                   test_pseudocode_line_belongs_to_the_event);
  return g_test_run ();
}
