#include "gist.h"
#include "prose-block.h"

#include <pango/pango.h>
#include <string.h>

typedef struct Row {
  const char *commonmark;
  const char *facts[4];
} Row;

static const Row rows[] = {
  { "", { NULL } },
  { "Nothing is bold. *This* neither.", { NULL } },
  { "One. The **horizon**: its ridges. Two.",
    { "The <b>horizon</b>: its ridges." } },
  { "So it is: **all of it.** And **more**!",
    { "So it is: <b>all of it.</b>", "And <b>more</b>!" } },
  { "**One. Two.** Three **four**.",
    { "<b>One. Two.</b>", "Three <b>four</b>." } },
  { "See z. B. the **cone**, or i. e. the *star*. Done.",
    { "See z. B. the <b>cone</b>, or i. e. the <i>star</i>." } },
  { "There are **4 = 2 + 2**. It is **f0**. It is **7**.",
    { "There are <b>4 = 2 + 2</b>." } },
  { "a\n\nb **c** d\n\n- e **f**\n\n### **g**\n",
    { "b <b>c</b> d", "e <b>f</b>" } },
  { "He says (“**look**.”) And so on.", { "He says (“<b>look</b>.”)" } },
  { "It lies **outside**. s5 waits. It is **so**, e. g. f3 is.",
    { "It lies <b>outside</b>.", "It is <b>so</b>, e. g. f3 is." } },
  { "At 2.5 the **site** is 1.5 up.", { "At 2.5 the <b>site</b> is 1.5 up." } },
};

static void
test_facts_are_sentences_with_something_bold (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autoptr (GPtrArray) facts = gist_facts (rows[i].commonmark);

    for (guint k = 0; k < facts->len; k++) {
      const char *fact = g_ptr_array_index (facts, k);

      g_assert_cmpstr (fact, ==, rows[i].facts[k]);
      g_assert_true (pango_parse_markup (fact, -1, 0, NULL, NULL, NULL, NULL));
    }
    g_assert_null (rows[i].facts[facts->len]);
  }
}

static void
test_sources_are_what_notes_cite (void)
{
  static const char text[]
      = "# T\n\n> Note: long. Sources: A 1996;\n> B, *C*, 4.\n\n"
        "> Note: more.\n\n```lesson\nformat 1\nsites 0 0\n"
        "```\n\n## S\n\n> Note: Source: D.\n\n## U\n\n"
        "> Note: none.\n";
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson
      = lesson_parse (text, strlen (text), "t.md", &error);
  g_autofree char *sources = NULL;

  g_assert_no_error (error);
  sources = gist_sources (lesson);
  g_strdelimit (sources, "\n", ' ');
  g_assert_cmpstr (sources, ==, "A 1996; B, *C*, 4.  D.");
}

static void
test_blocks_have_markers_and_depth (void)
{
  g_autoptr (GPtrArray) blocks = prose_to_blocks (
      "a **b**\n\n3. c\n\n   d\n4. e\n   - f\n\n### g\n\n    h < i\n\n> j\n");
  static const struct {
    ProseKind kind;
    guint depth;
    const char *marker, *markup;
  } expected[] = {
    { PROSE_PARAGRAPH, 0, NULL, "a <b>b</b>" },
    { PROSE_PARAGRAPH, 1, "3.", "c" },
    { PROSE_PARAGRAPH, 1, NULL, "d" },
    { PROSE_PARAGRAPH, 1, "4.", "e" },
    { PROSE_PARAGRAPH, 2, "•", "f" },
    { PROSE_HEADING, 0, NULL, "<b>g</b>" },
    { PROSE_CODE, 0, NULL, "<tt>h &lt; i</tt>" },
    { PROSE_PARAGRAPH, 1, NULL, "j" },
  };

  g_assert_cmpuint (blocks->len, ==, G_N_ELEMENTS (expected));
  for (guint i = 0; i < blocks->len; i++) {
    const ProseBlock *block = g_ptr_array_index (blocks, i);

    g_assert_cmpint (block->kind, ==, expected[i].kind);
    g_assert_cmpuint (block->depth, ==, expected[i].depth);
    g_assert_cmpstr (block->marker, ==, expected[i].marker);
    g_assert_cmpstr (block->markup, ==, expected[i].markup);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/gist/facts-are-sentences-with-something-bold",
                   test_facts_are_sentences_with_something_bold);
  g_test_add_func ("/gist/sources-are-what-notes-cite",
                   test_sources_are_what_notes_cite);
  g_test_add_func ("/gist/blocks-have-markers-and-depth",
                   test_blocks_have_markers_and_depth);
  return g_test_run ();
}
