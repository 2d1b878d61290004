/* What is recorded is a lesson, and it leads where the person was. */
#include "action.h"
#include "camera-text.h"
#include "command.h"
#include "fixture.h"
#include "lesson-text.h"
#include "object-name.h"
#include "session-record.h"

#include <math.h>
#include <string.h>

static const char lecture[]
    = LECTURE "## First\n\n```steps\ngoto round 1 see\n```\n\n"
              "## Second\n\n```steps\ngoto round 2 cone\nshow circumcircles\n"
              "theme dark\n```\n\n"
              "## Third\n\n```steps\ngoto complete\n```\n";

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "r.md", &error);

  if (error != NULL)
    g_error ("%s\n%s", error->message, text);
  return lesson;
}

static Session *
open_lesson (const char *text)
{
  Session *session = session_new ();
  g_autoptr (Lesson) lesson = parse (text);

  session_set_lesson (session, lesson);
  return session;
}

static void
act (Session *session, const char *name, GVariant *parameter)
{
  g_autoptr (GError) error = NULL;

  action_run (session, name, parameter, &error);
  g_assert_no_error (error);
}

static void
say (Session *session, const char *name, const char *word)
{
  act (session, name, g_variant_new_string (word));
}

/* Independent of what writes the record: what a person can see. */
static void
assert_same_sites (Session *a, Session *b)
{
  const SiteSet *left = session_get_set (a), *right = session_get_set (b);

  g_assert_cmpuint (left->n_sites, ==, right->n_sites);
  for (guint i = 0; i < left->n_sites; i++) {
    const Site p = site_set_given (left, i), q = site_set_given (right, i);

    g_assert_true (p.x == q.x && p.y == q.y);
  }
}

static void
assert_same_camera (const Camera *a, const Camera *b)
{
  static const Point3 points[]
      = { { 0, 0, 0 }, { 1, 0, 1 }, { 0, 1, 0.5 }, { -1, -1, 2 } };
  const Projection left = camera_projection (a, 1000, 1000);
  const Projection right = camera_projection (b, 1000, 1000);

  for (guint i = 0; i < G_N_ELEMENTS (points); i++) {
    const Point3 p = projection_apply (&left, points[i]);
    const Point3 q = projection_apply (&right, points[i]);

    /* Within what the zoom makes of a hundredth of a degree. */
    g_assert_cmpfloat (hypot (p.x - q.x, p.y - q.y), <, 2 * (1 + a->zoom));
  }
}

static void
assert_same_look (const SceneLook *a, const SceneLook *b)
{
  g_assert_cmpuint (a->layers, ==, b->layers);
  g_assert_cmpint (a->focus, ==, b->focus);
  g_assert_cmpfloat_with_epsilon (a->lift, b->lift, 1e-6);
  g_assert_cmpfloat_with_epsilon (a->raise, b->raise, 1e-6);
  for (guint i = 0; i < N_BODIES; i++)
    g_assert_cmpfloat_with_epsilon (a->body_fade[i], b->body_fade[i], 1e-6);
  for (guint i = 0; i < N_ROLES; i++)
    g_assert_cmpfloat_with_epsilon (a->role_fade[i], b->role_fade[i], 1e-6);
}

/* What is not born yet when the person steps back, and a site that is there no
 * more, show nothing. */
static void
assert_same_object (Session *session,
                    const char *action,
                    Object object,
                    Object other)
{
  char name[OBJECT_NAME_ROOM];

  object_name_write (object, name);
  if (action_run (session, action, g_variant_new_string (name), NULL))
    g_assert_true (object_equal (object, other));
  else
    g_assert_true (object_equal (object, other) || other.kind == OBJECT_NONE);
}

static void
assert_same (Session *a, Session *b)
{
  g_autofree char *left = session_narrate_in_english (a);
  g_autofree char *right = session_narrate_in_english (b);

  assert_same_sites (a, b);
  g_assert_cmpint (session_get_exhibit_kind (a), ==,
                   session_get_exhibit_kind (b));
  g_assert_cmpuint (session_get_step (a), ==, session_get_step (b));
  g_assert_cmpstr (left, ==, right);
  if (session_get_exhibit_kind (a) <= EXHIBIT_COMPARE)
    g_assert_true (frame_hash (session_get_frame (a))
                   == frame_hash (session_get_frame (b)));
  assert_same_look (session_get_look (a), session_get_look (b));
  assert_same_object (a, "select", session_get_look (a)->selection,
                      session_get_look (b)->selection);
  assert_same_object (a, "measure", session_get_look (a)->measured,
                      session_get_look (b)->measured);
  assert_same_camera (session_get_camera (a), session_get_camera (b));
  g_assert_cmpint (session_get_views (a), ==, session_get_views (b));
  g_assert_cmpint (session_get_listing (a), ==, session_get_listing (b));
  g_assert_cmpint (session_get_appearance (a)->theme, ==,
                   session_get_appearance (b)->theme);
}

/* Pastes a record behind a stop, and goes to its end. */
static Session *
paste (const char *lesson, const char *before, const char *record)
{
  g_autoptr (GString) text = g_string_new (lesson);
  gssize place = before == NULL ? (gssize)text->len
                                : strstr (text->str, before) - text->str;
  guint n_stops = 0;
  Session *session;

  g_string_insert (text, place, record);
  if (place > 0 && place == (gssize)(text->len - strlen (record)))
    g_string_insert (text, place, "\n");
  session = open_lesson (text->str);
  for (guint i = 0; i < session_get_n_stops (session); i++) {
    const LessonStop *stop = lesson_stop (session_get_lesson (session), i);

    if (g_str_has_prefix (stop->title, "Recorded"))
      n_stops = i;
  }
  session_set_stop (session, n_stops);
  return session;
}

static char *
lines_of (const char *record)
{
  g_autoptr (GString) lines = g_string_new (NULL);
  g_auto (GStrv) each = g_strsplit (record, "\n", -1);
  gboolean is_steps = FALSE;

  for (guint i = 0; each[i] != NULL; i++) {
    if (g_str_has_prefix (each[i], "```"))
      is_steps = g_str_equal (each[i], "```steps");
    else if (is_steps)
      g_string_append_printf (lines, "%s|", each[i]);
    else if (g_str_has_prefix (each[i], "## "))
      g_string_append (lines, "#|");
  }
  return g_string_free (g_steal_pointer (&lines), FALSE);
}

static void
assert_lines (SessionRecord *record, const char *expected)
{
  g_autofree char *text = session_record_text (record);
  g_autofree char *lines = lines_of (text);

  g_assert_cmpstr (lines, ==, expected);
}

static void
test_what_is_done_becomes_verbs (void)
{
  g_autoptr (Session) session = open_lesson (lecture);
  g_autoptr (SessionRecord) record = session_record_new (session);

  assert_lines (record, "");
  say (session, "goto", "round 1 horizon");
  say (session, "show", "circumcircles");
  say (session, "focus", "horizon");
  say (session, "select", "s4");
  act (session, "lift", g_variant_new_double (0.5));
  say (session, "camera", "look-up");
  say (session, "theme", "projector");
  assert_lines (record,
                "#|goto round 1 horizon|show circumcircles|focus horizon|"
                "lift 0.5|select s4|camera look-up|theme projector|");
}

static void
test_what_was_moved_often_is_one_line (void)
{
  g_autoptr (Session) session = open_lesson (lecture);
  g_autoptr (SessionRecord) record = session_record_new (session);

  for (guint i = 0; i <= 20; i++) {
    session_set_lift (session, i / 40.0);
    session_move_site (session, 7, (Site){ i / 32.0, 0.25 }, NULL);
  }
  assert_lines (record, "#|move site s7 0.625 0.25|lift 0.5|");
}

static void
test_what_was_taken_back_is_no_line (void)
{
  g_autoptr (Session) session = open_lesson (lecture);
  g_autoptr (SessionRecord) record = session_record_new (session);

  say (session, "show", "tangents");
  say (session, "hide", "tangents");
  session_add_site (session, (Site){ 0.5, 0.5 }, NULL);
  session_undo (session);
  say (session, "goto", "round 1 see");
  assert_lines (record, "");
}

static void
test_a_step_after_something_else_begins_a_stop (void)
{
  g_autoptr (Session) session = open_lesson (lecture);
  g_autoptr (SessionRecord) record = session_record_new (session);

  session_set_step_size (session, STEP_EVENT);
  act (session, "next", NULL);
  act (session, "next", NULL);
  say (session, "show", "circumcircles");
  say (session, "goto", "round 1 cone");
  say (session, "goto", "round 2 see");
  say (session, "hide", "circumcircles");
  session_record_cut (record);
  session_record_cut (record);
  say (session, "select", "s5");
  assert_lines (record,
                "#|goto before round 1 horizon|next event|next event|"
                "show circumcircles|#|goto round 2 see|hide circumcircles|"
                "#|select s5|");
}

static void
test_sites_are_told_as_briefly_as_they_can (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (SessionRecord) record = session_record_new (session);
  g_autofree char *text = NULL;

  assert_lines (record, "");
  say (session, "sites", "0 0; 1 0; 0 1; 1 1.5");
  session_record_cut (record);
  session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
  session_record_cut (record);
  session_remove_site (session, 1, NULL);
  session_record_cut (record);
  session_move_site (session, 0, (Site){ -0.5, 0 }, NULL);
  session_record_cut (record);
  say (session, "sites", "grid 2 2");
  text = session_record_text (record);
  g_assert_nonnull (strstr (text, "sites 0 0; 1 0; 0 1; 1 1.5\n```"));
  assert_lines (record, "#|goto complete|#|add site 0.5 0.25|#|"
                        "remove site s1|#|move site s0 -0.5 0|#|"
                        "sites -1 -1; 1 -1; -1 1; 1 1|");
}

static void
test_a_record_without_a_lesson_is_one (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (SessionRecord) record = NULL;
  g_autofree char *text = NULL;
  g_autoptr (Session) again = NULL;

  say (session, "sites", "circle 6");
  record = session_record_new (session);
  session_add_site (session, (Site){ 0, 0 }, NULL);
  say (session, "select", "s6");
  text = session_record_text (record);
  again = paste (text, NULL, "");
  assert_same (session, again);
}

static void
test_a_record_is_pasted_behind_its_stop (void)
{
  g_autoptr (Session) session = open_lesson (lecture);
  g_autoptr (SessionRecord) record = NULL;
  g_autofree char *text = NULL;
  g_autoptr (Session) again = NULL;

  session_set_stop (session, 1);
  record = session_record_new (session);
  say (session, "goto", "round 2 hand-over");
  say (session, "camera", "side");
  text = session_record_text (record);
  again = paste (lecture, "## Third", text);
  assert_same (session, again);
}

/* Cameras in words */

static void
test_cameras_survive_their_words (void)
{
  GRand *random = g_rand_new_with_seed (7);
  const double size[2] = { 800, 600 };

  for (guint i = 0; i < 500; i++) {
    Camera camera, again;
    g_autofree char *text = NULL, *twice = NULL;
    const double from[2] = { g_rand_double_range (random, 0, 800),
                             g_rand_double_range (random, 0, 600) };
    const double to[2] = { g_rand_double_range (random, 0, 800),
                           g_rand_double_range (random, 0, 600) };

    camera_init (&camera, (CameraPreset)(i % N_CAMERA_PRESETS));
    camera_roll (&camera, from, to, size);
    camera.zoom = g_rand_double_range (random, 0.2, 4);
    camera.pan_x = i % 3 == 0 ? 0 : g_rand_double_range (random, -1, 1);
    text = camera_text_write (&camera);
    g_assert_true (camera_text_read (text, &again));
    assert_same_camera (&camera, &again);
    twice = camera_text_write (&again);
    g_assert_cmpstr (text, ==, twice);
  }
  g_rand_free (random);
}

static void
test_words_that_are_no_camera_are_refused (void)
{
  static const char *const words[]
      = { "",       "20",         "20 91",          "20 18 0 0",
          "a b",    "20 18 nan",  "20 18 0 1 2",    "20 18 0 1 2 3 4",
          "inf 18", "20 18 flat", "parallel 20 18", "20 18 centre 1" };
  g_autoptr (Session) session = session_new ();

  for (guint i = 0; i < G_N_ELEMENTS (words); i++) {
    Camera camera;

    g_assert_false (camera_text_read (words[i], &camera));
    g_assert_false (
        action_run (session, "camera", g_variant_new_string (words[i]), NULL));
  }
  say (session, "camera", "20 18");
  g_assert_true (camera_text_write (session_get_camera (session))[0] != '\0');
}

/* Random sessions */

static double
number (GRand *random)
{
  return g_rand_int_range (random, -64, 65) / 64.0;
}

static void
edit (Session *session, GRand *random)
{
  const guint n = session_get_set (session)->n_sites;
  const Site site = { number (random), number (random) };
  const guint which = n == 0 ? 0 : g_rand_int (random) % n;

  switch (g_rand_int_range (random, 0, 7)) {
  case 0:
  case 1:
    session_add_site (session, site, NULL);
    break;
  case 2:
  case 3:
    session_move_site (session, which, site, NULL);
    break;
  case 4:
    session_remove_site (session, which, NULL);
    break;
  case 5:
    session_undo (session);
    break;
  default:
    session_redo (session);
    break;
  }
}

static void
turn_space (Session *session, GRand *random)
{
  Camera camera = *session_get_camera (session);
  const double size[2] = { 600, 600 };
  const double from[2] = { 300, 300 };
  const double to[2] = { g_rand_double_range (random, 0, 600),
                         g_rand_double_range (random, 0, 600) };

  camera_roll (&camera, from, to, size);
  session_set_camera (session, &camera);
}

/* One of the words of an action; those that cannot be done now are not. */
static void
try_word (Session *session,
          GRand *random,
          const char *name,
          const char *const *words)
{
  const guint n = g_strv_length ((char **)words);

  action_run (session, name,
              g_variant_new_string (words[g_rand_int (random) % n]), NULL);
}

#define TRY(name, ...)                                                         \
  try_word (session, random, name, (const char *const[]){ __VA_ARGS__, NULL })

static void
look (Session *session, GRand *random)
{
  switch (g_rand_int_range (random, 0, 9)) {
  case 0:
    TRY ("show", "circumcircles", "lifts", "why", "furthest", "tangents");
    break;
  case 1:
    TRY ("hide", "hull", "voronoi", "delaunay", "lifts", "circumcircles");
    break;
  case 2:
    TRY ("focus", "active", "none", "visible", "horizon", "cone");
    break;
  case 3:
    TRY ("select", "s0", "s3", "f0", "f5", "v1", "r2", "none");
    break;
  case 4:
    session_set_lift (session, g_rand_double (random));
    break;
  case 5:
    session_set_role_opacity (session, ROLE_UPPER, g_rand_double (random));
    break;
  case 6:
    session_set_body_opacity (session, BODY_HULL, g_rand_double (random));
    break;
  case 7:
    TRY ("measure", "s1", "s2", "none");
    break;
  default:
    session_set_raise (session, 2 * g_rand_double (random));
    break;
  }
}

static void
stage (Session *session, GRand *random)
{
  switch (g_rand_int_range (random, 0, 8)) {
  case 0:
    TRY ("views", "both", "plane", "space");
    break;
  case 1:
    TRY ("listing", "quickhull", "hull-2004", "diagrams-corrected");
    break;
  case 2:
    TRY ("theme", "light", "dark", "projector", "print");
    break;
  case 3:
    TRY ("camera", "home", "look-up", "side", "look-up-unmirrored");
    break;
  case 4:
    turn_space (session, random);
    break;
  case 5:
    TRY ("order", "input", "furthest", "random 7");
    break;
  case 6:
    TRY ("view", "lifts", "planar", "signs", "rounded", "lifts");
    break;
  default:
    TRY ("compare", "furthest input", "random 3 furthest", "none", "none");
    break;
  }
}

static void
step (Session *session, GRand *random)
{
  static const char *const steps[]
      = { "next-event", "next-phase", "next-round",
          "back-event", "back-phase", "back-round" };

  if (g_rand_int_range (random, 0, 4) > 0)
    action_run (session, steps[g_rand_int (random) % 6], NULL, NULL);
  else
    session_set_step (session, g_rand_int (random)
                                   % (session_get_n_steps (session) + 1));
}

static void
do_anything (Session *session, GRand *random, SessionRecord *record)
{
  switch (g_rand_int_range (random, 0, 9)) {
  case 0:
  case 1:
    edit (session, random);
    break;
  case 2:
  case 3:
    look (session, random);
    break;
  case 4:
    stage (session, random);
    break;
  case 5:
    if (g_rand_int_range (random, 0, 6) == 0)
      TRY ("sites", "grid 3 3", "circle 7", "random 9 seed 2", "line 4");
    break;
  case 6:
    if (g_rand_int_range (random, 0, 4) == 0)
      session_record_cut (record);
    break;
  default:
    step (session, random);
    break;
  }
}

/* Only verbs that lessons may use. */
static void
assert_verbs (const char *record)
{
  g_autofree char *lines = lines_of (record);
  g_auto (GStrv) each = g_strsplit (lines, "|", -1);

  for (guint i = 0; each[i] != NULL; i++) {
    g_autofree char *verb = NULL;
    g_autoptr (GVariant) parameter = NULL;
    g_autoptr (GError) error = NULL;

    if (*each[i] == '\0' || *each[i] == '#')
      continue;
    command_parse (each[i], &verb, &parameter, &error);
    g_assert_no_error (error);
    g_assert_true (action_find (verb)->where & ACTION_IN_LESSON);
  }
}

static void
check_random_session (guint seed, gboolean has_lesson)
{
  GRand *random = g_rand_new_with_seed (seed);
  g_autoptr (Session) session
      = has_lesson ? open_lesson (lecture) : session_new ();
  g_autoptr (SessionRecord) record = NULL;
  /* What comes after it may be about other sites. */
  g_autofree char *before
      = g_strndup (lecture, (gsize)(strstr (lecture, "## Second") - lecture));
  g_autofree char *text = NULL;
  g_autoptr (Session) again = NULL;

  if (!has_lesson)
    say (session, "sites", "random 6 seed 3");
  /* What was done before, behind the stop, is part of it. */
  for (guint i = 0; i < seed % 4; i++)
    look (session, random);
  record = session_record_new (session);
  for (guint i = 0; i < 40; i++)
    do_anything (session, random, record);
  if (session_get_set (session)->n_sites == 0)
    session_add_site (session, (Site){ 0, 0 }, NULL);
  text = session_record_text (record);
  assert_verbs (text);
  if (*text != '\0') {
    again = has_lesson ? paste (before, NULL, text) : paste (text, NULL, "");
    assert_same (session, again);
  }
  g_rand_free (random);
}

static void
test_whatever_is_recorded_leads_to_the_same (void)
{
  for (guint seed = 0; seed < fixture_n_seeds (200); seed++) {
    g_test_message ("seed %u", seed);
    check_random_session (seed, seed % 2 == 0);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/record/what-is-done-becomes-verbs",
                   test_what_is_done_becomes_verbs);
  g_test_add_func ("/record/what-was-moved-often-is-one-line",
                   test_what_was_moved_often_is_one_line);
  g_test_add_func ("/record/what-was-taken-back-is-no-line",
                   test_what_was_taken_back_is_no_line);
  g_test_add_func ("/record/a-step-after-something-else-begins-a-stop",
                   test_a_step_after_something_else_begins_a_stop);
  g_test_add_func ("/record/sites-are-told-as-briefly-as-they-can",
                   test_sites_are_told_as_briefly_as_they_can);
  g_test_add_func ("/record/a-record-without-a-lesson-is-one",
                   test_a_record_without_a_lesson_is_one);
  g_test_add_func ("/record/a-record-is-pasted-behind-its-stop",
                   test_a_record_is_pasted_behind_its_stop);
  g_test_add_func ("/record/cameras-survive-their-words",
                   test_cameras_survive_their_words);
  g_test_add_func ("/record/words-that-are-no-camera-are-refused",
                   test_words_that_are_no_camera_are_refused);
  g_test_add_func ("/record/whatever-is-recorded-leads-to-the-same",
                   test_whatever_is_recorded_leads_to_the_same);
  return g_test_run ();
}
