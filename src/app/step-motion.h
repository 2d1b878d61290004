/* The way from one step to the next: the horizon is drawn round its loop, the
 * cone grows from its ridges to the apex. As with camera-glide.h it is short,
 * over at any key or click, and not there where nothing may move; the
 * session is at the next step from the beginning. */
#ifndef STEP_MOTION_H
#define STEP_MOTION_H

#include "canvas.h"

G_BEGIN_DECLS

typedef struct StepMotion StepMotion;

StepMotion *step_motion_new (Canvas *canvas);
void step_motion_free (StepMotion *way);

/* Lets @look, of which a scene is about to be made, show how far it is. */
void step_motion_apply (StepMotion *way, SceneLook *look);

G_END_DECLS

#endif
