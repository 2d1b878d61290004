#include "scroll-to.h"

typedef struct Goal {
  int margin;
  gboolean is_laid_out; /* what has changed has its place */
} Goal;

static void
scroll (GtkWidget *widget, int margin)
{
  GtkWidget *view = gtk_widget_get_ancestor (widget, GTK_TYPE_VIEWPORT);
  int x, y;

  if (view == NULL || !gtk_widget_get_mapped (widget)
      || !gtk_widget_translate_coordinates (
          widget, gtk_bin_get_child (GTK_BIN (view)), 0, 0, &x, &y))
    return;
  gtk_adjustment_clamp_page (
      gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view)), y - margin,
      y + gtk_widget_get_allocated_height (widget) + margin);
}

/* A frame begins with its ticks and lays out after them. */
static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer user)
{
  Goal *goal = user;

  (void)clock;
  if (!goal->is_laid_out) {
    goal->is_laid_out = TRUE;
    return G_SOURCE_CONTINUE;
  }
  scroll (widget, goal->margin);
  return G_SOURCE_REMOVE;
}

void
scroll_to (GtkWidget *widget, int margin)
{
  Goal *goal = g_new0 (Goal, 1);

  goal->margin = margin;
  gtk_widget_add_tick_callback (widget, on_tick, goal, g_free);
}
