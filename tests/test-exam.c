/* A performance in a session: what is shown of it, and the way through. */
#include "action.h"
#include "learner.h"
#include "progress.h"

#include <string.h>

static const char lesson_text[]
    = LECTURE "## Look\n\n```steps\ngoto start\n```\n\n"
              "## Perform\n\n```ask\nstart\nperform 2\nfresh random 7 seed 3\n"
              "```\n\n"
              "## After\n\n```steps\ngoto complete\n```\n";

static Session *
begin (void)
{
  Session *session = learner_open (lesson_text, NULL);

  session_set_stop (session, 1);
  return session;
}

static void
assert_text (Session *session, const char *name, const char *text)
{
  g_autoptr (GVariant) value
      = g_variant_ref_sink (action_get_state (action_find (name), session));

  g_assert_cmpstr (g_variant_get_string (value, NULL), ==, text);
}

static PerformanceScore
score_of (Session *session)
{
  return performance_score (session_get_performance (session));
}

/* Answers the current task as the engine would. */
static void
answer (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);
  g_autoptr (Answer) right
      = answer_new (exercise->question, &exercise->occasion);

  for (guint i = 0; i < (right->is_any ? 1 : right->objects->len); i++)
    g_assert_true (session_answer_toggle (
        session, g_array_index (right->objects, Object, i)));
  learner_act (session, "check", NULL);
}

static void
perform_all (Session *session)
{
  for (guint i = 0; !session_get_performance (session)->is_over; i++) {
    g_assert_cmpuint (i, <, 100);
    if (session_get_exercise (session)->is_open)
      answer (session);
    else
      learner_act (session, "continue", NULL);
  }
}

static void
test_a_stop_is_performed_task_by_task (void)
{
  static const char *const tasks[]
      = { "partition s4",        "partition s5",    "partition s6",
          "partition s7",        "round 1 facet",   "round 1 site",
          "round 1 see",         "round 1 horizon", "round 1 cone",
          "round 1 hand-over s5" };
  g_autoptr (Session) session = begin ();

  assert_text (session, "performance", "open");
  for (guint i = 0; i < G_N_ELEMENTS (tasks); i++) {
    assert_text (session, "task", tasks[i]);
    answer (session);
    learner_act (session, "continue", NULL);
  }
  perform_all (session);
  assert_text (session, "performance", "over");
  g_assert_cmpuint (score_of (session).correct, ==, score_of (session).total);
  g_assert_true (session_get_exercise_of (session, 1)->verdict->is_right);
}

/* Whatever is tried, no step beyond the current task is shown, and what it
 * asks about is masked. */
static void
test_nothing_beyond_the_task_is_shown (void)
{
  g_autoptr (Session) session = begin ();

  while (!session_get_performance (session)->is_over) {
    const Exercise *exercise = session_get_exercise (session);
    const guint step = session_get_step (session);

    if (exercise->is_open) {
      g_autofree char *sentence = session_narrate (session);

      g_assert_true (session_is_asking (session));
      g_assert_nonnull (strstr (sentence, "What happens here?"));
      g_assert_cmpuint (session_get_look (session)->mask & MASK_WHY, ==,
                        MASK_WHY);
    }
    session_set_step (session, session_get_n_steps (session));
    g_assert_cmpuint (session_get_step (session), ==, step);
    learner_act (session, "goto", g_variant_new_string ("complete"));
    g_assert_cmpuint (session_get_step (session), ==, step);
    if (exercise->is_open)
      answer (session);
    else
      learner_act (session, "continue", NULL);
  }
}

/* Page Down alone gets through, and scores nothing. */
static void
test_a_clicker_gets_through (void)
{
  g_autoptr (Session) session = begin ();

  for (guint i = 0; i < 200 && session_get_stop (session) == 1; i++)
    g_assert_true (session_next (session));
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  g_assert_true (session_set_stop (session, 1));
  assert_text (session, "performance", "over");
  g_assert_cmpuint (score_of (session).correct, ==, 0);
}

/* Looking at an earlier step is allowed; the task is there when one comes
 * back, and when one comes back from another stop. */
static void
test_the_task_stays_while_one_looks_around (void)
{
  g_autoptr (Session) session = begin ();

  for (guint i = 0; i < 12; i++)
    learner_act (session, i % 2 == 0 ? "show-answer" : "continue", NULL);
  assert_text (session, "task", "round 1 see");
  session_set_step (session, 0);
  g_assert_false (session_is_asking (session));
  g_assert_true (session_next (session));
  g_assert_true (session_is_asking (session));
  session_set_stop (session, 0);
  session_set_stop (session, 1);
  assert_text (session, "task", "round 1 see");
  g_assert_true (session_is_asking (session));
  g_assert_null (session_get_undo_label (session));
}

static void
test_what_is_left_can_be_given_up (void)
{
  g_autoptr (Session) session = begin ();
  guint total;

  answer (session);
  learner_act (session, "grade", NULL);
  assert_text (session, "performance", "over");
  total = score_of (session).total;
  g_assert_cmpuint (score_of (session).correct, ==, 1);
  learner_act (session, "retry", NULL);
  assert_text (session, "performance", "open");
  perform_all (session);
  g_assert_cmpuint (score_of (session).total, ==, total);
  g_assert_cmpuint (score_of (session).correct, ==, total);
}

static void
test_browsing_shows_each_task_with_its_answer (void)
{
  g_autoptr (Session) session = begin ();
  const Performance *performance = session_get_performance (session);
  guint n = 0;

  learner_act (session, "grade", NULL);
  while (session_can_browse (session, FALSE)) {
    const Exercise *exercise = session_get_exercise (session);

    g_assert_cmpuint (session_get_step (session), ==,
                      exercise->occasion.reveal);
    g_assert_cmpuint (session_get_look (session)->n_answers, >, 0);
    learner_act (session, "previous-task", NULL);
    n += 1;
  }
  g_assert_cmpuint (n, ==, performance->tasks->len - 1);
  learner_act (session, "next-task", NULL);
  assert_text (session, "task", "partition s5");
}

/* New sites after grading, the same for the same seed; and those of the lesson
 * when one goes back. */
static void
test_fresh_sites_follow_the_grading (void)
{
  g_autoptr (Session) one = begin ();
  g_autoptr (Session) other = begin ();
  g_autofree char *sites = NULL;

  g_assert_false (session_can_another (one));
  learner_act (one, "grade", NULL);
  learner_act (other, "grade", NULL);
  learner_act (one, "another", NULL);
  learner_act (other, "another", NULL);
  g_assert_cmpuint (session_get_set (one)->n_sites, ==, 7);
  g_assert_cmpmem (session_get_set (one)->sites, 7 * sizeof (Site),
                   session_get_set (other)->sites, 7 * sizeof (Site));
  sites = session_performance_sites (one);
  g_assert_true (g_str_has_prefix (sites, "random 7 seed "));
  perform_all (one);
  assert_text (one, "performance", "over");
  session_set_stop (one, 1);
  g_assert_cmpuint (session_get_set (one)->n_sites, ==, 8);
}

/* What is remembered of a performance at any task is enough to go on with, and
 * a file that somebody has changed does no harm. */
static void
test_a_performance_goes_on_where_it_was_left (void)
{
  g_autoptr (Session) session = begin ();
  const Exercise *whole = session_get_exercise_of (session, 1);

  for (guint i = 0; !whole->performance->is_over; i++) {
    g_autoptr (Exercise) again
        = exercise_new (whole->question, whole->run, &whole->occasion);
    QuestionRecord record = { 0 };
    g_autofree char *task = NULL, *task_again = NULL;

    if (i % 5 == 2)
      learner_act (session, "show-answer", NULL);
    else
      answer (session);
    question_record_take (&record, whole);
    question_record_restore (&record, again);
    g_assert_cmpmem (
        &whole->performance->run->trace->rounds[0], sizeof (RoundRow),
        &again->performance->run->trace->rounds[0], sizeof (RoundRow));
    g_assert_cmpuint (performance_score (again->performance).total, ==, i + 1);
    g_assert_cmpuint (performance_score (again->performance).correct, ==,
                      score_of (session).correct);
    g_assert_cmpint (again->is_open, ==, whole->is_open);
    if (!whole->performance->is_over)
      learner_act (session, "continue", NULL);
    task = task_text (performance_task (whole->performance));
    task_again = task_text (performance_task (again->performance));
    g_assert_cmpstr (task, ==, task_again);
    json_object_set_int_member (record.memory, "tasks", 5);
    question_record_restore (&record, again);
    g_clear_pointer (&record.memory, json_object_unref);
  }
}

/* On a person's own sites */

static void
test_any_sites_can_be_performed_on (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;

  g_assert_false (
      action_run (session, "perform", g_variant_new_string (""), &error));
  g_assert_nonnull (strstr (error->message, "add sites, at least five"));
  learner_act (session, "sites", g_variant_new_string ("random 6 seed 1"));
  learner_act (session, "order", g_variant_new_string ("input"));
  learner_act (session, "perform", g_variant_new_string (""));
  perform_all (session);
  assert_text (session, "performance", "over");
  learner_act (session, "end-performance", NULL);
  assert_text (session, "performance", "none");
  learner_act (session, "perform", g_variant_new_string ("random 7 seed 4"));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 7);
  learner_act (session, "undo", NULL);
  assert_text (session, "performance", "none");
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 6);
}

/* Nothing is half done. */
static void
test_sources_without_a_seed_are_refused (void)
{
  static const char *const sources[]
      = { "random 7", "grid 3 3", "random 300 seed 1",
          "nonsense", "0 0; 1 0", "random 4 seed 1" };
  g_autoptr (Session) session = begin ();

  for (guint i = 0; i < G_N_ELEMENTS (sources); i++) {
    g_autoptr (GError) error = NULL;

    g_assert_false (action_run (session, "perform",
                                g_variant_new_string (sources[i]), &error));
    g_assert_nonnull (error);
    g_assert_nonnull (session_get_lesson (session));
    g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
  }
}

static void
test_an_edit_ends_a_performance_on_own_sites (void)
{
  g_autoptr (Session) session = session_new ();

  learner_act (session, "perform", g_variant_new_string ("random 7 seed 4"));
  learner_act (session, "add-site", g_variant_new ("(dd)", 0.3, 0.1));
  assert_text (session, "performance", "none");
  g_assert_null (session_get_exercise (session));
}

/* In a lesson, on sites that a person has changed */

static void
assert_own (Session *session)
{
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 9);
  g_assert_cmpfloat (session_get_set (session)->sites[8].x, ==, 0.3125);
}

static Session *
begin_with_own_sites (guint stop)
{
  Session *session = begin ();

  session_set_stop (session, stop);
  learner_act (session, "add-site", g_variant_new ("(dd)", 0.3125, 0.0625));
  assert_own (session);
  return session;
}

/* Undoes one edit, whose label says @what. */
static void
undo (Session *session, const char *what)
{
  const char *label = session_get_undo_label (session);

  g_assert_nonnull (label);
  g_assert_nonnull (strstr (label, what));
  learner_act (session, "undo", NULL);
}

static void
test_own_sites_outlast_a_performance_on_them (void)
{
  g_autoptr (Session) session = begin_with_own_sites (0);

  learner_act (session, "perform", g_variant_new_string (""));
  assert_own (session);
  perform_all (session);
  session_set_stop (session, 2);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
  undo (session, "return to the lesson’s sites");
  assert_own (session);
  undo (session, "adding s8");
  g_assert_null (session_get_undo_label (session));
}

static void
test_own_sites_outlast_leaving_a_performance (void)
{
  g_autoptr (Session) session = begin_with_own_sites (0);

  learner_act (session, "perform", g_variant_new_string (""));
  answer (session);
  learner_act (session, "end-performance", NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
  undo (session, "return to the lesson’s sites");
  assert_own (session);
}

static void
test_own_sites_outlast_fresh_ones (void)
{
  g_autoptr (Session) session = begin_with_own_sites (0);

  learner_act (session, "perform", g_variant_new_string (""));
  learner_act (session, "grade", NULL);
  learner_act (session, "another", NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, !=, 9);
  learner_act (session, "grade", NULL);
  learner_act (session, "another", NULL);
  undo (session, "generating sites");
  assert_own (session);
  assert_text (session, "performance", "none");
  undo (session, "adding s8");

  learner_act (session, "add-site", g_variant_new ("(dd)", 0.3125, 0.0625));
  learner_act (session, "perform", g_variant_new_string ("random 7 seed 4"));
  undo (session, "generating sites");
  assert_own (session);
}

/* The stop's own performance goes on on its own sites. */
static void
test_own_sites_outlast_the_performance_of_the_stop (void)
{
  g_autoptr (Session) session = begin_with_own_sites (1);

  learner_act (session, "grade", NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
  undo (session, "return to the lesson’s sites");
  assert_own (session);
  learner_act (session, "another", NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 7);
  undo (session, "generating sites");
  assert_own (session);
}

static void
test_sites_of_the_lesson_are_nothing_to_undo (void)
{
  g_autoptr (Session) session = begin ();

  learner_act (session, "grade", NULL);
  learner_act (session, "another", NULL);
  learner_act (session, "grade", NULL);
  learner_act (session, "another", NULL);
  session_set_stop (session, 0);
  learner_act (session, "order", g_variant_new_string ("input"));
  learner_act (session, "perform", g_variant_new_string (""));
  answer (session);
  session_set_stop (session, 2);
  g_assert_null (session_get_undo_label (session));
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/exam/a-stop-is-performed-task-by-task",
    test_a_stop_is_performed_task_by_task },
  { "/exam/nothing-beyond-the-task-is-shown",
    test_nothing_beyond_the_task_is_shown },
  { "/exam/a-clicker-gets-through", test_a_clicker_gets_through },
  { "/exam/the-task-stays-while-one-looks-around",
    test_the_task_stays_while_one_looks_around },
  { "/exam/what-is-left-can-be-given-up", test_what_is_left_can_be_given_up },
  { "/exam/browsing-shows-each-task-with-its-answer",
    test_browsing_shows_each_task_with_its_answer },
  { "/exam/fresh-sites-follow-the-grading",
    test_fresh_sites_follow_the_grading },
  { "/exam/a-performance-goes-on-where-it-was-left",
    test_a_performance_goes_on_where_it_was_left },
  { "/exam/any-sites-can-be-performed-on", test_any_sites_can_be_performed_on },
  { "/exam/sources-without-a-seed-are-refused",
    test_sources_without_a_seed_are_refused },
  { "/exam/own-sites-outlast-a-performance-on-them",
    test_own_sites_outlast_a_performance_on_them },
  { "/exam/own-sites-outlast-leaving-a-performance",
    test_own_sites_outlast_leaving_a_performance },
  { "/exam/own-sites-outlast-fresh-ones", test_own_sites_outlast_fresh_ones },
  { "/exam/own-sites-outlast-the-performance-of-the-stop",
    test_own_sites_outlast_the_performance_of_the_stop },
  { "/exam/sites-of-the-lesson-are-nothing-to-undo",
    test_sites_of_the_lesson_are_nothing_to_undo },
  { "/exam/an-edit-ends-a-performance-on-own-sites",
    test_an_edit_ends_a_performance_on_own_sites },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
