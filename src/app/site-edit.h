/* Edits of sites as a person makes them in a view: at a pixel, by an arrow
 * key. What cannot be done is said by the canvas. */
#ifndef SITE_EDIT_H
#define SITE_EDIT_H

#include "canvas.h"

G_BEGIN_DECLS

/* Returns: the site in given coordinates, on the snap grid, at a point of the
 *          plane scene. */
Site site_edit_at (Session *session, Point3 point);

/* Says why sites cannot be changed now.
 *
 * Returns: FALSE: they can, or all that is pressed is an answer. */
gboolean site_edit_refuse (Canvas *canvas);

/* Adds a site there, and goes to it. */
void site_edit_add (Canvas *canvas, Point3 point);

/* Puts the cursor on the last site, just added, and lets go of those that are
 * selected: what is deleted now is what can be seen to be meant. */
void site_edit_go_to_last (Canvas *canvas);

/* Moves a site there; when it is selected, the other selected ones with it. */
void site_edit_move (Canvas *canvas, guint site, Point3 point);

/* Returns: whether a click means a site beside those that are selected. */
gboolean site_edit_joins (const CanvasPress *press);

/* Selects a site beside the others, or lets it go; FALSE for what is none. */
gboolean site_edit_toggle (Canvas *canvas, Object object);

/* Moves the site under the cursor as site_edit_move() does by @by steps, y down
 * as on the screen; keys held down are one edit, until site_edit_settle().
 *
 * Returns: FALSE when the cursor is on no site. */
gboolean site_edit_nudge (Canvas *canvas, const double by[2], gboolean is_far);
void site_edit_settle (Canvas *canvas);

/* Removes the site under the cursor, when it is selected with all that are;
 * FALSE when it is on none. */
gboolean site_edit_remove (Canvas *canvas);

G_END_DECLS

#endif
