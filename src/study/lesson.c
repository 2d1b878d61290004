#include "lesson.h"

#include "stop-state.h"

G_DEFINE_QUARK (lesson - error - quark, lesson_error)

Lesson *
lesson_ref (Lesson *lesson)
{
  g_atomic_int_inc (&lesson->reference_count);
  return lesson;
}

void
lesson_unref (Lesson *lesson)
{
  if (!g_atomic_int_dec_and_test (&lesson->reference_count))
    return;
  g_free (lesson->path);
  g_free (lesson->title);
  g_free (lesson->prose);
  g_free (lesson->note);
  g_free (lesson->sites);
  g_ptr_array_unref (lesson->stops);
  g_clear_pointer (&lesson->start, stop_state_free);
  g_free (lesson);
}

const LessonStop *
lesson_stop (const Lesson *lesson, guint index)
{
  return g_ptr_array_index (lesson->stops, index);
}
