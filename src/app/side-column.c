#include "side-column.h"

struct _SideColumn {
  GtkBox parent_instance;
};

G_DEFINE_TYPE (SideColumn, side_column, GTK_TYPE_BOX)

/* Gives @last so much of both heights as it needs, after @first. */
static void
share (GtkWidget *first, GtkWidget *last)
{
  GtkAllocation upper, lower;
  int wanted, least, most, height;

  gtk_widget_get_allocation (first, &upper);
  gtk_widget_get_allocation (last, &lower);
  height = upper.height + lower.height;
  gtk_widget_get_preferred_height_for_width (first, upper.width, NULL, &wanted);
  gtk_widget_get_preferred_height_for_width (last, lower.width, &least, &most);
  lower.height = CLAMP (height - wanted, least, MAX (least, most));
  upper.height = height - lower.height;
  lower.y = upper.y + upper.height;
  gtk_widget_size_allocate (first, &upper);
  gtk_widget_size_allocate (last, &lower);
}

static void
side_column_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  g_autoptr (GList) children
      = gtk_container_get_children (GTK_CONTAINER (widget));
  GtkWidget *first = children->data;
  GtkWidget *last = g_list_last (children)->data;

  GTK_WIDGET_CLASS (side_column_parent_class)
      ->size_allocate (widget, allocation);
  if (first != last && gtk_widget_get_visible (first)
      && gtk_widget_get_visible (last))
    share (first, last);
}

static void
side_column_class_init (SideColumnClass *class)
{
  GTK_WIDGET_CLASS (class)->size_allocate = side_column_size_allocate;
}

static void
side_column_init (SideColumn *column)
{
  (void)column;
}
