#include "condition.h"

#include "condition-private.h"
#include "lesson.h"
#include "object-name.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

#define MAX_TERMS 6
#define MAX_NUMBER 1000000

/* A sum of quantities, each times a whole number, and a constant. */
typedef struct Sum {
  gint64 constant;
  guint n_terms;
  struct {
    gint64 factor;
    Quantity quantity;
  } terms[MAX_TERMS];
} Sum;

typedef enum Relation {
  RELATION_EQUAL,
  RELATION_UNEQUAL,
  RELATION_LESS,
  RELATION_AT_MOST,
  RELATION_GREATER,
  RELATION_AT_LEAST,
} Relation;

static const char *const relations[] = {
  [RELATION_EQUAL] = "=",   [RELATION_UNEQUAL] = "!=",
  [RELATION_LESS] = "<",    [RELATION_AT_MOST] = "<=",
  [RELATION_GREATER] = ">", [RELATION_AT_LEAST] = ">=",
};

struct Condition {
  char *text;
  gboolean is_negated;
  const ConditionWord *word; /* or NULL: a comparison */
  guint arguments[2];
  Sum left, right;
  Relation relation;
};

/* Reading */

static gboolean
refuse_name (const char *name, GError **error)
{
  g_autoptr (GPtrArray) names = g_ptr_array_new ();
  g_autofree char *hint = NULL;

  for (const char *const *word = condition_words (); *word != NULL; word++)
    g_ptr_array_add (names, (char *)*word);
  for (const char *const *key = quantity_names (); *key != NULL; key++)
    g_ptr_array_add (names, (char *)*key);
  g_ptr_array_add (names, NULL);
  hint = words_hint (name, (const char *const *)names->pdata);
  return lesson_refuse (error, _ ("a condition cannot use “%s”%s"), name, hint);
}

/* "3", "facets", "2*inserted" */
static gboolean
read_term (const char *word, gint64 sign, Sum *sum, GError **error)
{
  const char *star = strchr (word, '*');
  g_autofree char *head
      = star == NULL ? g_strdup (word) : g_strndup (word, star - word);
  const char *name = star == NULL ? word : star + 1;
  guint64 factor = 1;
  Quantity quantity;

  if (words_parse_number (word, MAX_NUMBER, &factor)) {
    sum->constant += sign * (gint64)factor;
    return TRUE;
  }
  if (star != NULL && !words_parse_number (head, MAX_NUMBER, &factor))
    return refuse_name (word, error);
  if (!quantity_parse (name, &quantity))
    return refuse_name (name, error);
  if (sum->n_terms == MAX_TERMS)
    return lesson_refuse (error, _ ("a sum has at most %d terms"), MAX_TERMS);
  sum->terms[sum->n_terms].factor = sign * (gint64)factor;
  sum->terms[sum->n_terms].quantity = quantity;
  sum->n_terms += 1;
  return TRUE;
}

/* Reads terms with signs between them, @n words. */
static gboolean
read_sum (char **words, guint n, Sum *sum, GError **error)
{
  gint64 sign = 1;

  for (guint i = 0; i < n; i++) {
    const gboolean is_sign
        = g_str_equal (words[i], "+") || g_str_equal (words[i], "-");

    if (is_sign != (i % 2 == 1))
      return lesson_refuse (error, _ ("“%s” is out of place in this sum"),
                            words[i]);
    if (is_sign)
      sign = words[i][0] == '-' ? -1 : 1;
    else if (!read_term (words[i], sign, sum, error))
      return FALSE;
  }
  return n % 2 == 1
         || lesson_refuse (error, _ ("a number or a quantity is missing"));
}

/* Returns: the place of the relation among @words, or their number. */
static guint
find_relation (char **words, Relation *relation)
{
  guint i;

  for (i = 0; words[i] != NULL; i++)
    for (guint k = 0; k < G_N_ELEMENTS (relations); k++)
      if (g_str_equal (words[i], relations[k])) {
        *relation = (Relation)k;
        return i;
      }
  return i;
}

static gboolean
read_comparison (Condition *condition, char **words, GError **error)
{
  const guint n = g_strv_length (words);
  const guint at = find_relation (words, &condition->relation);

  /* A quantity by itself: there is some. */
  if (at == n && n == 1) {
    condition->relation = RELATION_GREATER;
    return read_sum (words, n, &condition->left, error);
  }
  if (at == n)
    return quantity_parse (words[0], &(Quantity){ 0 })
               ? lesson_refuse (error,
                                _ ("what should “%s” be compared with? write "
                                   "%s = 4, or <, >, !="),
                                words[0], words[0])
               : refuse_name (words[0], error);
  return read_sum (words, at, &condition->left, error)
         && read_sum (words + at + 1, n - at - 1, &condition->right, error);
}

static const char *
argument_rule (const char *arguments)
{
  if (g_str_equal (arguments, "s"))
    return _ ("a site: s3");
  if (g_str_equal (arguments, "f"))
    return _ ("a facet: f3");
  if (g_str_equal (arguments, "sf"))
    return _ ("a site and a facet: s3 f0");
  return g_str_equal (arguments, "ss") ? _ ("two sites: s1 s3") : _ ("nothing");
}

static gboolean
read_word (Condition *condition, char **words, GError **error)
{
  const char *rule = condition->word->arguments;
  gboolean is_good = g_strv_length (words) == strlen (rule) + 1;

  for (guint i = 0; is_good && rule[i] != '\0'; i++) {
    Object object;

    is_good = object_name_parse (words[i + 1], &object)
              && object.kind == (rule[i] == 's' ? OBJECT_SITE : OBJECT_FACET);
    condition->arguments[i] = object.number;
  }
  return is_good
         || lesson_refuse (error, _ ("“%s” takes %s"), condition->word->name,
                           argument_rule (rule));
}

static gboolean
read_whole (Condition *condition, char **words, GError **error)
{
  condition->is_negated = words[0] != NULL && g_str_equal (words[0], "not");
  words += condition->is_negated ? 1 : 0;
  if (words[0] == NULL)
    return lesson_refuse (error, _ ("a condition is missing"));
  condition->word = condition_word_find (words[0]);
  return condition->word != NULL ? read_word (condition, words, error)
                                 : read_comparison (condition, words, error);
}

Condition *
condition_parse (const char *text, GError **error)
{
  g_autoptr (Condition) condition = g_new0 (Condition, 1);
  g_auto (GStrv) words = words_split (text);

  condition->text = g_strjoinv (" ", words);
  return read_whole (condition, words, error) ? g_steal_pointer (&condition)
                                              : NULL;
}

void
condition_free (Condition *condition)
{
  g_free (condition->text);
  g_free (condition);
}

/* What it says */

const char *
condition_text (const Condition *condition)
{
  return condition->text;
}

gboolean
condition_is_negated (const Condition *condition)
{
  return condition->is_negated;
}

const char *
condition_word (const Condition *condition, guint arguments[2])
{
  if (condition->word == NULL)
    return NULL;
  for (guint i = 0; i < 2; i++)
    arguments[i] = condition->arguments[i];
  return condition->word->name;
}

char *
condition_statement (const Condition *condition)
{
  const ConditionWord *word = condition->word;
  g_autoptr (GString) text = NULL;

  if (word == NULL)
    return NULL;
  text = g_string_new (_ (word->sentence));
  for (guint i = 0; word->arguments[i] != '\0'; i++) {
    g_autofree char *name
        = g_strdup_printf ("%c%u", word->arguments[i], condition->arguments[i]);

    g_string_replace (text, i == 0 ? "{a}" : "{b}", name, 0);
  }
  return g_string_free (g_steal_pointer (&text), FALSE);
}

/* Words have a sentence of their own; of what is written otherwise no language
 * has a better form. */
char *
condition_sentence (const Condition *condition)
{
  if (condition->word == NULL || condition->is_negated)
    return g_strdup_printf ("`%s`", condition->text);
  return condition_statement (condition);
}

static void
add_facts (GString *text, const Sum *sum, const Frame *frame)
{
  for (guint i = 0; i < sum->n_terms; i++) {
    const Quantity quantity = sum->terms[i].quantity;
    g_autofree char *fact = g_strdup_printf (
        "%s: %u", quantity_label (quantity), quantity_value (frame, quantity));

    if (strstr (text->str, fact) == NULL)
      g_string_append_printf (text, "%s%s", text->len == 0 ? "" : ", ", fact);
  }
}

char *
condition_facts (const Condition *condition, const Frame *frame)
{
  GString *text = g_string_new (NULL);

  add_facts (text, &condition->left, frame);
  add_facts (text, &condition->right, frame);
  return g_string_free (text, FALSE);
}

static void
visit_sum (const Sum *sum,
           void (*visit) (Quantity quantity, gpointer user),
           gpointer user)
{
  for (guint i = 0; i < sum->n_terms; i++)
    visit (sum->terms[i].quantity, user);
}

void
condition_for_each_quantity (const Condition *condition,
                             void (*visit) (Quantity quantity, gpointer user),
                             gpointer user)
{
  visit_sum (&condition->left, visit, user);
  visit_sum (&condition->right, visit, user);
}

gboolean
condition_needs_drag (const Condition *condition)
{
  return condition->word != NULL && condition->word->needs_drag;
}

static QuantityScope
scope_of_sum (const Sum *sum)
{
  QuantityScope scope = SCOPE_ALWAYS;

  for (guint i = 0; i < sum->n_terms; i++)
    scope = MAX (scope, quantity_scope (sum->terms[i].quantity));
  return scope;
}

QuantityScope
condition_scope (const Condition *condition)
{
  return MAX (scope_of_sum (&condition->left),
              scope_of_sum (&condition->right));
}

const char *
condition_fault (const Condition *condition, const Situation *situation)
{
  const char *rule = condition->word == NULL ? "" : condition->word->arguments;
  const Trace *trace = situation->frame->trace;

  if (condition_needs_drag (condition)
      && (situation->before == NULL || situation->site == INDEX_NONE))
    return _ ("this condition is about a site that is dragged");
  for (guint i = 0; rule[i] != '\0'; i++) {
    if (rule[i] == 's' && condition->arguments[i] >= trace->set->n_sites)
      return _ ("there is no such site");
    if (rule[i] == 'f' && condition->arguments[i] >= trace->n_facets)
      return _ ("there is no such facet");
  }
  return NULL;
}

static gint64
value_of (const Sum *sum, const Frame *frame)
{
  gint64 value = sum->constant;

  for (guint i = 0; i < sum->n_terms; i++)
    value += sum->terms[i].factor
             * quantity_value (frame, sum->terms[i].quantity);
  return value;
}

static gboolean
compare (gint64 left, Relation relation, gint64 right)
{
  switch (relation) {
  case RELATION_EQUAL:
    return left == right;
  case RELATION_UNEQUAL:
    return left != right;
  case RELATION_LESS:
    return left < right;
  case RELATION_AT_MOST:
    return left <= right;
  case RELATION_GREATER:
    return left > right;
  case RELATION_AT_LEAST:
    return left >= right;
  }
  return FALSE;
}

gboolean
condition_holds (const Condition *condition, const Situation *situation)
{
  gboolean holds;

  g_return_val_if_fail (condition_fault (condition, situation) == NULL, FALSE);
  if (condition->word != NULL)
    holds = condition->word->holds (situation, condition->arguments);
  else
    holds = compare (value_of (&condition->left, situation->frame),
                     condition->relation,
                     value_of (&condition->right, situation->frame));
  return holds != condition->is_negated;
}
