/* The lessons that come with the program, in order. */
#ifndef LESSON_LIST_H
#define LESSON_LIST_H

#include <glib.h>

G_BEGIN_DECLS

typedef struct LessonEntry {
  char *path;
  char *title;
} LessonEntry;

/* Returns: (transfer full) (element-type LessonEntry): those that can be
 *          opened; they are read, so this takes a moment. */
GPtrArray *lesson_list_new (void);

/* Returns: (transfer full): the path of the first one, or NULL. */
char *lesson_list_first (void);

/* The number that a lesson's file name begins with, or 0. */
guint lesson_list_number (const char *path);

G_END_DECLS

#endif
