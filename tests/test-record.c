/* What is recorded is a lesson, and it leads where the person was. */
#include "action.h"
#include "anything.h"
#include "command.h"
#include "fixture.h"
#include "learner.h"
#include "same-session.h"
#include "session-record.h"

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
say (Session *session, const char *name, const char *word)
{
  learner_act (session, name, g_variant_new_string (word));
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
  learner_act (session, "lift", g_variant_new_double (0.5));
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
  learner_act (session, "next", NULL);
  learner_act (session, "next", NULL);
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
  assert_same_session (session, again);
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
  assert_same_session (session, again);
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
    look_anyhow (session, random);
  record = session_record_new (session);
  for (guint i = 0; i < 40; i++)
    if (g_rand_int_range (random, 0, 36) == 0)
      session_record_cut (record);
    else
      do_anything (session, random);
  if (session_get_set (session)->n_sites == 0)
    session_add_site (session, (Site){ 0, 0 }, NULL);
  text = session_record_text (record);
  assert_verbs (text);
  if (*text != '\0') {
    again = has_lesson ? paste (before, NULL, text) : paste (text, NULL, "");
    assert_same_session (session, again);
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
  g_test_add_func ("/record/whatever-is-recorded-leads-to-the-same",
                   test_whatever_is_recorded_leads_to_the_same);
  return g_test_run ();
}
