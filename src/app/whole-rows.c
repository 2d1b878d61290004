#include "whole-rows.h"

static void
show_whole (GtkWidget *row, GtkWidget *view)
{
  GtkAdjustment *adjustment
      = gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view));
  const double page = gtk_adjustment_get_page_size (adjustment);
  const int height = gtk_widget_get_allocated_height (row);
  double top;
  int x, y;

  if (!gtk_widget_translate_coordinates (
          row, gtk_bin_get_child (GTK_BIN (view)), 0, 0, &x, &y))
    return;
  top = y - gtk_adjustment_get_value (adjustment);
  /* What no view can show whole is better cut than missing. */
  gtk_widget_set_opacity (
      row, height > page || (top >= 0 && top + height <= page) ? 1 : 0);
}

static void
update (GtkWidget *rows)
{
  GtkWidget *view = gtk_widget_get_ancestor (rows, GTK_TYPE_VIEWPORT);
  g_autoptr (GList) children
      = gtk_container_get_children (GTK_CONTAINER (rows));

  if (view == NULL || !gtk_widget_get_mapped (rows))
    return;
  for (GList *node = children; node != NULL; node = node->next)
    show_whole (node->data, view);
}

static void
on_allocated (GtkWidget *rows, GtkAllocation *allocation, gpointer user)
{
  (void)allocation;
  (void)user;
  update (rows);
}

static void
on_scrolled (GtkAdjustment *adjustment, GtkWidget *rows)
{
  GtkWidget *view = gtk_widget_get_ancestor (rows, GTK_TYPE_VIEWPORT);

  if (view != NULL
      && gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view)) == adjustment)
    update (rows);
}

/* What is never cut need not fade at the edges: for the style sheet. */
static void
set_class (GtkWidget *view, gboolean is_seen)
{
  GtkStyleContext *style
      = gtk_widget_get_style_context (gtk_widget_get_parent (view));

  if (is_seen)
    gtk_style_context_add_class (style, "whole-rows");
  else
    gtk_style_context_remove_class (style, "whole-rows");
}

static void
on_unmap (GtkWidget *rows, gpointer user)
{
  GtkWidget *view = gtk_widget_get_ancestor (rows, GTK_TYPE_VIEWPORT);

  (void)user;
  if (view != NULL)
    set_class (view, FALSE);
}

/* In each view that it comes to it listens once. */
static void
on_map (GtkWidget *rows, gpointer user)
{
  GtkWidget *view = gtk_widget_get_ancestor (rows, GTK_TYPE_VIEWPORT);
  GtkAdjustment *adjustment;

  (void)user;
  if (view == NULL)
    return;
  set_class (view, TRUE);
  adjustment = gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view));
  g_signal_handlers_disconnect_by_func (adjustment, on_scrolled, rows);
  g_signal_connect_object (adjustment, "value-changed",
                           G_CALLBACK (on_scrolled), rows, 0);
  g_signal_connect_object (adjustment, "changed", G_CALLBACK (on_scrolled),
                           rows, 0);
  update (rows);
}

void
whole_rows_keep (GtkContainer *rows)
{
  g_signal_connect_after (rows, "map", G_CALLBACK (on_map), NULL);
  g_signal_connect (rows, "unmap", G_CALLBACK (on_unmap), NULL);
  g_signal_connect (rows, "size-allocate", G_CALLBACK (on_allocated), NULL);
}
