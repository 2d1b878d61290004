#include "prose.h"
#include "words.h"

#include <pango/pango.h>

typedef struct Row {
  const char *commonmark, *markup, *text;
} Row;

static const Row rows[] = {
  { "", "", "" },
  { "One *two* **three** `four`.", "One <i>two</i> <b>three</b> <tt>four</tt>.",
    "One two three four." },
  { "a\nb  \nc\n\nd", "a b\nc\n\nd", "a b\nc\n\nd" },
  { "# H\n\nx", "<b>H</b>\n\nx", "H\n\nx" },
  { "x\n\n- a\n- b\n  - c\n\ny", "x\n\n•  a\n•  b\n    •  c\n\ny",
    "x\n\n•  a\n•  b\n    •  c\n\ny" },
  { "3. a\n4. b", "3.  a\n4.  b", "3.  a\n4.  b" },
  { "[a](http://x.org) ![b](c.png)", "a b", "a b" },
  { "a <b>c</b>\n\n<div>d</div>\n\ne", "a c\n\ne", "a c\n\ne" },
  { "1 < 2 & 3", "1 &lt; 2 &amp; 3", "1 < 2 & 3" },
  { "<span size='huge'>x", "x", "x" },
  { "`<b>` &lt;i&gt;", "<tt>&lt;b&gt;</tt> &lt;i&gt;", "<b> <i>" },
  { "    a < b\n    c\n", "<tt>a &lt; b\nc</tt>", "a < b\nc" },
  { "f1's `'a'` \"b\"...", "f1’s <tt>&apos;a&apos;</tt> “b”…",
    "f1’s 'a' “b”…" },
  { "> quoted\n>\n> words", "quoted\n\nwords", "quoted\n\nwords" },
};

static void
test_prose_becomes_markup_and_words (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *markup = prose_to_markup (rows[i].commonmark);
    g_autofree char *text = prose_to_text (rows[i].commonmark);

    g_assert_cmpstr (markup, ==, rows[i].markup);
    g_assert_cmpstr (text, ==, rows[i].text);
  }
}

static void
assert_markup (const char *commonmark)
{
  g_autofree char *markup = prose_to_markup (commonmark);
  g_autofree char *expected = prose_to_text (commonmark);
  g_autofree char *text = NULL;
  g_autoptr (GError) error = NULL;

  g_assert_true (pango_parse_markup (markup, -1, 0, NULL, &text, NULL, &error));
  g_assert_no_error (error);
  g_assert_cmpstr (text, ==, expected);
}

/* Pango is the judge: whatever is written, its markup is well-formed and its
 * words are those of the text. */
static void
test_markup_is_always_well_formed (void)
{
  static const char *const pieces[]
      = { "*",   "**",    "_",
          "`",   "<b>",   "</i>",
          "&",   "&amp;", "[a](b)",
          "- ",  "\n",    "\n\n",
          "1. ", "# ",    "> ",
          "x ",  "    ",  "<!--",
          "-->", "```\n", "<span foreground=\"red\">" };
  guint32 state = 1;

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    assert_markup (rows[i].commonmark);
  for (guint i = 0; i < 2000; i++) {
    g_autoptr (GString) text = g_string_new (NULL);

    for (guint j = 0; j < 12; j++) {
      state = state * 1664525 + 1013904223;
      g_string_append (text, pieces[(state >> 16) % G_N_ELEMENTS (pieces)]);
    }
    assert_markup (text->str);
  }
}

static void
test_hints_forgive_few_typing_errors (void)
{
  static const char *const names[] = { "goto", "show", "circumcircles", NULL };
  static const struct {
    const char *word, *hint;
  } hints[] = {
    { "gotto", " (did you mean “goto”?)" },
    { "gtoo", " (did you mean “goto”?)" },
    { "shwo", " (did you mean “show”?)" },
    { "circumcirles", " (did you mean “circumcircles”?)" },
    { "elephant", "" },
    { "go", "" },
    { "averyveryverylongwordindeed", "" },
  };

  for (guint i = 0; i < G_N_ELEMENTS (hints); i++) {
    g_autofree char *hint = words_hint (hints[i].word, names);

    g_assert_cmpstr (hint, ==, hints[i].hint);
  }
}

static void
test_numbers_are_digits_alone (void)
{
  static const char *const bad[]
      = { "", "-1", "+1", " 1", "1 ", "0x1", "1.0", "1e3", "11", "one" };
  guint64 number;

  g_assert_true (words_parse_number ("10", 10, &number));
  g_assert_cmpuint (number, ==, 10);
  for (guint i = 0; i < G_N_ELEMENTS (bad); i++)
    g_assert_false (words_parse_number (bad[i], 10, &number));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/prose/prose-becomes-markup-and-words",
                   test_prose_becomes_markup_and_words);
  g_test_add_func ("/prose/markup-is-always-well-formed",
                   test_markup_is_always_well_formed);
  g_test_add_func ("/prose/hints-forgive-few-typing-errors",
                   test_hints_forgive_few_typing_errors);
  g_test_add_func ("/prose/numbers-are-digits-alone",
                   test_numbers_are_digits_alone);
  return g_test_run ();
}
