/* The lessons that come with the program, in order. */
#ifndef LESSON_LIST_H
#define LESSON_LIST_H

#include "progress.h"

G_BEGIN_DECLS

typedef struct LessonEntry {
  char *path;
  char *title;
} LessonEntry;

/* Returns: (transfer full) (element-type LessonEntry): those that can be
 *          opened; they are read, so this takes a moment. */
GPtrArray *lesson_list_new (void);

/* Returns: (transfer full): how far the person is: "3 of 12", "2 questions
 *          open", "✓", or NULL: not begun. */
char *lesson_list_progress (const Progress *progress, const char *path);

/* Returns: (transfer full): the path of the lesson after that of this name, or
 *          NULL: it is the last, or none of these. */
char *lesson_list_next (const char *path);

/* Returns: (transfer full): the title of a lesson, or NULL: it cannot be
 *          read. */
char *lesson_list_title (const char *path);

/* Returns: (transfer full): the path of the one that was worked on last, or
 *          NULL. */
char *lesson_list_last (const Progress *progress);

/* Returns: (transfer full): the path of the first one, or NULL. */
char *lesson_list_first (void);

/* The number that a lesson's file name begins with, or 0. */
guint lesson_list_number (const char *path);

G_END_DECLS

#endif
