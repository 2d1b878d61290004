#include "cli.h"

#include "config.h"
#include "document.h"
#include "input.h"
#include "lesson.h"
#include "picture.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

void
cli_say (const char *format, ...)
{
  g_autofree char *text = NULL, *line = NULL;
  va_list arguments;

  va_start (arguments, format);
  text = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  line = g_utf8_make_valid (text, -1);
  for (char *byte = line; *byte != '\0'; byte++)
    if (g_ascii_iscntrl (*byte))
      *byte = ' ';
  fprintf (stderr, "%s\n", line);
}

static void
print_usage (const CliCommand *command)
{
  g_autofree char *line
      = g_strdup_printf (_ ("usage: hull2vd-cli %s [OPTION…] %s\n"),
                         command->name, command->arguments);

  fprintf (stderr, "%s\n", g_strchomp (line));
}

CliStatus
cli_usage (const CliCommand *command, const char *format, ...)
{
  g_autofree char *reason = NULL;
  va_list arguments;

  va_start (arguments, format);
  reason = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  cli_say ("hull2vd-cli: %s", reason);
  print_usage (command);
  return CLI_USAGE;
}

gboolean
cli_pdf (const CliCommand *command, const char *path)
{
  PictureFormat format = PICTURE_PDF;

  if (path == NULL) {
    cli_usage (command, _ ("no output file is given: use -o FILE.pdf"));
    return FALSE;
  }
  picture_format_of (path, &format);
  if (format != PICTURE_PDF)
    cli_usage (command, _ ("%s: the name of a PDF file must end in .pdf"),
               path);
  return format == PICTURE_PDF;
}

static gboolean
check_count (const CliCommand *command, CliCount count, guint n)
{
  if (n < count.least)
    cli_usage (command, _ ("%s: no file is given"), command->name);
  else if (n > count.most)
    cli_usage (command, _ ("%s: too many files"), command->name);
  return n >= count.least && n <= count.most;
}

/* What has been read from it once is not there a second time. */
static gboolean
check_input (const CliCommand *command, char **paths)
{
  guint n = 0;

  for (; paths != NULL && *paths != NULL; paths++)
    n += input_is_standard (*paths);
  if (n > 1)
    cli_usage (command, _ ("%s: “-”, standard input, can be read only once"),
               command->name);
  return n <= 1;
}

gboolean
cli_parse (const CliCommand *command,
           const GOptionEntry *options,
           CliCount count,
           int argc,
           char **argv,
           char ***arguments)
{
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_auto (GStrv) rest = NULL;
  g_autoptr (GError) error = NULL;
  const GOptionEntry remaining[] = { { .long_name = G_OPTION_REMAINING,
                                       .arg = G_OPTION_ARG_FILENAME_ARRAY,
                                       .arg_data = &rest,
                                       .arg_description = command->arguments },
                                     G_OPTION_ENTRY_NULL };
  g_autofree char *name = g_strdup_printf ("hull2vd-cli %s", command->name);

  g_set_prgname (name);
  g_option_context_set_translation_domain (context, GETTEXT_PACKAGE);
  g_option_context_set_summary (context, _ (command->sentence));
  if (options != NULL)
    g_option_context_add_main_entries (context, options, NULL);
  g_option_context_add_main_entries (context, remaining, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    cli_usage (command, "%s", error->message);
    return FALSE;
  }
  if (!check_count (command, count, rest == NULL ? 0 : g_strv_length (rest))
      || !check_input (command, rest))
    return FALSE;
  *arguments = rest == NULL ? g_new0 (char *, 1) : g_steal_pointer (&rest);
  return TRUE;
}

gboolean
cli_open_lesson (Session *session, const char *path, GError **error)
{
  return input_is_standard (path) ? document_open_lesson (session, path, error)
                                  : document_open (session, path, error);
}

gboolean
cli_number (const CliCommand *command,
            const char *option,
            const char *value,
            guint *number)
{
  guint64 parsed;

  if (value != NULL && g_ascii_isdigit (value[0])
      && g_ascii_string_to_unsigned (value, 10, 0, G_MAXUINT32, &parsed,
                                     NULL)) {
    *number = (guint)parsed;
    return TRUE;
  }
  cli_usage (command, _ ("%s needs a whole number"), option);
  return FALSE;
}

static CliStatus
status_of (const GError *error)
{
  if (error->domain == LESSON_ERROR)
    return error->code == LESSON_ERROR_CANNOT_OPEN ? CLI_CANNOT_OPEN
                                                   : CLI_BROKEN;
  if (error->domain == DOCUMENT_ERROR
      && error->code == DOCUMENT_ERROR_CANNOT_OPEN)
    return CLI_CANNOT_OPEN;
  if (error->domain == DOCUMENT_ERROR
      && error->code == DOCUMENT_ERROR_CANNOT_WRITE)
    return CLI_CANNOT_WRITE;
  return CLI_REFUSED;
}

CliStatus
cli_fail (GError *error)
{
  const CliStatus status = status_of (error);

  cli_say ("%s", error->message);
  g_error_free (error);
  return status;
}

void
cli_output_begin (CliOutput *output)
{
  output->bytes = NULL;
  output->file = open_memstream (&output->bytes, &output->length);
  if (output->file == NULL)
    g_error ("open_memstream: %s", g_strerror (errno));
}

void
cli_output_drop (CliOutput *output)
{
  fclose (output->file);
  free (output->bytes);
}

CliStatus
cli_output_fail (CliOutput *output, const char *path, GError *error)
{
  cli_output_drop (output);
  cli_say ("%s: %s", path, error->message);
  g_error_free (error);
  return CLI_CANNOT_WRITE;
}

static gboolean
write_stdout (const char *bytes, size_t length)
{
  errno = 0;
  /* Closing tells of what only the disk knows. */
  if (fwrite (bytes, 1, length, stdout) == length && fflush (stdout) == 0
      && close (STDOUT_FILENO) == 0)
    return TRUE;
  cli_say (_ ("hull2vd-cli: cannot write: %s"), g_strerror (errno));
  return FALSE;
}

/* A file that is begun is finished before a signal ends the program, so that
 * nothing half done is left. Who reads from a pipe may let it wait for ever. */
static gboolean
write_file (const char *path, const CliOutput *output, GError **error)
{
  const gboolean may_wait = g_file_test (path, G_FILE_TEST_EXISTS)
                            && !g_file_test (path, G_FILE_TEST_IS_REGULAR);
  gboolean is_written;
  sigset_t ends, before;

  sigemptyset (&ends);
  if (!may_wait) {
    sigaddset (&ends, SIGHUP);
    sigaddset (&ends, SIGINT);
    sigaddset (&ends, SIGTERM);
  }
  sigprocmask (SIG_BLOCK, &ends, &before);
  is_written = document_write (path, output->bytes, output->length, error);
  sigprocmask (SIG_SETMASK, &before, NULL);
  return is_written;
}

CliStatus
cli_output_end (CliOutput *output, const char *path)
{
  CliStatus status = CLI_DONE;
  GError *error = NULL;

  if (fclose (output->file) != 0)
    g_error ("%s", g_strerror (errno));
  if (path == NULL || g_str_equal (path, "-"))
    status = write_stdout (output->bytes, output->length) ? CLI_DONE
                                                          : CLI_CANNOT_WRITE;
  else if (!write_file (path, output, &error))
    status = cli_fail (error);
  free (output->bytes);
  return status;
}
