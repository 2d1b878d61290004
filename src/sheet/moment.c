#include "moment.h"

#include "session-picture.h"

/* A picture is painted larger than it is printed, so that its lines and names
 * are as fine on paper as they should be. */
#define PX_PER_PT 2.1
#define FRAME_WIDTH 0.5
#define FRAME_GREY 0.7

/* Entering */

/* A question that is answered may have left other sites than the stop's, so
 * it is asked anew each time. */
static void
ask_or_answer (Session *session, gboolean is_asked)
{
  const Exercise *exercise = session_get_exercise (session);
  const Performance *performance = session_get_performance (session);

  if (exercise == NULL)
    return;
  if (performance != NULL) {
    if (performance->is_over)
      session_retry (session);
    if (!is_asked)
      session_grade (session);
    return;
  }
  if (!exercise->is_open)
    session_retry (session);
  if (!is_asked)
    session_reveal (session);
}

void
moment_enter (const Moment *moment)
{
  Session *session = moment->session;

  if (moment->stop != MOMENT_NONE) {
    session_set_stop (session, moment->stop);
    ask_or_answer (session, moment->face == MOMENT_ASKED);
  }
  if (moment->step != MOMENT_NONE)
    session_set_step (session, moment->step);
}

/* Painting */

static PictureView
picture_view (Session *session, MomentView view)
{
  switch (view) {
  case MOMENT_PLANE:
    return PICTURE_PLANE;
  case MOMENT_SPACE:
    return PICTURE_SPACE;
  case MOMENT_VIEWS:
    break;
  }
  return session_picture_view (session);
}

static void
take_picture (Picture *picture,
              Session *session,
              MomentFace face,
              MomentView view)
{
  session_picture (picture, session, picture_view (session, view));
  if (face == MOMENT_MASKED)
    picture->look.mask |= MASK_WHY | MASK_ROUND;
}

static void
paint (Session *session,
       const Picture *what,
       const Appearance *appearance,
       cairo_t *cr,
       const cairo_rectangle_t *area)
{
  Picture picture = *what;
  Theme theme;

  theme_init (&theme, appearance);
  picture.theme = &theme;
  picture.width = area->width * PX_PER_PT;
  picture.height = area->height * PX_PER_PT;
  cairo_save (cr);
  cairo_rectangle (cr, area->x, area->y, area->width, area->height);
  cairo_clip (cr);
  cairo_translate (cr, area->x, area->y);
  cairo_scale (cr, 1 / PX_PER_PT, 1 / PX_PER_PT);
  picture_paint (&picture, session_get_frame (session), cr);
  cairo_restore (cr);
  cairo_rectangle (cr, area->x, area->y, area->width, area->height);
  cairo_set_line_width (cr, FRAME_WIDTH);
  cairo_set_source_rgb (cr, FRAME_GREY, FRAME_GREY, FRAME_GREY);
  cairo_stroke (cr);
}

void
moment_paint (Session *session,
              MomentView view,
              const Appearance *appearance,
              cairo_t *cr,
              const cairo_rectangle_t *area)
{
  Picture picture;

  take_picture (&picture, session, MOMENT_SHOWN, view);
  paint (session, &picture, appearance, cr, area);
}

/* What is in the picture is near enough to what is in this square: marks of
 * all kinds are about its middle. */
#define MARKS_REACH 1.3

void
moment_add_marks (Session *session,
                  MomentFace face,
                  MomentView view,
                  LegendMarks *marks)
{
  Picture picture;

  take_picture (&picture, session, face, view);
  picture.look.low = (Point3){ -MARKS_REACH, -MARKS_REACH, 0 };
  picture.look.high = (Point3){ MARKS_REACH, MARKS_REACH, 0 };
  for (int pane = 0; pane < N_PANES; pane++) {
    const gboolean is_left = picture.view != PICTURE_SPACE;
    Scene scene = { 0 };

    if (pane == 0 ? !is_left : picture.view == PICTURE_PLANE)
      continue;
    picture.fill (&scene, pane, &picture.look, picture.fill_user);
    legend_marks_add_stock (marks, &scene);
    legend_marks_add_pointed (marks, &scene);
    scene_clear (&scene);
  }
}

/* Block */

typedef struct Drawing {
  Moment moment;
  MomentView view;
  Appearance appearance;
} Drawing;

static void
draw (cairo_t *cr, double width, double height, gpointer data)
{
  const Drawing *drawing = data;
  Session *session = drawing->moment.session;
  Picture picture;

  moment_enter (&drawing->moment);
  take_picture (&picture, session, drawing->moment.face, drawing->view);
  paint (session, &picture, &drawing->appearance, cr,
         &(cairo_rectangle_t){ 0, 0, width, height });
}

static void
drawing_free (gpointer data)
{
  Drawing *drawing = data;

  g_object_unref (drawing->moment.session);
  g_free (drawing);
}

Block *
moment_block (const Moment *moment,
              MomentView view,
              const Appearance *appearance,
              double width,
              double height)
{
  Drawing *drawing = g_new (Drawing, 1);
  Block *block;

  *drawing = (Drawing){ *moment, view, *appearance };
  g_object_ref (moment->session);
  block = block_drawing (width, height, draw, drawing, drawing_free);
  block->tag = "Figure";
  return block;
}
