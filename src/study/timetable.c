#include "timetable.h"

#include <math.h>

/* Nobody measures single seconds. */
#define GRAIN_S 15.0

static guint
weight_before (const Lesson *lesson, guint stop)
{
  guint weight = 0;

  for (guint i = 0; i < stop; i++)
    weight += lesson_stop (lesson, i)->question != NULL ? 2 : 1;
  return weight;
}

guint
timetable_begin (const Lesson *lesson, guint stop)
{
  const double part = (double)weight_before (lesson, stop)
                      / weight_before (lesson, lesson->stops->len);

  return (guint)(GRAIN_S * round (60.0 * lesson->minutes * part / GRAIN_S));
}

char *
timetable_text (const Lesson *lesson, guint stop)
{
  const guint begin = timetable_begin (lesson, stop);
  const guint end = timetable_begin (lesson, stop + 1);

  if (lesson->minutes == 0)
    return g_strdup ("");
  return g_strdup_printf ("%u:%02u – %u:%02u", begin / 60, begin % 60, end / 60,
                          end % 60);
}
