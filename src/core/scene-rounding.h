/* Scenes of the demonstration of rounding, for the plane view. */
#ifndef SCENE_ROUNDING_H
#define SCENE_ROUNDING_H

#include "rounding.h"
#include "scene.h"

/* The map over the square -1 … 1; @node, column and row, is marked. */
void scene_sign_map (Scene *scene,
                     const SignMap *map,
                     bool is_exact,
                     const uint32_t node[2],
                     const SceneLook *look);

/* The true hull, when @is_exact, or the rounded one. */
void scene_rounded (Scene *scene,
                    const RoundedHull *hull,
                    bool is_exact,
                    const SceneLook *look);

#endif
