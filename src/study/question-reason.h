/* Why a clicked object is right, or is not: sentences, translated, in the
 * words of the mathematics. They are for ClickKind.why. */
#ifndef QUESTION_REASON_H
#define QUESTION_REASON_H

#include "question-click.h"

G_BEGIN_DECLS

#define REASON(name)                                                           \
  char *name (const Question *question G_GNUC_UNUSED,                          \
              const Occasion *occasion G_GNUC_UNUSED,                          \
              const Frame *frame G_GNUC_UNUSED, Object object)

REASON (reason_visible);      /* the current site sees the facet, or does not */
REASON (reason_circle);       /* the vertex's circle contains it, or does not */
REASON (reason_horizon);      /* a ridge */
REASON (reason_new_triangle); /* a ridge of the horizon */
REASON (reason_facing);       /* a facet */
REASON (reason_furthest);     /* a site */
REASON (reason_outside_set);  /* a facet */
REASON (reason_member);       /* a site of the argument's outside set */
REASON (reason_sees_argument); /* a site, the argument a facet */
REASON (reason_argument_sees); /* a facet, the argument a site */
REASON (reason_hand_over);     /* a facet, the argument a site */
REASON (reason_unbounded);
REASON (reason_corner);
REASON (reason_neighbour);
REASON (reason_duplicate);

/* Returns: (transfer full): why a condition holds, or does not, in the frame
 *          in which it is decided; NULL: there is no more to say of its word
 *          than the word. */
char *reason_condition (const Condition *condition,
                        const Occasion *occasion,
                        const Frame *frame);

/* Returns: whether the site sees the facet: the exact sign. */
gboolean question_sees (const Trace *trace, guint site, guint facet);

/* Returns: +1 when @p lies further in front of @facet than @q, -1 when @q
 *          does, 0 when they tie. */
int question_further (const Trace *trace, guint facet, guint p, guint q);

G_END_DECLS

#endif
