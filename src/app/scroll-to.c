#include "scroll-to.h"

typedef struct Goal {
  GtkWidget *widget;
  int margin;
} Goal;

static void
goal_free (gpointer user)
{
  Goal *goal = user;

  g_object_unref (goal->widget);
  g_free (goal);
}

static gboolean
on_idle (gpointer user)
{
  const Goal *goal = user;
  GtkWidget *view = gtk_widget_get_ancestor (goal->widget, GTK_TYPE_VIEWPORT);
  int x, y;

  if (view == NULL || !gtk_widget_get_mapped (goal->widget)
      || !gtk_widget_translate_coordinates (
          goal->widget, gtk_bin_get_child (GTK_BIN (view)), 0, 0, &x, &y))
    return G_SOURCE_REMOVE;
  gtk_adjustment_clamp_page (
      gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view)), y - goal->margin,
      y + gtk_widget_get_allocated_height (goal->widget) + goal->margin);
  return G_SOURCE_REMOVE;
}

void
scroll_to (GtkWidget *widget, int margin)
{
  Goal *goal = g_new (Goal, 1);

  *goal = (Goal){ g_object_ref (widget), margin };
  g_idle_add_full (G_PRIORITY_DEFAULT_IDLE, on_idle, goal, goal_free);
}
