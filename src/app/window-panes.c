/* What the two pictures show. Each place holds a view of the plane and one of
 * space; below it, while two runs are compared, stands what its run does. */
#include "window-private.h"

#include <glib/gi18n.h>

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
  gtk_widget_set_visible (window->space_buttons,
                          session_get_pane (window->session, 1) == PANE_SPACE);
  /* Sentences call the two of an exhibit left and right in every language. */
  gtk_widget_set_direction (GTK_WIDGET (window->view_paned),
                            session_get_exhibit_kind (window->session)
                                    == EXHIBIT_LIFTS
                                ? GTK_TEXT_DIR_NONE
                                : GTK_TEXT_DIR_LTR);
}

/* Reports of runs */

static char *
cost_text (const InsertionCost *cost)
{
  char mean[G_ASCII_DTOSTR_BUF_SIZE], expected[G_ASCII_DTOSTR_BUF_SIZE];

  if (cost->n_cones == 0)
    return g_strdup_printf (_ ("created %u · seen %u · handed over %u"),
                            cost->facets_created, cost->facets_seen,
                            cost->redistributions);
  /* The same in every language, as in the pictures. */
  g_ascii_formatd (mean, sizeof mean, "%.2f",
                   (double)cost->cone_facets / cost->n_cones);
  g_ascii_formatd (expected, sizeof expected, "%.2f", cost->expected_cone);
  /* Translators: facets created and seen, sites handed over, and the mean size
     of a cone beside that in a random order. */
  return g_strdup_printf (
      _ ("created %u · seen %u · handed over %u · mean cone %s (random "
         "order: %s)"),
      cost->facets_created, cost->facets_seen, cost->redistributions, mean,
      expected);
}

static void
update_report (Hull2vdWindow *window, guint pane)
{
  Session *session = window->session;
  const gboolean compares
      = session_get_exhibit_kind (session) == EXHIBIT_COMPARE;
  InsertionCost cost;
  g_autofree char *sentence = NULL;
  g_autofree char *numbers = NULL;
  g_autofree char *text = NULL;

  gtk_widget_set_visible (GTK_WIDGET (window->reports[pane]), compares);
  if (!compares)
    return;
  cost = session_get_cost (session, pane);
  sentence = session_narrate_pane (session, pane);
  numbers = cost_text (&cost);
  text = g_strdup_printf ("%s\n%s", sentence, numbers);
  gtk_label_set_text (window->reports[pane], text);
}

static GtkLabel *
make_report (void)
{
  GtkWidget *label = gtk_label_new (NULL);

  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_label_set_yalign (GTK_LABEL (label), 0);
  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_style_context_add_class (gtk_widget_get_style_context (label), "report");
  return GTK_LABEL (label);
}

/* Views */

static void
update (Hull2vdWindow *window)
{
  set_title (window, 0, window->plane_title);
  set_title (window, 1, window->space_title);
  show_panes (window);
  for (guint i = 0; i < G_N_ELEMENTS (window->views); i++)
    gtk_widget_set_visible (GTK_WIDGET (window->views[i]),
                            canvas_is_shown (window->views[i]));
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if (changes & (CHANGED_EXHIBIT | CHANGED_SITES | CHANGED_STAGING))
    update (window);
  if (changes & (CHANGED_EXHIBIT | CHANGED_SITES | CHANGED_STEP))
    for (guint pane = 0; pane < N_PANES; pane++)
      update_report (window, pane);
}

static void
on_failed (Canvas *canvas,
           const char *message,
           gboolean is_refusal,
           Hull2vdWindow *window)
{
  (void)canvas;
  window_message_say (window, is_refusal ? "edit" : NULL, message);
}

/* A view of the other kind, in the place of @view. */
static Canvas *
make_other (Hull2vdWindow *window, Canvas *view, GType type)
{
  GtkWidget *overlay = gtk_widget_get_parent (GTK_WIDGET (view));
  Canvas *other = g_object_new (type, NULL);

  canvas_set_pane (other, canvas_get_pane (view));
  canvas_set_session (other, window->session);
  gtk_overlay_add_overlay (GTK_OVERLAY (overlay), GTK_WIDGET (other));
  return other;
}

static void
make_pane (Hull2vdWindow *window, guint pane, Canvas *view, GType other)
{
  GtkWidget *overlay = gtk_widget_get_parent (GTK_WIDGET (view));

  canvas_set_pane (view, pane);
  window->views[2 * pane] = view;
  window->views[2 * pane + 1] = make_other (window, view, other);
  window->reports[pane] = make_report ();
  gtk_container_add (GTK_CONTAINER (gtk_widget_get_parent (overlay)),
                     GTK_WIDGET (window->reports[pane]));
}

static void
add_view (Hull2vdWindow *window, Canvas *view)
{
  legend_panel_add_view (window->legend_panel, view);
  g_signal_connect (view, "failed", G_CALLBACK (on_failed), window);
}

void
window_panes_init (Hull2vdWindow *window)
{
  make_pane (window, 0, HULL2VD_CANVAS (window->plane_view), SPACE_VIEW_TYPE);
  make_pane (window, 1, HULL2VD_CANVAS (window->space_view), PLANE_VIEW_TYPE);
  for (guint i = 0; i < G_N_ELEMENTS (window->views); i++)
    add_view (window, window->views[i]);
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  update (window);
}
