#include "canvas-show.h"

#include "answer-objects.h"
#include "canvas-picture.h"
#include "canvas-scene.h"
#include "canvas-work.h"
#include "session-chore.h"

#include <glib/gi18n.h>

#define REACH_PX 12.0

/* A picture that was painted roughly, because something moved, is painted well
 * when nothing has moved for so long, also when a rough one of the last motion
 * is still to come. It may itself take 120 ms where OpenGL is software;
 * pointers that move tell so every 20. */
#define SETTLE_MS 40

/* To light so much takes as long as a picture of a large set. */
#define MUCH_LIGHT 250

/* Among so many items, 30 000 sites, a single light takes 50 ms. */
#define MANY_ITEMS 200000

struct CanvasShow {
  Canvas *canvas;
  Session *session;
  CanvasScene *scene, *spare;
  CanvasPicture *picture;
  CanvasWork *work;      /* NULL: none is under way */
  guint chore;           /* of the session, for it */
  gboolean is_refused;   /* the person does not wait for this picture */
  gboolean is_undressed; /* it is not of the theme and sizes that are wanted */
  gboolean was_large;    /* the last picture of a thread was of many sites */
  gboolean is_moving;
  gint64 moved_us; /* when something has last changed */
  guint settle_source;
  char *trouble; /* to be told: why OpenGL does not paint */
  guint trouble_source;
};

CanvasShow *
canvas_show_new (Canvas *canvas)
{
  CanvasShow *show = g_new0 (CanvasShow, 1);

  show->canvas = canvas;
  show->session = g_object_ref (canvas_get_session (canvas));
  show->scene = canvas_scene_new ();
  show->picture = canvas_picture_new (
      GTK_WIDGET (canvas), HULL2VD_CANVAS_GET_CLASS (canvas)->is_space);
  return show;
}

static void
give_up_work (CanvasShow *show)
{
  if (show->work == NULL)
    return;
  canvas_work_give_up (show->work);
  show->work = NULL;
  session_end_chore (show->session, show->chore);
}

/* The picture that is there stays until something changes. */
static void
refuse_work (gpointer user)
{
  CanvasShow *show = user;

  give_up_work (show);
  show->is_refused = TRUE;
}

void
canvas_show_free (CanvasShow *show)
{
  if (show->settle_source != 0)
    g_source_remove (show->settle_source);
  if (show->trouble_source != 0)
    g_source_remove (show->trouble_source);
  give_up_work (show);
  g_free (show->trouble);
  canvas_scene_free (show->scene);
  canvas_scene_free (show->spare);
  canvas_picture_free (show->picture);
  g_object_unref (show->session);
  g_free (show);
}

void
canvas_show_release (CanvasShow *show)
{
  canvas_picture_release (show->picture);
}

/* The scene */

/* The look of the session as it is, made the view's own. */
static SceneLook
get_look (CanvasShow *show)
{
  SceneLook look = *session_get_look (show->session);

  HULL2VD_CANVAS_GET_CLASS (show->canvas)->adapt_look (show->canvas, &look);
  return look;
}

const Scene *
canvas_show_get_scene (CanvasShow *show)
{
  if (!canvas_scene_is_valid (show->scene)) {
    const SceneLook look = get_look (show);

    canvas_scene_update (show->scene, show->session,
                         canvas_get_pane (show->canvas), &look);
  }
  return canvas_scene_get (show->scene);
}

Object
canvas_show_pick (CanvasShow *show, const double at_px[2])
{
  const Projection projection = canvas_get_projection (show->canvas);
  const Scene *scene = canvas_show_get_scene (show);

  if (session_is_answering (show->session))
    return answer_objects_pick (show->canvas, scene, at_px, REACH_PX);
  return canvas_scene_pick (show->scene, &projection, at_px, REACH_PX);
}

/* Whether so much is lit, or was, that it is a thread's work. */
static gboolean
has_much_light (CanvasShow *show, const SceneLook *look)
{
  return look->n_selected > MUCH_LIGHT
         || canvas_scene_get (show->scene)->n_lit > MUCH_LIGHT;
}

/* Whether the scene is there, or made in no time. */
static gboolean
has_scene (CanvasShow *show)
{
  SceneLook look;

  if (canvas_scene_is_valid (show->scene))
    return TRUE;
  if (!canvas_scene_has_stock (show->scene))
    return FALSE;
  look = get_look (show);
  if (has_much_light (show, &look))
    return FALSE;
  return canvas_scene_relight (show->scene, show->session,
                               canvas_get_pane (show->canvas), &look);
}

/* While GTK dresses all widgets anew, the main loop has enough to do. */
static gboolean
is_large (const CanvasShow *show)
{
  return session_is_large (show->session, show->is_undressed);
}

gboolean
canvas_show_is_busy (CanvasShow *show)
{
  return show->work != NULL || (is_large (show) && !has_scene (show));
}

const LegendMarks *
canvas_show_get_marks (CanvasShow *show)
{
  if (!canvas_show_is_busy (show))
    canvas_show_get_scene (show);
  return canvas_scene_get_marks (show->scene);
}

static void
invalidate (CanvasShow *show, CanvasChange change)
{
  const gboolean is_only_look = change == CANVAS_CHANGE_LOOK;

  show->is_refused = FALSE;
  if (change == CANVAS_CHANGE_APPEARANCE)
    show->is_undressed = TRUE;
  canvas_picture_invalidate (show->picture);
  if (change != CANVAS_CHANGE_PICTURE)
    canvas_scene_invalidate (show->scene, is_only_look);
  if (show->work != NULL)
    canvas_work_note (show->work, change != CANVAS_CHANGE_PICTURE,
                      is_only_look);
  gtk_widget_queue_draw (GTK_WIDGET (show->canvas));
}

void
canvas_show_invalidate (CanvasShow *show, CanvasChange change)
{
  show->moved_us = g_get_monotonic_time ();
  invalidate (show, change);
}

/* Rough pictures */

/* Returns: how long it will be until nothing has moved for a while. */
static gint
ms_to_rest (const CanvasShow *show)
{
  const gint64 still_us = g_get_monotonic_time () - show->moved_us;

  return MAX (0, SETTLE_MS - (gint)(still_us / 1000));
}

static void settle_later (CanvasShow *show);

static gboolean
on_settled (gpointer user)
{
  CanvasShow *show = user;

  show->settle_source = 0;
  if (ms_to_rest (show) > 0)
    settle_later (show);
  else
    invalidate (show, CANVAS_CHANGE_PICTURE);
  return G_SOURCE_REMOVE;
}

static void
settle_later (CanvasShow *show)
{
  if (show->settle_source == 0)
    show->settle_source
        = g_timeout_add ((guint)ms_to_rest (show), on_settled, show);
}

void
canvas_show_set_moving (CanvasShow *show, gboolean moving)
{
  show->is_moving = moving;
}

static gboolean
may_be_rough (const CanvasShow *show)
{
  return show->is_moving && ms_to_rest (show) > 0;
}

/* Trouble */

static gboolean
on_trouble (gpointer user)
{
  CanvasShow *show = user;
  g_autofree char *trouble = g_steal_pointer (&show->trouble);

  show->trouble_source = 0;
  canvas_fail_with (show->canvas, trouble);
  return G_SOURCE_REMOVE;
}

/* A window that is being drawn cannot show a sentence more: later. */
static void
tell_trouble (CanvasShow *show, const GError *error)
{
  g_free (show->trouble);
  show->trouble = g_strdup_printf (_ ("Space is drawn without OpenGL: %s"),
                                   error->message);
  if (show->trouble_source == 0)
    show->trouble_source = g_idle_add (on_trouble, show);
}

/* What has just been painted, or has not. */
static void
note_painted (CanvasShow *show, const GError *error)
{
  if (error != NULL)
    tell_trouble (show, error);
  if (canvas_picture_is_valid (show->picture))
    show->is_undressed = FALSE;
  if (canvas_picture_is_rough (show->picture))
    settle_later (show);
}

/* Large sets */

void
canvas_show_check_work (CanvasShow *show)
{
  const guint n_sites = session_get_set (show->session)->n_sites;

  if (show->work != NULL && show->work->n_sites != n_sites)
    give_up_work (show);
}

/* The picture may be of a moment ago: it is shown all the same, or a site that
 * is dragged would never be. */
static void
on_work_done (CanvasWork *work, gpointer user)
{
  CanvasShow *show = user;
  g_autoptr (GError) error = NULL;

  show->work = NULL;
  session_end_chore (show->session, show->chore);
  canvas_scene_free (show->spare);
  show->spare = show->scene;
  show->scene = g_steal_pointer (&work->scene);
  if (work->has_other_look)
    canvas_scene_invalidate (show->scene, !work->has_other_scene);
  canvas_picture_take_back (show->picture, g_steal_pointer (&work->picture),
                            !work->is_outdated, &error);
  note_painted (show, error);
  gtk_widget_queue_draw (GTK_WIDGET (show->canvas));
  canvas_tell_renewed (show->canvas);
}

/* Lends scene and picture; what is asked of the scene until then is asked of
 * another one. Takes @showing. */
static void
begin_work (CanvasShow *show, const Projection *projection, Showing *showing)
{
  CanvasWork *work = g_new0 (CanvasWork, 1);
  g_autoptr (GError) error = NULL;

  work->scene = show->scene;
  work->showing = showing;
  work->picture = canvas_picture_lend (show->picture, projection,
                                       canvas_get_theme (show->canvas),
                                       may_be_rough (show), &error);
  work->projection = *projection;
  work->n_sites = session_get_set (show->session)->n_sites;
  if (error != NULL)
    tell_trouble (show, error);
  show->scene = show->spare != NULL ? g_steal_pointer (&show->spare)
                                    : canvas_scene_new ();
  show->was_large = work->n_sites > SESSION_AT_ONCE;
  canvas_scene_invalidate (show->scene, FALSE);
  canvas_scene_take_marks (show->scene, work->scene);
  show->work = work;
  show->chore = session_begin_chore (
      show->session, _ ("The picture is being drawn"), refuse_work, show);
  canvas_work_begin (work, on_work_done, show);
}

/* What few sites look like is not compared with what many did, which would
 * take as long as to draw these. */
static void
forget_large (CanvasShow *show)
{
  give_up_work (show);
  if (show->was_large)
    canvas_picture_forget (show->picture);
  show->was_large = FALSE;
}

/* Returns: FALSE: it is painted at once. */
static gboolean
paint_later (CanvasShow *show, const Projection *projection)
{
  const guint pane = canvas_get_pane (show->canvas);
  Showing *showing = NULL;
  SceneLook look;

  if (!is_large (show)) {
    forget_large (show);
    return FALSE;
  }
  if (show->work != NULL)
    return TRUE;
  look = get_look (show);
  if (has_much_light (show, &look)) {
    if (!canvas_scene_is_valid (show->scene))
      showing = session_keep_showing (show->session, pane, &look);
  } else if (!canvas_scene_relight (show->scene, show->session, pane, &look)) {
    showing = session_keep_showing (show->session, pane, &look);
  } else if (canvas_scene_get (show->scene)->stock.n_items <= MANY_ITEMS
             && canvas_picture_has_stock (
                 show->picture, canvas_scene_get (show->scene), projection,
                 canvas_get_theme (show->canvas))) {
    return FALSE;
  }
  begin_work (show, projection, showing);
  return TRUE;
}

/* Drawing */

static void
paint (CanvasShow *show)
{
  const Projection projection = canvas_get_projection (show->canvas);
  g_autoptr (GError) error = NULL;

  if (paint_later (show, &projection))
    return;
  canvas_picture_update (show->picture, canvas_show_get_scene (show),
                         &projection, canvas_get_theme (show->canvas),
                         may_be_rough (show), &error);
  note_painted (show, error);
}

/* Before there is any picture. */
static void
draw_ground (cairo_t *cr, const Theme *theme)
{
  const Colour ground = theme->background;

  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_paint (cr);
}

void
canvas_show_draw (CanvasShow *show, cairo_t *cr)
{
  if (!canvas_picture_is_valid (show->picture) && !show->is_refused)
    paint (show);
  if (!canvas_picture_draw (show->picture, cr))
    draw_ground (cr, canvas_get_theme (show->canvas));
}
