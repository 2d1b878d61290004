/* Files that are read, where "-" is the standard input. */
#ifndef INPUT_H
#define INPUT_H

#include <gio/gio.h>

G_BEGIN_DECLS

gboolean input_is_standard (const char *path);

/* Does not wait for somebody to write to it, where it is a pipe; reading may
 * wait.
 *
 * Returns: a descriptor to be closed, or -1 with errno set. */
int input_open (const char *path);

/* More than any file of points needs: what goes on beyond has no end. */
#define INPUT_MOST (G_GUINT64_CONSTANT (1) << 30)

/* Reads to the end, at most INPUT_MOST bytes; longer files are refused, with
 * errno EFBIG. A zero byte is the last that is read: no text has one. A pipe to
 * which nobody writes within two seconds is given up, with errno EPIPE. Who
 * holds one open and does not write is waited for, until @cancellable, unless
 * NULL, says no; then errno is ECANCELED.
 *
 * Returns: (transfer full): the bytes, or NULL with errno set. */
char *input_read (const char *path, gsize *length, GCancellable *cancellable);

G_END_DECLS

#endif
