/* Chores: what threads of others work on for the person, as a picture for a
 * file. Whoever begins one ends it, also when it has been given up: @give_up
 * asks for that once, and may end it at once.
 */
#ifndef SESSION_CHORE_H
#define SESSION_CHORE_H

#include "session.h"

typedef void (*SessionGiveUp) (gpointer user);

/* @sentence: what is done, translated.
 *
 * Returns: its number, never 0. */
guint session_begin_chore (Session *session,
                           const char *sentence,
                           SessionGiveUp give_up,
                           gpointer user);
void session_end_chore (Session *session, guint chore);

/* Returns: the sentence of the one that was begun last; NULL: there is none.
 */
const char *session_get_chore (Session *session);

#endif
