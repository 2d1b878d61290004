#include "coordinate-entry.h"

#include "number.h"
#include "site-edit.h"
#include "site-file.h"

#include <glib/gi18n.h>
#include <string.h>

struct _CoordinateEntry {
  GtkPopover parent_instance;
  Canvas *canvas; /* weak: NULL when it goes */
  gboolean moves; /* else it adds */
  guint site;     /* that it moves */
  GtkLabel *title, *fault;
  GtkEntry *entry;
};

G_DEFINE_TYPE (CoordinateEntry, coordinate_entry, GTK_TYPE_POPOVER)

static void
say_fault (CoordinateEntry *self, const char *reason)
{
  GtkStyleContext *style
      = gtk_widget_get_style_context (GTK_WIDGET (self->entry));
  AtkObject *accessible = gtk_widget_get_accessible (GTK_WIDGET (self->entry));

  gtk_label_set_text (self->fault, reason == NULL ? "" : reason);
  gtk_widget_set_visible (GTK_WIDGET (self->fault), reason != NULL);
  atk_object_set_description (accessible, reason == NULL ? "" : reason);
  if (reason == NULL)
    gtk_style_context_remove_class (style, "error");
  else
    gtk_style_context_add_class (style, "error");
}

static gboolean
put_site (CoordinateEntry *self, Site site, GError **error)
{
  Session *session = canvas_get_session (self->canvas);

  return self->moves ? session_move_site (session, self->site, site, error)
                     : session_add_site (session, site, error);
}

/* What was typed is seen, wherever it lies. */
static void
show_site (CoordinateEntry *self, guint site)
{
  GtkWidget *widget = GTK_WIDGET (self->canvas);
  const GdkRectangle view = { 0, 0, gtk_widget_get_allocated_width (widget),
                              gtk_widget_get_allocated_height (widget) };
  GdkRectangle place;
  PlaneCamera camera;

  if (!canvas_locate (self->canvas, (Object){ OBJECT_SITE, site }, &place)
      || gdk_rectangle_intersect (&place, &view, NULL))
    return;
  plane_camera_init (&camera);
  session_set_plane_camera (canvas_get_session (self->canvas), &camera);
}

static void
follow_edit (CoordinateEntry *self)
{
  Session *session = canvas_get_session (self->canvas);

  if (session_is_working (session, NULL))
    return;
  if (!self->moves)
    site_edit_go_to_last (self->canvas);
  show_site (self,
             self->moves ? self->site : session_get_set (session)->n_sites - 1);
}

static void
on_activate (GtkEntry *entry, CoordinateEntry *self)
{
  const char *text = gtk_entry_get_text (entry);
  g_autoptr (GError) error = NULL;
  const char *fault;
  Site site;

  if (text[strspn (text, " \t")] == '\0') {
    say_fault (self, _ ("type two numbers, such as 0.5 -1.25"));
    return;
  }
  fault = site_file_parse_line (text, strlen (text), &site);
  if (fault != NULL)
    fault = _ (fault);
  else if (!put_site (self, site, &error))
    fault = error->message;
  say_fault (self, fault);
  if (fault != NULL)
    return;
  gtk_entry_set_text (entry, "");
  follow_edit (self);
  if (self->moves)
    gtk_popover_popdown (GTK_POPOVER (self));
}

static void
on_changed (GtkEntry *entry, CoordinateEntry *self)
{
  (void)entry;
  say_fault (self, NULL);
}

/* The keyboard goes back to where it was needed. */
static void
on_closed (CoordinateEntry *self, gpointer user)
{
  (void)user;
  if (self->canvas != NULL)
    gtk_widget_grab_focus (GTK_WIDGET (self->canvas));
}

static void
open_at (CoordinateEntry *self, const GdkRectangle *place)
{
  gtk_popover_set_pointing_to (GTK_POPOVER (self), place);
  say_fault (self, NULL);
  gtk_popover_popup (GTK_POPOVER (self));
  gtk_widget_grab_focus (GTK_WIDGET (self->entry));
}

void
coordinate_entry_add (CoordinateEntry *self)
{
  GtkWidget *widget = GTK_WIDGET (self->canvas);
  const GdkRectangle place
      = { gtk_widget_get_allocated_width (widget) / 2,
          gtk_widget_get_allocated_height (widget) - 8, 1, 1 };

  self->moves = FALSE;
  gtk_label_set_text (self->title, _ ("New site: x y"));
  gtk_entry_set_text (self->entry, "");
  open_at (self, &place);
}

void
coordinate_entry_move (CoordinateEntry *self, guint site)
{
  Session *session = canvas_get_session (self->canvas);
  const Site given = site_set_given (session_get_set (session), site);
  GdkRectangle place = { 0, 0, 1, 1 };
  char x[NUMBER_ROOM], y[NUMBER_ROOM];
  g_autofree char *title = g_strdup_printf (_ ("Move s%u to: x y"), site);
  g_autofree char *text = NULL;

  number_write (given.x, x);
  number_write (given.y, y);
  text = g_strdup_printf ("%s %s", x, y);
  self->moves = TRUE;
  self->site = site;
  gtk_label_set_text (self->title, title);
  gtk_entry_set_text (self->entry, text);
  canvas_locate (self->canvas, (Object){ OBJECT_SITE, site }, &place);
  open_at (self, &place);
}

static void
coordinate_entry_dispose (GObject *object)
{
  g_clear_weak_pointer (&HULL2VD_COORDINATE_ENTRY (object)->canvas);
  G_OBJECT_CLASS (coordinate_entry_parent_class)->dispose (object);
}

static void
coordinate_entry_class_init (CoordinateEntryClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = coordinate_entry_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/coordinate-entry.ui");
  gtk_widget_class_bind_template_child (widget_class, CoordinateEntry, title);
  gtk_widget_class_bind_template_child (widget_class, CoordinateEntry, entry);
  gtk_widget_class_bind_template_child (widget_class, CoordinateEntry, fault);
}

static void
coordinate_entry_init (CoordinateEntry *self)
{
  gtk_widget_init_template (GTK_WIDGET (self));
  g_signal_connect (self->entry, "activate", G_CALLBACK (on_activate), self);
  g_signal_connect (self->entry, "changed", G_CALLBACK (on_changed), self);
  g_signal_connect (self, "closed", G_CALLBACK (on_closed), NULL);
}

CoordinateEntry *
coordinate_entry_new (PlaneView *view)
{
  CoordinateEntry *self
      = g_object_new (COORDINATE_ENTRY_TYPE, "relative-to", view, NULL);

  g_set_weak_pointer (&self->canvas, HULL2VD_CANVAS (view));
  return self;
}
