/* You be QuickHull: what is legal, where choices lead, and the score. */
#include "performance.h"

#include "certify.h"
#include "fresh-sites.h"
#include "perform-judge.h"
#include "question-click.h"
#include "trace-recorder.h"

#include <string.h>

/* Performing */

static Performance *
begin (Run *run, guint n_insertions)
{
  const Occasion occasion
      = { .trace = run->trace, .step = run->trace->simplex_end, .round = 1 };

  return performance_new (run, &occasion, n_insertions, 0);
}

static Run *
run_of (const SiteSet *set)
{
  g_autofree Site *sites = g_new0 (Site, set->n_sites + 1);

  for (guint i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, i);
  return run_new (sites, set->n_sites, &(Order){ ORDER_FURTHEST, 0 });
}

/* Whether both hold the same objects. */
static gboolean
are_equal (const GArray *one, const GArray *other)
{
  guint n = 0;

  for (guint i = 0; i < one->len; i++)
    for (guint k = 0; k < other->len; k++)
      n += object_equal (g_array_index (one, Object, i),
                         g_array_index (other, Object, k));
  return n == one->len && n == other->len;
}

/* How often a choice was another than the engine's own. */
static guint n_other_choices;

/* One of the legal moves, or the one answer, as a person would give it. */
static Object
answer_as_judged (Performance *performance, const GArray *right, GRand *rand)
{
  Exercise *exercise = performance_task (performance)->exercise;
  const guint one = (guint)g_rand_int_range (rand, 0, (gint32)right->len);

  for (guint i = 0; i < right->len; i++)
    if (!exercise->question->click->is_any || i == one)
      g_assert_true (
          exercise_toggle (exercise, g_array_index (right, Object, i)));
  n_other_choices += exercise->question->click->is_any && one > 0;
  g_assert_true (exercise_check (exercise));
  return g_array_index (right, Object, one);
}

/* The current task: judged, and answered by a legal move. */
static void
do_task (Performance *performance, PerformJudge *judge, GRand *rand)
{
  const Task *task = performance_task (performance);
  g_autoptr (Answer) answer
      = answer_new (task->exercise->question, &task->exercise->occasion);
  g_autoptr (GArray) right = perform_judge_answer (judge, performance);
  g_autofree char *name = task_text (task);
  Object chosen;

  if (right->len == 0 || !are_equal (answer->objects, right))
    g_error ("%s: %u are right, and not these %u", name, right->len,
             answer->objects->len);
  chosen = answer_as_judged (performance, right, rand);
  if (!task->exercise->verdict->is_right)
    g_error ("%s: a legal move is not taken", name);
  perform_judge_follow (judge, performance, chosen);
  performance_settle (performance);
}

/* A whole performance by legal moves that a seed chooses. */
static Performance *
perform (Run *run, guint32 seed)
{
  Performance *performance = begin (run, run->trace->n_rounds);
  g_autoptr (PerformJudge) judge = perform_judge_new (run->set);
  GRand *rand = g_rand_new_with_seed (seed);

  do
    do_task (performance, judge, rand);
  while (performance_advance (performance));
  g_rand_free (rand);
  return performance;
}

/* What the run has become: a hull at the end of each round, by a record that
 * believes nothing. */
static void
check_run (const char *name, const Run *run)
{
  TraceRecorder *recorder = trace_recorder_new (run->set, &run->trace->order);
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  for (guint round = 0; round < run->trace->n_rounds; round++) {
    frame_init (&frame, run->trace, run->trace->rounds[round].end);
    if (!certify_frame (&frame, why))
      g_error ("%s, round %u: %s", name, round + 1, why);
    frame_clear (&frame);
  }
  for (guint i = 0; i < run->trace->n_events; i++) {
    const Event event = trace_event (run->trace, i);

    g_assert_null (trace_recorder_add (recorder, &event));
  }
  trace_free (trace_recorder_finish (recorder));
}

/* Every choice is an event of the run. */
static void
check_choices (const Performance *performance)
{
  const Trace *trace = performance->run->trace;

  for (guint i = 0; i < performance->choices->len; i++) {
    const HullChoice choice
        = g_array_index (performance->choices, HullChoice, i);
    guint n = 0;

    for (guint k = 0; k < trace->n_events; k++)
      n += trace_event (trace, k).kind == choice.kind
           && trace_event (trace, k).facet == choice.facet
           && trace_event (trace, k).site == choice.site;
    g_assert_cmpuint (n, ==, 1);
  }
}

static void
check_performance (const Fixture *fixture)
{
  for (guint32 seed = 1; seed <= 4; seed++) {
    g_autoptr (Run) run = run_of (fixture->set);
    g_autoptr (Performance) performance = NULL;
    PerformanceScore score;

    if (run->trace->n_rounds == 0)
      return;
    performance = perform (run, seed);
    score = performance_score (performance);
    g_assert_true (performance->is_over);
    g_assert_cmpuint (score.correct, ==, score.total);
    g_assert_cmpuint (score.undone + score.hinted, ==, 0);
    check_choices (performance);
    check_run (fixture->name, performance->run);
  }
}

static void
test_every_task_takes_exactly_what_is_legal (void)
{
  n_other_choices = 0;
  fixture_for_each (6, 11, ORDER_FURTHEST, check_performance);
  for (const char *const *name = fixture_names (); *name != NULL; name += 1) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    check_performance (fixture);
  }
  g_assert_cmpuint (n_other_choices, >, 100);
}

/* s4 and s5 tie, exactly: whichever is chosen is the apex. */
static void
test_a_tie_goes_as_it_was_chosen (void)
{
  for (guint site = 4; site < 6; site++) {
    g_autoptr (Fixture) fixture = fixture_load ("tie6", ORDER_FURTHEST);
    g_autoptr (Run) run = run_of (fixture->set);
    const Occasion occasion
        = { run->trace, run->trace->start_end, run->trace->start_end, 1 };
    g_autoptr (Performance) performance
        = performance_new (run, &occasion, 1, 0);
    const Object objects[] = { { OBJECT_FACET, run->trace->rounds[0].facet },
                               { OBJECT_SITE, site } };

    for (guint i = 0; i < 2; i++) {
      Exercise *exercise = performance_task (performance)->exercise;

      g_assert_true (exercise_toggle (exercise, objects[i]));
      exercise_check (exercise);
      g_assert_true (exercise->verdict->is_right);
      performance_settle (performance);
      g_assert_true (performance_advance (performance));
    }
    g_assert_cmpuint (performance->run->trace->rounds[0].site, ==, site);
  }
}

/* Who lets the engine choose has the engine's own run. */
static void
test_the_model_answer_is_the_engines_own_run (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  g_autoptr (Run) run = run_of (fixture->set);
  const Trace *trace = run->trace;
  g_autoptr (Performance) performance = begin (run, trace->n_rounds);

  performance_play (performance, TRUE);
  g_assert_true (performance->run == run);
  for (guint i = 0; i < trace->n_events; i++) {
    const Event event = trace_event (trace, i);
    const Event other = trace_event (fixture->trace, i);

    g_assert_cmpmem (&event, sizeof event, &other, sizeof other);
  }
}

/* The score */

static Run *
lecture (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);

  return run_of (fixture->set);
}

/* Four sites to hand over, then two rounds of five tasks, three sites and two
 * to hand over. */
static void
test_the_total_is_the_number_of_tasks (void)
{
  g_autoptr (Run) run = lecture ();
  g_autoptr (Performance) performance = begin (run, 2);
  guint n_tasks = 4 + 2 * 5;

  for (guint round = 0; round < 2; round++)
    n_tasks += run->trace->rounds[round].end
               - run->trace->rounds[round].last_retire;
  performance_play (performance, TRUE);
  g_assert_cmpuint (performance_score (performance).total, ==, n_tasks);
  g_assert_cmpuint (performance_score (performance).correct, ==, n_tasks);
  g_assert_cmpfloat (performance_fraction (performance), ==, 1);
}

static void
test_wrong_answers_score_nothing_and_end_as_well (void)
{
  g_autoptr (Run) run = lecture ();
  g_autoptr (Performance) wrong = begin (run, 3);
  g_autoptr (Performance) given_up = begin (run, 3);
  g_autoptr (Performance) right = begin (run, 3);

  performance_play (right, TRUE);
  performance_play (wrong, FALSE);
  performance_give_up (given_up);
  g_assert_true (wrong->is_over && given_up->is_over);
  g_assert_cmpuint (performance_score (wrong).correct, ==, 0);
  g_assert_cmpuint (performance_score (given_up).correct, ==, 0);
  g_assert_cmpuint (performance_score (wrong).total, ==,
                    performance_score (right).total);
  g_assert_cmpuint (performance_score (given_up).total, ==,
                    performance_score (right).total);
}

/* The first check counts; help and steps back are counted beside it. */
static void
test_the_first_check_counts (void)
{
  g_autoptr (Run) run = lecture ();
  const Occasion occasion
      = { run->trace, run->trace->start_end, run->trace->start_end, 1 };
  g_autoptr (Performance) performance = performance_new (run, &occasion, 1, 1);
  Exercise *exercise = performance_task (performance)->exercise;
  const Object right = { OBJECT_FACET, run->trace->rounds[0].facet };
  const Object wrong = { OBJECT_FACET, right.number == 0 ? 1 : 0 };
  PerformanceScore score;

  g_assert_true (exercise_hint (exercise));
  g_assert_true (exercise_toggle (exercise, right));
  g_assert_true (exercise_undo (exercise));
  g_assert_true (exercise_toggle (exercise, wrong));
  exercise_check (exercise);
  performance_settle (performance);
  g_assert_false (performance_advance (performance));
  g_assert_true (exercise->is_open);
  g_assert_true (exercise_toggle (exercise, right));
  exercise_check (exercise);
  g_assert_true (exercise->verdict->is_right);
  performance_settle (performance);
  g_assert_true (performance_advance (performance));
  score = performance_score (performance);
  g_assert_cmpuint (score.total, ==, 1);
  g_assert_cmpuint (score.correct, ==, 0);
  g_assert_cmpuint (score.undone, ==, 1);
  g_assert_cmpuint (score.hinted, ==, 1);
}

/* When it is over, all tasks can be looked at, both ways. */
static void
test_the_model_answer_is_browsed_both_ways (void)
{
  g_autoptr (Run) run = lecture ();
  g_autoptr (Performance) performance = begin (run, 1);
  guint n = 0;

  g_assert_false (performance_browse (performance, FALSE));
  performance_play (performance, TRUE);
  g_assert_false (performance_browse (performance, TRUE));
  while (performance_browse (performance, FALSE))
    n += 1;
  g_assert_cmpuint (n, ==, performance->tasks->len - 1);
  g_assert_cmpint (performance_shown (performance)->kind, ==, TASK_PARTITION);
  while (performance_browse (performance, TRUE))
    n -= 1;
  g_assert_cmpuint (n, ==, 0);
}

/* Nobody learns from a prompt or the first hint what is right. */
static void
test_a_wrong_hand_over_is_told_why (void)
{
  g_autoptr (Run) run = lecture ();
  g_autoptr (Performance) performance = begin (run, 1);
  Exercise *exercise;
  guint retiring;

  while (performance_task (performance)->kind != TASK_HAND_OVER) {
    exercise = performance_task (performance)->exercise;
    exercise_reveal (exercise);
    performance_settle (performance);
    g_assert_true (performance_advance (performance));
  }
  exercise = performance_task (performance)->exercise;
  retiring = run->trace->rounds[0].facet;
  g_assert_true (
      exercise_toggle (exercise, (Object){ OBJECT_FACET, retiring }));
  exercise_check (exercise);
  g_assert_nonnull (strstr (g_ptr_array_index (exercise->verdict->reasons, 0),
                            "it is visible and will retire"));
}

/* Fresh sites */

static void
test_the_same_seed_gives_the_same_sites (void)
{
  for (guint64 seed = 0; seed < 40; seed += 7) {
    guint64 one = seed, other = seed, next;
    g_autoptr (Run) first = fresh_sites_next ("random 7", 3, &one);
    g_autoptr (Run) second = fresh_sites_next ("random 7", 3, &other);
    g_autoptr (Run) third = NULL;

    g_assert_cmpuint (one, ==, other);
    g_assert_cmpuint (one, >, seed);
    g_assert_cmpuint (first->trace->n_rounds, >=, 3);
    g_assert_cmpmem (first->set->sites, 7 * sizeof (Site), second->set->sites,
                     7 * sizeof (Site));
    next = one;
    third = fresh_sites_next ("random 7", 3, &next);
    g_assert_cmpuint (next, >, one);
    g_assert_true (first->set->sites[0].x != third->set->sites[0].x
                   || first->set->sites[0].y != third->set->sites[0].y);
  }
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/performance/every-task-takes-exactly-what-is-legal",
    test_every_task_takes_exactly_what_is_legal },
  { "/performance/a-tie-goes-as-it-was-chosen",
    test_a_tie_goes_as_it_was_chosen },
  { "/performance/the-model-answer-is-the-engines-own-run",
    test_the_model_answer_is_the_engines_own_run },
  { "/performance/the-total-is-the-number-of-tasks",
    test_the_total_is_the_number_of_tasks },
  { "/performance/wrong-answers-score-nothing-and-end-as-well",
    test_wrong_answers_score_nothing_and_end_as_well },
  { "/performance/the-first-check-counts", test_the_first_check_counts },
  { "/performance/the-model-answer-is-browsed-both-ways",
    test_the_model_answer_is_browsed_both_ways },
  { "/performance/a-wrong-hand-over-is-told-why",
    test_a_wrong_hand_over_is_told_why },
  { "/performance/the-same-seed-gives-the-same-sites",
    test_the_same_seed_gives_the_same_sites },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
