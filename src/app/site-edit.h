/* Edits of sites as a person makes them in a view: at a pixel, by an arrow
 * key. What cannot be done is said by the canvas. */
#ifndef SITE_EDIT_H
#define SITE_EDIT_H

#include "canvas.h"

G_BEGIN_DECLS

/* Returns: the site in given coordinates, on the snap grid, at a point of the
 *          plane scene. */
Site site_edit_at (Session *session, Point3 point);

/* Adds a site there, and puts the cursor on it. */
void site_edit_add (Canvas *canvas, Point3 point);

void site_edit_move (Canvas *canvas, guint site, Point3 point);

/* Moves the site under the cursor by @by steps, y down as on the screen; keys
 * held down are one edit, until site_edit_settle().
 *
 * Returns: FALSE when the cursor is on no site. */
gboolean site_edit_nudge (Canvas *canvas, const double by[2], gboolean is_far);
void site_edit_settle (Canvas *canvas);

/* Removes the site under the cursor; FALSE when it is on none. */
gboolean site_edit_remove (Canvas *canvas);

G_END_DECLS

#endif
