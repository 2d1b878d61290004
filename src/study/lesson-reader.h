/* What reads a lesson, for lesson-reader.c and lesson-fence.c alone. */
#ifndef LESSON_READER_H
#define LESSON_READER_H

#include "lesson-block.h"

#include <cmark.h>

G_BEGIN_DECLS

typedef struct LessonReader {
  const LessonSource *source;
  const char *folder; /* of the lesson, for files of sites */
  Lesson *lesson;
  LessonStop *stop;  /* the one being read; NULL before the first */
  guint lesson_line; /* of the lesson block; 0: not yet */
  guint steps_line;  /* of the stop's last steps block; 0: not yet */
  guint ask_line;    /* of the stop's ask block; 0: not yet */
  guint n_commands;
  gsize n_prose;
  GString *prose, *note;
  LessonFaults *faults;
} LessonReader;

/* Returns: the first line of a block. */
guint lesson_node_line (cmark_node *node);

/* Adds a block to what the student reads (prose) or to the notes. */
gboolean lesson_read_prose (LessonReader *reader,
                            cmark_node *node,
                            GString *text,
                            GError **error);

/* A quotation that begins with "Note:" is for the lecturer: takes the mark
 * off it.
 *
 * Returns: whether @node is one. */
gboolean lesson_note_strip (cmark_node *node);

/* Puts the mark before the words of a quotation again. */
void lesson_note_mark (cmark_node *quote);

/* Reads a block of code: commands, or code to be read. */
gboolean
lesson_read_fence (LessonReader *reader, cmark_node *block, GError **error);

/* Inside lists and quotations code is prose; what looks like commands there
 * would be silently left out, so it is refused. */
gboolean lesson_check_inner_fences (LessonReader *reader,
                                    cmark_node *node,
                                    GError **error);

G_END_DECLS

#endif
