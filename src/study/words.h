/* Words of a command line: what the lesson language and the parameters of
 * actions are made of. */
#ifndef WORDS_H
#define WORDS_H

#include <glib.h>

G_BEGIN_DECLS

/* Returns: (transfer full): the words between blanks and tabs. */
char **words_split (const char *text);

/* Reads a whole number 0 … @most: digits alone. */
gboolean words_parse_number (const char *word, guint64 most, guint64 *number);

/* Reads a decimal number, the same in every locale: all of @word, finite. */
gboolean words_parse_double (const char *word, double *number);

/* Returns: "; write decimals with a point, as in 1.5" when a number in @text
 * has a comma instead, or "". */
const char *words_comma_hint (const char *text);

/* Returns: (transfer full): @message, of which the middle is left out where it
 *          quotes more than a person can read. */
char *words_shorten (const char *message);

/* Returns: (transfer full): " (did you mean “NAME”?)" for the name nearest to
 *          @word by few typing errors, or "". @names ends with NULL. */
char *words_hint (const char *word, const char *const *names);

G_END_DECLS

#endif
