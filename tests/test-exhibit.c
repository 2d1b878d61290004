/* Exhibits in a session: time, edits, stops of lessons, and what lessons
 * expect of them. */
#include "action.h"
#include "fixture.h"
#include "replay.h"
#include "session.h"

#include <string.h>

static Session *
session_of (const char *sites)
{
  g_autoptr (GError) error = NULL;
  Session *session = session_new ();

  action_run (session, "sites", g_variant_new_string (sites), &error);
  g_assert_no_error (error);
  return session;
}

static void
run (Session *session, const char *action, const char *parameter)
{
  g_autoptr (GError) error = NULL;

  action_run (session, action,
              parameter == NULL ? NULL : g_variant_new_string (parameter),
              &error);
  g_assert_no_error (error);
}

/* Three corners, one site inside, one outside. */
#define FIVE "0 0; 4 0; 0 4; 1 1; 5 5"

static void
test_an_exhibit_has_time_of_its_own (void)
{
  g_autoptr (Session) session = session_of (FIVE);
  const guint n_steps = session_get_n_steps (session);
  guint step;

  run (session, "goto", "round 1 see");
  step = session_get_step (session);
  run (session, "view", "planar");
  /* SIMPLEX×3 IGNORE CLAIM SELECT VISIBLE HORIZON×2 CONE×2 RETIRE COMPLETE */
  g_assert_cmpuint (session_get_n_steps (session), ==, 13);
  g_assert_cmpuint (session_get_step (session), ==, 13);
  run (session, "goto", "round 1 horizon");
  g_assert_cmpuint (session_get_step (session), ==, 9);
  run (session, "back-phase", NULL);
  g_assert_cmpuint (session_get_place (session).phase, ==, PHASE_SEE);
  run (session, "view", "lifts");
  g_assert_cmpuint (session_get_n_steps (session), ==, n_steps);
  g_assert_cmpuint (session_get_step (session), ==, step);
}

static void
test_an_edit_keeps_the_place (void)
{
  g_autoptr (Session) session = session_of (FIVE);

  run (session, "view", "planar");
  run (session, "goto", "round 1 see");
  session_add_site (session, (Site){ 0.5, 0.5 }, NULL);
  g_assert_cmpuint (session_get_place (session).round, ==, 1);
  g_assert_cmpuint (session_get_place (session).phase, ==, PHASE_SEE);
  g_assert_cmpint (session_get_site_state (session, 0, 5), ==, SITE_IGNORED);
  session_undo (session);
  g_assert_cmpuint (session_get_place (session).phase, ==, PHASE_SEE);
  /* Without the site outside there is no round: then it is the end. */
  session_remove_site (session, 4, NULL);
  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
}

static void
assert_count (Session *session, const char *key, guint expected)
{
  guint count;

  g_assert_true (session_count (session, key, &count));
  g_assert_cmpuint (count, ==, expected);
}

static void
test_counters_are_those_of_what_is_shown (void)
{
  g_autoptr (Session) session = session_of (FIVE);
  guint count;

  g_assert_false (session_count (session, "hull-vertices", &count));
  assert_count (session, "facets", 6);
  run (session, "view", "planar");
  assert_count (session, "hull-vertices", 4);
  assert_count (session, "ignored", 1);
  run (session, "goto", "round 1 see");
  assert_count (session, "hull-vertices", 3);
  assert_count (session, "visible", 1);
  assert_count (session, "waiting", 1);
  assert_count (session, "round", 1);
  /* Keys of the lifts keep their meaning. */
  assert_count (session, "sites", 5);
}

static void
test_an_unknown_view_is_refused (void)
{
  g_autoptr (Session) session = session_of (FIVE);
  g_autoptr (GError) error = NULL;

  g_assert_false (
      action_run (session, "view", g_variant_new_string ("planer"), &error));
  g_assert_nonnull (strstr (error->message, "planar"));
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
}

/* What the events of a trace cost, counted from the events alone. */
static guint
count_events (const Trace *trace, guint step, EventKind kind)
{
  guint n = 0;

  for (guint i = 0; i < step; i++)
    n += trace_event (trace, i).kind == kind;
  return n;
}

#define TEN                                                                    \
  "-0.5 -0.4; 0.6 -0.5; 0.1 0.5; 0 0.125; 0.1 -0.2; 0.9 0.3; 0.5 0.6; "        \
  "-0.7 0.5; -0.9 -0.1; 0.2 -0.9"

static void
check_in_step (Session *session)
{
  const Trace *trace = session_get_trace (session);
  const Trace *other = session_get_other_trace (session);
  const guint step = session_get_step (session);
  const guint other_step = session_get_other_step (session);
  const Place a = timeline_place (trace, step);
  const Place b = timeline_place (other, other_step);
  const InsertionCost cost = session_get_cost (session, 1);

  g_assert_cmpuint (a.round, ==, b.round);
  g_assert_cmpint (a.phase, ==, b.phase);
  g_assert_cmpuint (cost.facets_created, ==,
                    count_events (other, other_step, EVENT_SIMPLEX)
                        + count_events (other, other_step, EVENT_CONE));
  g_assert_cmpuint (cost.facets_seen, ==,
                    count_events (other, other_step, EVENT_VISIBLE));
}

static void
test_two_runs_go_in_step (void)
{
  g_autoptr (Session) session = session_of (TEN);

  run (session, "compare", "furthest input");
  g_assert_cmpint (session_get_other_trace (session)->order.kind, ==,
                   ORDER_INPUT);
  for (guint step = 0; step <= session_get_n_steps (session); step++) {
    session_set_step (session, step);
    check_in_step (session);
  }
  assert_count (session, "other-round", 6);
  assert_count (session, "facets", 16);
  assert_count (session, "other-facets", 16);
  run (session, "compare", "none");
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
}

/* At the end of a phase of the one run, the other is at the end of it. */
static void
test_phases_end_together (void)
{
  g_autoptr (Session) session = session_of (TEN);
  guint end;

  run (session, "compare", "random 7 furthest");
  for (guint round = 1; round <= 6; round++) {
    const Place place = { round, PHASE_SEE };

    session_find_step (session, place, FALSE, &end);
    session_set_step (session, end);
    timeline_find (session_get_other_trace (session), place, FALSE, &end);
    g_assert_cmpuint (session_get_other_step (session), ==, end);
  }
}

static const char *
line_text (Session *session)
{
  const guint line = session_get_line (session);
  guint n_lines;
  const PseudocodeLine *lines = session_get_lines (session, &n_lines);

  if (line == INDEX_NONE)
    return "";
  g_assert_cmpuint (line, <, n_lines);
  return lines[line].text;
}

/* A hand over has two lines, and what is said of it is that of the line. */
static void
test_a_line_is_what_is_being_done (void)
{
  g_autoptr (Session) session = session_of (TEN);
  const char *const views[] = { "lifts", "compare", "planar" };

  for (guint i = 0; i < G_N_ELEMENTS (views); i++) {
    guint n_retiring = 0;

    run (session, "view", views[i]);
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      session_set_step (session, step);
      g_assert_cmpint (session_is_retiring (session), ==,
                       g_str_equal (line_text (session), "retire V"));
      n_retiring += session_is_retiring (session);
    }
    g_assert_cmpuint (n_retiring, >, 0);
  }
}

/* One may have handed over what the other had not to. */
static void
test_the_line_is_as_far_as_either_run (void)
{
  g_autoptr (Session) session = session_of (TEN);
  guint n_further = 0;

  run (session, "compare", "furthest input");
  for (guint step = 0; step <= session_get_n_steps (session); step++) {
    guint lines[2], line;

    session_set_step (session, step);
    line = session_get_line (session);
    lines[0] = pseudocode_line (session_get_trace (session), step);
    lines[1] = pseudocode_line (session_get_other_trace (session),
                                session_get_other_step (session));
    g_assert_cmpuint (line, ==, MAX (lines[0], lines[1]));
    n_further += line != lines[0];
  }
  g_assert_cmpuint (n_further, >, 0);
}

/* 6 - 12/k at k = 5 is 18/5, at k = 6 it is 4. */
static void
test_the_cone_is_compared_with_that_of_a_random_order (void)
{
  g_autoptr (Session) session = session_of (TEN);
  InsertionCost cost;

  run (session, "goto", "round 2");
  cost = session_get_cost (session, 0);
  g_assert_cmpuint (cost.n_cones, ==, 2);
  g_assert_cmpfloat_with_epsilon (cost.expected_cone, (3.6 + 4) / 2, 1e-12);
}

static void
test_flat_sites_and_duplicates_can_be_compared (void)
{
  static const char *const sets[]
      = { "0 0", "0 0; 1 0; 2 0", "0 0; 1 0; 1 1; 0 1",
          "0 0; 1 0; 0 1; 0.25 0.25; 0 0; 1 1" };

  for (guint i = 0; i < G_N_ELEMENTS (sets); i++) {
    g_autoptr (Session) session = session_of (sets[i]);
    g_autofree char *sentence = NULL;

    run (session, "compare", "input furthest");
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      session_set_step (session, step);
      check_in_step (session);
    }
    sentence = session_narrate (session);
    g_assert_nonnull (strstr (sentence, "Both"));
  }
}

static void
test_orders_that_are_none_are_refused (void)
{
  g_autoptr (Session) session = session_of (TEN);
  static const char *const wrong[]
      = { "furthest", "furthest random", "furthest inputs",
          "input furthest random 7", "" };

  for (guint i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_autoptr (GError) error = NULL;

    g_assert_false (action_run (session, "compare",
                                g_variant_new_string (wrong[i]), &error));
    g_assert_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER);
  }
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
}

static void
test_a_case_of_rounding_shows_its_wrong_turn (void)
{
  g_autoptr (Session) session = session_new ();
  g_autofree char *sentence = NULL;
  guint count;

  run (session, "rounding", "A1");
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_SIGNS);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 9);
  g_assert_true (session_count (session, "wrong-signs", &count));
  g_assert_cmpuint (count, >, 0);
  sentence = session_narrate_in_english (session);
  /* The marked node is the site itself, to the last bit. */
  g_assert_nonnull (strstr (sentence, "24.00000000000005"));
  run (session, "view", "rounded");
  assert_count (session, "lost-sites", 1);
  g_assert_false (
      action_run (session, "rounding", g_variant_new_string ("C9"), NULL));
}

static const char lesson_text[] = "# Hulls\n"
                                  "\n"
                                  "```lesson\n"
                                  "format 1\n"
                                  "sites " FIVE "\n"
                                  "```\n"
                                  "\n"
                                  "## In the plane\n"
                                  "\n"
                                  "```steps\n"
                                  "view planar\n"
                                  "goto round 1 see\n"
                                  "expect visible 1\n"
                                  "expect ignored 1\n"
                                  "expect narration contains s4 sees e1\n"
                                  "```\n"
                                  "\n"
                                  "## Its end\n"
                                  "\n"
                                  "```steps\n"
                                  "goto complete\n"
                                  "expect hull-vertices 4\n"
                                  "```\n"
                                  "\n"
                                  "## In space\n"
                                  "\n"
                                  "```steps\n"
                                  "view lifts\n"
                                  "goto round 1 see\n"
                                  "expect visible 2\n"
                                  "```\n";

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "lesson.md", &error);

  g_assert_no_error (error);
  return lesson;
}

static void
test_a_lesson_goes_from_view_to_view (void)
{
  g_autoptr (Lesson) lesson = parse (lesson_text);
  g_autoptr (Session) session = session_new ();
  static const struct {
    ExhibitKind kind;
    Phase phase;
  } stops[] = { { EXHIBIT_PLANAR, PHASE_SEE },
                { EXHIBIT_PLANAR, PHASE_COMPLETE },
                { EXHIBIT_LIFTS, PHASE_SEE } };
  static const guint way[] = { 0, 1, 2, 1, 0, 2, 0 };

  session_set_lesson (session, lesson);
  for (guint i = 0; i < G_N_ELEMENTS (way); i++) {
    g_assert_true (session_set_stop (session, way[i]));
    g_assert_cmpint (session_get_exhibit_kind (session), ==,
                     stops[way[i]].kind);
    g_assert_cmpint (session_get_place (session).phase, ==,
                     stops[way[i]].phase);
  }
}

/* Stepping past a stop enters it while its own view is shown, and no other. */
static void
test_stops_follow_the_step_of_their_view (void)
{
  g_autoptr (Lesson) lesson = parse (lesson_text);
  g_autoptr (Session) session = session_new ();
  guint step;

  session_set_lesson (session, lesson);
  g_assert_true (session_get_stop_step (session, 1, &step));
  g_assert_false (session_get_stop_step (session, 2, &step));
  session_set_step (session, session_get_n_steps (session));
  g_assert_cmpuint (session_get_stop (session), ==, 1);
  session_set_step (session, 0);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
}

static void
test_a_lesson_with_views_replays (void)
{
  g_autoptr (Lesson) lesson = parse (lesson_text);
  g_autoptr (GError) error = NULL;
  Replay *replay = replay_new ();

  g_assert_true (replay_add (replay, lesson, &error));
  g_assert_no_error (error);
  replay_end (replay);
  g_assert_cmpuint (replay->n_failed, ==, 0);
  g_assert_cmpuint (replay->n_expects, ==, 5);
  replay_free (replay);
}

/* Every step has a sentence, counters and a scene, on any sites. */
static void
check_steps (const Fixture *fixture)
{
  g_autoptr (Session) session = session_new ();
  g_autofree Site *sites = g_new (Site, MAX (fixture->set->n_sites, 1));
  Scene scene = { 0 };

  for (guint i = 0; i < fixture->set->n_sites; i++)
    sites[i] = site_set_given (fixture->set, i);
  g_assert_true (
      session_set_sites (session, sites, fixture->set->n_sites, NULL));
  for (ExhibitKind kind = EXHIBIT_LIFTS + 1; kind < N_EXHIBITS; kind++) {
    session_set_exhibit_kind (session, kind);
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      g_autofree char *sentence = NULL;
      g_autoptr (GPtrArray) laws = NULL;

      session_set_step (session, step);
      sentence = session_narrate (session);
      laws = session_get_laws (session);
      g_assert_cmpuint (strlen (sentence), >, 0);
      g_assert_null (strchr (sentence, '{'));
      g_assert_cmpuint (laws->len, >, 0);
      session_fill_scene (session, 0, &scene, session_get_look (session));
    }
  }
  scene_clear (&scene);
}

static void
test_every_step_can_be_shown (void)
{
  fixture_for_each (2, 12, ORDER_FURTHEST, check_steps);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/exhibit/an-exhibit-has-time-of-its-own",
                   test_an_exhibit_has_time_of_its_own);
  g_test_add_func ("/exhibit/an-edit-keeps-the-place",
                   test_an_edit_keeps_the_place);
  g_test_add_func ("/exhibit/counters-are-those-of-what-is-shown",
                   test_counters_are_those_of_what_is_shown);
  g_test_add_func ("/exhibit/an-unknown-view-is-refused",
                   test_an_unknown_view_is_refused);
  g_test_add_func ("/exhibit/two-runs-go-in-step", test_two_runs_go_in_step);
  g_test_add_func ("/exhibit/phases-end-together", test_phases_end_together);
  g_test_add_func ("/exhibit/a-line-is-what-is-being-done",
                   test_a_line_is_what_is_being_done);
  g_test_add_func ("/exhibit/the-line-is-as-far-as-either-run",
                   test_the_line_is_as_far_as_either_run);
  g_test_add_func ("/exhibit/the-cone-is-compared-with-that-of-a-random-order",
                   test_the_cone_is_compared_with_that_of_a_random_order);
  g_test_add_func ("/exhibit/flat-sites-and-duplicates-can-be-compared",
                   test_flat_sites_and_duplicates_can_be_compared);
  g_test_add_func ("/exhibit/orders-that-are-none-are-refused",
                   test_orders_that_are_none_are_refused);
  g_test_add_func ("/exhibit/a-case-of-rounding-shows-its-wrong-turn",
                   test_a_case_of_rounding_shows_its_wrong_turn);
  g_test_add_func ("/exhibit/a-lesson-goes-from-view-to-view",
                   test_a_lesson_goes_from_view_to_view);
  g_test_add_func ("/exhibit/stops-follow-the-step-of-their-view",
                   test_stops_follow_the_step_of_their_view);
  g_test_add_func ("/exhibit/a-lesson-with-views-replays",
                   test_a_lesson_with_views_replays);
  g_test_add_func ("/exhibit/every-step-can-be-shown",
                   test_every_step_can_be_shown);
  return g_test_run ();
}
