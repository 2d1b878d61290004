#include "gist.h"

#include "prose-block.h"

#include <glib/gi18n.h>
#include <string.h>

/* Sentences */

/* Letters before the full stop that ends at @end: abbreviations and names of
 * one letter do not end sentences. */
static gboolean
ends_a_word (const char *start, const char *end)
{
  guint n = 0;

  while (end > start && n < 2) {
    end = g_utf8_prev_char (end);
    if (!g_unichar_isalnum (g_utf8_get_char (end)))
      break;
    n += 1;
  }
  return n != 1;
}

/* Returns: the first character after the tags and closing signs at @at. */
static const char *
skip_closing (const char *at, int *depth)
{
  for (;;) {
    if (g_str_has_prefix (at, "</")) {
      *depth -= 1;
      at += strcspn (at, ">") + 1;
    } else if (*at == ')' || *at == '"') {
      at += 1;
    } else if (g_str_has_prefix (at, "”") || g_str_has_prefix (at, "“")) {
      at = g_utf8_next_char (at);
    } else {
      return at;
    }
  }
}

/* Names of objects, as "s5", are small at the beginning of a sentence too. */
static gboolean
begins_a_sentence (const char *at)
{
  while (*at == ' ' || *at == '<' || *at == '(')
    at += *at == '<' ? strcspn (at, ">") + 1 : 1;
  return !g_unichar_islower (g_utf8_get_char (at))
         || (strchr ("sfvr", *at) != NULL && g_ascii_isdigit (at[1]));
}

/* Returns: the end of the sentence that begins @markup: outside of all tags,
 *          so that each sentence is markup by itself. */
static const char *
end_of_sentence (const char *markup)
{
  const char *at = markup;
  int depth = 0;

  while (*at != '\0') {
    const char *end = at;
    int closed = depth;

    if (*at == '<') {
      depth += at[1] == '/' ? -1 : 1;
      at += strcspn (at, ">") + 1;
      continue;
    }
    at = g_utf8_next_char (at);
    if (strchr (".!?", *end) == NULL)
      continue;
    at = skip_closing (at, &closed);
    depth = closed;
    if (closed == 0 && (*at == ' ' || *at == '\0')
        && (*end != '.' || ends_a_word (markup, end)) && begins_a_sentence (at))
      return at;
  }
  return at;
}

/* Whether what is bold is more than the name of an object or a number. */
static gboolean
tells (const char *sentence)
{
  return g_regex_match_simple ("<b>(?![sfvr]?[0-9]+[.,:]?</b>)", sentence, 0,
                               0);
}

static void
add_facts (GPtrArray *facts, const char *markup)
{
  while (*markup != '\0') {
    const char *end = end_of_sentence (markup);
    g_autofree char *sentence = g_strndup (markup, (gsize)(end - markup));

    if (tells (sentence))
      g_ptr_array_add (facts, g_strdup (g_strstrip (sentence)));
    markup = end + strspn (end, " \n");
  }
}

GPtrArray *
gist_facts (const char *commonmark)
{
  GPtrArray *facts = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GPtrArray) blocks = prose_to_blocks (commonmark);

  for (guint i = 0; i < blocks->len; i++) {
    const ProseBlock *block = g_ptr_array_index (blocks, i);

    if (block->kind == PROSE_PARAGRAPH)
      add_facts (facts, block->markup);
  }
  return facts;
}

/* Sources */

/* Returns: what follows the word for sources, in either language, or NULL. */
static const char *
find_sources (const char *note)
{
  const char *const words[]
      = { /* Translators: as lessons introduce what they cite. */
          _ ("Sources:"), _ ("Source:"), "Sources:", "Source:"
        };

  for (guint i = 0; i < G_N_ELEMENTS (words); i++) {
    const char *found = strstr (note, words[i]);

    if (found != NULL)
      return found + strlen (words[i]);
  }
  return NULL;
}

static void
add_sources (GString *sources, const char *note)
{
  const char *found = note == NULL ? NULL : find_sources (note);
  const char *end = found == NULL ? NULL : strstr (found, "\n\n");
  g_autofree char *cited = NULL;

  if (found == NULL)
    return;
  cited = end == NULL ? g_strdup (found)
                      : g_strndup (found, (gsize)(end - found));
  g_string_append_printf (sources, "%s%s", sources->len > 0 ? "\n\n" : "",
                          g_strstrip (cited));
}

char *
gist_sources (const Lesson *lesson)
{
  GString *sources = g_string_new (NULL);

  add_sources (sources, lesson->note);
  for (guint i = 0; i < lesson->stops->len; i++)
    add_sources (sources, lesson_stop (lesson, i)->note);
  return g_string_free (sources, FALSE);
}
