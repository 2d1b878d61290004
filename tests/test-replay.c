#include "lesson-text.h"
#include "replay.h"

#include <string.h>

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "l.md", &error);

  g_assert_no_error (error);
  return lesson;
}

static void
test_replay_tells_each_expect (void)
{
  g_autoptr (Lesson) lesson
      = parse (STEPS ("goto round 1 see\nexpect visible 2\nexpect visible 3\n"
                      "expect narration contains # s4"));
  g_autoptr (Replay) replay = replay_new ();

  g_assert_true (replay_add (replay, lesson, NULL));
  replay_end (replay);
  g_assert_cmpuint (replay->n_expects, ==, 3);
  g_assert_cmpuint (replay->n_failed, ==, 2);
  g_assert_cmpstr (
      replay->report->str, ==,
      "ok 1 - T: S: expect visible 2\n"
      "not ok 2 - T: S: expect visible 3\n"
      "# l.md:13: expect visible 3, but found: 2\n"
      "not ok 3 - T: S: expect narration contains \\# s4\n"
      "# l.md:14: expect narration contains # s4, but found: s4 sees f1: its "
      "circle contains s4.\n"
      "1..3\n");
}

static void
test_replay_explains_the_first_failures_alone (void)
{
  g_autoptr (GString) text = g_string_new (STOP "```steps\n");
  g_autoptr (Lesson) lesson = NULL;
  g_autoptr (Replay) replay = replay_new ();

  for (guint i = 0; i < 1000; i++)
    g_string_append (text, "expect sites 9\n");
  g_string_append (text, "```\n");
  lesson = parse (text->str);
  g_assert_true (replay_add (replay, lesson, NULL));
  replay_end (replay);
  g_assert_cmpuint (replay->n_failed, ==, 1000);
  g_assert_nonnull (strstr (replay->report->str, "\n# and 980 more\n"));
}

/* Each key, at a step where its value is known from the curated facts. */
static void
test_every_key_can_be_expected (void)
{
  g_autoptr (Lesson) lesson = parse (
      STEPS ("goto round 1 hand-over\nexpect sites 5\nexpect inserted 5\n"
             "expect waiting 0\nexpect outside-sets 0\nexpect round 1\n"
             "expect step 18\nexpect facets 6\nexpect lower 4\n"
             "expect upper 2\nexpect vertical 0\nexpect visible 2\n"
             "expect horizon 4\nexpect cone 4\nexpect retired 2\n"
             "expect triangles 4\nexpect delaunay-edges 8\n"
             "expect voronoi-vertices 4\nexpect voronoi-edges 4\n"
             "expect rays 4\nexpect voronoi-lines 0\nexpect phase hand-over\n"
             "expect delaunay valid\nexpect narration contains retires"));
  g_autoptr (Replay) replay = replay_new ();

  g_assert_true (replay_add (replay, lesson, NULL));
  g_assert_cmpuint (replay->n_expects, ==, 23);
  g_assert_null (strstr (replay->report->str, "not ok"));
}

/* The examples of the reference: a whole lesson, and stops of others. */
static char **
read_examples (void)
{
  g_autofree char *path = g_build_filename (g_getenv ("HULL2VD_SOURCE"),
                                            "lessons", "README.md", NULL);
  g_autofree char *reference = NULL;

  g_assert_true (g_file_get_contents (path, &reference, NULL, NULL));
  return g_strsplit (reference, "````", -1);
}

static void
test_the_lesson_of_the_reference_holds (void)
{
  g_auto (GStrv) parts = read_examples ();
  g_autoptr (Lesson) lesson = parse (parts[1] + strlen ("markdown\n"));
  g_autoptr (Replay) replay = replay_new ();

  g_assert_true (replay_add (replay, lesson, NULL));
  g_assert_cmpuint (replay->n_expects, ==, 3);
  g_assert_cmpuint (replay->n_failed, ==, 0);
}

/* Each stop is a lesson of its own: one shows what the next asks. */
static void
play_stops (const char *example, Replay *replay)
{
  g_auto (GStrv) stops = g_strsplit (example, "\n## ", -1);

  for (guint i = 1; stops[i] != NULL; i++) {
    g_autofree char *text = g_strconcat (LECTURE "## ", stops[i], "\n", NULL);
    g_autoptr (Lesson) lesson = parse (text);

    g_assert_nonnull (lesson_stop (lesson, 0)->question);
    g_assert_true (replay_add (replay, lesson, NULL));
  }
}

static void
test_the_examples_of_the_reference_hold (void)
{
  g_auto (GStrv) parts = read_examples ();
  g_autoptr (Replay) replay = replay_new ();

  for (guint i = 3; i < g_strv_length (parts); i += 2)
    play_stops (parts[i] + strlen ("markdown"), replay);
  g_test_message ("%s", replay->report->str);
  g_assert_cmpuint (replay->n_expects, >, 4 * 20);
  g_assert_cmpuint (replay->n_failed, ==, 0);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/replay/replay-tells-each-expect", test_replay_tells_each_expect },
  { "/replay/replay-explains-the-first-failures-alone",
    test_replay_explains_the_first_failures_alone },
  { "/replay/every-key-can-be-expected", test_every_key_can_be_expected },
  { "/replay/the-lesson-of-the-reference-holds",
    test_the_lesson_of_the_reference_holds },
  { "/replay/the-examples-of-the-reference-hold",
    test_the_examples_of_the_reference_hold },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
