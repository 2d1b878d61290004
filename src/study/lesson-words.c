#include "lesson-words.h"

#include <libintl.h>

/* Of what is not in the catalog, dgettext() gives back what it was given;
 * the empty string stands for the catalog's header. */
const char *
lesson_words_look_up (const char *words)
{
  const char *translation
      = *words == '\0' ? words : dgettext (LESSON_WORDS_DOMAIN, words);

  return translation == words ? NULL : translation;
}

static void
translate_string (char **string, ProseTranslate translate)
{
  char *copy = *string != NULL ? g_strdup (translate (*string)) : NULL;

  if (copy == NULL)
    return;
  g_free (*string);
  *string = copy;
}

static void
translate_prose (char **prose, ProseTranslate translate)
{
  char *translated;

  if (*prose == NULL || **prose == '\0')
    return;
  translated = prose_translate (*prose, translate);
  g_free (*prose);
  *prose = translated;
}

static void
translate_question (Question *question, ProseTranslate translate)
{
  translate_string (&question->prompt, translate);
  for (guint i = 0; i < question->hints->len; i++)
    translate_string ((char **)&g_ptr_array_index (question->hints, i),
                      translate);
  for (guint i = 0; i < question->options->len; i++) {
    QuestionOption *option = g_ptr_array_index (question->options, i);

    translate_string (&option->text, translate);
  }
}

static void
translate_stop (LessonStop *stop, ProseTranslate translate)
{
  translate_string (&stop->title, translate);
  translate_prose (&stop->prose, translate);
  translate_prose (&stop->note, translate);
  if (stop->question != NULL)
    translate_question (stop->question, translate);
}

void
lesson_words_translate_by (Lesson *lesson, ProseTranslate translate)
{
  if (translate (lesson->title) == NULL)
    return;
  translate_string (&lesson->title, translate);
  translate_prose (&lesson->prose, translate);
  translate_prose (&lesson->note, translate);
  for (guint i = 0; i < lesson->stops->len; i++)
    translate_stop (g_ptr_array_index (lesson->stops, i), translate);
}

void
lesson_words_translate (Lesson *lesson)
{
  lesson_words_translate_by (lesson, lesson_words_look_up);
}

Lesson *
lesson_words_load (const char *path, GError **error)
{
  Lesson *lesson = lesson_load (path, error);

  if (lesson != NULL)
    lesson_words_translate (lesson);
  return lesson;
}
