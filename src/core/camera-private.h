/* What camera.c and camera-projection.c share. */
#ifndef CAMERA_PRIVATE_H
#define CAMERA_PRIVATE_H

#include "camera.h"

Quaternion camera_normalize (Quaternion turn);

/* Returns: pixels of a scene unit in the plane view at zoom 1. */
double camera_plane_scale (double width, double height);

#endif
