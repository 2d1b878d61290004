/* Reads ask blocks. */
#include "fresh-sites.h"
#include "lesson.h"
#include "object-name.h"
#include "position.h"
#include "question-click.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

#define MAX_LINE 1000 /* characters */

/* What has been read so far. */
typedef struct Reader {
  const LessonSource *source;
  Question *question;
  const LessonLine *line; /* the current one */
  GError **error;
  gboolean has_kind, has_position, has_retry;
} Reader;

static gboolean blame (Reader *reader, const char *at, const char *format, ...)
    G_GNUC_PRINTF (3, 4);

static gboolean
blame (Reader *reader, const char *at, const char *format, ...)
{
  g_autofree char *reason = NULL;
  va_list arguments;

  va_start (arguments, format);
  reason = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  return lesson_line_blame (reader->line, reader->source, at, reason,
                            reader->error);
}

static const char *
after_word (const char *text)
{
  text += strcspn (text, " \t");
  return text + strspn (text, " \t");
}

/* Sets the kind, of which there is one. */
static gboolean
begin_kind (Reader *reader, QuestionKind kind)
{
  if (reader->has_kind)
    return blame (reader, reader->line->text,
                  _ ("a second question; a block asks one"));
  reader->has_kind = TRUE;
  reader->question->kind = kind;
  return TRUE;
}

static gboolean
read_position (Reader *reader, const char *rest G_GNUC_UNUSED)
{
  g_autoptr (GError) reason = NULL;

  if (reader->has_position)
    return blame (reader, reader->line->text,
                  _ ("a second position; a question is asked once"));
  if (!position_check (reader->line->text, &reason))
    return blame (reader, reader->line->text, "%s", reason->message);
  reader->has_position = TRUE;
  reader->question->position = g_strdup (reader->line->text);
  return TRUE;
}

/* Options */

static gboolean
read_choose (Reader *reader, const char *rest)
{
  if (!begin_kind (reader, QUESTION_CHOOSE))
    return FALSE;
  reader->question->is_several = g_str_equal (rest, "several");
  return reader->question->is_several || g_str_equal (rest, "one")
         || blame (reader, rest, _ ("write choose one, or choose several"));
}

static void
add_option (Question *question, const char *text, Condition *condition)
{
  QuestionOption *option = g_new0 (QuestionOption, 1);

  option->text = g_strstrip (g_strdup (text));
  option->condition = condition;
  g_ptr_array_add (question->options, option);
}

static Condition *
read_condition (Reader *reader, const char *text)
{
  g_autoptr (GError) reason = NULL;
  Condition *condition = condition_parse (text, &reason);

  if (condition == NULL)
    blame (reader, text, "%s", reason->message);
  return condition;
}

static gboolean
read_option (Reader *reader, const char *rest)
{
  const char *at = question_find_if (rest);
  g_autofree char *text = question_option_words (rest);
  Condition *condition;

  if (reader->question->options->len == QUESTION_MAX_OPTIONS)
    return blame (reader, reader->line->text, _ ("more than %d options"),
                  QUESTION_MAX_OPTIONS);
  if (at == NULL || *text == '\0')
    return blame (reader, rest,
                  _ ("an option says when it is right: option TEXT if "
                     "CONDITION"));
  condition = read_condition (reader, at + strlen (" if "));
  if (condition == NULL)
    return FALSE;
  add_option (reader->question, text, condition);
  return !condition_needs_drag (condition)
         || blame (reader, at + strlen (" if "),
                   _ ("this condition is about a site that is dragged"));
}

/* Options that the engine writes. */
static void
add_kind (Question *question, const char *text, const char *condition)
{
  add_option (question, text, condition_parse (condition, NULL));
}

static gboolean
read_which_kind (Reader *reader, const char *rest)
{
  static const char *const kinds[] = { "is-lower", "is-upper", "is-vertical" };
  const char *const names[]
      = { _ ("a lower facet"), _ ("an upper facet"), _ ("a vertical facet") };
  Question *question = reader->question;

  if (!begin_kind (reader, QUESTION_CHOOSE))
    return FALSE;
  if (*rest == '\0') {
    question->is_several = TRUE;
    add_kind (question, _ ("lower facets"), "dying-triangles > 0");
    add_kind (question, _ ("upper facets"), "visible-upper > 0");
    add_kind (question, _ ("vertical facets"), "visible-vertical > 0");
    return TRUE;
  }
  if (!object_name_parse (rest, &question->argument)
      || question->argument.kind != OBJECT_FACET)
    return blame (reader, rest,
                  _ ("write which-kind, or which-kind and a facet: f3"));
  for (guint i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *condition = g_strdup_printf ("%s %s", kinds[i], rest);

    add_kind (question, names[i], condition);
  }
  return TRUE;
}

/* Numbers */

static gboolean
read_quantities (Reader *reader, const char *text)
{
  while (*text != '\0') {
    g_autofree char *name = g_strndup (text, strcspn (text, " \t"));
    Quantity quantity;

    if (!quantity_parse (name, &quantity)) {
      g_autofree char *hint = words_hint (name, quantity_names ());

      return blame (reader, text, _ ("nothing called “%s” can be counted%s"),
                    name, hint);
    }
    if (reader->question->quantities->len == QUESTION_MAX_NUMBERS)
      return blame (reader, text, _ ("more than %d numbers"),
                    QUESTION_MAX_NUMBERS);
    g_array_append_val (reader->question->quantities, quantity);
    text = after_word (text);
  }
  return TRUE;
}

static gboolean
read_number (Reader *reader, const char *rest)
{
  if (!begin_kind (reader, QUESTION_NUMBERS))
    return FALSE;
  if (*rest == '\0')
    return blame (reader, rest, _ ("which number? write number visible"));
  return read_quantities (reader, rest);
}

static gboolean
read_delta (Reader *reader, const char *rest)
{
  static const Quantity delta[]
      = { QUANTITY_DYING_TRIANGLES, QUANTITY_NEW_TRIANGLES,
          QUANTITY_HULL_CORNERS, QUANTITY_FACETS };

  if (!begin_kind (reader, QUESTION_NUMBERS))
    return FALSE;
  g_array_append_vals (reader->question->quantities, delta,
                       G_N_ELEMENTS (delta));
  return *rest == '\0' || blame (reader, rest, _ ("“delta” takes nothing"));
}

/* Clicks and orders */

static gboolean
read_argument (Reader *reader, const char *word, char letter)
{
  const ObjectKind kind = letter == 's' ? OBJECT_SITE : OBJECT_FACET;
  Object *argument = &reader->question->argument;

  if (letter == '\0')
    return *word == '\0' || blame (reader, word, _ ("nothing follows here"));
  if (object_name_parse (word, argument) && argument->kind == kind)
    return TRUE;
  *argument = (Object){ OBJECT_NONE, 0 };
  return blame (reader, word,
                letter == 's' ? _ ("of which site? write s3")
                              : _ ("of which facet? write f3"));
}

static gboolean
read_click (Reader *reader, const char *rest)
{
  g_autofree char *name = g_strndup (rest, strcspn (rest, " \t"));
  g_autofree char *hint = NULL;

  if (!begin_kind (reader, QUESTION_CLICK))
    return FALSE;
  reader->question->click = click_kind_find (name);
  if (reader->question->click != NULL)
    return read_argument (reader, after_word (rest),
                          reader->question->click->argument);
  if (*name == '\0')
    return blame (reader, rest, _ ("click what? write click visible-facets"));
  hint = words_hint (name, click_kind_names ());
  return blame (reader, rest, _ ("nothing called “%s” can be clicked%s"), name,
                hint);
}

static gboolean
read_order (Reader *reader, const char *rest)
{
  if (!begin_kind (reader, QUESTION_ORDER))
    return FALSE;
  if (g_str_equal (rest, "sites"))
    reader->question->order = ORDER_OF_SITES;
  else if (g_str_equal (rest, "phases"))
    reader->question->order = ORDER_OF_PHASES;
  else if (g_str_has_prefix (rest, "outside-set")) {
    reader->question->order = ORDER_OF_OUTSIDE_SET;
    return read_argument (reader, after_word (rest), 'f');
  } else
    return blame (reader, rest,
                  _ ("the order of what? write order sites, order phases or "
                     "order outside-set f0"));
  return TRUE;
}

/* Drags */

static gboolean
read_drag (Reader *reader, const char *rest)
{
  g_autofree char *name = g_strndup (rest, strcspn (rest, " \t"));
  const char *until = after_word (rest);
  Object site;

  if (!begin_kind (reader, QUESTION_DRAG))
    return FALSE;
  if (!object_name_parse (name, &site) || site.kind != OBJECT_SITE)
    return blame (reader, rest,
                  _ ("which site? write drag s3 until CONDITION"));
  reader->question->site = site.number;
  if (!g_str_has_prefix (until, "until") || strcspn (until, " \t") != 5)
    return blame (reader, until,
                  _ ("until what? write drag %s until "
                     "CONDITION"),
                  name);
  reader->question->condition = read_condition (reader, after_word (until));
  return reader->question->condition != NULL;
}

static gboolean
read_always (Reader *reader, const char *rest)
{
  if (!begin_kind (reader, QUESTION_ALWAYS))
    return FALSE;
  reader->question->condition = read_condition (reader, rest);
  if (reader->question->condition == NULL)
    return FALSE;
  return !condition_needs_drag (reader->question->condition)
         || blame (reader, rest,
                   _ ("this condition is about a site that is dragged"));
}

static gboolean
read_generate (Reader *reader, const char *rest)
{
  g_auto (GStrv) words = words_split (rest);
  Question *question = reader->question;

  if (!begin_kind (reader, QUESTION_CLICK))
    return FALSE;
  if (g_strv_length (words) != 3 || !g_str_equal (words[1], "seed")
      || !words_parse_number (words[2], G_MAXUINT32, &question->seed))
    return blame (reader, rest,
                  _ ("write generate KIND seed S; without a seed it would not "
                     "be the same question again"));
  if (g_strv_contains (question_generate_kinds (), words[0])) {
    question->generate = g_strdup (words[0]);
    return TRUE;
  }
  {
    g_autofree char *hint = words_hint (words[0], question_generate_kinds ());

    return blame (reader, rest, _ ("no question “%s” can be generated%s"),
                  words[0], hint);
  }
}

/* Performances */

static gboolean
read_perform (Reader *reader, const char *rest)
{
  guint64 *n = &reader->question->n_insertions;

  if (!begin_kind (reader, QUESTION_PERFORM))
    return FALSE;
  return (words_parse_number (rest, QUESTION_MAX_INSERTIONS, n) && *n > 0)
         || blame (reader, rest, _ ("how many insertions? write perform 3"));
}

static gboolean
read_fresh (Reader *reader, const char *rest)
{
  g_autoptr (GError) reason = NULL;
  gsize fault = 0;

  g_clear_pointer (&reader->question->fresh, g_free);
  return fresh_sites_parse (rest, &reader->question->fresh,
                            &reader->question->seed, &fault, &reason)
         || blame (reader, rest + fault, "%s", reason->message);
}

/* What helps */

static gboolean
read_prompt (Reader *reader, const char *rest)
{
  if (reader->question->prompt != NULL)
    return blame (reader, reader->line->text, _ ("a second prompt"));
  reader->question->prompt = g_strdup (rest);
  return *rest != '\0' || blame (reader, rest, _ ("the prompt has no words"));
}

static gboolean
read_hint (Reader *reader, const char *rest)
{
  if (reader->question->hints->len == QUESTION_MAX_HINTS)
    return blame (reader, reader->line->text, _ ("more than %d hints"),
                  QUESTION_MAX_HINTS);
  g_ptr_array_add (reader->question->hints, g_strdup (rest));
  return *rest != '\0' || blame (reader, rest, _ ("the hint has no words"));
}

static gboolean
read_retry (Reader *reader, const char *rest)
{
  guint64 n = 1;

  if (reader->has_retry)
    return blame (reader, reader->line->text, _ ("a second retry"));
  reader->has_retry = TRUE;
  if (*rest != '\0' && !words_parse_number (rest, QUESTION_MAX_RETRIES, &n))
    return blame (reader, rest, _ ("“retry” takes a whole number up to %d"),
                  QUESTION_MAX_RETRIES);
  reader->question->n_retries = (guint)n;
  return TRUE;
}

/* Lines */

static const struct {
  const char *name;
  gboolean (*read) (Reader *reader, const char *rest);
} keys[] = {
  { "before", read_position },   { "round", read_position },
  { "start", read_position },    { "simplex", read_position },
  { "complete", read_position }, { "choose", read_choose },
  { "option", read_option },     { "which-kind", read_which_kind },
  { "number", read_number },     { "delta", read_delta },
  { "click", read_click },       { "order", read_order },
  { "drag", read_drag },         { "always", read_always },
  { "generate", read_generate }, { "prompt", read_prompt },
  { "hint", read_hint },         { "retry", read_retry },
  { "perform", read_perform },   { "fresh", read_fresh },
};

static gboolean
refuse_key (Reader *reader, const char *word)
{
  const char *names[G_N_ELEMENTS (keys) + 1] = { NULL };
  g_autofree char *hint = NULL;

  for (guint i = 0; i < G_N_ELEMENTS (keys); i++)
    names[i] = keys[i].name;
  hint = words_hint (word, names);
  return blame (reader, reader->line->text, _ ("an ask block has no “%s”%s"),
                word, hint);
}

static gboolean
read_line (Reader *reader)
{
  const char *text = reader->line->text;
  g_autofree char *word = g_strndup (text, strcspn (text, " \t"));

  if (g_utf8_strlen (text, -1) > MAX_LINE)
    return blame (reader, text, _ ("a line longer than %d characters"),
                  MAX_LINE);
  for (guint i = 0; i < G_N_ELEMENTS (keys); i++)
    if (g_str_equal (word, keys[i].name))
      return keys[i].read (reader, after_word (text));
  return refuse_key (reader, word);
}

/* What can be known missing only at the end.
 *
 * Returns: the reason, translated, or NULL. */
static const char *
find_missing (const Reader *reader)
{
  const Question *question = reader->question;

  if (!reader->has_position)
    return _ ("where is it asked? write before round R PHASE, or another "
              "position");
  if (!reader->has_kind)
    return _ ("what is asked? write click, number, delta, choose, which-kind, "
              "order, drag, always, generate or perform");
  if (question->kind == QUESTION_CHOOSE && question->options->len < 2)
    return _ ("there must be at least two options: option TEXT if CONDITION");
  if (question->kind != QUESTION_CHOOSE && question->options->len > 0)
    return _ ("options belong to choose one or choose several");
  if (question->kind != QUESTION_PERFORM && question->fresh != NULL)
    return _ ("fresh sites belong to perform");
  if (question->kind == QUESTION_PERFORM
      && (question->prompt != NULL || question->hints->len > 0))
    return _ (
        "a performance has its own prompts and hints: write neither here");
  return NULL;
}

Question *
question_parse (const LessonSource *source,
                const LessonLines *lines,
                LessonFaults *faults)
{
  g_autoptr (Question) question = question_new ();
  Reader reader = { .source = source, .question = question };
  const guint n_faults = faults->errors->len;
  GError *error = NULL;

  question->line = lines->first - 1;
  question->column = 1;
  reader.error = &error;
  for (guint number = lines->first;
       number <= lines->last && !lesson_faults_is_full (faults); number++) {
    LessonLine line;

    lesson_line_init (&line, source, number);
    reader.line = &line;
    if (line.text[0] != '\0' && !read_line (&reader))
      lesson_faults_take (faults, g_steal_pointer (&error));
    lesson_line_clear (&line);
  }
  if (faults->errors->len == n_faults && find_missing (&reader) != NULL) {
    lesson_source_blame (source, question->line, 1, &error, "%s",
                         find_missing (&reader));
    lesson_faults_take (faults, g_steal_pointer (&error));
  }
  return faults->errors->len == n_faults ? g_steal_pointer (&question) : NULL;
}
