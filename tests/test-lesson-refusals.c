/* Lessons that must be refused, each by its line and column. */
#include "lesson-text.h"
#include "lesson.h"

#include <string.h>
#include <time.h>

static void
assert_broken_bytes (const char *text, gsize length, const char *message)
{
  g_autoptr (GError) error = NULL;

  g_autoptr (Lesson) lesson = lesson_parse (text, length, "l.md", &error);

  if (lesson != NULL) {
    g_test_message ("expected %s…, found nothing wrong", message);
    g_test_fail ();
    return;
  }
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
  if (!g_str_has_prefix (error->message, message)) {
    g_test_message ("expected %s…, found %s", message, error->message);
    g_test_fail ();
  }
  g_assert_cmpuint (strlen (error->message), <=, 2000);
}

static void
assert_broken (const char *text, const char *message)
{
  assert_broken_bytes (text, strlen (text), message);
}

typedef struct Row {
  const char *text;    /* of the lesson */
  const char *message; /* how its refusal begins */
} Row;

static void
check_rows (gconstpointer data)
{
  for (const Row *row = data; row->text != NULL; row++)
    assert_broken (row->text, row->message);
}

static const Row structure[] = {
  { "", "l.md:1:1: the file is empty" },
  { "\n\n", "l.md:1:1: a lesson begins with its title" },
  { "words\n", "l.md:1:1: a lesson begins with its title" },
  { "## S\n", "l.md:1:1: a lesson begins with its title" },
  { "#\n", "l.md:1:1: a heading without words" },
  { "# T\n", "l.md:1:1: there is no lesson block" },
  { "# T\n\n# U\n", "l.md:3:1: a second title" },
  { "# T\n\n## S\n", "l.md:3:1: the lesson block must stand before" },
  { HEAD, "l.md:7:1: there is no stop" },
  { HEAD "##\n", "l.md:8:1: a heading without words" },
  { HEAD HEAD, "l.md:8:1: a second title" },
  { HEAD "```lesson\nformat 1\n```\n",
    "l.md:8:1: a second lesson block; the first is on line 3" },
  { HEAD "## S\n\n```lesson\nformat 1\n```\n",
    "l.md:10:1: the lesson block must stand before" },
  { HEAD "```steps\ngoto start\n```\n",
    "l.md:8:1: a steps block belongs to a stop" },
  { STEPS ("goto start") "\n```steps\ngoto start\n```\n",
    "l.md:14:1: a second steps block in this stop; the first is on line 10" },
  { HEAD "## S\n\n```step\ngoto start\n```\n",
    "l.md:10:1: this program knows no “step” blocks (did you mean “steps”?)" },
  { HEAD "## S\n\n```aks\nbefore round 1 see\n```\n",
    "l.md:10:1: this program knows no “aks” blocks (did you mean “ask”?)" },
  { HEAD "## S\n\n- a\n\n  ```steps\n  goto start\n  ```\n",
    "l.md:12:1: a steps block stands by itself" },
  { HEAD "## S\n\n> ```steps\n> goto start\n> ```\n",
    "l.md:10:1: a steps block stands by itself" },
  { HEAD "## S\n\n```steps\ngoto start\n",
    "l.md:10:1: this block is not closed" },
  { HEAD "## S\n\n```steps", "l.md:10:1: this block is not closed" },
  { NULL, NULL },
};

static const Row head[] = {
  { "# T\n\n```lesson\n```\n\n## S\n",
    "l.md:3:1: the lesson block needs a line: format 1" },
  { "# T\n\n```lesson\nformat 1\n```\n\n## S\n",
    "l.md:3:1: the lesson block needs a line: sites" },
  { "# T\n\n```lesson\nformat 2\n```\n\n## S\n",
    "l.md:4:1: format 2 is newer than this program knows; open this lesson "
    "with a Hull2VD that knows lesson format 2" },
  { "# T\n\n```lesson\nformat one\n```\n\n## S\n",
    "l.md:4:8: the format is a whole number" },
  { "# T\n\n```lesson\nformat 0\n```\n\n## S\n",
    "l.md:4:8: the format is a whole number" },
  { "# T\n\n```lesson\nformat 1\n  format 1\n```\n\n## S\n",
    "l.md:5:3: a second format" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nsites 0 0\n```\n\n## S\n",
    "l.md:6:1: a second sites line" },
  { "# T\n\n```lesson\nformt 1\n```\n\n## S\n",
    "l.md:4:1: a lesson block has no “formt” (did you mean “format”?)" },
  { "# T\n\n```lesson\ninclude other.md\n```\n\n## S\n",
    "l.md:4:1: a lesson block has no “include”" },
  { NULL, NULL },
};

static const Row sites[] = {
  { SITES (""), "l.md:5:6: a site is missing" },
  { SITES ("0"), "l.md:5:7: " },
  { SITES ("0 0; 1"), "l.md:5:12: " },
  { SITES ("0 0;"), "l.md:5:11: a site is missing" },
  { SITES ("0 0;;1 1"), "l.md:5:11: a site is missing" },
  { SITES ("0 0; 1 1 1"), "l.md:5:12: " },
  { SITES ("nan 0"), "l.md:5:7: " },
  { SITES ("0 0; 0 inf"), "l.md:5:12: " },
  { SITES ("0 0; 0x10 0"), "l.md:5:12: " },
  { SITES ("0 0; 1e400 0"), "l.md:5:12: " },
  { SITES ("0 0; 1,5 2,5"), "l.md:5:12: " },
  { SITES ("0 0; 1e145 0; 0 1e-145"), "l.md:5:21: this site’s coordinates" },
  { SITES ("random 5"), "l.md:5:7: write “random N seed S”" },
  { SITES ("random 5 seed"), "l.md:5:7: write “random N seed S”" },
  { SITES ("random 1e3 seed 1"), "l.md:5:7: write “random N seed S”" },
  { SITES ("random -1 seed 1"), "l.md:5:7: write “random N seed S”" },
  { SITES ("random 1000000000000000000 seed 1"),
    "l.md:5:7: there is no such set" },
  { SITES ("random 2147483648 seed 1"), "l.md:5:7: there is no such set" },
  { SITES ("random 99999999999999999999 seed 1"), "l.md:5:7: write" },
  { SITES ("grid 1000 1000"),
    "l.md:5:7: there is no such set of 1000000 sites; the nearest has 20000" },
  { SITES ("grid 65536 65536"), "l.md:5:7: there is no such set" },
  { SITES ("grid 65536 65537"), "l.md:5:7: there is no such set" },
  { SITES ("circle 10000"),
    "l.md:5:7: there is no such set of 10000 sites; the nearest has 8192" },
  { SITES ("circl 8"),
    "l.md:5:7: “circl” makes no sites (did you mean “circle”?)" },
  { SITES ("file"), "l.md:5:11: which file?" },
  { SITES ("file no-such-file.txt"), "l.md:5:12: No such file" },
  { SITES ("file /etc/passwd"), "l.md:5:12: a file of sites must lie" },
  { SITES ("file ../l.md"), "l.md:5:12: a file of sites must lie" },
  { SITES ("file a/../../l.md"), "l.md:5:12: a file of sites must lie" },
  { SITES ("file ~/points.txt"), "l.md:5:12: No such file" },
  { SITES ("file $HOME/points.txt"), "l.md:5:12: No such file" },
  { SITES ("file file:///etc/passwd"), "l.md:5:12: No such file" },
  { SITES ("file http://example.org/p.txt"), "l.md:5:12: No such file" },
  { SITES ("file \\\\server\\p.txt"), "l.md:5:12: No such file" },
  { SITES ("file %s%n"), "l.md:5:12: No such file" },
  { NULL, NULL },
};

static const Row commands[] = {
  { STEPS ("gotto start"),
    "l.md:11:1: “gotto” is not a command (did you mean “goto”?)" },
  { STEPS ("  run rm"), "l.md:11:3: “run” is not a command" },
  { STEPS ("open file.txt"), "l.md:11:1: “open” is not a command" },
  { STEPS ("quit"), "l.md:11:1: “quit” is not a command" },
  { STEPS ("next"), "l.md:11:1: “next” is not a command" },
  { STEPS ("repeat 1000000000"), "l.md:11:1: “repeat” is not a command" },
  { STEPS ("include l.md"), "l.md:11:1: “include” is not a command" },
  { STEPS ("goto"), "l.md:11:1: “goto” takes something after it" },
  { STEPS ("goto somewhere"), "l.md:11:1: “somewhere” is not a position" },
  { STEPS ("goto round 9 see"),
    "l.md:11:1: there is no “round 9 see”: the last round is 1" },
  { STEPS ("goto round 4294967297 see"), "l.md:11:1: “round 4294967297 see”" },
  { STEPS ("goto start\nback event"),
    "l.md:12:1: there is nothing before the start" },
  { STEPS ("goto complete\nnext phase"),
    "l.md:12:1: there is nothing after the end" },
  { STEPS ("next event 3"), "l.md:11:1: “next event” takes nothing" },
  { STEPS ("show paraboloyd"),
    "l.md:11:1: there is no layer “paraboloyd” (did you mean “paraboloid”?)" },
  { STEPS ("camera nowhere"), "l.md:11:1: there is no camera “nowhere”" },
  { STEPS ("focus all"), "l.md:11:1: nothing called “all” can be in focus" },
  { STEPS ("select s5"), "l.md:11:1: cannot select “s5”: there is no such" },
  { STEPS ("select f0"), "l.md:11:1: cannot select “f0”: this facet is not" },
  { STEPS ("add site 1"), "l.md:11:1: “add site” takes two numbers" },
  { STEPS ("add site 0,5 1"), "l.md:11:1: “add site” takes two numbers: X Y; "
                              "write decimals with a point" },
  { STEPS ("sites 0,5 1,5; 1 1"),
    "l.md:11:1: a comma stands between numbers: write decimals with a point" },
  { STEPS ("camera 12,5 30"),
    "l.md:11:1: there is no camera “12,5 30”; write decimals with a point" },
  { STEPS ("add site 1 nan"), "l.md:11:1: “add site” takes two numbers" },
  { STEPS ("add site 1e400 0"), "l.md:11:1: “add site” takes two numbers" },
  { STEPS ("add site 1 0x2"), "l.md:11:1: “add site” takes two numbers" },
  { STEPS ("move site s9 0 0"), "l.md:11:1: there is no site s9" },
  { STEPS ("remove site -1"), "l.md:11:1: “remove site” takes a site" },
  { STEPS ("sites file p.txt"), "l.md:11:1: “file” makes no sites" },
  { STEPS ("expect"), "l.md:11:1: expect needs a key" },
  { STEPS ("expect cones 3"),
    "l.md:11:1: nothing called “cones” can be expected (did you mean “cone”" },
  { STEPS ("expect cone"), "l.md:11:1: expect cone needs a whole number" },
  { STEPS ("expect cone -1"), "l.md:11:1: expect cone needs a whole number" },
  { STEPS ("expect cone 3.0"), "l.md:11:1: expect cone needs a whole number" },
  { STEPS ("expect cone 1e9"), "l.md:11:1: expect cone needs a whole number" },
  { STEPS ("expect cone 99999999999999999999"), "l.md:11:1: expect cone" },
  { STEPS ("expect phase seeing"), "l.md:11:1: expect phase needs a phase" },
  { STEPS ("expect delaunay"), "l.md:11:1: expect delaunay needs the word" },
  { STEPS ("expect narration sees"), "l.md:11:1: expect narration needs" },
  { STEPS ("expect narration contains"), "l.md:11:1: expect narration" },
  { NULL, NULL },
};

static void
test_bytes_that_are_no_text_are_refused (void)
{
  static const struct {
    const char *bytes;
    gsize length;
    const char *message;
  } rows[] = {
#define BYTES(text) (text), sizeof (text) - 1
    { BYTES ("# T\0\n"), "l.md:1:4: a zero byte" },
    { BYTES ("# T\n\xFF\n"), "l.md:2:1: this is not UTF-8" },
    { BYTES ("# \xC0\xAF\n"), "l.md:1:3: this is not UTF-8" },
    { BYTES ("# \xED\xA0\x80\n"), "l.md:1:3: this is not UTF-8" },
    { BYTES ("# \xF5\x80\x80\x80\n"), "l.md:1:3: this is not UTF-8" },
    { BYTES ("# T\xE2\x82"), "l.md:1:4: this is not UTF-8" },
    { BYTES ("\xFF\xFE#\0 \0T\0\n\0"), "l.md:1:1: this is not UTF-8" },
    { BYTES ("\x1F\x8B\x08\x00\x00"), "l.md:1:1: a control character" },
    { BYTES ("PK\x03\x04"), "l.md:1:3: a control character" },
    { BYTES ("# T\rU\n"), "l.md:1:4: a carriage return" },
    { BYTES ("# T\r# U\r"), "l.md:1:4: a carriage return" },
    { BYTES ("# \x1B[31mT\n"), "l.md:1:3: a control character" },
    { BYTES ("# a\xE2\x80\xAEz\n"), "l.md:1:4: an invisible character" },
    { BYTES ("# a\xE2\x80\x8Bz\n"), "l.md:1:4: an invisible character" },
    { BYTES ("# \xC3\xA4\xEF\xBB\xBFz\n"), "l.md:1:4: an invisible" },
    { BYTES ("# a\xC2\x85z\n"), "l.md:1:4: an invisible character" },
#undef BYTES
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    assert_broken_bytes (rows[i].bytes, rows[i].length, rows[i].message);
}

/* Repeats @unit until there are @length bytes between @before and @after. */
static char *
fill (const char *before, const char *unit, gsize length, const char *after)
{
  GString *text = g_string_new (before);

  while (text->len < strlen (before) + length)
    g_string_append (text, unit);
  g_string_append (text, after);
  return g_string_free (text, FALSE);
}

typedef struct Large {
  const char *before, *unit;
  gsize length;
  const char *after, *message;
} Large;

static const Large large[] = {
  { HEAD, "<!-- word -->\n", 4 << 20, "", "l.md:29" },
  { STOP, "x", (64 << 10) + 1, "\n", "l.md:10:1: a line longer than 64 KB" },
  { "# ", "x", 201, "\n", "l.md:1:1: a heading longer than 200" },
  { STOP, "words ", 17 << 10, "\n", "l.md:10:1: a text longer than 16 KB" },
  { STOP, "x", 1001, "\n", "l.md:10:1: a word longer than 1000 characters" },
  { STOP, "x`y`", 2500, "\n", "l.md:10:1: a word longer than 1000 characters" },
  { LECTURE "## S\n\n```ask\nprompt ", "words ", 1000, "\n```\n",
    "l.md:11:1: a line longer than 1000 characters" },
  { STOP "```steps\n", "x", 60000, "\n```\n", "l.md:11:1: “xxxxxxxxxxxxxx" },
  { STOP "```steps\nselect ", "x", 60000, "\n```\n",
    "l.md:11:1: cannot select “xxxx" },
  { STOP, "words words words words words\n\n", 290 << 10, "",
    "l.md:18088:1: the texts of this lesson are longer than 256 KB" },
  { HEAD "## S\n\n```steps\n", "show hull\n", 1000010, "```\n",
    "l.md:100011:1: more than 100000 commands" },
  { HEAD "## S\n\n```steps\n", "sites circle 1000\n", 18 * 30, "```\n",
    "l.md:30:1: the sets of this lesson have more than 20000 sites" },
  { SITES ("0 0") "\n```steps\nadd site 0", "0", 60000, "x\n```\n",
    "l.md:11:1: “add site” takes two numbers" },
  { STOP, "> ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "- ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "1. ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "+ ", 60000, "\n", "l.md:10:1: nested too deeply" },
  { STOP, "![[]()\n", 1 << 20, "", "l.md:5010:" },
  { STOP, "[", 60000, "\n", "l.md:10:10001: too many marks" },
  { STOP, "1.\n", 1 << 19, "", "l.md:10:1: a text longer than 16 KB" },
  { STOP, "a\n", 1 << 20, "", "l.md:200001:1: more than 200000 lines" },
  { STOP, "*a*\n", 1 << 20, "", "l.md:50007:1: too many marks" },
  { HEAD, "## S\n", 1 << 16, "", "l.md:1008:1: more than 1000 stops" },
  { STOP, "*a **b `c ", 60000, "\n", "l.md:10:1: a text longer than 16 KB" },
  { STOP, "<a ", 60000, "\n", "l.md:10:1: a text longer than 16 KB" },
};

static void
test_what_is_too_large_is_refused_at_once (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (large); i++) {
    const Large *row = &large[i];
    g_autofree char *text
        = fill (row->before, row->unit, row->length, row->after);
    const clock_t start = clock ();

    assert_broken (text, row->message);
    /* One second is promised; sanitizers get a few, of the processor. */
    g_assert_cmpint (clock () - start, <, 4 * CLOCKS_PER_SEC);
  }
}

/* Chinese and Thai have no blanks, and lines that end anywhere. */
static void
test_words_written_together_are_no_long_word (void)
{
  const char *const scripts[] = { "點", "จุด", "words " };

  for (guint i = 0; i < G_N_ELEMENTS (scripts); i++) {
    g_autofree char *text = fill (STOP, scripts[i], 9000, "\n");
    g_autoptr (Lesson) lesson
        = lesson_parse (text, strlen (text), "l.md", NULL);

    g_assert_nonnull (lesson);
  }
}

static void
test_a_lesson_of_almost_4_mb_is_read_at_once (void)
{
  g_autofree char *text
      = fill (STOP "```steps\n", "# a comment that says nothing at all\n",
              (4 << 20) - 1000, "goto start\n```\n");
  const clock_t start = clock ();
  g_autoptr (Lesson) lesson = lesson_parse (text, strlen (text), "l.md", NULL);

  g_assert_nonnull (lesson);
  g_assert_cmpuint (lesson_stop (lesson, 0)->commands->len, ==, 1);
  g_assert_cmpint (clock () - start, <, 4 * CLOCKS_PER_SEC);
}

/* Whatever is cut off or turned over, the reader says something or accepts
 * it; it never crashes and never speaks without a place. */
static void
parse_anything (const char *text, gsize length)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = lesson_parse (text, length, "l.md", &error);

  g_assert_true ((lesson == NULL) == (error != NULL));
  if (error != NULL)
    g_assert_true (
        g_regex_match_simple ("^l\\.md:\\d+:\\d+: .", error->message, 0, 0));
}

static const char whole[]
    = "# Täst\n\n> Note: n\n\n```lesson\nformat 1\nsites 0 0; 1 0; 0 1; 2 2\n"
      "```\n\n## S\n\nA *b* [c](d) <e>\n\n- f\n  1. g\n\n```steps\n"
      "goto simplex\nadd site 0.25 0.5\nexpect facets 4\n"
      "expect narration contains s3\n```\n";

static void
test_no_prefix_crashes (void)
{
  for (gsize length = 0; length < sizeof whole; length++)
    parse_anything (whole, length);
}

static void
test_no_flipped_bit_crashes (void)
{
  for (gsize i = 0; i < sizeof whole - 1; i++)
    for (guint bit = 0; bit < 8; bit++) {
      g_autofree char *text = g_strdup (whole);

      ((guchar *)text)[i] ^= (guchar)(1u << bit);
      parse_anything (text, sizeof whole - 1);
    }
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/refusals/bytes-that-are-no-text-are-refused",
    test_bytes_that_are_no_text_are_refused },
  { "/refusals/what-is-too-large-is-refused-at-once",
    test_what_is_too_large_is_refused_at_once },
  { "/refusals/words-written-together-are-no-long-word",
    test_words_written_together_are_no_long_word },
  { "/refusals/a-lesson-of-almost-4-mb-is-read-at-once",
    test_a_lesson_of_almost_4_mb_is_read_at_once },
  { "/refusals/no-prefix-crashes", test_no_prefix_crashes },
  { "/refusals/no-flipped-bit-crashes", test_no_flipped_bit_crashes },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  g_test_add_data_func ("/refusals/broken-structure-is-refused-by-line",
                        structure, check_rows);
  g_test_add_data_func ("/refusals/broken-lesson-blocks-are-refused-by-line",
                        head, check_rows);
  g_test_add_data_func ("/refusals/sites-that-are-none-are-refused-by-column",
                        sites, check_rows);
  g_test_add_data_func ("/refusals/commands-that-are-none-are-refused-by-line",
                        commands, check_rows);
  return g_test_run ();
}
