#include "canvas-scene.h"

#include <string.h>

typedef enum Age {
  AGE_OLD, /* or not there at all */
  AGE_OTHER_LOOK,
  AGE_VALID,
} Age;

struct CanvasScene {
  Scene scene;
  Age age;
  ScenePicker *picker;
  gboolean stock_roles[N_ROLES]; /* whether the stock has something of it */
  gboolean roles[N_ROLES];       /* whether all of the scene has */
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
note_roles (CanvasScene *kept, gboolean has_new_stock)
{
  const Scene *scene = &kept->scene;

  if (has_new_stock) {
    memset (kept->stock_roles, 0, sizeof kept->stock_roles);
    for (guint i = 0; i < scene->stock.n_items; i++)
      kept->stock_roles[scene->items[i].role] = TRUE;
  }
  memcpy (kept->roles, kept->stock_roles, sizeof kept->roles);
  for (guint i = scene->stock.n_items; i < scene->n_items; i++)
    kept->roles[scene->items[i].role] = TRUE;
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
  note_roles (kept, FALSE);
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
  note_roles (kept, TRUE);
  kept->age = AGE_VALID;
}

void
canvas_scene_fill (CanvasScene *kept, const Showing *showing)
{
  showing_fill (showing, &kept->scene);
  note_roles (kept, TRUE);
  kept->age = AGE_VALID;
}

void
canvas_scene_prepare (CanvasScene *kept, const Projection *projection)
{
  scene_prepare_light (&kept->scene);
  scene_picker_prepare (kept->picker, &kept->scene, projection);
}

void
canvas_scene_take_roles (CanvasScene *kept, const CanvasScene *from)
{
  memcpy (kept->roles, from->roles, sizeof kept->roles);
}

const Scene *
canvas_scene_get (const CanvasScene *kept)
{
  return &kept->scene;
}

gboolean
canvas_scene_has_role (const CanvasScene *kept, Role role)
{
  return kept->roles[role];
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
