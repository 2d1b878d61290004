/* What can be found only by looking: sites that make a condition hold, sets
 * that make it fail, and legal orders of insertion. */
#ifndef QUESTION_SEARCH_H
#define QUESTION_SEARCH_H

#include "question.h"

G_BEGIN_DECLS

/* Returns: whether the condition of a drag holds for the sites of @now, in
 *          place of those of @before. */
gboolean question_drag_holds (const Question *question,
                              const Trace *before,
                              const Trace *now);

/* Looks for a place on the snap grid where the condition holds, the nearest
 * of a coarse grid first.
 *
 * Returns: FALSE: there is none that a hand can reach. */
gboolean
question_find_drag (const Question *question, const Trace *trace, Site *to);

/* Returns: whether a condition fails somewhere in a run: at the end of the
 *          first partition, of a round, or of all. Steps at which one of its
 *          quantities says nothing are passed over. */
gboolean question_fails (const Condition *condition, const Trace *trace);

/* Looks for sites for which it fails: those of @trace first, then sets of
 * some hundred: random, with ties, on grids, circles and lines.
 *
 * Returns: (transfer full): the sites, *@n_sites of them; NULL: none. */
Site *question_find_failure (const Condition *condition,
                             const Trace *trace,
                             guint *n_sites);

/* How many sites of @order QuickHull could insert from @occasion on, one after
 * the other: each the furthest of its facet's outside set, exact ties
 * included.
 *
 * Returns: their number; when it is not all, *@better is the site that lies
 *          further than the next one. */
guint question_legal_order (const Occasion *occasion,
                            const GArray *order,
                            guint *better);

G_END_DECLS

#endif
