/* Lessons: refused with a line and a column, or read; then they play to the
 * end, and whatever they expect is counted. */
#include "fuzz.h"

#include "replay.h"

#include <string.h>

static void
check_refusal (const GError *error)
{
  unsigned int line = 0, column = 0;

  fuzz_assert (error != NULL && error->domain == LESSON_ERROR);
  fuzz_assert (g_utf8_validate (error->message, -1, NULL));
  if (error->code == LESSON_ERROR_BROKEN)
    fuzz_assert (sscanf (error->message, "fuzz.md:%u:%u: ", &line, &column) == 2
                 && line >= 1 && column >= 1);
}

static void
play (Lesson *lesson)
{
  g_autoptr (Replay) replay = replay_new ();
  g_autoptr (GError) error = NULL;

  fuzz_assert (replay_add (replay, lesson, &error));
  replay_end (replay);
  fuzz_assert (replay->n_failed <= replay->n_expects);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson
      = lesson_parse ((const char *)data, size, "fuzz.md", &error);

  if (lesson == NULL)
    check_refusal (error);
  else
    play (lesson);
  return 0;
}
