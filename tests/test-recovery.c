/* Recovery files: what is left of sites in no file when a program is killed. */
#include "recovery.h"

#include "document.h"

#include <glib/gstdio.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

static char *folder;

/* A text of 1 + @n lines that says how many there are. */
static char *
make_text (guint n)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i <= n; i++)
    g_string_append_printf (text, "%u %u\n", i, n);
  return g_string_free (text, FALSE);
}

static void
write_text (Recovery *recovery, const char *origin, guint n)
{
  g_autofree char *text = make_text (n);
  g_autoptr (GError) error = NULL;

  g_assert_true (recovery_write (recovery, origin, text, &error));
  g_assert_no_error (error);
}

/* Returns: what make_text() was asked for, if the file is whole. */
static guint
read_text (const Recovery *recovery)
{
  g_autoptr (GError) error = NULL;
  SiteSet *set = document_read_points (recovery_get_path (recovery), &error);
  guint n;

  g_assert_no_error (error);
  n = (guint)site_set_given (set, 0).y;
  g_assert_cmpuint (set->n_sites, ==, n + 1);
  for (guint i = 0; i <= n; i++)
    g_assert_true (site_set_given (set, i).x == i);
  site_set_free (set);
  return n;
}

static gboolean
has_text (void)
{
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *name;

  while ((name = g_dir_read_name (dir)) != NULL)
    if (g_str_has_suffix (name, ".txt"))
      return TRUE;
  return FALSE;
}

/* Waits for a program, which is killed unless @after_us is NEVER: @after_us
 * from now. */
#define NEVER 0

static void
wait_for (pid_t child, guint after_us)
{
  int status;

  if (after_us != NEVER) {
    g_usleep (after_us);
    kill (child, SIGKILL);
  }
  g_assert_cmpint (waitpid (child, &status, 0), ==, child);
  g_assert_true (after_us != NEVER
                 || (WIFEXITED (status) && WEXITSTATUS (status) == 0));
}

static pid_t
start_another (void (*work) (void))
{
  const pid_t child = fork ();

  g_assert_cmpint (child, >=, 0);
  if (child != 0)
    return child;
  work ();
  _exit (0);
}

static void
run_another (void (*work) (void))
{
  wait_for (start_another (work), NEVER);
}

static void
write_for_ever (void)
{
  Recovery *recovery = recovery_new (folder);

  for (guint n = 3;; n++)
    write_text (recovery, "/tmp/a\nb c.txt", n);
}

static void
test_a_program_that_is_killed_leaves_a_whole_text (void)
{
  for (guint trial = 0; trial < 20; trial++) {
    const pid_t child = start_another (write_for_ever);
    g_autoptr (Recovery) left = NULL;

    while (!has_text ())
      g_usleep (100);
    wait_for (child, 1 + 200 * trial);
    left = recovery_claim (folder);
    g_assert_nonnull (left);
    g_assert_cmpuint (read_text (left), >=, 3);
    g_assert_cmpstr (recovery_get_origin (left), ==, "/tmp/a\nb c.txt");
    recovery_clear (left);
    g_assert_null (recovery_claim (folder));
  }
}

static void
test_a_program_that_is_killed_at_once_leaves_nothing_for_ever (void)
{
  for (guint trial = 0; trial < 20; trial++) {
    g_autoptr (Recovery) left = NULL;

    wait_for (start_another (write_for_ever), 1 + 50 * trial);
    left = recovery_claim (folder);
    if (left != NULL)
      recovery_clear (left);
  }
}

static void
write_once (void)
{
  write_text (recovery_new (folder), NULL, 8);
}

static void
claim_none (void)
{
  if (recovery_claim (folder) != NULL)
    _exit (1);
}

static void
test_what_a_living_program_holds_is_nobody_elses (void)
{
  g_autoptr (Recovery) first = recovery_new (folder);
  g_autoptr (Recovery) second = recovery_new (folder);

  g_assert_cmpstr (recovery_get_path (first), !=, recovery_get_path (second));
  write_text (first, NULL, 4);
  write_text (second, NULL, 5);
  g_assert_null (recovery_claim (folder));
  run_another (claim_none);
  recovery_clear (first);
  g_assert_cmpuint (read_text (second), ==, 5);
  recovery_clear (second);
}

static void
test_what_is_left_over_is_claimed_once (void)
{
  g_autoptr (Recovery) claimed = NULL;

  run_another (write_once);
  claimed = recovery_claim (folder);
  g_assert_nonnull (claimed);
  g_assert_null (recovery_get_origin (claimed));
  g_assert_null (recovery_claim (folder));
  run_another (claim_none);
  g_assert_cmpuint (read_text (claimed), ==, 8);
  /* Its holder writes where it was. */
  write_text (claimed, NULL, 9);
  g_assert_cmpuint (read_text (claimed), ==, 9);
  recovery_clear (claimed);
}

static void
test_what_is_let_go_of_is_left_for_later (void)
{
  Recovery *claimed;

  run_another (write_once);
  for (guint i = 0; i < 3; i++) {
    claimed = recovery_claim (folder);
    g_assert_nonnull (claimed);
    g_assert_cmpuint (read_text (claimed), ==, 8);
    if (i == 2)
      recovery_clear (claimed);
    recovery_free (claimed);
  }
  g_assert_null (recovery_claim (folder));
}

static void
test_a_folder_that_cannot_be_written_is_told (void)
{
  g_autofree char *file = g_build_filename (folder, "file", NULL);
  g_autoptr (Recovery) recovery = recovery_new (file);
  g_autoptr (GError) error = NULL;

  g_assert_true (g_file_set_contents (file, "", 0, NULL));
  g_assert_false (recovery_write (recovery, NULL, "0 0\n", &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE);
  g_assert_null (recovery_claim (file));
  g_unlink (file);
}

int
main (int argc, char **argv)
{
  int status;

  g_test_init (&argc, &argv, NULL);
  folder = g_dir_make_tmp ("hull2vd-recovery-XXXXXX", NULL);
  g_test_add_func ("/recovery/a-program-that-is-killed-leaves-a-whole-text",
                   test_a_program_that_is_killed_leaves_a_whole_text);
  g_test_add_func (
      "/recovery/a-program-that-is-killed-at-once-leaves-nothing-for-ever",
      test_a_program_that_is_killed_at_once_leaves_nothing_for_ever);
  g_test_add_func ("/recovery/what-a-living-program-holds-is-nobody-elses",
                   test_what_a_living_program_holds_is_nobody_elses);
  g_test_add_func ("/recovery/what-is-left-over-is-claimed-once",
                   test_what_is_left_over_is_claimed_once);
  g_test_add_func ("/recovery/what-is-let-go-of-is-left-for-later",
                   test_what_is_let_go_of_is_left_for_later);
  g_test_add_func ("/recovery/a-folder-that-cannot-be-written-is-told",
                   test_a_folder_that_cannot_be_written_is_told);
  status = g_test_run ();
  /* Nothing is left in it, not even a lock. */
  g_assert_cmpint (g_rmdir (folder), ==, 0);
  g_free (folder);
  return status;
}
