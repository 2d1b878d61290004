#include "window-private.h"

static void
set_title (Hull2vdWindow *window, guint pane, GtkLabel *label)
{
  g_autofree char *title = session_get_pane_title (window->session, pane);

  gtk_label_set_text (label, title);
}

/* A picture that the exhibit does not have is not missed. */
static void
show_panes (Hull2vdWindow *window)
{
  const gboolean has_second
      = session_get_pane (window->session, 1) != PANE_NONE;
  const Views views = session_get_views (window->session);

  gtk_widget_set_visible (window->space_box,
                          has_second && views != VIEWS_PLANE);
  gtk_widget_set_visible (window->plane_box,
                          !has_second || views != VIEWS_SPACE);
}

static void
update (Hull2vdWindow *window)
{
  set_title (window, 0, window->plane_title);
  set_title (window, 1, window->space_title);
  show_panes (window);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if (changes & (CHANGED_EXHIBIT | CHANGED_STAGING))
    update (window);
}

void
window_panes_init (Hull2vdWindow *window)
{
  legend_panel_add_view (window->legend_panel,
                         HULL2VD_CANVAS (window->plane_view));
  legend_panel_add_view (window->legend_panel,
                         HULL2VD_CANVAS (window->space_view));
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  update (window);
}
