/* The file of the lesson that is open, and that of its sites: saved, cut off,
 * removed, replaced by what is no lesson. */
#include "action.h"
#include "lesson-text.h"
#include "lesson-watch.h"
#include "limited.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SITE_FILE "sites.txt"
#define FIVE_SITES "-1 -0.5\n1 -0.8125\n0.75 0.8125\n-0.9375 0.5625\n0.2 -0.2\n"

static const char text[]
    = "# T\n\n```lesson\nformat 1\nsites file " SITE_FILE "\n```\n\n"
      "## Start\n\n```steps\ngoto simplex\n```\n\n"
      "## Which?\n\n```ask\nbefore round 1 see\nclick visible-facets\n```\n\n"
      "## End\n\n```steps\ngoto complete\n```\n";

/* A lesson that is open, with a person at its question. */
typedef struct Reader {
  char *folder, *path, *sites;
  Session *session;
  LessonWatch *watch;
  guint n_told;  /* how often something was wrong */
  char *told;    /* what is wrong now; NULL: nothing */
  Lesson *first; /* as it was opened */
} Reader;

static void
tell (const LessonFaults *faults, gpointer user)
{
  Reader *reader = user;

  g_clear_pointer (&reader->told, g_free);
  if (faults == NULL || faults->errors->len == 0)
    return;
  reader->n_told += 1;
  reader->told = g_strdup (
      ((const GError *)g_ptr_array_index (faults->errors, 0))->message);
}

static void
save (const char *path, const char *bytes, gsize length)
{
  FILE *file = g_fopen (path, "we");

  g_assert_nonnull (file);
  g_assert_cmpuint (fwrite (bytes, 1, length, file), ==, length);
  g_assert_cmpint (fclose (file), ==, 0);
}

static void
save_text (const char *path, const char *bytes)
{
  save (path, bytes, strlen (bytes));
}

static void
begin (Reader *reader)
{
  g_autoptr (Lesson) lesson = NULL;

  *reader = (Reader){ .folder = limited_make_folder () };
  reader->path = g_build_filename (reader->folder, "l.md", NULL);
  reader->sites = g_build_filename (reader->folder, SITE_FILE, NULL);
  save_text (reader->path, text);
  save_text (reader->sites, FIVE_SITES);
  lesson = lesson_load (reader->path, NULL);
  reader->first = lesson;
  reader->session = session_new ();
  session_set_lesson (reader->session, lesson);
  session_set_stop (reader->session, 1);
  reader->watch = lesson_watch_new (reader->session, tell, reader);
  lesson_watch_set_path (reader->watch, reader->path);
}

static void
end (Reader *reader)
{
  lesson_watch_free (reader->watch);
  g_object_unref (reader->session);
  limited_remove_folder (reader->folder);
  g_free (reader->path);
  g_free (reader->sites);
  g_free (reader->told);
}

static gboolean
on_time (gpointer is_over)
{
  *(gboolean *)is_over = TRUE;
  return G_SOURCE_REMOVE;
}

/* Lets the program go on until @holds; a machine at work takes its time. */
static void
await_state (Reader *reader, gboolean (*holds) (Reader *reader))
{
  gboolean is_over = FALSE;
  const guint source = g_timeout_add_seconds (120, on_time, &is_over);

  while (!holds (reader) && !is_over)
    g_main_context_iteration (NULL, TRUE);
  g_assert_true (holds (reader));
  if (!is_over)
    g_source_remove (source);
}

static void
pass (guint milliseconds)
{
  gboolean is_over = FALSE;

  g_timeout_add (milliseconds, on_time, &is_over);
  while (!is_over)
    g_main_context_iteration (NULL, TRUE);
}

static gboolean
is_told (Reader *reader)
{
  return reader->told != NULL;
}

static gboolean
is_renewed (Reader *reader)
{
  return session_get_lesson (reader->session) != reader->first;
}

static gboolean
is_mended (Reader *reader)
{
  return reader->told == NULL;
}

/* The lesson that was open is, with the person where they were. */
static void
assert_runs_on (Reader *reader)
{
  g_assert_true (session_get_lesson (reader->session) == reader->first);
  g_assert_cmpuint (session_get_stop (reader->session), ==, 1);
  g_assert_true (session_is_asking (reader->session));
}

static const char *
stop_title (Reader *reader)
{
  const Lesson *lesson = session_get_lesson (reader->session);

  return lesson_stop (lesson, session_get_stop (reader->session))->title;
}

/* What @do_it makes of the file is told as @reason while the lesson runs on,
 * and is over when the file is back. */
static void
check_fault (void (*do_it) (Reader *reader), const char *reason)
{
  Reader reader;

  begin (&reader);
  do_it (&reader);
  await_state (&reader, is_told);
  g_assert_nonnull (strstr (reader.told, reason));
  assert_runs_on (&reader);
  g_rmdir (reader.path);
  g_remove (reader.path);
  save_text (reader.path, text);
  save_text (reader.sites, FIVE_SITES);
  await_state (&reader, is_mended);
  assert_runs_on (&reader);
  end (&reader);
}

static void
remove_it (Reader *reader)
{
  g_assert_cmpint (g_remove (reader->path), ==, 0);
}

static void
put_a_folder (Reader *reader)
{
  remove_it (reader);
  g_assert_cmpint (g_mkdir (reader->path, 0700), ==, 0);
}

static void
put_a_pipe (Reader *reader)
{
  remove_it (reader);
  g_assert_cmpint (mkfifo (reader->path, 0600), ==, 0);
}

static void
put_a_loop (Reader *reader)
{
  remove_it (reader);
  g_assert_cmpint (symlink ("l.md", reader->path), ==, 0);
}

static void
empty_it (Reader *reader)
{
  save (reader->path, "", 0);
}

/* Returns: where a cut goes through a word of the question. */
static gsize
middle (void)
{
  return (gsize)(strstr (text, "facets") - text);
}

static void
cut_it_off (Reader *reader)
{
  save (reader->path, text, middle ());
}

static void
forbid_it (Reader *reader)
{
  g_assert_cmpint (g_chmod (reader->path, 0), ==, 0);
}

static void
test_a_lesson_that_goes_runs_on (void)
{
  check_fault (remove_it, g_strerror (ENOENT));
}

static void
test_what_is_no_file_in_its_place_is_told (void)
{
  check_fault (put_a_folder, g_strerror (EISDIR));
  check_fault (put_a_pipe, "not a regular file");
  check_fault (put_a_loop, g_strerror (ELOOP));
  /* Nothing is forbidden to root. */
  if (geteuid () != 0)
    check_fault (forbid_it, g_strerror (EACCES));
}

static void
test_what_is_no_lesson_in_its_place_is_told (void)
{
  check_fault (empty_it, "l.md:1:1: ");
  check_fault (cut_it_off, "l.md:");
}

/* Sites */

static void
remove_sites (Reader *reader)
{
  g_assert_cmpint (g_remove (reader->sites), ==, 0);
}

static void
spoil_sites (Reader *reader)
{
  save_text (reader->sites, "0 0\n1 one\n");
}

static void
name_others (Reader *reader)
{
  g_auto (GStrv) parts = g_strsplit (text, SITE_FILE, 2);
  g_autofree char *other = g_strconcat (parts[0], "o.txt", parts[1], NULL);

  save_text (reader->path, other);
}

static void
test_sites_that_go_are_told (void)
{
  check_fault (remove_sites, "l.md:5:12: ");
  check_fault (spoil_sites, SITE_FILE ":2: ");
}

static guint
n_sites (Reader *reader)
{
  return session_get_set (reader->session)->n_sites;
}

static void
test_sites_that_are_saved_are_shown (void)
{
  Reader reader;

  begin (&reader);
  save_text (reader.sites, FIVE_SITES "0.25 0.5\n");
  await_state (&reader, is_renewed);
  g_assert_cmpuint (n_sites (&reader), ==, 6);
  g_assert_cmpstr (stop_title (&reader), ==, "Which?");
  end (&reader);
}

/* The author writes the name first and the file then. */
static void
test_sites_that_are_missing_are_waited_for (void)
{
  Reader reader;
  g_autofree char *others = NULL;

  begin (&reader);
  others = g_build_filename (reader.folder, "o.txt", NULL);
  name_others (&reader);
  await_state (&reader, is_told);
  assert_runs_on (&reader);
  save_text (others, FIVE_SITES "0.25 0.5\n");
  await_state (&reader, is_renewed);
  g_assert_null (reader.told);
  g_assert_cmpuint (n_sites (&reader), ==, 6);
  end (&reader);
}

/* Saving */

/* As an editor does that writes in two pieces. Returns: FALSE: the machine has
 * slept so long in between that the first could have been all. */
static gboolean
write_in_two_pieces (Reader *reader, const char *content)
{
  const gint64 begin_us = g_get_monotonic_time ();
  FILE *file = g_fopen (reader->path, "we");

  fwrite (content, 1, middle (), file);
  fflush (file);
  pass (250);
  assert_runs_on (reader);
  fputs (content + middle (), file);
  fclose (file);
  return g_get_monotonic_time () - begin_us < 500 * G_TIME_SPAN_MILLISECOND;
}

static void
test_what_is_half_written_is_not_told (void)
{
  g_autofree char *longer = g_strconcat (text, "\n## More\n", NULL);
  g_autofree char *other = NULL;
  Reader reader;

  begin (&reader);
  while (!write_in_two_pieces (&reader, longer)) {
    end (&reader);
    begin (&reader);
  }
  await_state (&reader, is_renewed);
  g_assert_cmpuint (reader.n_told, ==, 0);
  g_assert_cmpuint (session_get_n_stops (reader.session), ==, 4);

  other = g_build_filename (reader.folder, "l.md.new", NULL);
  reader.first = session_get_lesson (reader.session);
  save_text (other, text);
  remove_it (&reader);
  g_assert_cmpint (g_rename (other, reader.path), ==, 0);
  await_state (&reader, is_renewed);
  g_assert_cmpuint (reader.n_told, ==, 0);
  g_assert_cmpstr (stop_title (&reader), ==, "Which?");
  end (&reader);
}

/* A file without its last stops is a lesson too. */
static void
test_a_file_cut_between_stops_costs_no_place (void)
{
  Reader reader;

  begin (&reader);
  save (reader.path, text, (gsize)(strstr (text, "## Which?") - text));
  await_state (&reader, is_renewed);
  g_assert_cmpstr (stop_title (&reader), ==, "Start");
  reader.first = session_get_lesson (reader.session);
  save_text (reader.path, text);
  await_state (&reader, is_renewed);
  g_assert_cmpstr (stop_title (&reader), ==, "Which?");
  end (&reader);
}

static void
test_what_is_saved_as_it_was_costs_no_answer (void)
{
  g_autoptr (GVariant) attempt = NULL;
  Reader reader;

  begin (&reader);
  g_assert_true (action_run (reader.session, "answer-toggle",
                             g_variant_new_string ("f0"), NULL));
  save_text (reader.path, text);
  save_text (reader.sites, FIVE_SITES);
  pass (400);
  assert_runs_on (&reader);
  attempt = g_variant_ref_sink (
      action_get_state (action_find ("attempt"), reader.session));
  g_assert_cmpstr (g_variant_get_string (attempt, NULL), ==, "f0");
  end (&reader);
}

static void
test_a_link_is_followed (void)
{
  Reader reader;
  g_autofree char *link = NULL;

  begin (&reader);
  link = g_build_filename (reader.folder, "link.md", NULL);
  g_assert_cmpint (symlink ("l.md", link), ==, 0);
  lesson_watch_set_path (reader.watch, link);
  save_text (reader.path, text);
  name_others (&reader);
  await_state (&reader, is_told);
  assert_runs_on (&reader);
  end (&reader);
}

static void
test_a_drag_comes_to_its_end (void)
{
  g_autofree char *longer = g_strconcat (text, "\n## More\n", NULL);
  Reader reader;

  begin (&reader);
  session_set_stop (reader.session, 2);
  session_begin_edit (reader.session);
  g_assert_true (
      session_move_site (reader.session, 4, (Site){ 0.5, 0.5 }, NULL));
  save_text (reader.path, longer);
  await_state (&reader, is_renewed);
  session_end_edit (reader.session);
  g_assert_cmpstr (stop_title (&reader), ==, "End");
  g_assert_cmpfloat (session_get_set (reader.session)->sites[4].x, ==, 0.2);
  /* What was dragged can be had back. */
  g_assert_true (action_run (reader.session, "undo", NULL, NULL));
  g_assert_cmpfloat (session_get_set (reader.session)->sites[4].x, ==, 0.5);
  end (&reader);
}

static void
test_two_windows_follow_one_file (void)
{
  g_autofree char *longer = g_strconcat (text, "\n## More\n", NULL);
  Reader reader, other = { 0 };

  begin (&reader);
  other.session = session_new ();
  other.first = reader.first;
  session_set_lesson (other.session, other.first);
  other.watch = lesson_watch_new (other.session, tell, &other);
  lesson_watch_set_path (other.watch, reader.path);
  save_text (reader.path, longer);
  await_state (&reader, is_renewed);
  await_state (&other, is_renewed);
  g_assert_cmpstr (stop_title (&reader), ==, "Which?");
  g_assert_cmpstr (stop_title (&other), ==, "Start");
  lesson_watch_free (other.watch);
  g_object_unref (other.session);
  end (&reader);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/lesson-watch/a-lesson-that-goes-runs-on",
    test_a_lesson_that_goes_runs_on },
  { "/lesson-watch/what-is-no-file-in-its-place-is-told",
    test_what_is_no_file_in_its_place_is_told },
  { "/lesson-watch/what-is-no-lesson-in-its-place-is-told",
    test_what_is_no_lesson_in_its_place_is_told },
  { "/lesson-watch/sites-that-go-are-told", test_sites_that_go_are_told },
  { "/lesson-watch/sites-that-are-saved-are-shown",
    test_sites_that_are_saved_are_shown },
  { "/lesson-watch/sites-that-are-missing-are-waited-for",
    test_sites_that_are_missing_are_waited_for },
  { "/lesson-watch/what-is-half-written-is-not-told",
    test_what_is_half_written_is_not_told },
  { "/lesson-watch/a-file-cut-between-stops-costs-no-place",
    test_a_file_cut_between_stops_costs_no_place },
  { "/lesson-watch/what-is-saved-as-it-was-costs-no-answer",
    test_what_is_saved_as_it_was_costs_no_answer },
  { "/lesson-watch/a-link-is-followed", test_a_link_is_followed },
  { "/lesson-watch/a-drag-comes-to-its-end", test_a_drag_comes_to_its_end },
  { "/lesson-watch/two-windows-follow-one-file",
    test_two_windows_follow_one_file },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
