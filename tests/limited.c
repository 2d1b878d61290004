#include "limited.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

/* What AddressSanitizer reserves is no memory of ours. */
#if defined(__SANITIZE_ADDRESS__)
#define IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define IS_SANITIZED 1
#endif
#endif
#ifndef IS_SANITIZED
#define IS_SANITIZED 0
#endif

/* More than any refusal may take: a program that hangs is ended, and the test
 * fails by its signal. */
static void
limit (gpointer user)
{
  const struct rlimit memory = { 200 << 20, 200 << 20 };
  const struct rlimit seconds = { 100, 100 };

  (void)user;
  if (!IS_SANITIZED)
    setrlimit (RLIMIT_AS, &memory);
  setrlimit (RLIMIT_CPU, &seconds);
}

LimitedResult
limited_run (const char *folder, const char *command, const char *path)
{
  const char *argv[] = { g_getenv ("HULL2VD_CLI"), command, path, NULL };
  LimitedResult result;
  g_autoptr (GError) error = NULL;
  int status;

  g_spawn_sync (folder, (char **)argv, NULL, 0, limit, NULL, &result.out,
                &result.err, &status, &error);
  g_assert_no_error (error);
  result.status = WIFEXITED (status) ? WEXITSTATUS (status) : -1;
  return result;
}

void
limited_result_clear (LimitedResult *result)
{
  g_free (result->out);
  g_free (result->err);
}

char *
limited_make_folder (void)
{
  return g_dir_make_tmp ("hull2vd-hostile-XXXXXX", NULL);
}

void
limited_remove_folder (char *folder)
{
  const char *const argv[] = { "rm", "-rf", folder, NULL };

  g_spawn_sync (NULL, (char **)argv, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL,
                NULL, NULL, NULL, NULL);
  g_free (folder);
}
