#include "learner.h"
#include "panel.h"
#include "storyboard.h"

#include <stdio.h>
#include <string.h>

static const char lesson_text[]
    = "# What a site sees\n"
      "\n"
      "Words & <more> words.\n"
      "\n"
      "```lesson\n"
      "format 1\n"
      "sites -0.6 -0.5; 0.7 -0.4; 0.1 0.8; 0.0 0.1; 0.3 -0.1\n"
      "```\n"
      "\n"
      "## First\n"
      "\n"
      "A *long* story & its **end**.\n"
      "\n"
      "```steps\n"
      "goto round 1 choose\n"
      "```\n"
      "\n"
      "## Second\n"
      "\n"
      "```steps\n"
      "goto round 1 see\n"
      "```\n"
      "\n"
      "## Third\n"
      "\n"
      "```steps\n"
      "goto round 1 horizon\n"
      "```\n"
      "\n"
      "## Fourth\n"
      "\n"
      "```steps\n"
      "goto round 1 cone\n"
      "```\n"
      "\n"
      "## Fifth\n"
      "\n"
      "```steps\n"
      "goto round 1 hand-over\n"
      "```\n";

static GString *
write_board_in (Session *session, ThemeKind theme)
{
  g_autoptr (GError) error = NULL;
  GString *bytes = g_string_new (NULL);
  FILE *file = tmpfile ();
  Appearance appearance;
  int byte;

  appearance_init (&appearance);
  appearance.theme = theme;
  g_assert_true (storyboard_write (session, &appearance, file, NULL, &error));
  g_assert_no_error (error);
  rewind (file);
  while ((byte = fgetc (file)) != EOF)
    g_string_append_c (bytes, (char)byte);
  fclose (file);
  return bytes;
}

static GString *
write_board (Session *session)
{
  return write_board_in (session, THEME_LIGHT);
}

static guint
count (const GString *bytes, const char *words)
{
  const gsize length = strlen (words);
  guint n = 0;
  gsize i;

  for (i = 0; i + length <= bytes->len; i++)
    n += memcmp (bytes->str + i, words, length) == 0;
  return n;
}

static void
test_pages (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  GString *bytes = write_board (session);

  g_assert_cmpuint (count (bytes, "<< /Type /Page "), ==, 2);
  g_assert_cmpuint (count (bytes, "/Title (What a site sees)"), ==, 1);
  g_assert_cmpuint (count (bytes, "/Title (Second)"), ==, 1);
  g_assert_cmpuint (count (bytes, "/Title (Fifth)"), ==, 1);
  g_assert_cmpuint (count (bytes, "/Title (Legend)"), ==, 1);
  g_assert_cmpuint (count (bytes, "/CreationDate (20040101000000"), ==, 1);
  g_string_free (bytes, TRUE);
}

static void
test_same_bytes (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (Session) again = learner_open (lesson_text, NULL);
  GString *first = write_board (session);
  GString *second = write_board (session);
  GString *third = write_board (again);

  g_assert_cmpmem (first->str, first->len, second->str, second->len);
  g_assert_cmpmem (first->str, first->len, third->str, third->len);
  g_string_free (first, TRUE);
  g_string_free (second, TRUE);
  g_string_free (third, TRUE);
}

static void
test_left_as_found (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  guint step;
  GString *bytes;

  session_set_stop (session, 2);
  step = session_get_step (session);
  bytes = write_board (session);
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  g_assert_cmpuint (session_get_step (session), ==, step);
  g_string_free (bytes, TRUE);
}

/* What panels say of a lesson with a question. */
static void
test_questions_are_asked (void)
{
  static const char text[]
      = "# T\n\n```lesson\nformat 1\n"
        "sites -0.6 -0.5; 0.7 -0.4; 0.1 0.8; 0.0 0.1; 0.3 -0.1\n```\n\n"
        "## Asked\n\n```ask\nbefore round 1 see\nclick visible-facets\n"
        "prompt **Which** facets?\n```\n\n```steps\ngoto round 1 see\n```\n\n"
        "## Told\n\n```steps\ngoto round 1 see\n```\n";
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson
      = lesson_parse (text, strlen (text), "test.md", &error);
  g_autoptr (Session) session = session_new ();
  g_autoptr (Panel) asked = NULL, told = NULL;

  g_assert_no_error (error);
  session_set_lesson (session, lesson);
  asked = panel_new (session, 0);
  g_assert_cmpstr (asked->narration, ==, "<b>Which</b> facets?");
  g_assert_true (session_is_asking (session));
  told = panel_new (session, 1);
  g_assert_nonnull (strstr (told->narration, "its circle contains"));
}

/* Each theme gives other pictures. */
static void
test_themes_matter (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (GHashTable) seen
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);

  for (guint i = 0; i < N_THEMES; i++) {
    GString *bytes = write_board_in (session, (ThemeKind)i);

    g_assert_true (g_hash_table_add (
        seen, g_compute_checksum_for_data (
                  G_CHECKSUM_SHA256, (const guchar *)bytes->str, bytes->len)));
    g_string_free (bytes, TRUE);
  }
}

/* Without a lesson: the simplex, each round, and the end. */
static void
test_rounds (void)
{
  static const Site sites[]
      = { { -0.6, -0.5 }, { 0.7, -0.4 }, { 0.1, 0.8 }, { 0, 0.1 },
          { 0.3, -0.1 },  { 0.9, 0.9 },  { -0.8, 0.7 } };
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;
  GString *bytes;

  g_assert_true (session_set_sites (session, sites, 7, &error));
  bytes = write_board (session);
  g_assert_cmpuint (count (bytes, "/Title (Round 1: s"), ==, 1);
  g_assert_cmpuint (count (bytes, "/Title (Round 3: s"), ==, 1);
  g_assert_cmpuint (count (bytes, "/Title (Round 4: s"), ==, 0);
  g_assert_cmpuint (count (bytes, "<< /Type /Page "), ==, 2);
  g_string_free (bytes, TRUE);
}

static void
test_full_disk (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (GError) error = NULL;
  FILE *file = fopen ("/dev/full", "wb");
  Appearance appearance;

  appearance_init (&appearance);
  g_assert_nonnull (file);
  g_assert_false (storyboard_write (session, &appearance, file, NULL, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_NO_SPACE);
  fclose (file);
}

/* Nobody wants it any more while the first of two pages is painted. */
static void
on_changed (Session *session, guint changes, gpointer user)
{
  (void)changes;
  if (session_get_stop (session) >= 1)
    g_cancellable_cancel (user);
}

static void
note_stop (Session *session, guint changes, gpointer user)
{
  guint *last = user;

  (void)changes;
  *last = MAX (*last, session_get_stop (session));
}

static void
test_given_up (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (GCancellable) wanted = g_cancellable_new ();
  g_autoptr (GError) error = NULL;
  FILE *file = tmpfile ();
  Appearance appearance;
  guint last = 0;

  appearance_init (&appearance);
  g_signal_connect (session, "changed", G_CALLBACK (on_changed), wanted);
  g_signal_connect (session, "changed", G_CALLBACK (note_stop), &last);
  g_assert_false (
      storyboard_write (session, &appearance, file, wanted, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_CANCELLED);
  g_assert_cmpuint (last, ==, 3);
  g_assert_cmpint (ftell (file), ==, 0);
  fclose (file);
}

static double
width_at (double size)
{
  static const cairo_rectangle_t page = { 0, 0, 10000, 1000 };
  cairo_surface_t *surface
      = cairo_recording_surface_create (CAIRO_CONTENT_COLOR_ALPHA, NULL);
  cairo_t *cr = cairo_create (surface);
  double x, y, width, height;

  panel_paint_text (cr, "Inside the hull of the plane a new site sees", size,
                    &page);
  cairo_recording_surface_ink_extents (surface, &x, &y, &width, &height);
  cairo_destroy (cr);
  cairo_surface_destroy (surface);
  return width;
}

/* Letters at whole pixels would stand apart on paper. */
static void
test_letters_keep_their_distance (void)
{
  g_assert_cmpfloat_with_epsilon (width_at (9), width_at (90) / 10, 2);
  g_assert_cmpfloat_with_epsilon (width_at (10.5), width_at (105) / 10, 2);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func (
      "/storyboard/four-stops-or-a-legend-share-a-page-and-are-in-its-outline",
      test_pages);
  g_test_add_func ("/storyboard/the-same-lesson-gives-the-same-bytes",
                   test_same_bytes);
  g_test_add_func ("/storyboard/the-session-is-left-as-it-was",
                   test_left_as_found);
  g_test_add_func ("/storyboard/without-a-lesson-rounds-are-shown",
                   test_rounds);
  g_test_add_func ("/storyboard/questions-are-asked-not-answered",
                   test_questions_are_asked);
  g_test_add_func ("/storyboard/themes-matter", test_themes_matter);
  g_test_add_func ("/storyboard/a-full-disk-is-said", test_full_disk);
  g_test_add_func ("/storyboard/what-is-given-up-ends-with-its-page",
                   test_given_up);
  g_test_add_func ("/storyboard/letters-keep-their-distance-at-any-size",
                   test_letters_keep_their_distance);
  return g_test_run ();
}
