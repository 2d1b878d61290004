#include "small-picture.h"

#include "session-picture.h"

#include <glib/gi18n.h>

#define MARGIN_PX 12 /* beside words that stand for a picture */

/* Marks and names are as large beside a picture of a third of the window's
 * size as they are in the window. */
#define SHRINK 1.6

struct _SmallPicture {
  GtkDrawingArea parent_instance;
  Session *session, *like;  /* NULL: nothing */
  guint stop;               /* or SMALL_PICTURE_NOW */
  cairo_surface_t *surface; /* what was painted, or NULL: it has changed */
};

G_DEFINE_TYPE (SmallPicture, small_picture, GTK_TYPE_DRAWING_AREA)

static gboolean
is_too_large (SmallPicture *picture)
{
  return session_get_set (picture->session)->n_sites > SMALL_PICTURE_MOST_SITES;
}

static char *
excuse_text (void)
{
  return g_strdup_printf (_ ("There is no small picture of more than %u sites: "
                             "look at the window of the class."),
                          SMALL_PICTURE_MOST_SITES);
}

/* Nobody wonders why there is no picture. */
static void
draw_excuse (GtkWidget *widget, cairo_t *cr)
{
  const int width = gtk_widget_get_allocated_width (widget) - 2 * MARGIN_PX;
  g_autofree char *text = excuse_text ();
  g_autoptr (PangoLayout) layout
      = gtk_widget_create_pango_layout (widget, text);
  int height;

  pango_layout_set_width (layout, MAX (width, 1) * PANGO_SCALE);
  pango_layout_set_wrap (layout, PANGO_WRAP_WORD_CHAR);
  pango_layout_set_alignment (layout, PANGO_ALIGN_CENTER);
  pango_layout_get_pixel_size (layout, NULL, &height);
  gtk_render_layout (
      gtk_widget_get_style_context (widget), cr, MARGIN_PX,
      MAX (0, gtk_widget_get_allocated_height (widget) - height) / 2.0, layout);
}

static void
tell_excuse (SmallPicture *picture)
{
  AtkObject *accessible = gtk_widget_get_accessible (GTK_WIDGET (picture));
  g_autofree char *text = picture->session != NULL && is_too_large (picture)
                              ? excuse_text ()
                              : g_strdup ("");

  atk_object_set_description (accessible, text);
}

static void
paint (SmallPicture *picture, cairo_t *cr, double width, double height)
{
  Picture what;
  Theme theme;

  if (picture->stop != SMALL_PICTURE_NOW)
    session_set_stop (picture->session, picture->stop);
  theme_init (&theme, session_get_appearance (picture->like));
  session_picture (&what, picture->session,
                   session_picture_view (picture->session));
  what.theme = &theme;
  what.width = width * SHRINK;
  what.height = height * SHRINK;
  cairo_scale (cr, 1 / SHRINK, 1 / SHRINK);
  picture_paint (&what, session_get_frame (picture->session), cr);
}

static void
forget (SmallPicture *picture)
{
  g_clear_pointer (&picture->surface, cairo_surface_destroy);
}

static gboolean
small_picture_draw (GtkWidget *widget, cairo_t *cr)
{
  SmallPicture *picture = HULL2VD_SMALL_PICTURE (widget);
  const int width = gtk_widget_get_allocated_width (widget);
  const int height = gtk_widget_get_allocated_height (widget);

  if (picture->session == NULL)
    return FALSE;
  if (is_too_large (picture)) {
    draw_excuse (widget, cr);
    return FALSE;
  }
  if (picture->surface == NULL) {
    cairo_t *own;

    picture->surface = gdk_window_create_similar_surface (
        gtk_widget_get_window (widget), CAIRO_CONTENT_COLOR, width, height);
    own = cairo_create (picture->surface);
    paint (picture, own, width, height);
    cairo_destroy (own);
  }
  cairo_set_source_surface (cr, picture->surface, 0, 0);
  cairo_paint (cr);
  return FALSE;
}

void
small_picture_changed (SmallPicture *picture)
{
  forget (picture);
  tell_excuse (picture);
  gtk_widget_queue_draw (GTK_WIDGET (picture));
}

void
small_picture_set_session (SmallPicture *picture,
                           Session *session,
                           guint stop,
                           Session *like)
{
  picture->stop = stop;
  g_set_object (&picture->session, session);
  g_set_object (&picture->like, like);
  small_picture_changed (picture);
}

static void
small_picture_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  forget (HULL2VD_SMALL_PICTURE (widget));
  GTK_WIDGET_CLASS (small_picture_parent_class)
      ->size_allocate (widget, allocation);
}

static void
small_picture_dispose (GObject *object)
{
  SmallPicture *picture = HULL2VD_SMALL_PICTURE (object);

  forget (picture);
  g_clear_object (&picture->session);
  g_clear_object (&picture->like);
  G_OBJECT_CLASS (small_picture_parent_class)->dispose (object);
}

static void
small_picture_class_init (SmallPictureClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = small_picture_dispose;
  widget_class->draw = small_picture_draw;
  widget_class->size_allocate = small_picture_size_allocate;
}

static void
small_picture_init (SmallPicture *picture)
{
  (void)picture;
}
