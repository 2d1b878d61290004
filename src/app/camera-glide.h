/* A smooth way from the camera that a view shows to that of the session: at
 * most 0.6 s, over at any key or click, and none at all where the desktop
 * wants no animations. The session's camera itself leaps. */
#ifndef CAMERA_GLIDE_H
#define CAMERA_GLIDE_H

#include "canvas.h"

G_BEGIN_DECLS

typedef struct CameraGlide CameraGlide;

/* Watches the session of @canvas, once it has one. */
CameraGlide *camera_glide_new (Canvas *canvas);
void camera_glide_free (CameraGlide *glide);

/* Returns: the projection to show now. */
Projection
camera_glide_projection (CameraGlide *glide, double width, double height);

/* To be called before the view itself changes the camera, as the pointer
 * turns it: that is followed at once. */
void camera_glide_follow (CameraGlide *glide);

G_END_DECLS

#endif
