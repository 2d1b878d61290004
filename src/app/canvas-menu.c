#include "canvas-menu.h"

#include "canvas-name.h"
#include "site-edit.h"

#include <glib/gi18n.h>

static void
append (GMenu *menu, const char *text, const char *action)
{
  g_menu_append (menu, text, action);
}

/* What can be done with the selection. */
static void
add_object (GMenu *menu, Canvas *canvas, Object object)
{
  g_autoptr (GMenu) section = g_menu_new ();
  g_autofree char *title = NULL;
  guint n_selected;

  if (object.kind == OBJECT_NONE)
    return;
  session_get_selected_sites (canvas_get_session (canvas), &n_selected);
  if (object.kind == OBJECT_SITE && n_selected > 1)
    title = g_strdup_printf (ngettext ("%u site", "%u sites", n_selected),
                             n_selected);
  else
    title = canvas_name_object (canvas_get_session (canvas), object);
  if (object.kind == OBJECT_SITE && n_selected <= 1)
    append (section, _ ("_Coordinates…"), "win.move-site-to");
  if (object.kind == OBJECT_SITE)
    append (section, _ ("_Delete"), "win.delete-selection");
  append (section, _ ("Select _Nothing"), "win.select-none");
  g_menu_append_section (menu, title, G_MENU_MODEL (section));
}

/* What can be done at this point of the plane. */
static void
add_point (GMenu *menu, Canvas *canvas, const double at_px[2])
{
  const Projection projection = canvas_get_projection (canvas);
  const Point3 point = projection_unapply (&projection, at_px[0], at_px[1]);
  const Site site = site_edit_at (canvas_get_session (canvas), point);
  g_autoptr (GMenu) section = g_menu_new ();
  g_autoptr (GMenuItem) item = g_menu_item_new (_ ("Add Site _Here"), NULL);

  g_menu_item_set_action_and_target (item, "win.add-site", "(dd)", site.x,
                                     site.y);
  g_menu_append_item (section, item);
  append (section, _ ("Add Site _at Coordinates…"), "win.add-site-at");
  append (section, _ ("_Generate Sites…"), "win.generate");
  g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
}

static void
add_all (GMenu *menu)
{
  g_autoptr (GMenu) section = g_menu_new ();

  append (section, _ ("Select A_ll"), "win.select-all");
  append (section, _ ("C_opy Sites"), "win.copy");
  append (section, _ ("_Paste Sites"), "win.paste");
  append (section, _ ("_Snap to Grid"), "win.snap");
  g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
}

static void
add_space (GMenu *menu)
{
  g_autoptr (GMenu) section = g_menu_new ();

  append (section, _ ("_Home"), "win.camera-home");
  append (section, _ ("Look _Up"), "win.camera-look-up");
  append (section, _ ("Look _Down"), "win.camera-look-down");
  append (section, _ ("From the S_ide"), "win.camera-side");
  append (section, _ ("In a Separate _Window"), "win.detach-space");
  g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
}

static void
drop_menu (gpointer menu)
{
  gtk_widget_destroy (menu);
  g_object_unref (menu);
}

static GtkWidget *
make_menu (Canvas *canvas, Object object, const double at_px[2])
{
  g_autoptr (GMenu) model = g_menu_new ();
  GtkWidget *menu;

  add_object (model, canvas, object);
  if (HULL2VD_CANVAS_GET_CLASS (canvas)->is_space)
    add_space (model);
  else {
    add_point (model, canvas, at_px);
    add_all (model);
  }
  menu = gtk_menu_new_from_model (G_MENU_MODEL (model));
  gtk_menu_attach_to_widget (GTK_MENU (menu), GTK_WIDGET (canvas), NULL);
  /* The one before has done its work. */
  g_object_set_data_full (G_OBJECT (canvas), "menu", g_object_ref (menu),
                          drop_menu);
  return menu;
}

static void
select_for_menu (Canvas *canvas, Object object)
{
  Session *session = canvas_get_session (canvas);

  if (object.kind == OBJECT_SITE
      && session_is_selected (session, object.number))
    return;
  if (object.kind == OBJECT_SITE)
    canvas_set_cursor (canvas, object);
  session_set_selection (session, object);
}

/* A menu asks what made it pop up: a clock (a long press) and assistive
 * technology are no events.
 *
 * Returns: (transfer full): what does for one. */
static GdkEvent *
make_trigger (GtkWidget *widget)
{
  GdkSeat *seat
      = gdk_display_get_default_seat (gtk_widget_get_display (widget));
  GdkEvent *event = gtk_get_current_event ();

  if (event != NULL)
    return event;
  event = gdk_event_new (GDK_BUTTON_PRESS);
  event->button.window = g_object_ref (gtk_widget_get_window (widget));
  event->button.time = GDK_CURRENT_TIME;
  gdk_event_set_device (event, gdk_seat_get_pointer (seat));
  return event;
}

void
canvas_menu_popup (Canvas *canvas, Object object, const double at_px[2])
{
  const GdkRectangle place = { (int)at_px[0], (int)at_px[1], 1, 1 };
  g_autoptr (GdkEvent) trigger = make_trigger (GTK_WIDGET (canvas));
  GtkWidget *menu;

  /* What it offers edits the sites that a question is about. */
  if (session_is_asking (canvas_get_session (canvas)))
    return;
  select_for_menu (canvas, object);
  menu = make_menu (canvas, object, at_px);
  gtk_menu_popup_at_rect (
      GTK_MENU (menu), gtk_widget_get_window (GTK_WIDGET (canvas)), &place,
      GDK_GRAVITY_SOUTH_EAST, GDK_GRAVITY_NORTH_WEST, trigger);
}

void
canvas_menu_popup_at_cursor (Canvas *canvas)
{
  GtkWidget *widget = GTK_WIDGET (canvas);
  const Object cursor = canvas_get_cursor (canvas);
  double at_px[2] = { gtk_widget_get_allocated_width (widget) / 2.0,
                      gtk_widget_get_allocated_height (widget) / 2.0 };
  GdkRectangle box;

  if (canvas_locate (canvas, cursor, &box)) {
    at_px[0] = box.x + box.width / 2.0;
    at_px[1] = box.y + box.height / 2.0;
  }
  canvas_menu_popup (canvas, cursor, at_px);
}
