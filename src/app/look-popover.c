#include "look-popover.h"

#include <glib/gi18n.h>

#define SLIDER_WIDTH 120 /* px; the pictures that it changes stay in view */

static double
get_lift (Session *session)
{
  return session_get_look (session)->lift;
}

static double
get_raise (Session *session)
{
  return session_get_look (session)->raise;
}

static double
get_paraboloid (Session *session)
{
  return 1 - session_get_look (session)->body_fade[BODY_PARABOLOID];
}

static void
set_paraboloid (Session *session, double opacity)
{
  session_set_body_opacity (session, BODY_PARABOLOID, opacity);
}

static double
get_hull (Session *session)
{
  return 1 - session_get_look (session)->body_fade[BODY_HULL];
}

static void
set_hull (Session *session, double opacity)
{
  session_set_body_opacity (session, BODY_HULL, opacity);
}

static double
get_plane (Session *session)
{
  return 1 - session_get_look (session)->body_fade[BODY_PLANE];
}

static void
set_plane (Session *session, double opacity)
{
  session_set_body_opacity (session, BODY_PLANE, opacity);
}

typedef struct SliderRow {
  const char *text;    /* with mnemonic, marked for translation */
  const char *tooltip; /* marked for translation */
  double most;
  double (*get) (Session *session);
  void (*set) (Session *session, double value);
} SliderRow;

static const SliderRow rows[] = {
  { N_ ("_Lift"), N_ ("Let the sites glide from the plane to the paraboloid"),
    1, get_lift, session_set_lift },
  { N_ ("_Height"), N_ ("Raise the paraboloid above the plane"), RAISE_MOST,
    get_raise, session_set_raise },
  { N_ ("_Paraboloid"), N_ ("How opaque the paraboloid is"), 1, get_paraboloid,
    set_paraboloid },
  { N_ ("H_ull"), N_ ("How opaque the hull is"), 1, get_hull, set_hull },
  { N_ ("Pla_ne"), N_ ("How opaque the plane is in space"), 1, get_plane,
    set_plane },
};

#define N_SLIDERS G_N_ELEMENTS (rows)

typedef struct Sliders {
  Session *session; /* borrowed: lives as long as the window */
  GtkRange *ranges[N_SLIDERS];
  gboolean is_updating;
} Sliders;

static void
update (Sliders *sliders)
{
  sliders->is_updating = TRUE;
  for (guint i = 0; i < N_SLIDERS; i++)
    gtk_range_set_value (sliders->ranges[i], rows[i].get (sliders->session));
  sliders->is_updating = FALSE;
}

static void
on_changed (Session *session, guint changes, GtkWidget *grid)
{
  (void)session;
  if (changes & CHANGED_LOOK)
    update (g_object_get_data (G_OBJECT (grid), "sliders"));
}

static void
on_value (GtkRange *range, Sliders *sliders)
{
  if (sliders->is_updating)
    return;
  for (guint i = 0; i < N_SLIDERS; i++)
    if (sliders->ranges[i] == range)
      rows[i].set (sliders->session, gtk_range_get_value (range));
}

static void
add_row (GtkGrid *grid, Sliders *sliders, guint i)
{
  GtkWidget *label = gtk_label_new_with_mnemonic (_ (rows[i].text));
  GtkWidget *scale = gtk_scale_new_with_range (GTK_ORIENTATION_HORIZONTAL, 0,
                                               rows[i].most, 0.05);

  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_label_set_mnemonic_widget (GTK_LABEL (label), scale);
  gtk_scale_set_draw_value (GTK_SCALE (scale), FALSE);
  gtk_widget_set_size_request (scale, SLIDER_WIDTH, -1);
  gtk_widget_set_tooltip_text (scale, _ (rows[i].tooltip));
  atk_object_set_name (gtk_widget_get_accessible (scale),
                       gtk_label_get_text (GTK_LABEL (label)));
  sliders->ranges[i] = GTK_RANGE (scale);
  g_signal_connect (scale, "value-changed", G_CALLBACK (on_value), sliders);
  gtk_grid_attach (grid, label, 0, (int)i, 1, 1);
  gtk_grid_attach (grid, scale, 1, (int)i, 1, 1);
}

static GtkWidget *
grid_new (Session *session)
{
  GtkWidget *grid = gtk_grid_new ();
  GtkWidget *reset = gtk_button_new_with_mnemonic (_ ("_Reset"));
  Sliders *sliders = g_new0 (Sliders, 1);

  sliders->session = session;
  g_object_set (grid, "margin", 6, "column-spacing", 6, NULL);
  gtk_style_context_add_class (gtk_widget_get_style_context (grid), "look");
  for (guint i = 0; i < N_SLIDERS; i++)
    add_row (GTK_GRID (grid), sliders, i);
  gtk_actionable_set_action_name (GTK_ACTIONABLE (reset), "win.reset-look");
  gtk_grid_attach (GTK_GRID (grid), reset, 1, (int)N_SLIDERS, 1, 1);
  gtk_widget_set_halign (reset, GTK_ALIGN_END);
  g_object_set_data_full (G_OBJECT (grid), "sliders", sliders, g_free);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), grid,
                           0);
  update (sliders);
  gtk_widget_show_all (grid);
  return grid;
}

static void
on_closed (GtkPopover *popover, GtkToggleButton *button)
{
  if (!gtk_widget_in_destruction (GTK_WIDGET (popover)))
    gtk_toggle_button_set_active (button, FALSE);
}

/* The sliders are made when they are wanted for the first time: what assistive
 * technology has never seen it does not ask for after its end. */
static void
on_toggled (GtkToggleButton *button, Session *session)
{
  GtkPopover *popover = g_object_get_data (G_OBJECT (button), "popover");

  if (!gtk_toggle_button_get_active (button)) {
    if (popover != NULL)
      gtk_popover_popdown (popover);
    return;
  }
  if (popover == NULL) {
    popover = GTK_POPOVER (gtk_popover_new (GTK_WIDGET (button)));
    gtk_container_add (GTK_CONTAINER (popover), grid_new (session));
    g_signal_connect_object (popover, "closed", G_CALLBACK (on_closed), button,
                             0);
    g_object_set_data (G_OBJECT (button), "popover", popover);
  }
  gtk_popover_popup (popover);
}

GtkWidget *
look_popover_button_new (Session *session)
{
  GtkWidget *button = gtk_toggle_button_new ();

  gtk_container_add (GTK_CONTAINER (button),
                     gtk_image_new_from_icon_name ("hull2vd-sliders-symbolic",
                                                   GTK_ICON_SIZE_BUTTON));
  gtk_widget_set_tooltip_text (button, _ ("Lift, height and transparency"));
  atk_object_set_name (gtk_widget_get_accessible (button),
                       _ ("Lift, height and transparency"));
  g_signal_connect_object (button, "toggled", G_CALLBACK (on_toggled), session,
                           0);
  gtk_widget_set_focus_on_click (button, FALSE);
  gtk_widget_set_valign (button, GTK_ALIGN_CENTER);
  gtk_style_context_add_class (gtk_widget_get_style_context (button), "flat");
  gtk_widget_show_all (button);
  return button;
}
