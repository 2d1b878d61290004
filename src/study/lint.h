/* Lint: all that is wrong with lessons, and what could be better. */
#ifndef LINT_H
#define LINT_H

#include "lesson.h"

G_BEGIN_DECLS

/* More words than this are not read from the last row. */
#define LINT_MOST_WORDS 100

typedef struct Lint {
  GPtrArray *errors;   /* of char *: "FILE:LINE:COL: reason" */
  GPtrArray *warnings; /* of char *: "FILE:LINE:COL: warning: reason" */
  GPtrArray *folders;  /* of the lessons that were looked at */
  gboolean is_missing; /* a lesson could not be opened */
} Lint;

Lint *lint_new (void);
void lint_free (Lint *lint);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Lint, lint_free)

/* Looks at one lesson. */
void lint_add (Lint *lint, const char *path);

/* Looks for files of sites, beside the lessons, that no lesson names. */
void lint_end (Lint *lint);

G_END_DECLS

#endif
