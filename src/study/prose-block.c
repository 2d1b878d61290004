#include "prose-block.h"

#include "prose.h"

#include <cmark.h>
#include <string.h>

static void
block_free (gpointer data)
{
  ProseBlock *block = data;

  g_free (block->marker);
  g_free (block->markup);
  g_free (block);
}

/* The item whose first block this is, or NULL. */
static cmark_node *
item_begun_by (cmark_node *node)
{
  cmark_node *parent = cmark_node_parent (node);

  return cmark_node_previous (node) == NULL && parent != NULL
                 && cmark_node_get_type (parent) == CMARK_NODE_ITEM
             ? parent
             : NULL;
}

static char *
marker_of (cmark_node *item)
{
  cmark_node *list = cmark_node_parent (item);
  int number = MAX (cmark_node_get_list_start (list), 1);

  if (cmark_node_get_list_type (list) != CMARK_ORDERED_LIST)
    return g_strdup ("•");
  while ((item = cmark_node_previous (item)) != NULL)
    number += 1;
  return g_strdup_printf ("%d.", number);
}

static guint
depth_of (cmark_node *node)
{
  guint depth = 0;

  for (; node != NULL; node = cmark_node_parent (node)) {
    const cmark_node_type type = cmark_node_get_type (node);

    depth += type == CMARK_NODE_ITEM || type == CMARK_NODE_BLOCK_QUOTE;
  }
  return depth;
}

static void
add (GPtrArray *blocks, cmark_node *node, ProseKind kind)
{
  cmark_node *item = item_begun_by (node);
  ProseBlock *block = g_new0 (ProseBlock, 1);

  block->kind = kind;
  block->depth = depth_of (node);
  block->marker = item != NULL ? marker_of (item) : NULL;
  block->markup = prose_tree_to_markup (node);
  g_ptr_array_add (blocks, block);
}

static void
add_leaf (GPtrArray *blocks, cmark_node *node)
{
  switch ((int)cmark_node_get_type (node)) {
  case CMARK_NODE_PARAGRAPH:
    add (blocks, node, PROSE_PARAGRAPH);
    break;
  case CMARK_NODE_HEADING:
    add (blocks, node, PROSE_HEADING);
    break;
  case CMARK_NODE_CODE_BLOCK:
    add (blocks, node, PROSE_CODE);
    break;
  default:
    break;
  }
}

GPtrArray *
prose_to_blocks (const char *commonmark)
{
  GPtrArray *blocks = g_ptr_array_new_with_free_func (block_free);
  cmark_node *document
      = cmark_parse_document (commonmark, strlen (commonmark), CMARK_OPT_SMART);
  cmark_iter *iter = cmark_iter_new (document);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE)
    if (event == CMARK_EVENT_ENTER)
      add_leaf (blocks, cmark_iter_get_node (iter));

  cmark_iter_free (iter);
  cmark_node_free (document);
  return blocks;
}
