#include "canvas-scene.h"

typedef enum Age {
  AGE_OLD, /* or not there at all */
  AGE_OTHER_LOOK,
  AGE_VALID,
} Age;

struct CanvasScene {
  Scene scene;
  Age age;
  ScenePicker *picker;
  LegendMarks stock_marks; /* but for their light */
  LegendMarks marks;       /* of all of the scene */
};

CanvasScene *
canvas_scene_new (void)
{
  CanvasScene *kept = g_new0 (CanvasScene, 1);

  kept->picker = scene_picker_new ();
  return kept;
}

void
canvas_scene_free (CanvasScene *kept)
{
  if (kept == NULL)
    return;
  scene_clear (&kept->scene);
  scene_picker_free (kept->picker);
  g_free (kept);
}

void
canvas_scene_invalidate (CanvasScene *kept, gboolean is_only_look)
{
  if (!is_only_look)
    kept->age = AGE_OLD;
  else if (kept->age == AGE_VALID)
    kept->age = AGE_OTHER_LOOK;
}

gboolean
canvas_scene_is_valid (const CanvasScene *kept)
{
  return kept->age == AGE_VALID;
}

static void
note_marks (CanvasScene *kept, gboolean has_new_stock)
{
  const Scene *scene = &kept->scene;

  if (has_new_stock) {
    kept->stock_marks = (LegendMarks){ 0 };
    legend_marks_add_stock (&kept->stock_marks, scene);
  }
  kept->marks = kept->stock_marks;
  legend_marks_add_pointed (&kept->marks, scene);
}

gboolean
canvas_scene_has_stock (const CanvasScene *kept)
{
  return kept->age != AGE_OLD;
}

gboolean
canvas_scene_relight (CanvasScene *kept,
                      Session *session,
                      guint pane,
                      const SceneLook *look)
{
  if (kept->age == AGE_VALID)
    return TRUE;
  if (kept->age == AGE_OLD
      || !session_relight_scene (session, pane, &kept->scene, look)) {
    kept->age = AGE_OLD;
    return FALSE;
  }
  note_marks (kept, FALSE);
  kept->age = AGE_VALID;
  return TRUE;
}

void
canvas_scene_update (CanvasScene *kept,
                     Session *session,
                     guint pane,
                     const SceneLook *look)
{
  if (canvas_scene_relight (kept, session, pane, look))
    return;
  session_fill_scene (session, pane, &kept->scene, look);
  note_marks (kept, TRUE);
  kept->age = AGE_VALID;
}

void
canvas_scene_fill (CanvasScene *kept, const Showing *showing)
{
  const gboolean is_lit
      = kept->age != AGE_OLD && showing_relight (showing, &kept->scene);

  if (!is_lit)
    showing_fill (showing, &kept->scene);
  note_marks (kept, !is_lit);
  kept->age = AGE_VALID;
}

void
canvas_scene_prepare (CanvasScene *kept, const Projection *projection)
{
  scene_prepare_light (&kept->scene);
  scene_picker_prepare (kept->picker, &kept->scene, projection);
}

void
canvas_scene_take_marks (CanvasScene *kept, const CanvasScene *from)
{
  kept->marks = from->marks;
}

const Scene *
canvas_scene_get (const CanvasScene *kept)
{
  return &kept->scene;
}

const LegendMarks *
canvas_scene_get_marks (const CanvasScene *kept)
{
  return &kept->marks;
}

Object
canvas_scene_pick (CanvasScene *kept,
                   const Projection *projection,
                   const double at_px[2],
                   double reach_px)
{
  return scene_picker_pick (kept->picker, &kept->scene, projection, at_px,
                            reach_px);
}
