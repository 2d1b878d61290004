/* Themes and sizes: whose choice is shown when. */
#include "action.h"
#include "session.h"

#include <math.h>
#include <string.h>

static const char text[] = "# A lesson\n"
                           "\n"
                           "```lesson\n"
                           "format 1\n"
                           "sites 0 0; 1 0; 0 1; 0.25 0.25; 0.5 0.75\n"
                           "```\n"
                           "\n"
                           "## As the person has it\n"
                           "\n"
                           "Nothing is said of a theme.\n"
                           "\n"
                           "## Dark\n"
                           "\n"
                           "```steps\n"
                           "theme dark\n"
                           "```\n"
                           "\n"
                           "## Still dark\n"
                           "\n"
                           "Nothing new.\n"
                           "\n"
                           "## Paper\n"
                           "\n"
                           "```steps\n"
                           "theme paper\n"
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

static void
choose (Session *session, const char *theme)
{
  g_autoptr (GError) error = NULL;

  g_assert_true (
      action_run (session, "theme", g_variant_new_string (theme), &error));
  g_assert_no_error (error);
}

static const char *
shown (Session *session)
{
  return theme_kind_name (session_get_appearance (session)->theme);
}

static void
go (Session *session, guint stop)
{
  g_assert_true (session_set_stop (session, stop));
}

static void
test_stops_show_the_lessons_theme (void)
{
  g_autoptr (Session) session = new_session ();
  static const char *const themes[] = { "light", "dark", "dark", "paper" };

  for (guint i = 0; i < G_N_ELEMENTS (themes); i++) {
    go (session, i);
    g_assert_cmpstr (shown (session), ==, themes[i]);
  }
  go (session, 2);
  g_assert_cmpstr (shown (session), ==, "dark");
}

static void
test_the_persons_theme_comes_back (void)
{
  g_autoptr (Session) session = new_session ();

  choose (session, "contrast");
  go (session, 1);
  g_assert_cmpstr (shown (session), ==, "dark");
  g_assert_cmpint (session_get_own_appearance (session)->theme, ==,
                   THEME_CONTRAST);
  go (session, 0);
  g_assert_cmpstr (shown (session), ==, "contrast");
  go (session, 3);
  session_set_lesson (session, NULL);
  g_assert_cmpstr (shown (session), ==, "contrast");
}

static void
test_a_person_overrules_until_the_lesson_says_another (void)
{
  g_autoptr (Session) session = new_session ();

  go (session, 1);
  choose (session, "projector");
  g_assert_cmpstr (shown (session), ==, "projector");
  go (session, 2);
  g_assert_cmpstr (shown (session), ==, "projector");
  go (session, 3);
  g_assert_cmpstr (shown (session), ==, "paper");
}

static void
test_unknown_themes_are_refused_with_a_hint (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;

  g_assert_false (
      action_run (session, "theme", g_variant_new_string ("drak"), &error));
  g_assert_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER);
  g_assert_nonnull (strstr (error->message, "“dark”"));
  g_assert_cmpstr (shown (session), ==, "light");
}

static double
scale_of (Session *session, const char *name)
{
  g_autoptr (GVariant) state
      = g_variant_ref_sink (action_get_state (action_find (name), session));

  return g_variant_get_double (state);
}

static void
test_scales_are_kept_apart_and_within_bounds (void)
{
  static const char *const names[]
      = { "line-scale", "mark-scale", "text-scale" };
  static const double bad[] = { 0.49, 3.01, -1, NAN, INFINITY };
  g_autoptr (Session) session = session_new ();

  for (guint i = 0; i < G_N_ELEMENTS (names); i++) {
    g_assert_true (
        action_run (session, names[i], g_variant_new_double (0.5 + i), NULL));
    for (guint k = 0; k < G_N_ELEMENTS (bad); k++)
      g_assert_false (
          action_run (session, names[i], g_variant_new_double (bad[k]), NULL));
  }
  for (guint i = 0; i < G_N_ELEMENTS (names); i++)
    g_assert_cmpfloat (scale_of (session, names[i]), ==, 0.5 + i);
}

static void
on_changed (Session *session, guint changes, gpointer user)
{
  guint *all = user;

  (void)session;
  *all |= changes;
}

static void
test_only_changes_are_told (void)
{
  g_autoptr (Session) session = session_new ();
  guint changes = 0;

  g_signal_connect (session, "changed", G_CALLBACK (on_changed), &changes);
  choose (session, "light");
  g_assert_cmpuint (changes, ==, 0);
  choose (session, "print");
  g_assert_cmpuint (changes, ==, CHANGED_APPEARANCE);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/appearance/stops-show-the-lessons-theme",
                   test_stops_show_the_lessons_theme);
  g_test_add_func ("/appearance/the-persons-theme-comes-back",
                   test_the_persons_theme_comes_back);
  g_test_add_func (
      "/appearance/a-person-overrules-until-the-lesson-says-another",
      test_a_person_overrules_until_the_lesson_says_another);
  g_test_add_func ("/appearance/unknown-themes-are-refused-with-a-hint",
                   test_unknown_themes_are_refused_with_a_hint);
  g_test_add_func ("/appearance/scales-are-kept-apart-and-within-bounds",
                   test_scales_are_kept_apart_and_within_bounds);
  g_test_add_func ("/appearance/only-changes-are-told",
                   test_only_changes_are_told);
  return g_test_run ();
}
