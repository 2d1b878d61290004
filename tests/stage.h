/* A frame with both of its scenes, drawn and projected, for tests of what is
 * seen and picked. */
#ifndef STAGE_H
#define STAGE_H

#include "clip.h"
#include "fixture.h"
#include "scene.h"

typedef struct Stage {
  Fixture *fixture;
  Frame frame;
  SceneLook look;
  Scene plane, space;
  Projection on_plane, on_space;
} Stage;

/* Returns: (transfer full): all layers, 500 by 500 pixels, the home camera.
 *          Takes over the fixture. */
Stage *stage_take (Fixture *fixture, uint32_t step);

/* The same of a named set in the furthest order, at a place or at the end. */
Stage *stage_new (const char *name, uint32_t round, Phase phase);
Stage *stage_at_end (const char *name);
void stage_free (Stage *stage);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Stage, stage_free)

/* Makes the scenes anew, after the look has changed. */
void stage_draw (Stage *stage);

/* Projects into views of this many pixels. */
void stage_project (Stage *stage, double width, double height);

/* Returns: how many items have the role. */
guint stage_count (const Scene *scene, Role role);

/* Returns: the first item with role and object, or NULL. */
const SceneItem *stage_find (const Scene *scene, Role role, Object object);

const Site *stage_site (const Stage *stage, uint32_t site);
Pixel stage_pixel (const Projection *projection, Point3 point);

#endif
