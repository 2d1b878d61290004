#include "canvas-work.h"

static void
work_free (CanvasWork *work)
{
  canvas_scene_free (work->scene);
  showing_free (work->showing);
  picture_work_free (work->picture);
  g_free (work);
}

static gboolean
is_given_up (CanvasWork *work)
{
  return g_atomic_int_get (&work->is_given_up) != 0;
}

/* What nobody needs any more, or wants: of many sites it is 100 MB, and to give
 * them back takes the main loop too long. */
static void
let_go (CanvasWork *work)
{
  g_clear_pointer (&work->showing, showing_free);
  if (!is_given_up (work))
    return;
  g_clear_pointer (&work->scene, canvas_scene_free);
  g_clear_pointer (&work->picture, picture_work_free);
}

static void
make_picture (GTask *task,
              gpointer source,
              gpointer task_data,
              GCancellable *cancellable)
{
  CanvasWork *work = task_data;

  (void)source;
  (void)cancellable;
  if (work->showing != NULL && !is_given_up (work))
    canvas_scene_fill (work->scene, work->showing);
  if (!is_given_up (work))
    picture_work_do (work->picture, canvas_scene_get (work->scene));
  if (!is_given_up (work)) {
    canvas_scene_prepare (work->scene, &work->projection);
    picture_work_prepare (work->picture);
  }
  let_go (work);
  g_task_return_boolean (task, TRUE);
}

/* Who is told. */
typedef struct Waiting {
  CanvasWorkDone done;
  gpointer user;
} Waiting;

static void
on_made (GObject *source, GAsyncResult *result, gpointer user)
{
  g_autofree Waiting *waiting = user;
  CanvasWork *work = g_task_get_task_data (G_TASK (result));

  (void)source;
  if (!is_given_up (work))
    waiting->done (work, waiting->user);
  work_free (work);
}

void
canvas_work_begin (CanvasWork *work, CanvasWorkDone done, gpointer user)
{
  Waiting *waiting = g_new (Waiting, 1);
  g_autoptr (GTask) task = g_task_new (NULL, NULL, on_made, waiting);

  *waiting = (Waiting){ done, user };
  g_task_set_task_data (task, work, NULL);
  g_task_run_in_thread (task, make_picture);
}

void
canvas_work_note (CanvasWork *work,
                  gboolean has_other_scene,
                  gboolean is_only_look)
{
  work->is_outdated = TRUE;
  work->has_other_look = work->has_other_look || has_other_scene;
  work->has_other_scene
      = work->has_other_scene || (has_other_scene && !is_only_look);
}

void
canvas_work_give_up (CanvasWork *work)
{
  g_atomic_int_set (&work->is_given_up, 1);
}
