/* A small picture of what a session shows, to be looked at alone. */
#ifndef SMALL_PICTURE_H
#define SMALL_PICTURE_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Of more sites there is no small picture: a sentence in its place says so. */
#define SMALL_PICTURE_MOST_SITES 2000

#define SMALL_PICTURE_TYPE (small_picture_get_type ())
G_DECLARE_FINAL_TYPE (
    SmallPicture, small_picture, HULL2VD, SMALL_PICTURE, GtkDrawingArea)

#define SMALL_PICTURE_NOW G_MAXUINT

/* @session: what is shown, in the appearance of @like; NULL: nothing. @stop:
 * where it is taken to first, if it plays the lesson for pictures alone; or
 * SMALL_PICTURE_NOW: it stays where it is, and the picture follows it when told
 * so by small_picture_changed(). */
void small_picture_set_session (SmallPicture *picture,
                                Session *session,
                                guint stop,
                                Session *like);

/* It is painted anew when it is next seen. */
void small_picture_changed (SmallPicture *picture);

G_END_DECLS

#endif
