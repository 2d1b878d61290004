/* Progress: what is written down, and recalled another time. */
#include "learner.h"

#include <string.h>

static void
test_what_was_answered_is_answered_the_next_time (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  const Exercise *exercise;

  learner_answer_all (session);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
  g_assert_cmpint (learner_record (session, 1)->outcome, ==, OUTCOME_AT_ONCE);
  g_assert_cmpint (learner_record (session, 2)->outcome, ==, OUTCOME_SHOWN);
  exercise = session_get_exercise_of (session, 1);
  g_assert_false (exercise->is_open);
  g_assert_true (exercise->verdict->is_right);
  g_assert_cmpuint (exercise->attempt->objects->len, ==, 2);
  exercise = session_get_exercise_of (session, 2);
  g_assert_true (exercise->is_shown);
  g_assert_cmpuint (exercise->n_undone, ==, 1);
  g_assert_cmpint (g_array_index (exercise->attempt->numbers, gint64, 0), ==,
                   90);
  g_assert_false (session_get_exercise_of (session, 3)->is_open);
  learner_end (session);
}

static void
test_a_person_goes_on_where_they_were (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  guint stop;

  g_assert_false (session_can_resume (session, NULL));
  session_set_stop (session, 2);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  g_assert_true (session_can_resume (session, &stop));
  g_assert_cmpuint (stop, ==, 2);
  learner_act (session, "resume", NULL);
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  g_assert_false (session_can_resume (session, NULL));
  /* Who went back to the start of it begins there. */
  session_set_stop (session, 0);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  g_assert_false (session_can_resume (session, NULL));
  g_assert_cmpuint (session_get_record (session)->furthest, ==, 2);
  learner_end (session);
}

static void
test_opening_a_lesson_keeps_the_place (void)
{
  Session *session = learner_start (LEARNER_LESSON);

  session_set_stop (session, 3);
  learner_end (session);
  for (guint i = 0; i < 2; i++) {
    session = learner_start (LEARNER_LESSON);
    g_assert_cmpuint (session_get_record (session)->stop, ==, 3);
    learner_end (session);
  }
}

/* A hint, and a wrong check before, are help; a start of the program between
 * does not wipe them out. */
static void
test_help_is_remembered_before_the_answer (void)
{
  Session *session = learner_start (LEARNER_LESSON);

  session_set_stop (session, 1);
  learner_answer (session, "f0");
  g_assert_true (session_get_exercise (session)->is_open);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  learner_act (session, "resume", NULL);
  g_assert_cmpuint (session_get_exercise (session)->n_checks, ==, 1);
  learner_answer (session, "f0 f1");
  g_assert_cmpint (learner_record (session, 1)->outcome, ==,
                   OUTCOME_AFTER_HELP);
  g_assert_cmpuint (learner_record (session, 1)->total, ==, 2);
  g_assert_cmpuint (learner_record (session, 1)->correct, ==, 1);
  learner_end (session);
}

static void
test_the_first_answer_stays (void)
{
  Session *session = learner_start (LEARNER_LESSON);

  session_set_stop (session, 1);
  learner_answer (session, "f0 f1");
  learner_act (session, "retry", NULL);
  learner_act (session, "show-answer", NULL);
  g_assert_cmpint (learner_record (session, 1)->outcome, ==, OUTCOME_AT_ONCE);
  session_set_stop (session, 2);
  learner_act (session, "show-answer", NULL);
  g_assert_cmpint (learner_record (session, 2)->outcome, ==, OUTCOME_SHOWN);
  learner_act (session, "retry", NULL);
  learner_act (session, "answer-number", g_variant_new ("(uu)", 1, 1));
  learner_act (session, "check", NULL);
  g_assert_cmpint (learner_record (session, 2)->outcome, ==, OUTCOME_SHOWN);
  learner_end (session);
}

/* An edited lesson: a question that moved keeps its credit, another in its
 * place gets none, and neither does the same about other sites. */
static void
test_credit_belongs_to_what_was_asked (void)
{
  static const char edited[]
      = LECTURE "## Start\n\n```steps\ngoto start\n```\n\n## New\n\n```ask\n"
                "before round 1 see\nclick dying-triangles\n```\n\n"
                "## Later\n\n```steps\ngoto start\n```\n\n"
                "## Reworded\n\n```ask\nbefore round 2 see\n"
                "prompt In other words?\nnumber visible cone\n```\n";
  static const char elsewhere[] = HEAD LEARNER_WHICH;
  Session *session = learner_start (LEARNER_LESSON);

  session_set_stop (session, 1);
  learner_answer (session, "f0 f1");
  session_set_stop (session, 2);
  learner_act (session, "show-answer", NULL);
  learner_end (session);
  session = learner_start (edited);
  g_assert_cmpint (learner_record (session, 1)->outcome, ==, OUTCOME_OPEN);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  g_assert_cmpint (learner_record (session, 3)->outcome, ==, OUTCOME_SHOWN);
  g_object_unref (session);
  session = learner_start (elsewhere);
  g_assert_true (session_get_exercise_of (session, 0)->is_open);
  g_object_unref (session);
}

/* The picture is that after the answer, not that of the open question. */
static void
test_a_first_stop_that_was_answered_shows_its_end (void)
{
  static const char text[]
      = LECTURE LEARNER_WHICH "```steps\ngoto round 1 see\n```\n";
  Session *session = learner_start (text);
  guint step;

  learner_answer (session, "f0 f1");
  step = session_get_step (session);
  learner_end (session);
  session = learner_start (text);
  g_assert_cmpuint (session_get_step (session), ==, step);
  g_assert_false (session_is_asking (session));
  g_assert_cmpuint (session_get_look (session)->mask, ==, 0);
  learner_end (session);
}

static void
test_drags_are_recalled_with_their_sites (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  g_autoptr (Attempt) model = NULL;
  const Exercise *exercise;
  Site to;

  session_set_stop (session, 3);
  exercise = session_get_exercise (session);
  model = answer_model (exercise->question, &exercise->occasion);
  to = site_set_given (model->run->set, 7);
  session_begin_edit (session);
  g_assert_true (session_move_site (session, 7, to, NULL));
  session_end_edit (session);
  g_assert_cmpint (learner_record (session, 3)->outcome, ==, OUTCOME_AT_ONCE);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  exercise = session_get_exercise_of (session, 3);
  g_assert_true (exercise->verdict->is_right);
  g_assert_cmpfloat (site_set_given (exercise->attempt->run->set, 7).x, ==,
                     to.x);
  learner_end (session);
}

/* A performance has a score of its own; the first one counts. */
static void
test_the_score_of_a_performance_is_kept (void)
{
  static const char text[]
      = LECTURE "## Exam\n\n```ask\nbefore round 1\nperform 2\n```\n";
  Session *session = learner_start (text);
  const Exercise *exercise;
  const QuestionRecord *record;
  guint total;

  while (session_can_grade (session))
    g_assert_true (session_grade (session));
  record = learner_record (session, 0);
  total = record->total;
  g_assert_cmpint (record->outcome, ==, OUTCOME_SHOWN);
  g_assert_cmpuint (total, >, 4);
  g_assert_cmpuint (record->correct, ==, 0);
  learner_end (session);
  session = learner_start (text);
  record = learner_record (session, 0);
  g_assert_cmpuint (record->total, ==, total);
  exercise = session_get_exercise_of (session, 0);
  g_assert_false (exercise->is_open);
  g_assert_cmpuint (exercise->verdict->total, ==, total);
  g_assert_true (session_can_browse (session, FALSE));
  learner_end (session);
}

static const LearnerTest tests[] = {
  { "/progress/what-was-answered-is-answered-the-next-time",
    test_what_was_answered_is_answered_the_next_time },
  { "/progress/a-person-goes-on-where-they-were",
    test_a_person_goes_on_where_they_were },
  { "/progress/opening-a-lesson-keeps-the-place",
    test_opening_a_lesson_keeps_the_place },
  { "/progress/help-is-remembered-before-the-answer",
    test_help_is_remembered_before_the_answer },
  { "/progress/the-first-answer-stays", test_the_first_answer_stays },
  { "/progress/credit-belongs-to-what-was-asked",
    test_credit_belongs_to_what_was_asked },
  { "/progress/a-first-stop-that-was-answered-shows-its-end",
    test_a_first_stop_that_was_answered_shows_its_end },
  { "/progress/drags-are-recalled-with-their-sites",
    test_drags_are_recalled_with_their_sites },
  { "/progress/the-score-of-a-performance-is-kept",
    test_the_score_of_a_performance_is_kept },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  learner_add_tests (tests, G_N_ELEMENTS (tests));
  return learner_test_run ();
}
