#include "window-private.h"

#include <glib/gi18n.h>
#include <math.h>

static const char *const setting_names[N_PANELS]
    = { "show-lesson", "show-code", "show-counters", "show-legend" };

static const struct {
  const char *name, *title;
} tab_names[N_PANELS] = {
  [PANEL_CODE] = { "code", N_ ("Code") },
  [PANEL_COUNTERS] = { "counters", N_ ("Now") },
  [PANEL_LEGEND] = { "legend", N_ ("Legend") },
};

static GtkWidget *
get_panel (Hull2vdWindow *window, WindowPanel panel)
{
  switch (panel) {
  case PANEL_LESSON:
    return GTK_WIDGET (window->lesson_panel);
  case PANEL_CODE:
    return GTK_WIDGET (window->code_panel);
  case PANEL_COUNTERS:
    return GTK_WIDGET (window->counters_panel);
  case PANEL_LEGEND:
    return GTK_WIDGET (window->legend_panel);
  }
  return NULL;
}

gboolean
window_layout_shows (Hull2vdWindow *window, WindowPanel panel)
{
  return window->shows_panel[panel];
}

/* Columns without a panel are not there. */
static void
update_columns (Hull2vdWindow *window)
{
  const gboolean is_folded = columns_is_folded (window->columns);
  const gboolean *shows = window->shows_panel;
  const gboolean has_right
      = shows[PANEL_CODE] || shows[PANEL_COUNTERS] || shows[PANEL_LEGEND];

  for (WindowPanel panel = 0; panel < N_PANELS; panel++)
    gtk_widget_set_visible (get_panel (window, panel), shows[panel]);
  gtk_widget_set_visible (window->tabs, is_folded && has_right);
  gtk_widget_set_visible (window->right_column, !is_folded && has_right);
  gtk_widget_set_visible (window->left_column,
                          shows[PANEL_LESSON] || (is_folded && has_right));
}

void
window_layout_show (Hull2vdWindow *window, WindowPanel panel, gboolean on)
{
  window->shows_panel[panel] = on;
  if (window->settings != NULL)
    g_settings_set_boolean (window->settings, setting_names[panel], on);
  update_columns (window);
}

/* Puts a panel of the right column into tabs, or back. */
static void
move_panel (Hull2vdWindow *window, WindowPanel panel, gboolean to_tabs)
{
  GtkWidget *widget = g_object_ref (get_panel (window, panel));
  GtkWidget *parent = gtk_widget_get_parent (widget);

  gtk_container_remove (GTK_CONTAINER (parent), widget);
  if (to_tabs)
    gtk_stack_add_titled (window->stack, widget, tab_names[panel].name,
                          _ (tab_names[panel].title));
  else
    gtk_container_add (GTK_CONTAINER (window->right_box), widget);
  g_object_unref (widget);
}

static void
on_fold (Columns *columns, gboolean is_folded, Hull2vdWindow *window)
{
  GtkStyleContext *style = gtk_widget_get_style_context (GTK_WIDGET (window));

  (void)columns;
  for (WindowPanel panel = PANEL_CODE; panel < N_PANELS; panel++)
    move_panel (window, panel, is_folded);
  legend_panel_set_columns (window->legend_panel, is_folded ? 1 : 2);
  if (is_folded)
    gtk_style_context_add_class (style, "folded");
  else
    gtk_style_context_remove_class (style, "folded");
  update_columns (window);
}

static gboolean
has_halves (Hull2vdWindow *window)
{
  return !window_space_is_detached (window)
         && gtk_widget_get_visible (window->plane_box)
         && gtk_widget_get_visible (window->space_box);
}

/* Of both views, without the divider between them. */
static int
get_views_width (Hull2vdWindow *window)
{
  return has_halves (window)
             ? gtk_widget_get_allocated_width (window->plane_box)
                   + gtk_widget_get_allocated_width (window->space_box)
             : gtk_widget_get_allocated_width (GTK_WIDGET (window->view_paned));
}

#define HALF_REACH_PX 4

/* Halves that are not quite equal would show one picture twice in two sizes:
 * the divider stands in the middle where it is near.
 *
 * Returns: where the divider should be. */
static int
get_even_position (Hull2vdWindow *window)
{
  const int position = gtk_paned_get_position (window->view_paned);
  const int left = gtk_widget_get_allocated_width (window->plane_box);
  const int right = gtk_widget_get_allocated_width (window->space_box);
  int least, most;

  if (!has_halves (window) || abs (left - right) < 2
      || abs (left - right) > 2 * HALF_REACH_PX)
    return position;
  g_object_get (window->view_paned, "min-position", &least, "max-position",
                &most, NULL);
  return CLAMP ((left + right) / 2, least, MAX (least, most));
}

/* Not while sizes are being given. */
static gboolean
on_frame (GtkWidget *paned, GdkFrameClock *clock, gpointer user)
{
  Hull2vdWindow *window = user;

  (void)clock;
  gtk_paned_set_position (GTK_PANED (paned), get_even_position (window));
  return G_SOURCE_REMOVE;
}

/* The divider can be put in its place once there is a width to share. */
static void
on_views_allocated (GtkWidget *paned,
                    GtkAllocation *allocation,
                    Hull2vdWindow *window)
{
  const double share
      = window->settings != NULL
            ? g_settings_get_double (window->settings, "plane-share")
            : 0.5;

  if (window->is_placed
      && get_even_position (window)
             != gtk_paned_get_position (GTK_PANED (paned)))
    gtk_widget_add_tick_callback (paned, on_frame, window, NULL);
  if (window->is_placed || allocation->width < 2)
    return;
  window->is_placed = TRUE;
  gtk_paned_set_position (GTK_PANED (paned),
                          (int)lround (share * get_views_width (window)));
}

/* With a frame and a title bar round it, the window fits on the screen. */
#define FRAME_WIDTH 10
#define FRAME_HEIGHT 57

static void
set_size (Hull2vdWindow *window)
{
  GdkDisplay *display = gtk_widget_get_display (GTK_WIDGET (window));
  GdkMonitor *monitor = gdk_display_get_primary_monitor (display);
  GdkRectangle room = { 0, 0, G_MAXINT, G_MAXINT };
  int width = 1430;
  int height = 843;

  if (monitor == NULL)
    monitor = gdk_display_get_monitor (display, 0);
  if (monitor != NULL)
    gdk_monitor_get_workarea (monitor, &room);
  if (window->settings != NULL)
    g_settings_get (window->settings, "window-size", "(ii)", &width, &height);
  width = MIN (width, room.width - FRAME_WIDTH);
  height = MIN (height, room.height - FRAME_HEIGHT);
  gtk_window_set_default_size (GTK_WINDOW (window), width, height);
  if (width < COLUMNS_FOLD_PX)
    columns_fold (window->columns);
}

static void
restore (Hull2vdWindow *window)
{
  for (WindowPanel panel = 0; panel < N_PANELS; panel++)
    window->shows_panel[panel] = TRUE;
  set_size (window);
  if (window->settings == NULL)
    return;
  if (g_settings_get_boolean (window->settings, "maximized"))
    gtk_window_maximize (GTK_WINDOW (window));
  gtk_paned_set_position (
      window->lesson_paned,
      g_settings_get_int (window->settings, "lesson-width"));
  session_set_step_size (window->session, (StepSize)g_settings_get_enum (
                                              window->settings, "step-size"));
  hull2vd_window_set_paper_bindings (
      window, g_settings_get_boolean (window->settings, "paper-bindings"));
  session_set_snaps (window->session,
                     g_settings_get_boolean (window->settings, "snap"));
  for (WindowPanel panel = 0; panel < N_PANELS; panel++)
    window->shows_panel[panel]
        = g_settings_get_boolean (window->settings, setting_names[panel]);
}

void
window_layout_save (Hull2vdWindow *window)
{
  GtkWindow *gtk_window = GTK_WINDOW (window);
  const int views = get_views_width (window);
  int width, height;

  if (window->settings == NULL || views < 2)
    return;
  if (!gtk_window_is_maximized (gtk_window)) {
    gtk_window_get_size (gtk_window, &width, &height);
    g_settings_set (window->settings, "window-size", "(ii)", width, height);
  }
  g_settings_set_boolean (window->settings, "maximized",
                          gtk_window_is_maximized (gtk_window));
  g_settings_set_int (window->settings, "lesson-width",
                      MAX (250, gtk_paned_get_position (window->lesson_paned)));
  if (!window_space_is_detached (window))
    g_settings_set_double (
        window->settings, "plane-share",
        CLAMP (gtk_paned_get_position (window->view_paned) / (double)views,
               0.05, 0.95));
  g_settings_set_boolean (window->settings, "snap",
                          session_get_snaps (window->session));
  g_settings_set_enum (window->settings, "step-size",
                       (int)session_get_step_size (window->session));
}

/* Of the column's height: a question leaves less to what is looked up. */
#define TABS_SHARE 0.34
#define TABS_SHARE_ASKING 0.2

static void
share_column (Hull2vdWindow *window)
{
  side_column_set_share (HULL2VD_SIDE_COLUMN (window->left_column),
                         session_is_asking (window->session) ? TABS_SHARE_ASKING
                                                             : TABS_SHARE);
}

/* What a lesson asks to be read is not behind another tab. */
static void
show_listing (Hull2vdWindow *window, Listing listing)
{
  GtkWidget *code = GTK_WIDGET (window->code_panel);

  if (listing == window->listing)
    return;
  window->listing = listing;
  if (columns_is_folded (window->columns) && gtk_widget_get_visible (code))
    gtk_stack_set_visible_child (window->stack, code);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  if (changes & (CHANGED_QUESTION | CHANGED_LESSON | CHANGED_SITES))
    share_column (window);
  if (changes & (CHANGED_STAGING | CHANGED_LESSON))
    show_listing (window, session_get_listing (session));
}

static void
on_tab (GtkStack *stack, GParamSpec *property, GtkAdjustment *adjustment)
{
  (void)stack;
  (void)property;
  gtk_adjustment_set_value (adjustment, 0);
}

/* The tabs have another height for each stop, as much as its text leaves, and
 * lines another one in each theme. */
static void
follow_line (Hull2vdWindow *window)
{
  GtkWidget *scroll = gtk_widget_get_ancestor (GTK_WIDGET (window->stack),
                                               GTK_TYPE_SCROLLED_WINDOW);
  GtkAdjustment *adjustment
      = gtk_scrolled_window_get_vadjustment (GTK_SCROLLED_WINDOW (scroll));

  g_signal_connect_object (adjustment, "changed",
                           G_CALLBACK (code_panel_scroll), window->code_panel,
                           G_CONNECT_SWAPPED);
  /* What one tab is scrolled to means nothing in another. */
  g_signal_connect_object (window->stack, "notify::visible-child",
                           G_CALLBACK (on_tab), adjustment, 0);
}

/* From here on, letters may be as large as the pictures have become. */
#define WIDE_PX 1700

static gboolean
on_configure (GtkWidget *widget, GdkEventConfigure *event, gpointer user)
{
  GtkStyleContext *style = gtk_widget_get_style_context (widget);

  (void)user;
  if (event->width >= WIDE_PX)
    gtk_style_context_add_class (style, "wide");
  else
    gtk_style_context_remove_class (style, "wide");
  return GDK_EVENT_PROPAGATE;
}

void
window_layout_follow_width (GtkWidget *window)
{
  g_signal_connect (window, "configure-event", G_CALLBACK (on_configure), NULL);
}

void
window_layout_init (Hull2vdWindow *window)
{
  columns_set_folding (window->columns, window->right_column);
  g_signal_connect (window->columns, "fold", G_CALLBACK (on_fold), window);
  restore (window);
  update_columns (window);
  follow_line (window);
  share_column (window);
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  window_layout_follow_width (GTK_WIDGET (window));
  g_signal_connect (window->view_paned, "size-allocate",
                    G_CALLBACK (on_views_allocated), window);
}
