#include "action-private.h"
#include "object-name.h"
#include "words.h"

#include <glib/gi18n.h>

static gboolean
refuse (const char *reason, GError **error)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_DISABLED, "%s", reason);
  return FALSE;
}

/* "f3" an object; "o2" the second option, or yes and no; phases of a round by
 * their name. */
static gboolean
read_object (const char *name, Object *object)
{
  guint64 number;
  Phase phase;

  if (phase_parse (name, &phase)) {
    *object = (Object){ OBJECT_NONE, phase };
    return TRUE;
  }
  if (name[0] == 'o' && words_parse_number (name + 1, G_MAXUINT32, &number)
      && number > 0) {
    *object = (Object){ OBJECT_NONE, (guint32)number - 1 };
    return TRUE;
  }
  return object_name_parse (name, object) && object->kind != OBJECT_NONE;
}

ACTION_RUN (action_answer_toggle)
{
  const char *name = g_variant_get_string (parameter, NULL);
  Object object;

  if (!read_object (name, &object)) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                 _ ("“%s” is not an answer: write f3, s3, v3, r3, o1 for the "
                    "first option, or the name of a phase"),
                 name);
    return FALSE;
  }
  return session_answer_toggle (session, object)
         || refuse (_ ("this does not answer an open question"), error);
}

ACTION_RUN (action_answer_number)
{
  guint index, number;

  g_variant_get (parameter, "(uu)", &index, &number);
  return (index > 0 && session_answer_number (session, index - 1, number))
         || refuse (_ ("no open question asks for this number"), error);
}

ACTION_RUN (action_answer_undo)
{
  return session_answer_undo (session)
         || refuse (_ ("nothing has been answered yet"), error);
}

ACTION_RUN (action_check)
{
  return session_check (session)
         || refuse (_ ("nothing has been answered yet"), error);
}

ACTION_RUN (action_hint)
{
  return session_hint (session) || refuse (_ ("there is no more help"), error);
}

ACTION_RUN (action_retry)
{
  return session_retry (session)
         || refuse (_ ("no question is asked here"), error);
}

ACTION_RUN (action_show_answer)
{
  return session_reveal (session)
         || refuse (_ ("no open question is asked here"), error);
}

ACTION_RUN (action_another)
{
  return session_another (session)
         || refuse (_ ("this question cannot be asked of other sites"), error);
}

ACTION_RUN (action_continue)
{
  return session_continue (session)
         || refuse (_ ("there is nothing to continue with"), error);
}

/* States */

static char *
attempt_text (const Exercise *exercise)
{
  const Attempt *attempt = exercise->attempt;
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < attempt->objects->len; i++) {
    const Object object = g_array_index (attempt->objects, Object, i);
    char name[OBJECT_NAME_ROOM];

    object_name_write (object, name);
    if (object.kind == OBJECT_NONE
        && exercise->question->kind == QUESTION_ORDER)
      g_string_append_printf (text, " %s", phase_name ((Phase)object.number));
    else if (object.kind == OBJECT_NONE)
      g_string_append_printf (text, " o%u", object.number + 1);
    else
      g_string_append_printf (text, " %s", name);
  }
  for (guint i = 0; i < attempt->numbers->len; i++) {
    const gint64 number = g_array_index (attempt->numbers, gint64, i);

    if (number == NUMBER_NONE)
      g_string_append (text, " ?");
    else
      g_string_append_printf (text, " %" G_GINT64_FORMAT, number);
  }
  return g_strdup (text->len > 0 ? text->str + 1 : "");
}

ACTION_STATE (action_state_attempt)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise == NULL ? g_variant_new_string ("")
                          : g_variant_new_take_string (attempt_text (exercise));
}

ACTION_STATE (action_state_question)
{
  const Exercise *exercise = session_get_exercise (session);
  const char *state = "none";

  if (exercise != NULL && exercise->is_open)
    state = exercise->verdict == NULL ? "open" : "wrong";
  else if (exercise != NULL && exercise->verdict != NULL)
    state = exercise->verdict->is_right ? "right" : "shown";
  else if (exercise != NULL)
    state = "shown";
  return g_variant_new_string (state);
}

ACTION_STATE (action_state_score)
{
  const Exercise *exercise = session_get_exercise (session);
  const Verdict *verdict = exercise == NULL ? NULL : exercise->verdict;

  return verdict == NULL
             ? g_variant_new ("(uuuu)", 0, 0, 0, 0)
             : g_variant_new ("(uuuu)", verdict->total, verdict->right,
                              verdict->missing, verdict->wrong);
}

ACTION_ENABLED (action_has_lesson)
{
  return session_get_lesson (session) != NULL;
}

ACTION_ENABLED (action_can_check) { return session_can_check (session); }

ACTION_ENABLED (action_can_hint)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open
         && exercise->n_hints < exercise->question->hints->len;
}

ACTION_ENABLED (action_can_undo_answer)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open && exercise->undo->len > 0;
}

ACTION_ENABLED (action_has_question)
{
  return session_get_exercise (session) != NULL;
}

ACTION_ENABLED (action_has_open_question)
{
  const Exercise *exercise = session_get_exercise (session);

  return exercise != NULL && exercise->is_open;
}

ACTION_ENABLED (action_can_another) { return session_can_another (session); }

ACTION_ENABLED (action_can_continue) { return session_can_continue (session); }
