#include "replay.h"

#include "session.h"

Replay *
replay_new (void)
{
  Replay *replay = g_new0 (Replay, 1);

  replay->report = g_string_new (NULL);
  return replay;
}

void
replay_free (Replay *replay)
{
  g_string_free (replay->report, TRUE);
  g_free (replay);
}

/* TAP takes "#" for the start of a directive. */
static void
append_description (GString *report, const char *text)
{
  for (; *text != '\0'; text++) {
    if (*text == '#' || *text == '\\')
      g_string_append_c (report, '\\');
    g_string_append_c (report, *text);
  }
}

/* The stop that is played, for its lines of the report. */
typedef struct Playing {
  Replay *replay;
  const Lesson *lesson;
  const LessonStop *stop;
} Playing;

static void
explain (Playing *playing, const LessonCommand *command, const char *actual)
{
  playing->replay->n_failed += 1;
  if (playing->replay->n_failed <= REPLAY_MAX_EXPLAINED)
    g_string_append_printf (
        playing->replay->report, "# %s:%u: %s, but found: %s\n",
        playing->lesson->path, command->line, command->text, actual);
}

static void
on_expect (const LessonCommand *command,
           gboolean holds,
           const char *actual,
           gpointer user)
{
  Playing *playing = user;
  Replay *replay = playing->replay;

  replay->n_expects += 1;
  g_string_append_printf (replay->report, "%s %u - ", holds ? "ok" : "not ok",
                          replay->n_expects);
  append_description (replay->report, playing->lesson->title);
  g_string_append (replay->report, ": ");
  append_description (replay->report, playing->stop->title);
  g_string_append (replay->report, ": ");
  append_description (replay->report, command->text);
  g_string_append_c (replay->report, '\n');
  if (!holds)
    explain (playing, command, actual);
}

gboolean
replay_add (Replay *replay, Lesson *lesson, GError **error)
{
  g_autoptr (Session) session = session_new ();

  session_set_lesson (session, lesson);
  for (guint i = 0; i < lesson->stops->len; i++) {
    Playing playing = { replay, lesson, lesson_stop (lesson, i) };

    if (!session_play_stop (session, i, on_expect, &playing, error))
      return FALSE;
  }
  return TRUE;
}

void
replay_end (Replay *replay)
{
  if (replay->n_failed > REPLAY_MAX_EXPLAINED)
    g_string_append_printf (replay->report, "# and %u more\n",
                            replay->n_failed - REPLAY_MAX_EXPLAINED);
  g_string_append_printf (replay->report, "1..%u\n", replay->n_expects);
}
