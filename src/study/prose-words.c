#include "prose-words.h"

#include <stdlib.h>
#include <string.h>

char *
prose_block_words (cmark_node *block)
{
  const cmark_node_type type = cmark_node_get_type (block);
  g_autofree char *words = NULL;
  char *rendered;

  if (type != CMARK_NODE_PARAGRAPH && type != CMARK_NODE_HEADING)
    return NULL;
  rendered = cmark_render_commonmark (block, CMARK_OPT_NOBREAKS, 0);
  words = g_strstrip (g_strdup (rendered));
  free (rendered);
  if (type == CMARK_NODE_HEADING)
    return g_strdup (words + strspn (words, "# "));
  return g_steal_pointer (&words);
}

char *
prose_plain_words (cmark_node *heading)
{
  GString *words = g_string_new (NULL);
  cmark_iter *iter = cmark_iter_new (heading);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE) {
    cmark_node *node = cmark_iter_get_node (iter);
    const cmark_node_type type = cmark_node_get_type (node);

    if (event != CMARK_EVENT_ENTER)
      continue;
    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE)
      g_string_append (words, cmark_node_get_literal (node));
    else if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK)
      g_string_append_c (words, ' ');
  }
  cmark_iter_free (iter);
  return g_string_free (words, FALSE);
}

static void
remove_children (cmark_node *block)
{
  cmark_node *child;

  while ((child = cmark_node_first_child (block)) != NULL) {
    cmark_node_unlink (child);
    cmark_node_free (child);
  }
}

static void
move_children (cmark_node *from, cmark_node *to)
{
  cmark_node *child;

  while ((child = cmark_node_first_child (from)) != NULL) {
    cmark_node_unlink (child);
    cmark_node_append_child (to, child);
  }
}

/* Gives a block the inside of the one paragraph that @commonmark is. */
static void
replace_inside (cmark_node *block, const char *commonmark)
{
  cmark_node *document = cmark_parse_document (commonmark, strlen (commonmark),
                                               CMARK_OPT_DEFAULT);
  cmark_node *paragraph = cmark_node_first_child (document);

  if (paragraph != NULL && cmark_node_next (paragraph) == NULL
      && cmark_node_get_type (paragraph) == CMARK_NODE_PARAGRAPH) {
    remove_children (block);
    move_children (paragraph, block);
  }
  cmark_node_free (document);
}

static void
translate_words (cmark_node *block, ProseTranslate translate)
{
  g_autofree char *words = prose_block_words (block);
  const char *translation = words != NULL ? translate (words) : NULL;

  if (translation != NULL)
    replace_inside (block, translation);
}

/* What is inside a block may be replaced once it has been passed. */
void
prose_translate_block (cmark_node *block, ProseTranslate translate)
{
  cmark_iter *iter = cmark_iter_new (block);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE)
    if (event == CMARK_EVENT_EXIT)
      translate_words (cmark_iter_get_node (iter), translate);
  cmark_iter_free (iter);
}

void
prose_set_words (cmark_node *heading, const char *words)
{
  cmark_node *text = cmark_node_new (CMARK_NODE_TEXT);

  cmark_node_set_literal (text, words);
  remove_children (heading);
  cmark_node_append_child (heading, text);
}

char *
prose_translate (const char *commonmark, ProseTranslate translate)
{
  cmark_node *document = cmark_parse_document (commonmark, strlen (commonmark),
                                               CMARK_OPT_DEFAULT);
  char *rendered, *copy;

  prose_translate_block (document, translate);
  rendered = cmark_render_commonmark (document, CMARK_OPT_DEFAULT, 0);
  copy = g_strdup (rendered);
  free (rendered);
  cmark_node_free (document);
  return copy;
}
