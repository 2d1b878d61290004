#include "lesson.h"
#include "replay.h"

#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define HEAD                                                                   \
  "# T\n\n```lesson\nformat 1\nsites -1 -0.5; 1 -0.8125; 0.75 0.8125; "        \
  "-0.9375 0.5625; 0.1875 -0.1875\n```\n\n"

/* A lesson with one stop, whose steps begin in line 11. */
#define STEPS(lines) HEAD "## S\n\n```steps\n" lines "\n```\n"

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "l.md", &error);

  g_assert_no_error (error);
  return lesson;
}

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
}

static void
assert_broken (const char *text, const char *message)
{
  assert_broken_bytes (text, strlen (text), message);
}

static void
test_a_lesson_is_read (void)
{
  g_autoptr (Lesson) lesson = parse (
      "# The *horizon* `f(x)`\n\nIntro **bold**.\n\n> Note: for me.\n\n"
      "```lesson\n# a comment\nformat 1\n\nsites 0 0; 1 0; 0 1; 1 1.5\n```\n\n"
      "## First & last\n\nText one.\n\nText two.\n\n```steps\n"
      "  goto simplex  \n# nothing\n\nexpect facets 4\n```\n\n"
      "> Note: one.\n\n> A quotation.\n\n> Note: two.\n>\n> Three.\n\n"
      "## Second\n");
  const LessonStop *stop = lesson_stop (lesson, 0);
  const LessonCommand *command = g_ptr_array_index (stop->commands, 0);

  g_assert_cmpstr (lesson->title, ==, "The horizon f(x)");
  g_assert_cmpstr (lesson->prose, ==, "Intro **bold**.\n");
  g_assert_cmpstr (lesson->note, ==, "for me.\n");
  g_assert_cmpuint (lesson->n_sites, ==, 4);
  g_assert_cmpuint (lesson->stops->len, ==, 2);
  g_assert_cmpstr (stop->title, ==, "First & last");
  g_assert_cmpstr (stop->prose, ==,
                   "Text one.\n\nText two.\n\n> A quotation.\n");
  g_assert_cmpstr (stop->note, ==, "one.\n\ntwo.\n\nThree.\n");
  g_assert_cmpuint (stop->line, ==, 14);
  g_assert_cmpuint (stop->commands->len, ==, 2);
  g_assert_cmpstr (command->text, ==, "goto simplex");
  g_assert_cmpuint (command->line, ==, 21);
  g_assert_cmpuint (command->column, ==, 3);
  g_assert_cmpuint (lesson_stop (lesson, 1)->commands->len, ==, 0);
  g_assert_cmpuint (stop->step, ==, lesson_stop (lesson, 1)->step);
}

static void
test_line_ends_and_marks_do_not_matter (void)
{
  g_autoptr (Lesson) plain = parse (STEPS ("goto simplex"));
  g_auto (GStrv) lines = g_strsplit (STEPS ("goto simplex"), "\n", -1);
  g_autofree char *crlf = g_strjoinv ("\r\n", lines);
  g_autofree char *marked = g_strconcat ("\xEF\xBB\xBF", crlf, NULL);
  g_autoptr (Lesson) other = parse (marked);

  g_assert_cmpstr (other->title, ==, plain->title);
  g_assert_cmpuint (lesson_stop (other, 0)->step, ==,
                    lesson_stop (plain, 0)->step);
}

static void
test_every_verb_is_carried_out (void)
{
  g_autoptr (Lesson) lesson = parse (
      STEPS ("goto before round 1 see\nnext event\nnext-event\nnext phase\n"
             "next round\ngoto complete\nback round\nback phase\nback event\n"
             "show circumcircles\nhide labels\ncamera look-up\nfocus horizon\n"
             "select s3\nadd site 0 0.25\nmove site s5 0.25 0.25\n"
             "move-site 5 0.25 0.5\nremove site s5\nsites grid 3 3\n"
             "sites 0 0; 1 0; 0 1; 0.25 0.25\ngoto complete\n"
             "expect sites 4"));
  const LessonStop *stop = lesson_stop (lesson, 0);

  g_assert_cmpuint (stop->commands->len, ==, 22);
  g_assert_cmpuint (stop->step, >, 0);
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
    "l.md:8:1: a second lesson block; the first is in line 3" },
  { HEAD "## S\n\n```lesson\nformat 1\n```\n",
    "l.md:10:1: the lesson block must stand before" },
  { HEAD "```steps\ngoto start\n```\n",
    "l.md:8:1: a steps block belongs to a stop" },
  { STEPS ("goto start") "\n```steps\ngoto start\n```\n",
    "l.md:14:1: a second steps block in this stop; the first is in line 10" },
  { HEAD "## S\n\n```step\ngoto start\n```\n",
    "l.md:10:1: this program knows no “step” blocks (did you mean “steps”?)" },
  { HEAD "## S\n\n```ask\nbefore round 1 see\n```\n",
    "l.md:10:1: this program knows no “ask” blocks" },
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

#define SITES(words)                                                           \
  "# T\n\n```lesson\nformat 1\nsites " words "\n```\n\n## S\n"

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
  { SITES ("0 0; 1e145 0; 0 1e-145"), "l.md:5:21: this site's coordinates" },
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
  { SITES ("file /etc/passwd"), "l.md:5:12: a file of sites lies below" },
  { SITES ("file ../l.md"), "l.md:5:12: a file of sites lies below" },
  { SITES ("file a/../../l.md"), "l.md:5:12: a file of sites lies below" },
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
    "l.md:11:1: “gotto” is no command (did you mean “goto”?)" },
  { STEPS ("  run rm"), "l.md:11:3: “run” is no command" },
  { STEPS ("open file.txt"), "l.md:11:1: “open” is no command" },
  { STEPS ("quit"), "l.md:11:1: “quit” is no command" },
  { STEPS ("next"), "l.md:11:1: “next” is no command" },
  { STEPS ("repeat 1000000000"), "l.md:11:1: “repeat” is no command" },
  { STEPS ("include l.md"), "l.md:11:1: “include” is no command" },
  { STEPS ("goto"), "l.md:11:1: “goto” takes something after it" },
  { STEPS ("goto somewhere"), "l.md:11:1: “somewhere” is no position" },
  { STEPS ("goto round 9 see"),
    "l.md:11:1: there is no “round 9 see”: the last round is 1" },
  { STEPS ("goto round 4294967297 see"), "l.md:11:1: “round 4294967297 see”" },
  { STEPS ("goto start\nback event"),
    "l.md:12:1: there is nothing before the start" },
  { STEPS ("goto complete\nnext phase"),
    "l.md:12:1: there is nothing after the end" },
  { STEPS ("next event 3"), "l.md:11:1: “next-event” takes nothing" },
  { STEPS ("show paraboloyd"),
    "l.md:11:1: there is no layer “paraboloyd” (did you mean “paraboloid”?)" },
  { STEPS ("camera nowhere"), "l.md:11:1: there is no camera “nowhere”" },
  { STEPS ("focus all"), "l.md:11:1: nothing called “all” can be in focus" },
  { STEPS ("select s5"), "l.md:11:1: cannot select “s5”: there is no such" },
  { STEPS ("select f0"), "l.md:11:1: cannot select “f0”: this facet is not" },
  { STEPS ("add site 1"), "l.md:11:1: “add-site” takes two numbers" },
  { STEPS ("add site 1 nan"), "l.md:11:1: “add-site” takes two numbers" },
  { STEPS ("add site 1e400 0"), "l.md:11:1: “add-site” takes two numbers" },
  { STEPS ("add site 1 0x2"), "l.md:11:1: “add-site” takes two numbers" },
  { STEPS ("move site s9 0 0"), "l.md:11:1: there is no site s9" },
  { STEPS ("remove site -1"), "l.md:11:1: “remove-site” takes a whole" },
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
#define BYTES(text) text, sizeof text - 1
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

#define STOP HEAD "## S\n\n"

static const Large large[] = {
  { HEAD, "<!-- word -->\n", 4 << 20, "", "l.md:29" },
  { STOP, "x", (64 << 10) + 1, "\n", "l.md:10:1: a line longer than 64 KB" },
  { "# ", "x", 201, "\n", "l.md:1:1: a heading longer than 200" },
  { STOP, "words ", 17 << 10, "\n", "l.md:10:1: a text longer than 16 KB" },
  { STOP, "words words words words words\n\n", 290 << 10, "",
    "l.md:18088:1: the texts of this lesson are longer than 256 KB" },
  { HEAD "## S\n\n```steps\n", "show hull\n", 1000010, "```\n",
    "l.md:100011:1: more than 100000 commands" },
  { HEAD "## S\n\n```steps\n", "sites circle 1000\n", 18 * 30, "```\n",
    "l.md:30:1: the sets of this lesson have more than 20000 sites" },
  { SITES ("0 0") "\n```steps\nadd site 0", "0", 60000, "x\n```\n",
    "l.md:11:1: “add-site” takes two numbers" },
  { STOP, "> ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "- ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "1. ", 60000, "x\n", "l.md:10:1: nested too deeply" },
  { STOP, "+ ", 60000, "\n", "l.md:10:1: nested too deeply" },
  { STOP, "![[]()\n", 1 << 20, "", "l.md:5010:" },
  { STOP, "[", 60000, "\n", "l.md:10:10001: more than 10000 brackets" },
  { STOP, "1.\n", 1 << 20, "", "l.md:10:1: a text longer than 16 KB" },
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
    const gint64 start = g_get_monotonic_time ();

    assert_broken (text, row->message);
    /* One second is promised; a busy machine gets a few. */
    g_assert_cmpint (g_get_monotonic_time () - start, <, 4 * G_USEC_PER_SEC);
  }
}

static void
test_a_lesson_of_almost_4_mb_is_read_at_once (void)
{
  g_autofree char *text
      = fill (STOP "```steps\n", "# a comment that says nothing at all\n",
              (4 << 20) - 1000, "goto start\n```\n");
  const gint64 start = g_get_monotonic_time ();
  g_autoptr (Lesson) lesson = parse (text);

  g_assert_cmpuint (lesson_stop (lesson, 0)->commands->len, ==, 1);
  g_assert_cmpint (g_get_monotonic_time () - start, <, 4 * G_USEC_PER_SEC);
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

      text[i] ^= (char)(1 << bit);
      parse_anything (text, sizeof whole - 1);
    }
}

/* A folder with files to name, removed afterwards. */
static char *
make_folder (void)
{
  char *folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  g_autofree char *below = g_build_filename (folder, "sites", NULL);

  g_assert_cmpint (g_mkdir (below, 0700), ==, 0);
  return folder;
}

static void
put_file (const char *folder, const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static void
remove_folder (char *folder)
{
  const char *const argv[] = { "rm", "-rf", folder, NULL };

  g_assert_true (g_spawn_sync (NULL, (char **)argv, NULL, G_SPAWN_SEARCH_PATH,
                               NULL, NULL, NULL, NULL, NULL, NULL));
  g_free (folder);
}

static Lesson *
load_with_sites (const char *folder, const char *name, GError **error)
{
  g_autofree char *text
      = g_strdup_printf ("# T\n\n```lesson\nformat 1\nsites file %s\n```\n\n"
                         "## S\n",
                         name);
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);

  put_file (folder, "l.md", text);
  return lesson_load (path, error);
}

static void
test_files_of_sites_are_read_below_the_lesson (void)
{
  char *folder = make_folder ();
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = NULL;

  put_file (folder, "sites/three.txt", "# three\n0 0\n1,0\n0;1\n");
  lesson = load_with_sites (folder, "sites/three.txt", &error);
  g_assert_no_error (error);
  g_assert_cmpuint (lesson->n_sites, ==, 3);
  remove_folder (folder);
}

static void
test_a_bad_file_of_sites_is_named_by_line (void)
{
  char *folder = make_folder ();
  g_autoptr (GError) error = NULL;

  put_file (folder, "sites/bad.txt", "0 0\n1 x\n");
  g_assert_null (load_with_sites (folder, "sites/bad.txt", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_SITES);
  g_assert_nonnull (strstr (error->message, "sites/bad.txt:2: "));
  remove_folder (folder);
}

static void
test_links_pipes_and_folders_are_no_files_of_sites (void)
{
  static const char *const names[]
      = { "sites/out.txt", "sites/pipe", "sites", "sites/zero", "." };
  char *folder = make_folder ();
  g_autofree char *out = g_build_filename (folder, "sites/out.txt", NULL);
  g_autofree char *zero = g_build_filename (folder, "sites/zero", NULL);
  g_autofree char *pipe = g_build_filename (folder, "sites/pipe", NULL);

  g_assert_cmpint (symlink ("/etc/passwd", out), ==, 0);
  g_assert_cmpint (symlink ("/dev/zero", zero), ==, 0);
  g_assert_cmpint (mkfifo (pipe, 0600), ==, 0);
  for (guint i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autoptr (GError) error = NULL;

    g_assert_null (load_with_sites (folder, names[i], &error));
    g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
    g_assert_nonnull (strstr (error->message, "l.md:5:12: "));
  }
  remove_folder (folder);
}

static void
test_links_inside_the_folder_are_followed (void)
{
  char *folder = make_folder ();
  g_autofree char *link = g_build_filename (folder, "sites/link.txt", NULL);
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = NULL;

  put_file (folder, "sites/one.txt", "0 0\n");
  g_assert_cmpint (symlink ("one.txt", link), ==, 0);
  lesson = load_with_sites (folder, "sites/link.txt", &error);
  g_assert_no_error (error);
  remove_folder (folder);
}

static void
test_a_lesson_that_is_not_there_cannot_be_opened (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_load ("/no/such/lesson.md", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN);
  g_clear_error (&error);
  g_assert_null (lesson_load ("/tmp", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN);
}

static void
test_names_cannot_steer_a_terminal (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_parse ("", 0, "a\n\x1B[2Jb.md", &error));
  g_assert_null (strchr (error->message, '\x1B'));
  g_assert_null (strchr (error->message, '\n'));
}

static void
test_an_endless_file_is_refused (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_load ("/dev/zero", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
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
  g_autofree char *text
      = fill (STOP "```steps\n", "expect sites 9\n", 15 * 1000, "```\n");
  g_autoptr (Lesson) lesson = parse (text);
  g_autoptr (Replay) replay = replay_new ();

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

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/lesson/a-lesson-is-read", test_a_lesson_is_read },
  { "/lesson/line-ends-and-marks-do-not-matter",
    test_line_ends_and_marks_do_not_matter },
  { "/lesson/every-verb-is-carried-out", test_every_verb_is_carried_out },
  { "/lesson/bytes-that-are-no-text-are-refused",
    test_bytes_that_are_no_text_are_refused },
  { "/lesson/what-is-too-large-is-refused-at-once",
    test_what_is_too_large_is_refused_at_once },
  { "/lesson/a-lesson-of-almost-4-mb-is-read-at-once",
    test_a_lesson_of_almost_4_mb_is_read_at_once },
  { "/lesson/no-prefix-crashes", test_no_prefix_crashes },
  { "/lesson/no-flipped-bit-crashes", test_no_flipped_bit_crashes },
  { "/lesson/files-of-sites-are-read-below-the-lesson",
    test_files_of_sites_are_read_below_the_lesson },
  { "/lesson/a-bad-file-of-sites-is-named-by-line",
    test_a_bad_file_of_sites_is_named_by_line },
  { "/lesson/links-pipes-and-folders-are-no-files-of-sites",
    test_links_pipes_and_folders_are_no_files_of_sites },
  { "/lesson/links-inside-the-folder-are-followed",
    test_links_inside_the_folder_are_followed },
  { "/lesson/a-lesson-that-is-not-there-cannot-be-opened",
    test_a_lesson_that_is_not_there_cannot_be_opened },
  { "/lesson/names-cannot-steer-a-terminal",
    test_names_cannot_steer_a_terminal },
  { "/lesson/an-endless-file-is-refused", test_an_endless_file_is_refused },
  { "/lesson/replay-tells-each-expect", test_replay_tells_each_expect },
  { "/lesson/replay-explains-the-first-failures-alone",
    test_replay_explains_the_first_failures_alone },
  { "/lesson/every-key-can-be-expected", test_every_key_can_be_expected },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  g_test_add_data_func ("/lesson/broken-structure-is-refused-by-line",
                        structure, check_rows);
  g_test_add_data_func ("/lesson/broken-lesson-blocks-are-refused-by-line",
                        head, check_rows);
  g_test_add_data_func ("/lesson/sites-that-are-none-are-refused-by-column",
                        sites, check_rows);
  g_test_add_data_func ("/lesson/commands-that-are-none-are-refused-by-line",
                        commands, check_rows);
  return g_test_run ();
}
