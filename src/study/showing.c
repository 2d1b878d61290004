#include "showing.h"

Showing *
showing_new (KeptFrame *frame, gboolean is_space, const SceneLook *look)
{
  Showing *showing = g_new (Showing, 1);
  SceneLook *own = &showing->look;

  *showing = (Showing){ kept_frame_ref (frame), is_space, *look };
  own->answers
      = g_memdup2 (look->answers, look->n_answers * sizeof *look->answers);
  own->selected
      = g_memdup2 (look->selected, look->n_selected * sizeof *look->selected);
  return showing;
}

void
showing_free (Showing *showing)
{
  if (showing == NULL)
    return;
  g_free ((gpointer)showing->look.answers);
  g_free ((gpointer)showing->look.selected);
  kept_frame_unref (showing->frame);
  g_free (showing);
}

void
showing_fill (const Showing *showing, Scene *scene)
{
  const Frame *frame = &showing->frame->frame;

  if (showing->is_space)
    scene_space (scene, frame, &showing->look);
  else
    scene_plane (scene, frame, &showing->look);
}
