/* Timetables: how a lesson's minutes are shared out. */
#include "timetable.h"

#include <string.h>

#define HEAD                                                                   \
  "# T\n\n```lesson\nformat 1\nsites 0 0; 1 0; 0 1; 1 1.5; 0.25 0.25\n"
#define PLAIN "## S\n\n"
#define ASKING                                                                 \
  "## S\n\n```ask\nbefore round 1 see\nclick visible-facets\n```\n\n"

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "l.md", &error);

  g_assert_no_error (error);
  return lesson;
}

static void
test_a_question_takes_twice_the_time (void)
{
  g_autoptr (Lesson) lesson
      = parse (HEAD "minutes 8\n```\n\n" PLAIN ASKING PLAIN);
  const guint begins[] = { 0, 120, 360, 480 };

  for (guint i = 0; i < G_N_ELEMENTS (begins); i++)
    g_assert_cmpuint (timetable_begin (lesson, i), ==, begins[i]);
}

static void
test_parts_are_quarters_of_minutes_and_end_with_the_lesson (void)
{
  g_autoptr (Lesson) lesson = parse (
      HEAD "minutes 5\n```\n\n" PLAIN PLAIN PLAIN PLAIN PLAIN PLAIN PLAIN);
  g_autofree char *last = timetable_text (lesson, 6);

  for (guint i = 0; i <= 7; i++) {
    g_assert_cmpuint (timetable_begin (lesson, i) % 15, ==, 0);
    g_assert_true (i == 0
                   || timetable_begin (lesson, i)
                          > timetable_begin (lesson, i - 1));
  }
  g_assert_cmpuint (timetable_begin (lesson, 7), ==, 300);
  g_assert_cmpstr (last, ==, "4:15 – 5:00");
}

static void
test_a_lesson_that_does_not_say_has_none (void)
{
  g_autoptr (Lesson) lesson = parse (HEAD "```\n\n" PLAIN PLAIN);
  g_autofree char *text = timetable_text (lesson, 1);

  g_assert_cmpuint (timetable_begin (lesson, 1), ==, 0);
  g_assert_cmpstr (text, ==, "");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/timetable/a-question-takes-twice-the-time",
                   test_a_question_takes_twice_the_time);
  g_test_add_func (
      "/timetable/parts-are-quarters-of-minutes-and-end-with-the-lesson",
      test_parts_are_quarters_of_minutes_and_end_with_the_lesson);
  g_test_add_func ("/timetable/a-lesson-that-does-not-say-has-none",
                   test_a_lesson_that_does_not_say_has_none);
  return g_test_run ();
}
