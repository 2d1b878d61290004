/* Heights above a facet, and distances from an edge. */
#include "scene-builder.h"

#include <math.h>

/* Scene units. */
#define TICK 0.035  /* half of one */
#define SHORT 0.2   /* as large is the mark of the site, or larger */
#define ASIDE 0.135 /* from the middle of that mark, with room for a tick */

static Point3
move (Point3 from, Point3 direction, double part)
{
  return (Point3){ from.x + part * direction.x, from.y + part * direction.y,
                   from.z + part * direction.z };
}

static double
length_of (Point3 way)
{
  return sqrt (way.x * way.x + way.y * way.y + way.z * way.z);
}

/* Returns: how long a way is for who looks along @gaze. */
static double
seen_length (Point3 way, Point3 gaze)
{
  const Point3 cross
      = { way.y * gaze.z - way.z * gaze.y, way.z * gaze.x - way.x * gaze.z,
          way.x * gaze.y - way.y * gaze.x };

  return length_of (cross) / length_of (gaze);
}

void
scene_put_aside (Point3 ends[2], Point3 across, Point3 gaze)
{
  const double part = ASIDE / length_of (across);
  int i;

  if (!isfinite (part)
      || seen_length (move (ends[1], ends[0], -1), gaze) > SHORT)
    return;
  for (i = 0; i < 2; i++)
    ends[i] = move (ends[i], across, part);
}

void
scene_add_measure (SceneBuilder *builder,
                   Object object,
                   const Point3 ends[2],
                   Point3 across)
{
  const double part = TICK / length_of (across);
  int i;

  scene_add_segment (builder, ROLE_DROP, object, ends);
  for (i = 0; i < 2 && isfinite (part); i++) {
    const Point3 tick[2]
        = { move (ends[i], across, -part), move (ends[i], across, part) };

    scene_add_segment (builder, ROLE_DROP, object, tick);
  }
}
