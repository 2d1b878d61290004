#include "document.h"
#include "point-import.h"

#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A folder for one test, with a path in it. */
typedef struct Spot {
  char *folder, *path;
} Spot;

static void
spot_init (Spot *spot)
{
  spot->folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  spot->path = g_build_filename (spot->folder, "points.txt", NULL);
}

static void
spot_clear (Spot *spot)
{
  const char *const argv[] = { "rm", "-rf", spot->folder, NULL };

  g_spawn_sync (NULL, (char **)argv, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL,
                NULL, NULL, NULL, NULL);
  g_free (spot->folder);
  g_free (spot->path);
}

static void
assert_contents (const char *path, const char *expected)
{
  g_autofree char *found = NULL;

  g_assert_true (g_file_get_contents (path, &found, NULL, NULL));
  g_assert_cmpstr (found, ==, expected);
}

static guint
count_files (const char *folder)
{
  g_autoptr (GDir) directory = g_dir_open (folder, 0, NULL);
  guint n = 0;

  while (g_dir_read_name (directory) != NULL)
    n += 1;
  return n;
}

static void
test_points_open_and_save_bit_for_bit (void)
{
  g_autoptr (Session) session = session_new ();
  g_autofree char *text = NULL;
  g_autoptr (GError) error = NULL;
  Spot spot;

  spot_init (&spot);
  g_file_set_contents (spot.path, "0.1,1e-9\n1;2.5\n", -1, NULL);
  g_assert_true (document_open (session, spot.path, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  text = document_copy (session);
  g_assert_true (document_write (spot.path, text, strlen (text), &error));
  assert_contents (spot.path, "0.1 1e-09\n1 2.5\n");
  spot_clear (&spot);
}

static void
test_a_refused_file_leaves_the_session_as_it_was (void)
{
  static const Site sites[] = { { 1, 2 }, { 3, 4 } };
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;
  Spot spot;

  spot_init (&spot);
  session_set_sites (session, sites, 2, NULL);
  g_file_set_contents (spot.path, "0 0\n\n1 x\n", -1, NULL);
  g_assert_false (document_open (session, spot.path, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED);
  g_assert_nonnull (strstr (error->message, "points.txt:3: "));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  g_clear_error (&error);

  g_assert_false (document_open (session, spot.folder, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_OPEN);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  spot_clear (&spot);
}

static void
test_a_broken_lesson_leaves_the_lesson_open (void)
{
  static const char good[]
      = "# T\n\n```lesson\nformat 1\nsites 0 0\n```\n\n## S\n";
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;
  g_autofree char *lesson = NULL;
  Spot spot;

  spot_init (&spot);
  lesson = g_build_filename (spot.folder, "lesson.md", NULL);
  g_file_set_contents (lesson, good, -1, NULL);
  g_assert_true (document_open (session, lesson, &error));
  g_file_set_contents (lesson, "# U\n\nno lesson block\n", -1, NULL);
  g_assert_false (document_open (session, lesson, &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
  g_assert_cmpstr (session_get_lesson (session)->title, ==, "T");
  spot_clear (&spot);
}

static void
test_points_close_the_lesson (void)
{
  static const char text[]
      = "# T\n\n```lesson\nformat 1\nsites 0 0\n```\n\n## S\n";
  g_autoptr (Session) session = session_new ();
  g_autoptr (Lesson) lesson = lesson_parse (text, strlen (text), "l.md", NULL);
  Spot spot;

  spot_init (&spot);
  session_set_lesson (session, lesson);
  g_file_set_contents (spot.path, "0 0\n1 1\n", -1, NULL);
  g_assert_true (document_open (session, spot.path, NULL));
  g_assert_null (session_get_lesson (session));
  spot_clear (&spot);
}

static void
test_what_is_copied_can_be_pasted (void)
{
  g_autoptr (Session) session = session_new ();
  g_autofree char *copy = NULL;
  g_autoptr (GError) error = NULL;

  g_assert_true (point_import_text (session, "1 2\n0.1;-0.3\n", "clipboard",
                                    "paste", &error));
  copy = document_copy (session);
  g_assert_cmpstr (copy, ==, "1 2\n0.1 -0.3\n");
  g_assert_false (
      point_import_text (session, "words\n", "clipboard", "paste", &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  session_undo (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 0);
}

static void
test_saving_keeps_links_and_modes (void)
{
  g_autofree char *link = NULL;
  struct stat status;
  Spot spot;

  spot_init (&spot);
  link = g_build_filename (spot.folder, "link.txt", NULL);
  g_file_set_contents (spot.path, "old\n", -1, NULL);
  g_assert_cmpint (g_chmod (spot.path, 0640), ==, 0);
  g_assert_cmpint (symlink ("points.txt", link), ==, 0);

  g_assert_true (document_write (link, "new\n", 4, NULL));
  g_assert_true (g_file_test (link, G_FILE_TEST_IS_SYMLINK));
  assert_contents (spot.path, "new\n");
  g_assert_cmpint (stat (spot.path, &status), ==, 0);
  g_assert_cmpint (status.st_mode & 0777, ==, 0640);
  g_assert_cmpuint (count_files (spot.folder), ==, 2);
  spot_clear (&spot);
}

static void
test_what_cannot_be_written_is_said (void)
{
  g_autofree char *missing = NULL;
  g_autoptr (GError) error = NULL;
  Spot spot;

  spot_init (&spot);
  missing = g_build_filename (spot.folder, "no", "such", "folder", NULL);
  g_assert_false (document_write (missing, "x", 1, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE);
  g_clear_error (&error);
  g_assert_false (document_write (spot.folder, "x", 1, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE);
  g_clear_error (&error);
  g_assert_false (document_write ("/dev/full", "x", 1, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE);
  g_assert_true (g_str_has_prefix (error->message, "/dev/full: "));
  g_assert_cmpuint (count_files (spot.folder), ==, 0);
  spot_clear (&spot);
}

static gpointer
cancel_soon (gpointer user)
{
  g_usleep (50000);
  g_cancellable_cancel (user);
  return NULL;
}

/* Somebody holds the pipe open, and falls silent. */
static void
test_a_silent_writer_is_given_up (void)
{
  g_autoptr (GCancellable) wanted = g_cancellable_new ();
  g_autoptr (GError) error = NULL;
  gboolean is_foreign;
  GThread *thread;
  Spot spot;
  int writer;

  spot_init (&spot);
  g_assert_cmpint (mkfifo (spot.path, 0600), ==, 0);
  writer = g_open (spot.path, O_RDWR | O_CLOEXEC, 0);
  g_assert_cmpint (write (writer, "0 0\n", 4), ==, 4);
  thread = g_thread_new ("person", cancel_soon, wanted);
  g_assert_null (point_import_read (spot.path, &is_foreign, wanted, &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_OPEN);
  g_thread_join (thread);
  close (writer);
  spot_clear (&spot);
}

static void
test_what_is_no_file_is_refused_at_once (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;
  gboolean is_foreign;
  Spot spot;

  spot_init (&spot);
  g_assert_false (
      point_import_open (session, spot.folder, &is_foreign, &error));
  g_assert_true (g_str_has_suffix (error->message, ": Is a directory"));
  g_clear_error (&error);
  g_assert_false (
      point_import_open (session, "/dev/zero", &is_foreign, &error));
  g_assert_cmpstr (error->message, ==, "/dev/zero:1: a NUL byte");
  g_clear_error (&error);
  g_free (spot.path);
  spot.path = g_build_filename (spot.folder, "lesson.md", NULL);
  g_assert_cmpint (mkfifo (spot.path, 0600), ==, 0);
  g_assert_false (point_import_open (session, spot.path, &is_foreign, &error));
  g_assert_true (
      g_str_has_suffix (error->message, ": this is not a regular file"));
  spot_clear (&spot);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/document/points-open-and-save-bit-for-bit",
    test_points_open_and_save_bit_for_bit },
  { "/document/a-refused-file-leaves-the-session-as-it-was",
    test_a_refused_file_leaves_the_session_as_it_was },
  { "/document/a-broken-lesson-leaves-the-lesson-open",
    test_a_broken_lesson_leaves_the_lesson_open },
  { "/document/points-close-the-lesson", test_points_close_the_lesson },
  { "/document/what-is-copied-can-be-pasted",
    test_what_is_copied_can_be_pasted },
  { "/document/saving-keeps-links-and-modes",
    test_saving_keeps_links_and_modes },
  { "/document/what-cannot-be-written-is-said",
    test_what_cannot_be_written_is_said },
  { "/document/a-silent-writer-is-given-up", test_a_silent_writer_is_given_up },
  { "/document/what-is-no-file-is-refused-at-once",
    test_what_is_no_file_is_refused_at_once },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
