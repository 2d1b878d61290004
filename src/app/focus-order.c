#include "focus-order.h"

/* What GTK does itself is left out. */
static gboolean
answer (GtkWidget *widget, gboolean has_focus)
{
  g_signal_stop_emission_by_name (widget, "focus");
  return has_focus;
}

static gboolean
on_paned_focus (GtkWidget *widget, GtkDirectionType direction, gpointer user)
{
  GtkPaned *paned = GTK_PANED (widget);
  const gboolean goes_back = direction == GTK_DIR_TAB_BACKWARD;
  GtkWidget *first
      = goes_back ? gtk_paned_get_child2 (paned) : gtk_paned_get_child1 (paned);
  GtkWidget *second
      = goes_back ? gtk_paned_get_child1 (paned) : gtk_paned_get_child2 (paned);

  (void)user;
  if (direction != GTK_DIR_TAB_FORWARD && !goes_back)
    return FALSE;
  if (second != NULL
      && gtk_container_get_focus_child (GTK_CONTAINER (paned)) == second)
    first = NULL;
  return answer (
      widget,
      (first != NULL && gtk_widget_child_focus (first, direction))
          || (second != NULL && gtk_widget_child_focus (second, direction)));
}

void
focus_order_of_paned (GtkPaned *paned)
{
  g_signal_connect (paned, "focus", G_CALLBACK (on_paned_focus), NULL);
}

static gboolean
on_list_focus (GtkWidget *widget, GtkDirectionType direction, gpointer user)
{
  (void)direction;
  (void)user;
  return answer (widget, FALSE);
}

void
focus_order_pass_over (GtkListBox *list)
{
  g_signal_connect (list, "focus", G_CALLBACK (on_list_focus), NULL);
}
