/* The legend: a sample and a name for each mark that the pictures of a session
 * show, in the order in which the algorithm makes them. What speaks for itself
 * has no row: the frame of the plane, and names. */
#ifndef LEGEND_H
#define LEGEND_H

#include "legend-mark.h"
#include "session.h"
#include "theme.h"

G_BEGIN_DECLS

typedef struct LegendRow {
  int mark; /* legend-mark.h */
  SceneItem sample;
  char *text; /* "new site s4" */
  gboolean is_of_pointer;
} LegendRow;

/* @marks: of all the pictures that are shown.
 *
 * Returns: (transfer full) (element-type LegendRow): what they mean at the
 *          session's step, what is of the pointer last. */
GPtrArray *
legend_rows (Session *session, const LegendMarks *marks, const Theme *theme);

/* The same of many moments, in which the current site is another one each: p.
 *
 * Returns: (transfer full) (element-type LegendRow): empty. */
GPtrArray *legend_new (void);
void legend_gather (GPtrArray *rows,
                    Session *session,
                    const LegendMarks *marks,
                    const Theme *theme);

/* Whether a mark ever has a row. */
gboolean legend_mark_has_words (int mark);

/* Whether its row is there only as long as the pointer. */
gboolean legend_mark_is_of_pointer (int mark);

/* Whether it is a role that can be hidden; a selection is given up, not
 * hidden. */
gboolean legend_mark_is_switch (int mark);

G_END_DECLS

#endif
