/* Forms: what a person fills in with a pencil. */
#ifndef FORM_H
#define FORM_H

#include "block.h"

G_BEGIN_DECLS

typedef enum FormMark {
  FORM_EMPTY,
  FORM_CROSSED,
  FORM_ROOMY, /* to write a number into */
  FORM_SOLID, /* a round dot: of what is only listed */
} FormMark;

/* Returns: (transfer full): a box to cross, and the words beside it. */
Block *form_choice (const Press *press,
                    double width,
                    const char *markup,
                    FormMark mark);

/* One word, and a line to write upon. */
Block *form_entry (const Press *press, double width, const char *markup);

/* What is counted, and at the right a short line for its number; @value is
 * written there, or NULL. */
Block *form_number (const Press *press,
                    double width,
                    const char *markup,
                    const char *value);

/* Lines to write upon. */
Block *form_lines (double width, guint n_lines);

/* Returns: how many of them a height has room for. */
guint form_lines_in (double height);

/* An empty frame to draw in. */
Block *form_field (double width, double height);

/* A fine line across. */
Block *form_rule (double width);

G_END_DECLS

#endif
