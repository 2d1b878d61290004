#include "scroll-to.h"

typedef struct Goal {
  int margin;
  gboolean is_line;
  gboolean is_laid_out; /* what has changed has its place */
} Goal;

/* Scrolls past what is cut at the top of the view, of the list that @line is
 * in. */
static void
align (GtkWidget *line, GtkWidget *content, GtkAdjustment *adjustment)
{
  g_autoptr (GList) lines = gtk_container_get_children (
      GTK_CONTAINER (gtk_widget_get_parent (line)));
  const double top = gtk_adjustment_get_value (adjustment);

  for (GList *node = lines; node != NULL && node->data != line;
       node = node->next) {
    const int height = gtk_widget_get_allocated_height (node->data);
    int x, y;

    gtk_widget_translate_coordinates (node->data, content, 0, 0, &x, &y);
    if (y < top && y + height > top)
      gtk_adjustment_set_value (adjustment, y + height);
  }
}

static void
scroll (GtkWidget *widget, const Goal *goal)
{
  GtkWidget *view = gtk_widget_get_ancestor (widget, GTK_TYPE_VIEWPORT);
  GtkWidget *content;
  GtkAdjustment *adjustment;
  int x, y;

  if (view == NULL || !gtk_widget_get_mapped (widget))
    return;
  content = gtk_bin_get_child (GTK_BIN (view));
  if (!gtk_widget_translate_coordinates (widget, content, 0, 0, &x, &y))
    return;
  adjustment = gtk_scrollable_get_vadjustment (GTK_SCROLLABLE (view));
  gtk_adjustment_clamp_page (adjustment, y - goal->margin,
                             y + gtk_widget_get_allocated_height (widget)
                                 + goal->margin);
  if (goal->is_line)
    align (widget, content, adjustment);
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
  scroll (widget, goal);
  return G_SOURCE_REMOVE;
}

static void
queue (GtkWidget *widget, int margin, gboolean is_line)
{
  Goal *goal = g_new0 (Goal, 1);

  goal->margin = margin;
  goal->is_line = is_line;
  gtk_widget_add_tick_callback (widget, on_tick, goal, g_free);
}

void
scroll_to (GtkWidget *widget, int margin)
{
  queue (widget, margin, FALSE);
}

void
scroll_to_line (GtkWidget *line, int margin)
{
  queue (line, margin, TRUE);
}
