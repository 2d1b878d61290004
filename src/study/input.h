/* Files that are read, where "-" is the standard input. */
#ifndef INPUT_H
#define INPUT_H

#include <glib.h>

G_BEGIN_DECLS

gboolean input_is_standard (const char *path);

/* Does not wait for somebody to write to it, where it is a pipe; reading may
 * wait.
 *
 * Returns: a descriptor to be closed, or -1 with errno set. */
int input_open (const char *path);

/* Reads to the end, however long it is. A zero byte is the last that is read:
 * no text has one. A pipe to which nobody writes within two seconds is given
 * up, with errno EPIPE.
 *
 * Returns: (transfer full): the bytes, or NULL with errno set. */
char *input_read (const char *path, gsize *length);

G_END_DECLS

#endif
