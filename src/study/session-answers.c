/* What the pictures show of a question: what is chosen, how right it is, and
 * the names of what it speaks of. */
#include "attempt.h"
#include "object-name.h"
#include "session-private.h"

static gboolean
has (const GArray *objects, Object object)
{
  for (guint i = 0; i < objects->len; i++)
    if (object_equal (g_array_index (objects, Object, i), object))
      return TRUE;
  return FALSE;
}

static void
add_answer (Session *session, Object object, AnswerKind kind, guint place)
{
  const SceneAnswer answer = { object, kind, place };

  if (object.kind != OBJECT_NONE)
    g_array_append_val (session->answers, answer);
}

/* What is chosen; once it has been checked, what of it is right. */
static void
add_chosen (Session *session, const Exercise *exercise, const Answer *answer)
{
  const GArray *chosen = exercise->attempt->objects;
  const gboolean is_order = exercise->question->kind == QUESTION_ORDER;

  for (guint i = 0; i < chosen->len; i++) {
    const Object object = g_array_index (chosen, Object, i);
    AnswerKind kind = ANSWER_CHOSEN;

    if (answer != NULL && is_order)
      kind = exercise->verdict != NULL && i < exercise->verdict->right
                 ? ANSWER_RIGHT
                 : ANSWER_WRONG;
    else if (answer != NULL)
      kind = has (answer->objects, object) ? ANSWER_RIGHT : ANSWER_WRONG;
    add_answer (session, object, kind, is_order ? i + 1 : 0);
  }
}

static void
add_missed (Session *session, const Exercise *exercise, const Answer *answer)
{
  const gboolean is_order = exercise->question->kind == QUESTION_ORDER;
  guint n_right = 0;

  for (guint i = 0; i < session->answers->len; i++)
    n_right += g_array_index (session->answers, SceneAnswer, i).kind
               == ANSWER_RIGHT;
  if ((answer->is_any && n_right > 0)
      || (exercise->verdict != NULL && exercise->verdict->is_right))
    return;
  for (guint i = 0; i < answer->objects->len; i++) {
    const Object object = g_array_index (answer->objects, Object, i);

    if (!has (exercise->attempt->objects, object))
      add_answer (session, object, ANSWER_MISSED, is_order ? i + 1 : 0);
  }
}

static gboolean
has_answer (const Session *session, Object object)
{
  for (guint i = 0; i < session->answers->len; i++)
    if (object_equal (g_array_index (session->answers, SceneAnswer, i).object,
                      object))
      return TRUE;
  return FALSE;
}

/* The facets that the words call by their names. */
static void
add_named (Session *session, const char *words)
{
  const char *end;

  for (const char *word = words; *word != '\0'; word = end) {
    g_autofree char *name = NULL;
    Object object;

    end = word + 1;
    if (!g_ascii_isalnum (*word))
      continue;
    while (g_ascii_isalnum (*end))
      end++;
    name = g_strndup (word, (gsize)(end - word));
    if (object_name_parse (name, &object) && object.kind == OBJECT_FACET
        && !has_answer (session, object))
      add_answer (session, object, ANSWER_NAMED, 0);
  }
}

static void
add_what_is_spoken_of (Session *session, const Exercise *exercise)
{
  const Question *question = exercise->question;
  g_autofree char *prompt = question_prompt (question, &exercise->occasion);

  add_named (session, prompt);
  for (guint i = 0; question->options != NULL && i < question->options->len;
       i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    add_named (session, option->text);
  }
}

void
session_find_answers (Session *session, const Exercise *exercise)
{
  g_autoptr (Answer) answer = NULL;

  if (exercise->verdict != NULL || !exercise->is_open)
    answer = answer_new (exercise->question, &exercise->occasion);
  add_chosen (session, exercise, answer);
  if (!exercise->is_open)
    add_missed (session, exercise, answer);
  add_what_is_spoken_of (session, exercise);
}
