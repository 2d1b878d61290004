#include "cli.h"
#include "lesson-words.h"
#include "replay.h"

/* All lessons are read before any is played.
 *
 * Returns: the worst status; messages are on stderr. */
static CliStatus
load_all (char **paths, GPtrArray *lessons)
{
  CliStatus worst = CLI_DONE;

  for (; *paths != NULL; paths++) {
    GError *error = NULL;
    Lesson *lesson = lesson_words_load (*paths, &error);

    if (lesson != NULL) {
      g_ptr_array_add (lessons, lesson);
    } else {
      const CliStatus status = cli_fail (error);

      worst = MAX (worst, status);
    }
  }
  return worst;
}

static CliStatus
play_all (GPtrArray *lessons)
{
  g_autoptr (Replay) replay = replay_new ();
  GError *error = NULL;
  CliOutput output;
  CliStatus status;

  for (guint i = 0; i < lessons->len; i++)
    if (!replay_add (replay, g_ptr_array_index (lessons, i), &error))
      return cli_fail (error);
  replay_end (replay);

  cli_output_begin (&output);
  fwrite (replay->report->str, 1, replay->report->len, output.file);
  status = cli_output_end (&output, NULL);
  return status == CLI_DONE && replay->n_failed > 0 ? CLI_REFUSED : status;
}

CliStatus
cli_replay (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (GPtrArray) lessons
      = g_ptr_array_new_with_free_func ((GDestroyNotify)lesson_unref);
  g_auto (GStrv) paths = NULL;
  CliStatus status;

  if (!cli_parse (command, NULL, (CliCount){ 1, G_MAXUINT }, argc, argv,
                  &paths))
    return CLI_USAGE;
  status = load_all (paths, lessons);
  return status == CLI_DONE ? play_all (lessons) : status;
}
