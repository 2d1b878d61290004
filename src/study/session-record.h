/* A record: what a person does in a session, as text of a lesson.
 *
 * A stop of a lesson shows its end alone, so the record is a row of stops,
 * each the commands that lead there from the stop before, in a fixed order:
 * sites, view, time, look, selection, camera, staging, theme. However often a
 * slider or a site was moved on the way, one line tells where it came to. A new
 * stop begins when time is moved after something else was done, when another
 * stop of the lesson is entered, and when session_record_cut() is called.
 *
 * The commands are those of the lesson language. Each is carried out in a
 * session beside, so that what they lead to is what the next ones begin from.
 * A few sites that were moved or added are told one by one, more of them by
 * the line "sites" of the end.
 *
 * Not recorded: what the plane view is zoomed to, answers to questions, and
 * all but one of several selected sites.
 */
#ifndef SESSION_RECORD_H
#define SESSION_RECORD_H

#include "session.h"

G_BEGIN_DECLS

typedef struct SessionRecord SessionRecord;

/* Begins now. In a lesson the record goes on from the end of the stop;
 * without one it is a lesson of its own. */
SessionRecord *session_record_new (Session *session);
void session_record_free (SessionRecord *record);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (SessionRecord, session_record_free)

/* Begins a new stop; when nothing was done since the last one, nothing
 * happens. */
void session_record_cut (SessionRecord *record);

/* Returns: (transfer full): the text so far, to be put behind the stop where
 *          it began, or into a file; "" when there is nothing yet. */
char *session_record_text (SessionRecord *record);

G_END_DECLS

#endif
