#include "command.h"

#include "action.h"
#include "expect.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

/* Returns: the lesson verb that the first @n words name, or NULL. */
static const Action *
find_verb (char **words, guint n)
{
  g_autofree char *name = NULL;
  g_auto (GStrv) first = g_new0 (char *, n + 1);
  const Action *action;

  for (guint i = 0; i < n; i++)
    first[i] = g_strdup (words[i]);
  name = g_strjoinv ("-", first);
  action = action_find (name);
  return action != NULL && (action->where & ACTION_IN_LESSON) ? action : NULL;
}

/* Returns: what follows the first @n words of @text. */
static const char *
after_words (const char *text, guint n)
{
  text += strspn (text, " \t");
  for (; n > 0; n--) {
    text += strcspn (text, " \t");
    text += strspn (text, " \t");
  }
  return text;
}

/* Returns: (transfer full): a name as it is written in a lesson. */
static char *
verb_words (const char *name)
{
  return g_strdelimit (g_strdup (name), "-", ' ');
}

/* Returns: (transfer full): the verb that begins with a word, as "move site"
 *          does with "move"; NULL: none. */
static char *
find_longer_verb (const char *word)
{
  guint n_actions;
  const Action *table = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++)
    if ((table[i].where & ACTION_IN_LESSON)
        && strcspn (table[i].name, "-") == strlen (word)
        && g_str_has_prefix (table[i].name, word))
      return verb_words (table[i].name);
  return NULL;
}

static char *
verb_hint (const char *word)
{
  g_autoptr (GPtrArray) names = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *longer = find_longer_verb (word);
  guint n_actions;
  const Action *table = action_table (&n_actions);

  if (longer != NULL)
    return g_strdup_printf (_ (" (did you mean “%s”?)"), longer);
  for (guint i = 0; i < n_actions; i++)
    if (table[i].where & ACTION_IN_LESSON)
      g_ptr_array_add (names,
                       g_strndup (table[i].name, strcspn (table[i].name, "-")));
  g_ptr_array_add (names, g_strdup ("expect"));
  g_ptr_array_add (names, NULL);
  return words_hint (word, (const char *const *)names->pdata);
}

static gboolean
refuse_verb (const char *word, GError **error)
{
  g_autofree char *hint = verb_hint (word);

  g_set_error (error, ACTION_ERROR, ACTION_ERROR_UNKNOWN,
               _ ("“%s” is not a command%s"), word, hint);
  return FALSE;
}

/* How a parameter is written, for messages. */
static const char *
parameter_rule (const char *type)
{
  if (type == NULL)
    return _ ("nothing");
  if (g_str_equal (type, "u"))
    return _ ("a site, such as s3");
  if (g_str_equal (type, "(dd)"))
    return _ ("two numbers: X Y");
  if (g_str_equal (type, "(uu)"))
    return _ ("two whole numbers");
  if (g_str_equal (type, "(uuu)"))
    return _ ("three sites");
  if (g_str_equal (type, "(udd)"))
    return _ ("a site and two numbers: s3 X Y");
  if (g_str_equal (type, "d"))
    return _ ("a number");
  if (g_str_equal (type, "(sd)"))
    return _ ("a name and a number");
  return _ ("something after it");
}

/* Reads one word as a name (s), a whole number (u) or a decimal number (d). A
 * site may be called by its name: s3. */
static GVariant *
parse_member (char type, const char *word)
{
  guint64 number;
  double real;

  if (type == 'u') {
    word += *word == 's' ? 1 : 0;
    return words_parse_number (word, G_MAXUINT32, &number)
               ? g_variant_new_uint32 ((guint32)number)
               : NULL;
  }
  if (type == 's')
    return g_variant_new_string (word);
  return words_parse_double (word, &real) ? g_variant_new_double (real) : NULL;
}

/* Reads as many words as @type, "u" or "(udd)", has members. */
static GVariant *
parse_members (const char *type, char **words)
{
  const char *members = type + (*type == '(' ? 1 : 0);
  const gsize n = strspn (members, "sud");
  GVariant *values[4];

  if (g_strv_length (words) != n)
    return NULL;
  for (gsize i = 0; i < n; i++) {
    values[i] = parse_member (members[i], words[i]);
    if (values[i] == NULL) {
      while (i-- > 0)
        g_variant_unref (g_variant_ref_sink (values[i]));
      return NULL;
    }
  }
  return *type == '(' ? g_variant_new_tuple (values, n) : values[0];
}

static gboolean
parse_parameter (const Action *action,
                 const char *rest,
                 GVariant **parameter,
                 GError **error)
{
  g_auto (GStrv) words = words_split (rest);
  g_autofree char *verb = g_strdelimit (g_strdup (action->name), "-", ' ');
  GVariant *value = NULL;

  *parameter = NULL;
  if (action->parameter == NULL && *rest == '\0')
    return TRUE;
  if (action->parameter != NULL && g_str_equal (action->parameter, "s"))
    value = *rest == '\0' ? NULL : g_variant_new_string (rest);
  else if (action->parameter != NULL)
    value = parse_members (action->parameter, words);

  if (value != NULL) {
    *parameter = g_variant_ref_sink (value);
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("“%s” takes %s%s"), verb, parameter_rule (action->parameter),
               action->parameter != NULL && strchr (action->parameter, 'd')
                   ? words_comma_hint (rest)
                   : "");
  return FALSE;
}

static gboolean
parse_expect (const char *rest,
              char **verb,
              GVariant **parameter,
              GError **error)
{
  if (!expect_parse (rest, error))
    return FALSE;
  *verb = g_strdup ("expect");
  *parameter = g_variant_ref_sink (g_variant_new_string (rest));
  return TRUE;
}

gboolean
command_parse (const char *text,
               char **verb,
               GVariant **parameter,
               GError **error)
{
  g_auto (GStrv) words = words_split (text);
  const Action *action = NULL;
  guint n = MIN (g_strv_length (words), 2);

  if (words[0] == NULL)
    return refuse_verb ("", error);
  if (g_str_equal (words[0], "expect"))
    return parse_expect (after_words (text, 1), verb, parameter, error);

  /* The longest name wins: "next phase" before "next". */
  while (n > 0 && (action = find_verb (words, n)) == NULL)
    n -= 1;
  if (action == NULL)
    return refuse_verb (words[0], error);
  if (!parse_parameter (action, after_words (text, n), parameter, error))
    return FALSE;
  *verb = g_strdup (action->name);
  return TRUE;
}
