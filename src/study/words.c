#include "words.h"

#include "number.h"

#include <glib/gi18n.h>
#include <string.h>

/* Longer words have no near name. */
#define HINT_MAX 24

/* Longer messages are longer by what they quote: letters of both ends. */
#define MESSAGE_END 300

/* As many letters of a name tell which one is meant. */
#define HINT_BEGINNING 5

char **
words_split (const char *text)
{
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();

  for (;;) {
    g_autofree char *word = NULL;
    gsize length;

    text += strspn (text, " \t");
    length = strcspn (text, " \t");
    if (length == 0)
      return g_strv_builder_end (builder);
    word = g_strndup (text, length);
    g_strv_builder_add (builder, word);
    text += length;
  }
}

gboolean
words_parse_number (const char *word, guint64 most, guint64 *number)
{
  return g_ascii_isdigit (word[0])
         && g_ascii_string_to_unsigned (word, 10, 0, most, number, NULL);
}

gboolean
words_parse_double (const char *word, double *number)
{
  const char *end = number_parse (word, number);

  return end != NULL && *end == '\0';
}

const char *
words_comma_hint (const char *text)
{
  for (const char *comma = strchr (text, ','); comma != NULL;
       comma = strchr (comma + 1, ','))
    if (comma > text && g_ascii_isdigit (comma[-1])
        && g_ascii_isdigit (comma[1]))
      return _ ("; write decimals with a point, as in 1.5");
  return "";
}

/* Least number of letters put in, left out, changed or swapped with their
 * neighbour to make @b of @a.
 *
 * Source: Damerau 1964, in the restricted form (optimal string alignment). */
static guint
typing_errors (const char *a, const char *b)
{
  guint cost[HINT_MAX + 1][HINT_MAX + 1];
  const gsize n = strlen (a), m = strlen (b);

  for (gsize i = 0; i <= n; i++)
    for (gsize j = 0; j <= m; j++) {
      guint *least = &cost[i][j];

      if (i == 0 || j == 0) {
        *least = (guint)(i + j);
        continue;
      }
      *least = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      *least = MIN (*least, cost[i - 1][j] + 1);
      *least = MIN (*least, cost[i][j - 1] + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        *least = MIN (*least, cost[i - 2][j - 2] + 1);
    }
  return cost[n][m];
}

static const char *
find_mistyped (const char *word, const char *const *names)
{
  const char *nearest = NULL;
  guint least = strlen (word) <= 4 ? 2 : 3;

  for (; *names != NULL; names++)
    if (strlen (*names) <= HINT_MAX && typing_errors (word, *names) < least) {
      nearest = *names;
      least = typing_errors (word, *names);
    }
  return nearest;
}

/* Of "visible-facets" the beginning was written, or more than "upper". */
static const char *
find_beginning (const char *word, const char *const *names)
{
  for (; *names != NULL; names++)
    if (MIN (strlen (word), strlen (*names)) >= HINT_BEGINNING
        && (g_str_has_prefix (*names, word) || g_str_has_prefix (word, *names)))
      return *names;
  return NULL;
}

char *
words_hint (const char *word, const char *const *names)
{
  g_autofree char *lower = g_ascii_strdown (word, -1);
  const char *nearest = NULL;

  if (strlen (word) > HINT_MAX)
    return g_strdup ("");
  nearest = find_mistyped (lower, names);
  if (nearest == NULL)
    nearest = find_beginning (lower, names);
  return nearest == NULL
             ? g_strdup ("")
             : g_strdup_printf (_ (" (did you mean “%s”?)"), nearest);
}

char *
words_shorten (const char *message)
{
  const glong n = g_utf8_strlen (message, -1);
  g_autofree char *begin = NULL;

  if (n <= 2 * MESSAGE_END)
    return g_strdup (message);
  begin = g_utf8_substring (message, 0, MESSAGE_END);
  return g_strconcat (
      begin, " … ", g_utf8_offset_to_pointer (message, n - MESSAGE_END), NULL);
}
