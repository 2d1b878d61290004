#include "stage.h"

void
stage_draw (Stage *stage)
{
  scene_plane (&stage->plane, &stage->frame, &stage->look);
  scene_space (&stage->space, &stage->frame, &stage->look);
}

void
stage_project (Stage *stage, double width, double height)
{
  PlaneCamera plane;
  Camera space;

  plane_camera_init (&plane);
  camera_init (&space, CAMERA_HOME);
  stage->on_plane = plane_camera_projection (&plane, width, height);
  stage->on_space = camera_projection (&space, width, height);
  scene_look_fit (&stage->look, &stage->on_plane, 6);
}

Stage *
stage_take (Fixture *fixture, uint32_t step)
{
  Stage *stage = g_new0 (Stage, 1);

  stage->fixture = fixture;
  frame_init (&stage->frame, fixture->trace, step);
  scene_look_init (&stage->look, &stage->frame);
  stage_project (stage, 500, 500);
  stage_draw (stage);
  return stage;
}

Stage *
stage_new (const char *name, uint32_t round, Phase phase)
{
  Fixture *fixture = fixture_load (name, ORDER_FURTHEST);
  uint32_t step;

  g_assert_true (
      timeline_find (fixture->trace, (Place){ round, phase }, false, &step));
  return stage_take (fixture, step);
}

Stage *
stage_at_end (const char *name)
{
  Fixture *fixture = fixture_load (name, ORDER_FURTHEST);

  return stage_take (fixture, fixture->trace->n_events);
}

void
stage_free (Stage *stage)
{
  scene_clear (&stage->plane);
  scene_clear (&stage->space);
  frame_clear (&stage->frame);
  fixture_free (stage->fixture);
  g_free (stage);
}

guint
stage_count (const Scene *scene, Role role)
{
  guint i, n = 0;

  for (i = 0; i < scene->n_items; i++)
    n += scene->items[i].role == role;
  return n;
}

const SceneItem *
stage_find (const Scene *scene, Role role, Object object)
{
  guint i;

  for (i = 0; i < scene->n_items; i++)
    if (scene->items[i].role == role
        && object_equal (scene->items[i].object, object))
      return &scene->items[i];
  return NULL;
}

const Site *
stage_site (const Stage *stage, uint32_t site)
{
  return &stage->fixture->set->sites[site];
}

Pixel
stage_pixel (const Projection *projection, Point3 point)
{
  const Point3 at = projection_apply (projection, point);

  return (Pixel){ at.x, at.y };
}
