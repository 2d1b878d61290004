#include "showing.h"

static Showing *
new_with_look (Run *run, const SceneLook *look)
{
  Showing *showing = g_new0 (Showing, 1);
  SceneLook *own = &showing->look;

  showing->run = run_ref (run);
  *own = *look;
  own->answers
      = g_memdup2 (look->answers, look->n_answers * sizeof *look->answers);
  own->selected
      = g_memdup2 (look->selected, look->n_selected * sizeof *look->selected);
  return showing;
}

Showing *
showing_new (KeptFrame *frame,
             Run *run,
             gboolean is_space,
             const SceneLook *look)
{
  Showing *showing = new_with_look (run, look);

  showing->frame = kept_frame_ref (frame);
  showing->is_space = is_space;
  return showing;
}

Showing *
showing_new_exhibit (const Exhibit *exhibit,
                     guint step,
                     guint pane,
                     const SceneLook *look)
{
  Showing *showing = new_with_look (exhibit_run (exhibit), look);

  showing->exhibit = exhibit_share (exhibit);
  showing->step = step;
  showing->pane = pane;
  return showing;
}

void
showing_free (Showing *showing)
{
  if (showing == NULL)
    return;
  g_free ((gpointer)showing->look.answers);
  g_free ((gpointer)showing->look.selected);
  g_clear_pointer (&showing->frame, kept_frame_unref);
  exhibit_free (showing->exhibit);
  run_unref (showing->run);
  g_free (showing);
}

gboolean
showing_relight (const Showing *showing, Scene *scene)
{
  const Frame *frame = showing->frame != NULL ? &showing->frame->frame : NULL;

  return showing->is_space == scene->is_space
         && scene_relight (scene, frame, &showing->look);
}

void
showing_fill (const Showing *showing, Scene *scene)
{
  if (showing->frame == NULL)
    exhibit_scene (showing->exhibit, showing->step, showing->pane, scene,
                   &showing->look);
  else if (showing->is_space)
    scene_space (scene, &showing->frame->frame, &showing->look);
  else
    scene_plane (scene, &showing->frame->frame, &showing->look);
}
