#include "prose.h"

#include <cmark.h>
#include <stdlib.h>
#include <string.h>

/* Writes the tree as it is walked. */
typedef struct Writer {
  GString *text;
  gboolean has_markup;
  gboolean has_words; /* something stands before what comes next */
  GArray *numbers;    /* int: of the next item of each open list, 0: bullets */
} Writer;

static void
write_tag (Writer *writer, const char *tag)
{
  if (writer->has_markup)
    g_string_append (writer->text, tag);
}

static void
write_literal (Writer *writer, const char *literal)
{
  g_autofree char *escaped = g_markup_escape_text (literal, -1);

  g_string_append (writer->text, writer->has_markup ? escaped : literal);
  writer->has_words = writer->has_words || *literal != '\0';
}

static gboolean
is_in_item (cmark_node *node)
{
  cmark_node *parent = cmark_node_parent (node);

  return parent != NULL && cmark_node_get_type (parent) == CMARK_NODE_ITEM;
}

/* A block begins after an empty line, an item's first on the item's line. */
static void
begin_block (Writer *writer, cmark_node *node)
{
  if (is_in_item (node) && cmark_node_previous (node) == NULL)
    return;
  if (writer->has_words)
    g_string_append (writer->text, "\n\n");
}

static void
begin_list (Writer *writer, cmark_node *node)
{
  const int number = cmark_node_get_list_type (node) == CMARK_ORDERED_LIST
                         ? MAX (cmark_node_get_list_start (node), 1)
                         : 0;

  g_array_append_val (writer->numbers, number);
}

static void
begin_item (Writer *writer, cmark_node *node)
{
  int *number = &g_array_index (writer->numbers, int, writer->numbers->len - 1);
  const gboolean is_first = cmark_node_previous (node) == NULL;

  if (writer->has_words)
    g_string_append (writer->text,
                     is_first && writer->numbers->len == 1 ? "\n\n" : "\n");
  for (guint i = 1; i < writer->numbers->len; i++)
    g_string_append (writer->text, "    ");
  if (*number == 0)
    write_literal (writer, "•  ");
  else
    g_string_append_printf (writer->text, "%d.  ", (*number)++);
  writer->has_words = TRUE;
}

/* The line end after code belongs to the fence. */
static void
write_code_block (Writer *writer, cmark_node *node)
{
  g_autofree char *code = g_strdup (cmark_node_get_literal (node));

  begin_block (writer, node);
  write_tag (writer, "<tt>");
  write_literal (writer, g_strchomp (code));
  write_tag (writer, "</tt>");
}

/* Returns: whether it was a block. */
static gboolean
enter_block (Writer *writer, cmark_node *node)
{
  switch ((int)cmark_node_get_type (node)) {
  case CMARK_NODE_HEADING:
    begin_block (writer, node);
    write_tag (writer, "<b>");
    return TRUE;
  case CMARK_NODE_PARAGRAPH:
    begin_block (writer, node);
    return TRUE;
  case CMARK_NODE_CODE_BLOCK:
    write_code_block (writer, node);
    return TRUE;
  case CMARK_NODE_THEMATIC_BREAK:
    begin_block (writer, node);
    write_literal (writer, "⁂");
    return TRUE;
  case CMARK_NODE_LIST:
    begin_list (writer, node);
    return TRUE;
  case CMARK_NODE_ITEM:
    begin_item (writer, node);
    return TRUE;
  default:
    return FALSE;
  }
}

static void
enter (Writer *writer, cmark_node *node)
{
  if (enter_block (writer, node))
    return;
  switch ((int)cmark_node_get_type (node)) {
  case CMARK_NODE_TEXT:
    write_literal (writer, cmark_node_get_literal (node));
    break;
  case CMARK_NODE_SOFTBREAK:
    g_string_append_c (writer->text, ' ');
    break;
  case CMARK_NODE_LINEBREAK:
    g_string_append_c (writer->text, '\n');
    break;
  case CMARK_NODE_CODE:
    write_tag (writer, "<tt>");
    write_literal (writer, cmark_node_get_literal (node));
    write_tag (writer, "</tt>");
    break;
  case CMARK_NODE_EMPH:
    write_tag (writer, "<i>");
    break;
  case CMARK_NODE_STRONG:
    write_tag (writer, "<b>");
    break;
  default:
    break;
  }
}

static void
leave (Writer *writer, cmark_node *node)
{
  switch ((int)cmark_node_get_type (node)) {
  case CMARK_NODE_HEADING:
  case CMARK_NODE_STRONG:
    write_tag (writer, "</b>");
    break;
  case CMARK_NODE_EMPH:
    write_tag (writer, "</i>");
    break;
  case CMARK_NODE_LIST:
    g_array_set_size (writer->numbers, writer->numbers->len - 1);
    break;
  default:
    break;
  }
}

static char *
write_tree (cmark_node *tree, gboolean has_markup)
{
  Writer writer = { g_string_new (NULL), has_markup, FALSE,
                    g_array_new (FALSE, FALSE, sizeof (int)) };
  cmark_iter *iter = cmark_iter_new (tree);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE)
    if (event == CMARK_EVENT_ENTER)
      enter (&writer, cmark_iter_get_node (iter));
    else
      leave (&writer, cmark_iter_get_node (iter));

  cmark_iter_free (iter);
  g_array_unref (writer.numbers);
  return g_string_free (writer.text, FALSE);
}

static char *
convert (const char *commonmark, gboolean has_markup)
{
  cmark_node *document
      = cmark_parse_document (commonmark, strlen (commonmark), CMARK_OPT_SMART);
  char *text = write_tree (document, has_markup);

  cmark_node_free (document);
  return text;
}

char *
prose_tree_to_markup (struct cmark_node *tree)
{
  return write_tree (tree, TRUE);
}

char *
prose_to_markup (const char *commonmark)
{
  return convert (commonmark, TRUE);
}

char *
prose_to_text (const char *commonmark)
{
  return convert (commonmark, FALSE);
}

char *
prose_to_html (const char *commonmark)
{
  char *html = cmark_markdown_to_html (commonmark, strlen (commonmark),
                                       CMARK_OPT_DEFAULT);
  char *copy = g_strdup (html);

  free (html);
  return copy;
}

char *
prose_capitalize (const char *words)
{
  char first[7] = { 0 };
  const gunichar letter = g_utf8_get_char (words);

  if (letter == 0)
    return g_strdup ("");
  g_unichar_to_utf8 (g_unichar_totitle (letter), first);
  return g_strconcat (first, g_utf8_next_char (words), NULL);
}
