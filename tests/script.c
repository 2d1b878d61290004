#include "script.h"

static char *folder; /* the tests run in it */

void
script_result_clear (ScriptResult *result)
{
  g_free (result->out);
  g_free (result->err);
}

void
script_run_in (const char *locale,
               const char *input,
               ScriptResult *result,
               const char *line)
{
  g_autoptr (GSubprocessLauncher) launcher = g_subprocess_launcher_new (
      G_SUBPROCESS_FLAGS_STDIN_PIPE | G_SUBPROCESS_FLAGS_STDOUT_PIPE
      | G_SUBPROCESS_FLAGS_STDERR_PIPE);
  g_autoptr (GSubprocess) process = NULL;
  g_autoptr (GError) error = NULL;
  g_autofree char *command = g_strdup_printf ("\"$HULL2VD_CLI\" %s", line);
  const char *const argv[] = { "sh", "-c", command, NULL };

  g_subprocess_launcher_setenv (launcher, "LC_ALL", locale, TRUE);
  g_subprocess_launcher_set_cwd (launcher, folder);
  process = g_subprocess_launcher_spawnv (launcher, argv, &error);
  g_assert_no_error (error);
  g_subprocess_communicate_utf8 (process, input, NULL, &result->out,
                                 &result->err, &error);
  g_assert_no_error (error);
  g_assert_true (g_subprocess_get_if_exited (process));
  result->status = g_subprocess_get_exit_status (process);
}

void
script_run (ScriptResult *result, const char *line)
{
  script_run_in ("C", NULL, result, line);
}

void
script_put (const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

gboolean
script_exists (const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  return g_file_test (path, G_FILE_TEST_EXISTS);
}

char *
script_get (const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  char *text = NULL;

  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  return text;
}

#define LESSON(title, steps)                                                   \
  "# " title "\n\n```lesson\nformat 1\nsites -1 -0.5; 1 -0.8125; "             \
  "0.75 0.8125; -0.9375 0.5625; 0.1875 -0.1875\n```\n\n## See\n\n"             \
  "```steps\n" steps "```\n"

static void
put_files (void)
{
  script_put (
      "five.txt",
      "-1 -0.5\n1 -0.8125\n0.75 0.8125\n-0.9375 0.5625\n0.1875 -0.1875\n");
  script_put ("bad.txt", "0 0\n1 one\n");
  script_put ("square.txt", "0 0\n1 0\n1 1\n0 1\n");
  script_put ("good.md",
              LESSON ("Good", "goto round 1 see\nexpect visible 2\n") //
              "\n## End\n\n```steps\ngoto complete\nexpect facets 6\n```\n");
  script_put ("failing.md",
              LESSON ("Failing", "goto round 1 see\nexpect visible 3\n"));
  script_put ("broken.md", LESSON ("Broken", "gotto round 1 see\n"));
  script_put ("far.md", LESSON ("Far", "goto round 7 see\n"));
}

int
script_test_run (void)
{
  g_autofree char *remove = NULL;
  int status;

  folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  put_files ();
  status = g_test_run ();
  remove = g_strdup_printf ("rm -rf '%s'", folder);
  g_spawn_command_line_sync (remove, NULL, NULL, NULL, NULL);
  g_free (folder);
  return status;
}
