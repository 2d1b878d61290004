/* What pictures show, the legend explains: at every stop of every lesson, and
 * wherever else marks come up. */
#include "action.h"
#include "command.h"
#include "document.h"
#include "legend-judge.h"
#include "locate.h"

/* Lessons */

/* All that can be clicked is chosen, and nothing of it right. */
static void
answer_anything (Session *session)
{
  for (int kind = OBJECT_NONE + 1; kind <= OBJECT_VERTEX; kind++)
    for (guint number = 0; number < 5; number++)
      session_answer_toggle (session, (Object){ (ObjectKind)kind, number });
}

static void
check_question (Session *session, const char *name, guint stop)
{
  answer_anything (session);
  legend_judge (session, name, stop);
  session_check (session);
  legend_judge (session, name, stop);
  session_reveal (session);
  legend_judge (session, name, stop);
}

static void
check_stop (Session *session, const char *name, guint stop)
{
  const Performance *performance;

  session_set_stop (session, stop);
  legend_judge (session, name, stop);
  performance = session_get_performance (session);
  if (performance == NULL && session_get_exercise (session) != NULL)
    check_question (session, name, stop);
  for (guint i = 0; performance != NULL && !performance->is_over && i < 12;
       i++) {
    check_question (session, name, stop);
    session_continue (session);
    performance = session_get_performance (session);
  }
}

static void
test_lessons (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  legend_judge_open ();
  g_assert_cmpuint (paths->len, >=, 15);
  for (guint i = 0; i < paths->len; i++) {
    g_autoptr (Session) session = session_new ();
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *name = g_path_get_basename (path);

    g_assert_true (document_open (session, path, NULL));
    for (guint stop = 0; stop < session_get_n_stops (session); stop++)
      check_stop (session, name, stop);
  }
  legend_judge_close ();
}

/* Free states */

static const char *const states[][8] = {
  { "sites random 12 seed 7", "compare furthest input", "goto round 4 cone" },
  { "sites random 12 seed 7", "compare furthest input", "goto round 5",
    "select s3" },
  { "sites random 12 seed 7", "view planar", "goto round 2 choose" },
  { "sites random 12 seed 7", "view planar", "goto round 2 see" },
  { "sites random 12 seed 7", "view planar", "goto round 2 cone" },
  { "sites random 12 seed 7", "view planar" },
  { "rounding fig2a" },
  { "rounding A1", "view rounded" },
  { "rounding A1", "view rounded", "goto round 3" },
  { "sites random 12 seed 7", "show why", "select f39", "measure s7" },
  { "sites random 12 seed 7", "show why", "select f39", "measure s2",
    "show circumcircles", "show furthest", "show tangents" },
  { "sites random 12 seed 7", "show why", "select f30", "measure s2",
    "show circumcircles", "hide voronoi", "show furthest", "show tangents" },
  { "sites random 12 seed 7", "hide voronoi", "hide hull", "show tangents" },
  { "sites random 12 seed 7", "goto round 4 choose", "show why", "measure s2" },
  { "sites random 12 seed 7", "goto round 4 see", "show circumcircles" },
  { "sites random 12 seed 7", "goto round 4 horizon", "show why", "select f7",
    "measure s5" },
  { "sites random 12 seed 7", "goto round 4 cone", "show why", "select f7",
    "measure s2" },
  { "sites random 12 seed 7", "goto round 4 hand-over", "lift 0.5" },
  { "sites random 12 seed 7", "goto round 4 horizon", "focus visible" },
  { "sites grid 4 3", "goto round 3 cone", "focus visible" },
  { "sites grid 4 3", "select f3" },
  { "sites grid 4 3", "goto round 3 see", "show why" },
  { "sites grid 4 3", "goto round 4 cone", "show furthest" },
  { "sites circle 12" },
  { "sites line 5" },
  { "sites 0.1 0.1; 0.1 0.1; -0.3 0.4; 0.5 0.2; 0 -0.6; -0.4 -0.1" },
  { "sites 0 0" },
  { "sites random 12 seed 7", "goto start" },
  { "sites random 12 seed 7", "goto simplex" },
};

static void
run (Session *session, const char *text)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GVariant) parameter = NULL;
  g_autofree char *verb = NULL;

  command_parse (text, &verb, &parameter, &error);
  g_assert_no_error (error);
  action_run (session, verb, parameter, &error);
  g_assert_no_error (error);
}

/* The pointer on things of each kind; then on none, where a site would be. */
static void
point_around (Session *session, guint state)
{
  static const Site places[] = { { 0.1, 0.15 }, { -0.2, 0.3 }, { 1.2, 1.1 } };
  const char *what = states[state][1];

  for (int kind = OBJECT_NONE + 1; kind <= OBJECT_VERTEX; kind++)
    for (guint number = 0; number < 40; number += 9) {
      session_set_hover (session, (Object){ (ObjectKind)kind, number });
      legend_judge (session, what != NULL ? what : "hover", state);
      session_set_selection (session, (Object){ (ObjectKind)kind, number + 3 });
      legend_judge (session, what != NULL ? what : "hover, selected", state);
      session_set_selection (session, (Object){ OBJECT_NONE, 0 });
    }
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  for (guint i = 0; i < G_N_ELEMENTS (places); i++) {
    session_set_preview (session, &places[i]);
    legend_judge (session, "preview", state);
  }
  session_set_preview (session, NULL);
}

static void
test_free_states (void)
{
  legend_judge_open ();
  for (guint i = 0; i < G_N_ELEMENTS (states); i++) {
    g_autoptr (Session) session = session_new ();

    for (guint k = 0; k < 8 && states[i][k] != NULL; k++)
      run (session, states[i][k]);
    legend_judge (session, "state", i);
    point_around (session, i);
  }
  legend_judge_close ();
}

static void
test_every_step (void)
{
  static const guint32 some[] = { 1, 3, 4 };
  static const char *const sets[]
      = { "sites random 12 seed 7", "sites grid 4 3" };

  legend_judge_open ();
  for (guint i = 0; i < G_N_ELEMENTS (sets); i++) {
    g_autoptr (Session) session = session_new ();

    run (session, sets[i]);
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      session_set_step (session, step);
      legend_judge (session, sets[i], step);
    }
    session_select_sites (session, some, G_N_ELEMENTS (some));
    legend_judge (session, "sites selected", i);
  }
  legend_judge_close ();
}

static void
test_performance (void)
{
  g_autoptr (Session) session = session_new ();

  legend_judge_open ();
  run (session, "sites random 8 seed 3");
  g_assert_true (session_perform (session, "", NULL));
  for (guint i = 0; i < 30 && !session_get_performance (session)->is_over;
       i++) {
    check_question (session, "performance", i);
    session_continue (session);
  }
  session_grade (session);
  legend_judge (session, "graded", 0);
  legend_judge_close ();
}

/* Each mark that has words is among what the tests look at. */
static void
test_all_are_met (void)
{
  for (int mark = 0; mark < N_LEGEND_MARKS; mark++)
    if (legend_mark_has_words (mark) && !legend_judge_has_met (mark))
      g_error ("mark %d (%s) is never shown", mark,
               mark < N_ROLES ? role_name ((Role)mark) : "no role");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/legend/lessons-show-no-mark-that-it-does-not-explain",
                   test_lessons);
  g_test_add_func ("/legend/free-sites-show-no-mark-that-it-does-not-explain",
                   test_free_states);
  g_test_add_func ("/legend/no-step-shows-a-mark-that-it-does-not-explain",
                   test_every_step);
  g_test_add_func ("/legend/no-task-shows-a-mark-that-it-does-not-explain",
                   test_performance);
  g_test_add_func ("/legend/every-row-that-there-is-was-looked-at",
                   test_all_are_met);
  return g_test_run ();
}
