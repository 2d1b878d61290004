/* Judges the legend of what a session shows: in each theme every item of the
 * scenes looks like the sample of a row, as pale and as wide, and no two rows
 * look or read alike. It asks the styles of items and the pixels of samples,
 * not the legend's own notion of marks. */
#ifndef LEGEND_JUDGE_H
#define LEGEND_JUDGE_H

#include "legend.h"

/* Between these, faults are gathered and told, each of them once. */
void legend_judge_open (void);
void legend_judge_close (void); /* fails the test when there are some */

/* @name, @place: of the moment, for the person who reads of a fault. */
void legend_judge (Session *session, const char *name, guint place);

/* Returns: whether a legend has had a row for @mark. */
gboolean legend_judge_has_met (int mark);

#endif
