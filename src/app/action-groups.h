/* Actions under headings, where a person reads a list of them: the window of
 * shortcuts, and that in which keys are changed. */
#ifndef ACTION_GROUPS_H
#define ACTION_GROUPS_H

#include "action.h"

G_BEGIN_DECLS

#define N_ACTION_GROUPS 6

/* Returns: the heading in the person's language. */
const char *action_group_title (guint group);

guint action_group_of (const Action *action);

G_END_DECLS

#endif
