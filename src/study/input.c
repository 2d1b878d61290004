#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

gboolean
input_is_standard (const char *path)
{
  return g_str_equal (path, "-");
}

int
input_open (const char *path, gboolean waits)
{
  int descriptor;

  if (input_is_standard (path))
    return fcntl (STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
  if (waits)
    return g_open (path, O_RDONLY | O_CLOEXEC, 0);
  descriptor = g_open (path, O_RDONLY | O_CLOEXEC | O_NONBLOCK, 0);
  if (descriptor >= 0)
    fcntl (descriptor, F_SETFL, 0);
  return descriptor;
}

/* Returns: whether all could be read; if not, errno says why. */
static gboolean
read_all (int descriptor, GString *text)
{
  char bytes[1 << 16];

  for (;;) {
    const gssize n = read (descriptor, bytes, sizeof bytes);

    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return n == 0;
    g_string_append_len (text, bytes, n);
    if (memchr (bytes, '\0', (gsize)n) != NULL)
      return TRUE;
  }
}

char *
input_read (const char *path, gsize *length)
{
  const int descriptor = input_open (path, TRUE);
  GString *text;
  gboolean is_read;
  int reason;

  if (descriptor < 0)
    return NULL;
  text = g_string_new (NULL);
  is_read = read_all (descriptor, text);
  reason = errno;
  close (descriptor);
  errno = reason;
  *length = text->len;
  return g_string_free (text, !is_read);
}
