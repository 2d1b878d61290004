#include "lesson.h"

#include "stop-state.h"

G_DEFINE_QUARK (lesson - error - quark, lesson_error)

gboolean
lesson_refuse (GError **error, const char *format, ...)
{
  va_list arguments;

  va_start (arguments, format);
  g_propagate_error (error,
                     g_error_new_valist (LESSON_ERROR, LESSON_ERROR_BROKEN,
                                         format, arguments));
  va_end (arguments);
  return FALSE;
}

static const char *const views_names[N_VIEWS] = {
  [VIEWS_BOTH] = "both",
  [VIEWS_PLANE] = "plane",
  [VIEWS_SPACE] = "space",
};

const char *
views_name (Views views)
{
  return views_names[views];
}

gboolean
views_parse (const char *name, Views *views)
{
  for (Views i = 0; i < N_VIEWS; i++)
    if (g_str_equal (name, views_names[i])) {
      *views = i;
      return TRUE;
    }
  return FALSE;
}

const char *
level_name (Level level)
{
  static const char *const names[N_LEVELS] = {
    [LEVEL_VIEWING] = "viewing",       [LEVEL_RESPONDING] = "responding",
    [LEVEL_CHANGING] = "changing",     [LEVEL_CONSTRUCTING] = "constructing",
    [LEVEL_PRESENTING] = "presenting",
  };

  return names[level];
}

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
  g_free (lesson->site_file);
  g_free (lesson->author);
  g_ptr_array_unref (lesson->stops);
  g_clear_pointer (&lesson->start, stop_state_free);
  g_free (lesson);
}

const LessonStop *
lesson_stop (const Lesson *lesson, guint index)
{
  return g_ptr_array_index (lesson->stops, index);
}
