/* hull2vd-cli with little memory and time, as a test of what it refuses. */
#ifndef LIMITED_H
#define LIMITED_H

#include <glib.h>

typedef struct LimitedResult {
  int status; /* exit status, or -1: ended by a signal */
  char *out, *err;
} LimitedResult;

/* Runs COMMAND PATH in @folder. */
LimitedResult
limited_run (const char *folder, const char *command, const char *path);
void limited_result_clear (LimitedResult *result);

/* Returns: (transfer full): a folder of its own. */
char *limited_make_folder (void);

/* Removes it with all that is in it, and frees its name. */
void limited_remove_folder (char *folder);

#endif
