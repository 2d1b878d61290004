/* A picture of what a session shows: its panes, its look, its cameras. */
#ifndef SESSION_PICTURE_H
#define SESSION_PICTURE_H

#include "picture.h"
#include "session.h"

G_BEGIN_DECLS

/* Returns: what the session has its pictures show: plane, space or both. */
PictureView session_picture_view (Session *session);

/* @view: which of the panes; where there is one alone, that one. Of a default
 * size and theme, without a title; the hover is left out.
 *
 * Owns: @picture borrows @session. */
void session_picture (Picture *picture, Session *session, PictureView view);

/* The same for a picture that has its size, view and theme. */
void session_picture_take (Picture *picture, Session *session);

/* The same for a picture that another thread paints, whatever the session
 * shows by then.
 *
 * Owns: @picture borrows @kept, and its title, theme and description. */
typedef struct KeptPanes KeptPanes;

KeptPanes *session_picture_keep (Picture *picture, Session *session);

/* No pane is filled any more; from any thread. */
void kept_panes_give_up (KeptPanes *kept);
gboolean kept_panes_are_given_up (KeptPanes *kept);
void kept_panes_free (KeptPanes *kept);

G_END_DECLS

#endif
