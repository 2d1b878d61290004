#include "cli.h"
#include "lesson-words.h"
#include "question-bank.h"

#include <archive.h>
#include <archive_entry.h>
#include <glib/gi18n.h>
#include <string.h>

/* The same package at any time: the first moment that a zip file can tell. */
#define PACKAGE_TIME 315532800

static int
add_to_package (struct archive *package, const BankFile *file)
{
  struct archive_entry *entry = archive_entry_new ();
  const size_t length = strlen (file->text);
  int status;

  archive_entry_set_pathname (entry, file->name);
  archive_entry_set_filetype (entry, AE_IFREG);
  archive_entry_set_perm (entry, 0644);
  archive_entry_set_size (entry, (la_int64_t)length);
  archive_entry_set_mtime (entry, PACKAGE_TIME, 0);
  status = archive_write_header (package, entry);
  if (status == ARCHIVE_OK
      && archive_write_data (package, file->text, length) != (la_ssize_t)length)
    status = ARCHIVE_FATAL;
  archive_entry_free (entry);
  return status;
}

static void
write_package (const QuestionBank *bank, FILE *file)
{
  g_autoptr (GPtrArray) files = question_bank_qti (bank);
  struct archive *package = archive_write_new ();
  int status = archive_write_set_format_zip (package);

  archive_write_set_bytes_in_last_block (package, 1);

  if (status == ARCHIVE_OK)
    status = archive_write_open_FILE (package, file);
  for (guint i = 0; status == ARCHIVE_OK && i < files->len; i++)
    status = add_to_package (package, g_ptr_array_index (files, i));
  if (status != ARCHIVE_OK || archive_write_close (package) != ARCHIVE_OK)
    g_error ("zip: %s", archive_error_string (package)); /* no memory */
  archive_write_free (package);
}

static void
write_gift (QuestionBank *bank, FILE *file)
{
  g_autofree char *gift = question_bank_gift (bank);

  fputs (gift, file);
}

static CliStatus
write_bank (QuestionBank *bank, gboolean is_gift, const char *path)
{
  CliOutput output;

  cli_output_begin (&output);
  if (is_gift)
    write_gift (bank, output.file);
  else
    write_package (bank, output.file);
  for (guint i = 0; i < bank->left_out->len; i++)
    cli_say ("%s", (const char *)g_ptr_array_index (bank->left_out, i));
  return cli_output_end (&output, path);
}

CliStatus
cli_questions (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (QuestionBank) bank = question_bank_new ();
  g_autofree char *path = NULL, *format = NULL;
  g_auto (GStrv) paths = NULL;
  GError *error = NULL;
  const GOptionEntry options[]
      = { { "format", 'f', 0, G_OPTION_ARG_STRING, &format,
            N_ ("gift: for Moodle; qti: a QTI 2.1 content package"),
            "gift|qti" },
          { "output", 'o', 0, G_OPTION_ARG_FILENAME, &path,
            N_ ("write to FILE instead of standard output"), "FILE" },
          G_OPTION_ENTRY_NULL };

  if (!cli_parse (command, options, (CliCount){ 1, G_MAXUINT }, argc, argv,
                  &paths))
    return CLI_USAGE;
  if (g_strcmp0 (format, "gift") != 0 && g_strcmp0 (format, "qti") != 0)
    return cli_usage (command, _ ("--format must be gift or qti"));
  for (guint i = 0; paths[i] != NULL; i++) {
    g_autoptr (Lesson) lesson = lesson_words_load (paths[i], &error);

    if (lesson == NULL)
      return cli_fail (error);
    question_bank_add (bank, lesson);
  }
  return write_bank (bank, g_str_equal (format, "gift"), path);
}
