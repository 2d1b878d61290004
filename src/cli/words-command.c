/* words: what there is to translate, in a form that xgettext reads. */
#include "cli.h"
#include "lesson-words.h"

typedef struct Output {
  FILE *file;
  const char *path;
} Output;

/* Words are never formats, whatever follows a "%" in them. */
static void
write_words (const char *words, guint line, gpointer user)
{
  const Output *output = user;

  fprintf (output->file, "#line %u \"%s\"\n/* xgettext:no-c-format */ _(\"",
           line, output->path);
  for (; *words != '\0'; words++) {
    if (*words == '"' || *words == '\\')
      fputc ('\\', output->file);
    fputc (*words, output->file);
  }
  fprintf (output->file, "\");\n");
}

CliStatus
cli_words (const CliCommand *command, int argc, char **argv)
{
  g_auto (GStrv) paths = NULL;
  GError *error = NULL;
  CliOutput output;

  if (!cli_parse (command, NULL, (CliCount){ 1, G_MAXUINT }, argc, argv,
                  &paths))
    return CLI_USAGE;
  cli_output_begin (&output);
  for (guint i = 0; paths[i] != NULL; i++) {
    Output words = { output.file, paths[i] };

    if (!lesson_words_find (paths[i], write_words, &words, &error)) {
      cli_output_drop (&output);
      return cli_fail (error);
    }
  }
  return cli_output_end (&output, NULL);
}
