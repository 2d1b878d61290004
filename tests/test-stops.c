/* A session at the stops of a lesson. */
#include "action.h"
#include "object-name.h"
#include "same-session.h"
#include "session.h"

#include <string.h>

static const char text[]
    = "# A lesson\n"
      "\n"
      "```lesson\n"
      "format 1\n"
      "sites -1 -0.5; 1 -0.8125; 0.75 0.8125; -0.9375 0.5625; "
      "0.1875 -0.1875; 0.5 -0.1875\n"
      "```\n"
      "\n"
      "## Sites\n"
      "\n"
      "Nothing has happened yet.\n"
      "\n"
      "## Seen\n"
      "\n"
      "```steps\n"
      "goto round 1 see\n"
      "show circumcircles\n"
      "focus visible\n"
      "camera look-up\n"
      "```\n"
      "\n"
      "## The same step\n"
      "\n"
      "```steps\n"
      "hide circumcircles\n"
      "select s4\n"
      "```\n"
      "\n"
      "## The cone\n"
      "\n"
      "```steps\n"
      "goto round 1 cone\n"
      "camera home\n"
      "focus active\n"
      "select none\n"
      "```\n"
      "\n"
      "## One more site\n"
      "\n"
      "```steps\n"
      "add site 0 0.25\n"
      "goto complete\n"
      "```\n";

static Session *
new_session (void)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson
      = lesson_parse (text, strlen (text), "lesson.md", &error);
  Session *session = session_new ();

  g_assert_no_error (error);
  session_set_lesson (session, lesson);
  return session;
}

/* All that a stop decides, in one string. */
static char *
look_of (Session *session)
{
  const SceneLook *look = session_get_look (session);
  const Camera *camera = session_get_camera (session);
  char selection[OBJECT_NAME_ROOM];

  object_name_write (look->selection, selection);
  return g_strdup_printf (
      "stop %u, %u sites, step %u, layers %x, focus %s, "
      "selection %s, camera %g %g %g %g %d",
      session_get_stop (session), session_get_set (session)->n_sites,
      session_get_step (session), look->layers, focus_name (look->focus),
      selection, camera->turn.w, camera->turn.x, camera->turn.y, camera->turn.z,
      camera->is_parallel);
}

static guint
find_step (Session *session, Phase phase)
{
  guint step;

  g_assert_true (timeline_find (session_get_trace (session),
                                (Place){ 1, phase }, false, &step));
  return step;
}

static void
test_a_lesson_opens_at_its_first_stop (void)
{
  g_autoptr (Session) session = new_session ();

  g_assert_cmpuint (session_get_stop (session), ==, 0);
  g_assert_cmpuint (session_get_n_stops (session), ==, 5);
  g_assert_cmpuint (session_get_step (session), ==, 0);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 6);
}

static void
test_a_stop_is_the_same_whichever_way_it_is_reached (void)
{
  g_autoptr (Session) forwards = new_session ();

  for (guint stop = 0; stop < session_get_n_stops (forwards); stop++) {
    g_autofree char *expected = look_of (forwards);

    for (guint from = 0; from < session_get_n_stops (forwards); from++) {
      g_autoptr (Session) session = new_session ();
      g_autofree char *found = NULL;

      g_assert_true (session_set_stop (session, from));
      g_assert_true (session_set_stop (session, stop));
      found = look_of (session);
      g_assert_cmpstr (found, ==, expected);
    }
    session_next (forwards);
  }
}

static void
test_back_lands_on_the_end_of_the_beat_before (void)
{
  g_autoptr (Session) session = new_session ();
  g_autofree char *before = NULL, *after = NULL;

  session_set_stop (session, 1);
  before = look_of (session);
  g_assert_true (session_next (session));
  g_assert_true (session_back (session));
  after = look_of (session);
  g_assert_cmpstr (before, ==, after);
}

static void
test_the_ends_of_a_lesson_are_ends (void)
{
  g_autoptr (Session) session = new_session ();

  g_assert_false (session_back (session));
  for (guint i = 1; i < 5; i++)
    g_assert_true (session_next (session));
  g_assert_false (session_next (session));
  g_assert_false (session_set_stop (session, 5));
  g_assert_cmpuint (session_get_stop (session), ==, 4);
}

static void
test_first_and_last_reach_the_ends_of_time (void)
{
  g_autoptr (Session) session = new_session ();

  session_last (session);
  g_assert_cmpuint (session_get_stop (session), ==, 4);
  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
  session_first (session);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
  g_assert_cmpuint (session_get_step (session), ==, 0);
}

static void
test_the_stop_follows_the_step (void)
{
  g_autoptr (Session) session = new_session ();
  const guint see = find_step (session, PHASE_SEE);
  const guint cone = find_step (session, PHASE_CONE);

  session_set_step (session, see - 1);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
  /* Of two stops at one step, the nearest is entered. */
  session_set_step (session, see);
  g_assert_cmpuint (session_get_stop (session), ==, 1);
  session_set_step (session, see + 1);
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  session_set_step (session, cone + 1);
  g_assert_cmpuint (session_get_stop (session), ==, 3);
  session_set_step (session, see);
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  session_set_step (session, see - 1);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
}

static void
test_a_stop_entered_by_steps_brings_its_look (void)
{
  g_autoptr (Session) session = new_session ();
  g_autofree char *by_steps = NULL, *by_stop = NULL;

  session_set_step (session, find_step (session, PHASE_SEE));
  by_steps = look_of (session);
  session_set_stop (session, 0);
  session_set_stop (session, 1);
  by_stop = look_of (session);
  g_assert_cmpstr (by_steps, ==, by_stop);
}

static void
test_back_returns_to_a_stop_that_was_left_by_steps (void)
{
  g_autoptr (Session) session = new_session ();

  session_set_stop (session, 3);
  session_set_step (session, session_get_step (session) + 2);
  g_assert_true (session_back (session));
  g_assert_cmpuint (session_get_stop (session), ==, 3);
  g_assert_cmpuint (session_get_step (session), ==,
                    find_step (session, PHASE_CONE));
}

static void
test_a_turned_camera_is_kept_until_the_lesson_turns_it (void)
{
  g_autoptr (Session) session = new_session ();
  Camera camera;

  session_set_stop (session, 1);
  camera = *session_get_camera (session);
  camera.zoom = 3;
  session_set_camera (session, &camera);
  session_next (session);
  g_assert_cmpfloat (session_get_camera (session)->zoom, ==, 3);
  session_next (session);
  g_assert_cmpfloat (session_get_camera (session)->zoom, ==, 1);
}

static void
test_a_stop_keeps_the_sites_selected (void)
{
  g_autoptr (Session) session = new_session ();
  const guint32 others[] = { 0, 1, 2 };
  const guint32 *sites;
  guint n;

  for (guint i = 0; i < 2; i++) {
    session_set_stop (session, 2);
    sites = session_get_selected_sites (session, &n);
    g_assert_cmpuint (n, ==, 1);
    g_assert_cmpuint (sites[0], ==, 4);
    session_select_sites (session, others, G_N_ELEMENTS (others));
    session_set_stop (session, 3);
    session_get_selected_sites (session, &n);
    g_assert_cmpuint (n, ==, 0);
  }
}

static void
test_edits_leave_the_lesson_and_return (void)
{
  g_autoptr (Session) session = new_session ();
  guint step;

  session_set_stop (session, 1);
  session_move_site (session, 4, (Site){ 0.25, 0.25 }, NULL);
  g_assert_false (session_get_stop_step (session, 1, &step));
  g_assert_true (session_next (session));
  g_assert_true (session_get_stop_step (session, 2, &step));
  g_assert_cmpuint (step, ==, session_get_step (session));
  g_assert_cmpstr (session_get_undo_label (session), ==,
                   "Undo return to the lesson’s sites");

  g_assert_true (session_undo (session));
  g_assert_cmpfloat (site_set_given (session_get_set (session), 4).x, ==, 0.25);
  g_assert_true (session_undo (session));
  g_assert_true (session_get_stop_step (session, 2, &step));
}

static void
test_opening_a_lesson_can_be_undone (void)
{
  static const Site sites[] = { { 3, 4 }, { 5, 6 } };
  g_autoptr (Session) from_lesson = new_session ();
  g_autoptr (Session) session = session_new ();

  session_set_sites (session, sites, 2, NULL);
  session_set_lesson (session, session_get_lesson (from_lesson));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 6);
  g_assert_true (session_undo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
}

static void
test_stops_with_other_sites_have_no_mark (void)
{
  g_autoptr (Session) session = new_session ();
  guint step;

  g_assert_true (session_get_stop_step (session, 3, &step));
  g_assert_false (session_get_stop_step (session, 4, &step));
  session_set_stop (session, 4);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 7);
  g_assert_false (session_get_stop_step (session, 3, &step));
  g_assert_true (session_get_stop_step (session, 4, &step));
}

static void
count_change (Session *session G_GNUC_UNUSED, guint changes, gpointer user)
{
  guint *told = user;

  told[0] += 1;
  told[1] |= changes;
}

static void
test_a_stop_is_told_once (void)
{
  g_autoptr (Session) session = new_session ();
  guint told[2] = { 0 };

  g_signal_connect (session, "changed", G_CALLBACK (count_change), told);
  session_next (session);
  g_assert_cmpuint (told[0], ==, 1);
  g_assert_cmphex (told[1], ==,
                   CHANGED_STEP | CHANGED_LOOK | CHANGED_CAMERA
                       | CHANGED_LESSON);
}

/* A lesson whose first stop is not at the start of time. */
static void
test_next_from_before_the_first_stop_leads_to_it (void)
{
  static const char late[] = "# T\n\n```lesson\nformat 1\nsites grid 3 3\n"
                             "```\n\n## S\n\n```steps\ngoto round 1\n```\n";
  g_autoptr (Session) session = session_new ();
  g_autoptr (Lesson) lesson = lesson_parse (late, strlen (late), "l.md", NULL);
  guint step;

  session_set_lesson (session, lesson);
  step = session_get_step (session);
  g_assert_cmpuint (step, >, 0);
  session_first (session);
  g_assert_cmpuint (session_get_step (session), ==, 0);
  g_assert_true (session_can_next (session));
  g_assert_true (session_next (session));
  g_assert_cmpuint (session_get_step (session), ==, step);
  g_assert_false (session_can_next (session));
  g_assert_false (session_next (session));
}

static void
test_a_lesson_outlives_its_first_owner (void)
{
  g_autoptr (Session) session = new_session ();

  g_assert_cmpstr (session_get_lesson (session)->title, ==, "A lesson");
  session_set_lesson (session, NULL);
  g_assert_null (session_get_lesson (session));
  g_assert_cmpuint (session_get_n_stops (session), ==, 0);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 6);
}

static void
test_nothing_of_a_lesson_is_left_over_own_sites (void)
{
  static const char all_else[]
      = "# A lesson\n\n```lesson\nformat 1\n"
        "sites -1 -0.5; 1 -0.8125; 0.75 0.8125; -0.9375 0.5625; 0 0\n"
        "theme dark\n```\n\n## One\n\n```steps\n"
        "order input\nhide hull\nhide delaunay\nshow circumcircles\n"
        "view planar\nviews plane\nlisting hull-2004\nfocus visible\n"
        "camera look-up\nlift 0.5\nraise 2\nopacity plane 0.25\n"
        "opacity upper 0.5\n```\n";
  static const Site sites[] = { { 0, 0 }, { 4, 1 }, { 1, 3 }, { 2, 2 } };
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson
      = lesson_parse (all_else, strlen (all_else), "lesson.md", &error);

  g_assert_no_error (error);
  for (guint opens = 0; opens < 2; opens++) {
    g_autoptr (Session) session = session_new (), fresh = session_new ();

    session_set_lesson (session, lesson);
    if (!opens)
      g_assert_true (action_run (session, "new", NULL, &error));
    for (guint i = 0; i < 2; i++) {
      Session *either = i == 0 ? session : fresh;

      g_assert_true (opens ? session_open_sites (
                         either, sites, G_N_ELEMENTS (sites), "sites", &error)
                           : session_set_sites (either, sites,
                                                G_N_ELEMENTS (sites), &error));
      session_fit (either);
    }
    g_assert_cmpint (session_get_order (session).kind, ==, ORDER_FURTHEST);
    assert_same_session (session, fresh);
  }
}

static void
test_playing_a_lesson_goes_from_stop_to_stop (void)
{
  g_autoptr (Session) session = new_session ();
  guint n = 0;

  session_set_playing (session, TRUE);
  while (session_get_playing (session) && n < 100) {
    session_tick (session);
    n += 1;
  }
  g_assert_cmpuint (n, ==, 4);
  g_assert_cmpuint (session_get_stop (session), ==, 4);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/stops/a-lesson-opens-at-its-first-stop",
    test_a_lesson_opens_at_its_first_stop },
  { "/stops/a-stop-is-the-same-whichever-way-it-is-reached",
    test_a_stop_is_the_same_whichever_way_it_is_reached },
  { "/stops/back-lands-on-the-end-of-the-beat-before",
    test_back_lands_on_the_end_of_the_beat_before },
  { "/stops/the-ends-of-a-lesson-are-ends",
    test_the_ends_of_a_lesson_are_ends },
  { "/stops/first-and-last-reach-the-ends-of-time",
    test_first_and_last_reach_the_ends_of_time },
  { "/stops/the-stop-follows-the-step", test_the_stop_follows_the_step },
  { "/stops/a-stop-entered-by-steps-brings-its-look",
    test_a_stop_entered_by_steps_brings_its_look },
  { "/stops/back-returns-to-a-stop-that-was-left-by-steps",
    test_back_returns_to_a_stop_that_was_left_by_steps },
  { "/stops/a-turned-camera-is-kept-until-the-lesson-turns-it",
    test_a_turned_camera_is_kept_until_the_lesson_turns_it },
  { "/stops/a-stop-keeps-the-sites-selected",
    test_a_stop_keeps_the_sites_selected },
  { "/stops/edits-leave-the-lesson-and-return",
    test_edits_leave_the_lesson_and_return },
  { "/stops/opening-a-lesson-can-be-undone",
    test_opening_a_lesson_can_be_undone },
  { "/stops/stops-with-other-sites-have-no-mark",
    test_stops_with_other_sites_have_no_mark },
  { "/stops/a-stop-is-told-once", test_a_stop_is_told_once },
  { "/stops/next-from-before-the-first-stop-leads-to-it",
    test_next_from_before_the_first_stop_leads_to_it },
  { "/stops/a-lesson-outlives-its-first-owner",
    test_a_lesson_outlives_its_first_owner },
  { "/stops/nothing-of-a-lesson-is-left-over-own-sites",
    test_nothing_of_a_lesson_is_left_over_own_sites },
  { "/stops/playing-a-lesson-goes-from-stop-to-stop",
    test_playing_a_lesson_goes_from_stop_to_stop },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
