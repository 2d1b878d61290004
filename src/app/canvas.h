/* Canvas: a drawn view of the session, what plane view and space view have in
 * common. It keeps the painted picture until something changes, tells the
 * session what the pointer and the keyboard do, and shows its objects to
 * assistive technology. */
#ifndef CANVAS_H
#define CANVAS_H

#include "legend-mark.h"
#include "painter.h"
#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define CANVAS_TYPE (canvas_get_type ())
G_DECLARE_DERIVABLE_TYPE (Canvas, canvas, HULL2VD, CANVAS, GtkDrawingArea)

/* A press that has become a drag, or a click. */
typedef struct CanvasPress {
  Object object; /* under the pointer when it went down */
  double at_px[2];
  guint button;
  GdkModifierType modifiers;
} CanvasPress;

struct _CanvasClass {
  GtkDrawingAreaClass parent_class;

  const char *title; /* marked for translation: its accessible name */
  gboolean is_space;

  /* What the view shows, and where. The look is the session's, to be made the
   * view's own. */
  void (*adapt_look) (Canvas *canvas, SceneLook *look);
  Projection (*project) (Canvas *canvas, double width, double height);

  /* What a person does. Lengths in px of the widget. */
  void (*zoom) (Canvas *canvas, const double at_px[2], double factor);
  void (*pan) (Canvas *canvas, const double by_px[2]);
  void (*click) (Canvas *canvas, const CanvasPress *press);
  void (*double_click) (Canvas *canvas, const CanvasPress *press);
  /* Whether so many clicks in quick succession would add a site; NULL: never.
   */
  gboolean (*click_adds) (Canvas *canvas, const CanvasPress *press, int n);
  /* Returns: FALSE: nothing to drag here, so the view pans, or nothing moves
   *          when it has said why not and given up. */
  gboolean (*drag_begin) (Canvas *canvas, const CanvasPress *press);
  void (*drag) (Canvas *canvas, const double from_px[2], const double to_px[2]);
  void (*drag_end) (Canvas *canvas);
  /* What a drag shows over the picture, or NULL. */
  void (*draw_over) (Canvas *canvas, cairo_t *cr);
  /* Returns: the name of a CSS cursor for the pointer on @object. */
  const char *(*pointer) (Canvas *canvas, Object object, const double at_px[2]);
  /* Keys that no canvas knows; Returns: whether it was used. */
  gboolean (*key) (Canvas *canvas, const GdkEventKey *event);
  /* The objects that Tab and assistive technology walk through. */
  guint (*count_objects) (Canvas *canvas);
  Object (*get_object) (Canvas *canvas, guint index);
};

void canvas_set_session (Canvas *canvas, Session *session);
Session *canvas_get_session (Canvas *canvas);

/* Which of the two pictures it is: 0, the left one, unless said otherwise. */
void canvas_set_pane (Canvas *canvas, guint pane);
guint canvas_get_pane (Canvas *canvas);

/* Whether the session shows this kind of picture in this place. */
gboolean canvas_is_shown (Canvas *canvas);

/* Returns: the theme in the sizes that the session wants; good until the next
 *          call. */
const Theme *canvas_get_theme (Canvas *canvas);

/* Whether the picture is another thread's work, and shows what was before:
 * what it shows cannot be pointed at. Then "renewed" is emitted. */
gboolean canvas_is_busy (Canvas *canvas);

/* What the picture shows, for the legend; good until something changes. */
const LegendMarks *canvas_get_marks (Canvas *canvas);

/* The object that the keyboard is on, OBJECT_NONE when on the whole view. */
Object canvas_get_cursor (Canvas *canvas);
void canvas_set_cursor (Canvas *canvas, Object cursor);

/* Whether the keyboard focus is drawn. */
void canvas_show_focus (Canvas *canvas, gboolean shows);

/* Whether @event means something to the view as it is: then no accelerator
 * of the window may have it. */
gboolean canvas_wants_key (Canvas *canvas, const GdkEventKey *event);

#define LOCATE_MARGIN_PX 8

/* Where an object is drawn, with LOCATE_MARGIN_PX round it.
 *
 * Returns: FALSE when it is not shown. */
gboolean canvas_locate (Canvas *canvas, Object object, GdkRectangle *rectangle);

/* The places of the sites that make an object: one, two of a ridge, three of
 * a facet. Units: px.
 *
 * Returns: how many; 0 when it is not shown. */
guint canvas_outline (Canvas *canvas, Object object, Point3 points[3]);

Object canvas_pick (Canvas *canvas, const double at_px[2]);
Projection canvas_get_projection (Canvas *canvas);

/* Says in the window why sites cannot be changed, and what else is wrong:
 * signal "failed", with the sentence and whether it is the former. */
void canvas_fail (Canvas *canvas, const GError *error);
void canvas_fail_with (Canvas *canvas, const char *sentence);

/* For canvas-*.c and the views. */
void canvas_invalidate (Canvas *canvas);
void canvas_set_moving (Canvas *canvas, gboolean moving);
void canvas_tell_renewed (Canvas *canvas);

G_END_DECLS

#endif
