/* What of a handout is for the lecturer: notes and timings. */
#ifndef HANDOUT_NOTES_H
#define HANDOUT_NOTES_H

#include "handout-private.h"

G_BEGIN_DECLS

/* Adds the notes on the whole lesson, and what comes when. */
void handout_add_timetable (Handout *handout);

/* Returns: (transfer full): a note and the hints to a question; either may be
 *          NULL, and where there is nothing to say so is the block. */
Block *handout_note (const Handout *handout,
                     const char *note,
                     const Question *question);

G_END_DECLS

#endif
