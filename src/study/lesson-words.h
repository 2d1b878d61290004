/* The words of lessons in the person's language.
 *
 * A lesson is written in one language; catalogs of the text domain
 * LESSON_WORDS_DOMAIN translate it string by string: titles, paragraphs,
 * items of lists, notes, prompts, hints and options. What has no translation
 * stays as it was written. Blocks of commands hold no words, so a lesson
 * plays the same in every language.
 */
#ifndef LESSON_WORDS_H
#define LESSON_WORDS_H

#include "lesson.h"
#include "prose.h"

G_BEGIN_DECLS

#define LESSON_WORDS_DOMAIN "hull2vd-lessons"

/* Puts the words of @lesson into the language of the locale. A lesson whose
 * title is in no catalog is nobody's but its author's: it keeps its words,
 * even those that another lesson has too. */
void lesson_words_translate (Lesson *lesson);

/* The same with other catalogs; @translate gives NULL for what it has not. */
void lesson_words_translate_by (Lesson *lesson, ProseTranslate translate);

/* As lesson_load(), then lesson_words_translate(). */
Lesson *lesson_words_load (const char *path, GError **error);

/* Writes a lesson with its words in another language, for who wants to change
 * it: commands as they were, byte by byte.
 *
 * Returns: (transfer full): the text of its file, or NULL when its title has
 *          no translation, or what was written is no lesson. */
char *lesson_words_write (const char *text,
                          gsize length,
                          const char *path,
                          ProseTranslate translate);

/* The translation in the language of the locale, or NULL. */
const char *lesson_words_look_up (const char *words);

/* A string of a lesson, and the line where it begins, from 1. */
typedef void (*LessonWordFound) (const char *words, guint line, gpointer user);

/* Finds all that there is to translate in a lesson, in its order.
 *
 * Returns: FALSE with @error set, as lesson_load(). */
gboolean lesson_words_find (const char *path,
                            LessonWordFound found,
                            gpointer user,
                            GError **error);

G_END_DECLS

#endif
