#include "words.h"

#include "number.h"

#include <glib/gi18n.h>
#include <string.h>

/* Longer words have no near name. */
#define HINT_MAX 24

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

char *
words_hint (const char *word, const char *const *names)
{
  const char *nearest = NULL;
  guint least = strlen (word) <= 4 ? 2 : 3;

  if (strlen (word) > HINT_MAX)
    return g_strdup ("");
  for (; *names != NULL; names++)
    if (strlen (*names) <= HINT_MAX && typing_errors (word, *names) < least) {
      nearest = *names;
      least = typing_errors (word, *names);
    }
  return nearest == NULL
             ? g_strdup ("")
             : g_strdup_printf (_ (" (did you mean “%s”?)"), nearest);
}
