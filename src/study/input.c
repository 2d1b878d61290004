#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <poll.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PATIENCE 20 /* how often it is looked whether somebody writes */
#define LOOK_MS 100

gboolean
input_is_standard (const char *path)
{
  return g_str_equal (path, "-");
}

int
input_open (const char *path)
{
  int descriptor;

  if (input_is_standard (path))
    return fcntl (STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
  descriptor = g_open (path, O_RDONLY | O_CLOEXEC | O_NONBLOCK, 0);
  if (descriptor >= 0)
    fcntl (descriptor, F_SETFL, 0);
  return descriptor;
}

static gboolean
is_pipe (int descriptor)
{
  struct stat status;

  return fstat (descriptor, &status) == 0 && S_ISFIFO (status.st_mode);
}

/* A pipe has an end also while nobody has opened it to write: somebody may be
 * about to, but nobody is waited for for ever.
 *
 * Returns: FALSE with errno EPIPE when nobody writes. */
static gboolean
await_writer (int descriptor, GString *text, GCancellable *cancellable)
{
  struct pollfd pipe = { .fd = descriptor, .events = POLLIN };
  const int flags = fcntl (descriptor, F_GETFL);
  gboolean is_there = FALSE;

  fcntl (descriptor, F_SETFL, flags | O_NONBLOCK);
  for (guint i = 0;
       i < PATIENCE && !is_there && !g_cancellable_is_cancelled (cancellable);
       i++) {
    const gboolean was_written = poll (&pipe, 1, LOOK_MS) > 0;
    char byte;
    const gssize n = read (descriptor, &byte, 1);

    if (n > 0)
      g_string_append_c (text, byte);
    /* Who has not written yet, but holds it open, makes it fail. */
    is_there = was_written || n != 0;
  }
  fcntl (descriptor, F_SETFL, flags);
  errno = g_cancellable_is_cancelled (cancellable) ? ECANCELED : EPIPE;
  return is_there;
}

/* Waits until there is something to read, or the end.
 *
 * Returns: FALSE with errno ECANCELED: it is not wanted any more. */
static gboolean
await_bytes (int descriptor, GCancellable *cancellable)
{
  GPollFD no = { .fd = -1 };
  struct pollfd both[2] = { { .fd = descriptor, .events = POLLIN } };

  if (!g_cancellable_make_pollfd (cancellable, &no))
    return TRUE;
  both[1] = (struct pollfd){ .fd = no.fd, .events = POLLIN };
  while (poll (both, G_N_ELEMENTS (both), -1) < 0 && errno == EINTR)
    ;
  g_cancellable_release_fd (cancellable);
  errno = ECANCELED;
  return !g_cancellable_is_cancelled (cancellable);
}

/* Returns: whether all could be read; if not, errno says why. */
static gboolean
read_all (int descriptor, GString *text, GCancellable *cancellable)
{
  char bytes[1 << 16];

  while (await_bytes (descriptor, cancellable)) {
    const gssize n = read (descriptor, bytes, sizeof bytes);

    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return n == 0;
    g_string_append_len (text, bytes, n);
    if (memchr (bytes, '\0', (gsize)n) != NULL)
      return TRUE;
    errno = EFBIG;
    if (text->len > INPUT_MOST)
      return FALSE;
  }
  return FALSE;
}

char *
input_read (const char *path, gsize *length, GCancellable *cancellable)
{
  const int descriptor = input_open (path);
  GString *text;
  gboolean is_read;
  int reason;

  if (descriptor < 0)
    return NULL;
  text = g_string_new (NULL);
  is_read = (input_is_standard (path) || !is_pipe (descriptor)
             || await_writer (descriptor, text, cancellable))
            && read_all (descriptor, text, cancellable);
  reason = errno;
  close (descriptor);
  errno = reason;
  *length = text->len;
  return g_string_free (text, !is_read);
}
