/* Drives the built hull2vd-cli as scripts do, in a folder of its own. In it are
 * five.txt, square.txt, the lesson good.md, and some files that are not good:
 * bad.txt, failing.md, broken.md, far.md. */
#ifndef SCRIPT_H
#define SCRIPT_H

#include <gio/gio.h>

/* What a run of the program left behind. */
typedef struct ScriptResult {
  int status;
  char *out, *err;
} ScriptResult;

void script_result_clear (ScriptResult *result);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (ScriptResult, script_result_clear)

/* Runs the program with @line, which a shell reads; in the locale "C" and
 * without input, or with what is given. */
void script_run (ScriptResult *result, const char *line);
void script_run_in (const char *locale,
                    const char *input,
                    ScriptResult *result,
                    const char *line);

/* Files of the folder. */
void script_put (const char *name, const char *text);
gboolean script_exists (const char *name);
char *script_get (const char *name); /* (transfer full) */

/* g_test_run() while there is such a folder. */
int script_test_run (void);

#endif
