#include "narration.h"

#include "standing.h"

#include <string.h>

typedef void (*CheckSentence) (const Fixture *fixture,
                               uint32_t step,
                               const char *sentence);
static CheckSentence check_sentence;

static void
visit_steps (const Fixture *fixture)
{
  for (uint32_t step = 0; step <= fixture->trace->n_events; step++) {
    char text[NARRATION_ROOM];

    narration_write (fixture->trace, step, NULL, text);
    check_sentence (fixture, step, text);
  }
}

static void
at_every_step (gconstpointer check)
{
  check_sentence = *(const CheckSentence *)check;
  for (const char *const *name = fixture_names (); *name != NULL; name++) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    visit_steps (fixture);
  }
  fixture_for_each (5, 16, ORDER_FURTHEST, visit_steps);
  fixture_for_each (2, 16, ORDER_RANDOM, visit_steps);
}

#define sentence_assert(condition)                                             \
  G_STMT_START                                                                 \
  {                                                                            \
    if (!(condition))                                                          \
      g_error ("%s, step %u: %s: \"%s\"", fixture->name, step, #condition,     \
               sentence);                                                      \
  }                                                                            \
  G_STMT_END

static void
check_is_a_sentence (const Fixture *fixture,
                     uint32_t step,
                     const char *sentence)
{
  sentence_assert (strlen (sentence) > 10);
  sentence_assert (strlen (sentence) < NARRATION_ROOM - 1);
  sentence_assert (g_utf8_validate (sentence, -1, NULL));
  sentence_assert (g_str_has_suffix (sentence, "."));
  sentence_assert (strpbrk (sentence, "{}%\n") == NULL);
  sentence_assert (strstr (sentence, "4294967295") == NULL);
}

/* Whether a name such as s1 stands in the sentence as a word. */
static bool
names (const char *sentence, char kind, uint32_t number)
{
  g_autofree char *pattern = g_strdup_printf ("\\b%c%u\\b", kind, number);

  return g_regex_match_simple (pattern, sentence, 0, 0);
}

static Event
event_of_step (const Fixture *fixture, uint32_t step)
{
  return trace_event (fixture->trace, step == 0 ? 0 : step - 1);
}

static void
check_names_its_event (const Fixture *fixture,
                       uint32_t step,
                       const char *sentence)
{
  const Event said = event_of_step (fixture, step);
  const Event *event = step == 0 ? NULL : &said;

  if (event == NULL || event->kind == EVENT_COMPLETE
      || event->kind == EVENT_FLAT)
    return;
  if (event->facet != INDEX_NONE)
    sentence_assert (names (sentence, 'f', event->facet));
  if (event->kind == EVENT_HORIZON || event->kind == EVENT_CONE) {
    sentence_assert (names (sentence, 's', event->ridge[0]));
    sentence_assert (names (sentence, 's', event->ridge[1]));
  }
  if (event->kind != EVENT_SIMPLEX && event->kind != EVENT_RETIRE)
    sentence_assert (names (sentence, 's', event->site));
}

static bool
says (const char *sentence, const char *format, uint32_t site)
{
  g_autofree char *name = g_strdup_printf ("s%u", site);
  g_auto (GStrv) parts = g_strsplit (format, "%", 2);
  g_autofree char *words = g_strjoinv (name, parts);

  return strstr (sentence, words) != NULL;
}

/* What a sentence says of circles and edges is so. */
static void
check_tells_the_truth (const Fixture *fixture,
                       uint32_t step,
                       const char *sentence)
{
  const Event said = event_of_step (fixture, step);
  const Event *event = step == 0 ? NULL : &said;
  g_autoptr (Judge) judge = NULL;
  g_autoptr (Standing) standing = NULL;
  Facing facing;

  if (event == NULL || event->kind != EVENT_VISIBLE)
    return;
  judge = judge_new (fixture->set);
  standing = standing_new (fixture, judge, step);
  facing = standing_facing (standing, event->facet);
  sentence_assert (standing_sees (standing, event->facet, event->site));
  sentence_assert (says (sentence, "its circle contains %", event->site)
                   == (facing == FACING_LOWER));
  sentence_assert (says (sentence, "% is outside its circle", event->site)
                   == (facing == FACING_UPPER));
  sentence_assert (says (sentence, "% is beyond this hull edge", event->site)
                   == (facing == FACING_VERTICAL));
}

static const char *
turned_round (const char *english)
{
  if (strstr (english, "its circle contains") != NULL)
    return "{f} ← {p}; {p}";
  return english;
}

static void
test_translation (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const uint32_t step = fixture->trace->rounds[0].first_visible;
  const Event event = trace_event (fixture->trace, step - 1);
  g_autofree char *expected
      = g_strdup_printf ("f%u ← s%u; s%u", event.facet, event.site, event.site);
  char text[NARRATION_ROOM];

  narration_write (fixture->trace, step, turned_round, text);
  g_assert_cmpstr (text, ==, expected);
}

static const char *
endless (const char *english)
{
  static char text[4 * NARRATION_ROOM];

  (void)english;
  for (guint i = 0; i + 6 < sizeof text; i += 5)
    memcpy (&text[i], "{p}é", 6);
  return text;
}

static void
test_long_translation (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  char text[NARRATION_ROOM];

  narration_write (fixture->trace, 9, endless, text);
  g_assert_cmpuint (strlen (text), <, NARRATION_ROOM);
  g_assert_cmpuint (strlen (text), >, NARRATION_ROOM / 2);
  g_assert_true (g_utf8_validate (text, -1, NULL));
}

int
main (int argc, char **argv)
{
  static const struct {
    const char *name;
    CheckSentence check;
  } checks[] = {
    { "every-step-has-a-whole-sentence", check_is_a_sentence },
    { "a-sentence-names-what-its-event-names", check_names_its_event },
    { "what-it-says-of-circles-and-edges-is-so", check_tells_the_truth },
  };

  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (checks); i++) {
    g_autofree char *path = g_strconcat ("/narration/", checks[i].name, NULL);

    g_test_add_data_func (path, &checks[i].check, at_every_step);
  }
  g_test_add_func ("/narration/a-translation-may-put-names-in-its-own-order",
                   test_translation);
  g_test_add_func ("/narration/a-long-translation-ends-on-a-whole-character",
                   test_long_translation);
  return g_test_run ();
}
