/* What there is to translate in a lesson, with its lines. The reader of
 * lessons forgets them; this walks the same blocks once more. */
#include "lesson-reader.h"
#include "lesson-words.h"
#include "prose-words.h"

#include <string.h>

typedef struct Finder {
  const LessonSource *source;
  LessonWordFound found;
  gpointer user;
} Finder;

/* Takes @words. */
static void
tell (const Finder *finder, char *words, guint line)
{
  if (words != NULL && *words != '\0')
    finder->found (words, line, finder->user);
  g_free (words);
}

static void
find_in_prose (const Finder *finder, cmark_node *block)
{
  cmark_iter *iter = cmark_iter_new (block);
  cmark_event_type event;

  while ((event = cmark_iter_next (iter)) != CMARK_EVENT_DONE) {
    cmark_node *node = cmark_iter_get_node (iter);

    if (event == CMARK_EVENT_ENTER)
      tell (finder, prose_block_words (node), lesson_node_line (node));
  }
  cmark_iter_free (iter);
}

static void
find_in_line (const Finder *finder, const LessonLine *line)
{
  g_autofree char *key = g_strndup (line->text, strcspn (line->text, " \t"));
  const char *rest = line->text + strlen (key);

  rest += strspn (rest, " \t");
  if (g_str_equal (key, "prompt") || g_str_equal (key, "hint"))
    tell (finder, g_strdup (rest), line->line);
  if (g_str_equal (key, "option"))
    tell (finder, question_option_words (rest), line->line);
}

static void
find_in_question (const Finder *finder, cmark_node *block)
{
  const guint last = (guint)cmark_node_get_end_line (block);

  for (guint number = lesson_node_line (block) + 1; number < last; number++) {
    LessonLine line;

    lesson_line_init (&line, finder->source, number);
    find_in_line (finder, &line);
    lesson_line_clear (&line);
  }
}

static void
find_in_node (const Finder *finder, cmark_node *node)
{
  const cmark_node_type type = cmark_node_get_type (node);

  if (type == CMARK_NODE_HEADING && cmark_node_get_heading_level (node) <= 2)
    tell (finder, prose_plain_words (node), lesson_node_line (node));
  else if (type != CMARK_NODE_CODE_BLOCK) {
    lesson_note_strip (node);
    find_in_prose (finder, node);
  } else if (g_str_equal (cmark_node_get_fence_info (node), "ask"))
    find_in_question (finder, node);
}

gboolean
lesson_words_find (const char *path,
                   LessonWordFound found,
                   gpointer user,
                   GError **error)
{
  gsize length;
  g_autofree char *text = lesson_read (path, &length, error);
  g_autoptr (LessonSource) source = NULL;
  g_autoptr (Lesson) lesson = NULL;
  cmark_node *document;

  if (text == NULL
      || (lesson = lesson_parse (text, length, path, error)) == NULL
      || (source = lesson_source_new (text, length, path, error)) == NULL)
    return FALSE;
  document = cmark_parse_document (source->text, strlen (source->text),
                                   CMARK_OPT_SOURCEPOS);
  for (cmark_node *node = cmark_node_first_child (document); node != NULL;
       node = cmark_node_next (node))
    find_in_node (&(Finder){ source, found, user }, node);
  cmark_node_free (document);
  return TRUE;
}
