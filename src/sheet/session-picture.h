/* A picture of what a session shows: its panes, its look, its cameras. */
#ifndef SESSION_PICTURE_H
#define SESSION_PICTURE_H

#include "picture.h"
#include "session.h"

G_BEGIN_DECLS

/* @view: which of the panes; where there is one alone, that one. Of a default
 * size and theme, without a title; the hover is left out.
 *
 * Owns: @picture borrows @session. */
void session_picture (Picture *picture, Session *session, PictureView view);

/* The same for a picture that has its size, view and theme. */
void session_picture_take (Picture *picture, Session *session);

G_END_DECLS

#endif
