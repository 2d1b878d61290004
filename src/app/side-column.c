#include "side-column.h"

struct _SideColumn {
  GtkContainer parent_instance;
  GPtrArray *children; /* from above */
  double share;        /* of the height: what the lower one has in any case */
};

G_DEFINE_TYPE (SideColumn, side_column, GTK_TYPE_CONTAINER)

void
side_column_set_share (SideColumn *column, double share)
{
  if (share == column->share)
    return;
  column->share = share;
  gtk_widget_queue_resize (GTK_WIDGET (column));
}

/* Children */

static void
side_column_add (GtkContainer *container, GtkWidget *child)
{
  g_assert (HULL2VD_SIDE_COLUMN (container)->children->len < 2);
  g_ptr_array_add (HULL2VD_SIDE_COLUMN (container)->children, child);
  gtk_widget_set_parent (child, GTK_WIDGET (container));
}

static void
side_column_remove (GtkContainer *container, GtkWidget *child)
{
  if (g_ptr_array_remove (HULL2VD_SIDE_COLUMN (container)->children, child)) {
    gtk_widget_unparent (child);
    gtk_widget_queue_resize (GTK_WIDGET (container));
  }
}

static void
side_column_forall (GtkContainer *container,
                    gboolean include_internals,
                    GtkCallback callback,
                    gpointer user)
{
  g_autoptr (GPtrArray) children = g_ptr_array_copy (
      HULL2VD_SIDE_COLUMN (container)->children, NULL, NULL);

  (void)include_internals;
  for (guint i = 0; i < children->len; i++)
    callback (g_ptr_array_index (children, i), user);
}

static GType
side_column_child_type (GtkContainer *container)
{
  (void)container;
  return GTK_TYPE_WIDGET;
}

/* Sizes */

static GtkSizeRequestMode
side_column_get_request_mode (GtkWidget *widget)
{
  (void)widget;
  return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void
side_column_get_preferred_width (GtkWidget *widget, int *minimum, int *natural)
{
  SideColumn *column = HULL2VD_SIDE_COLUMN (widget);

  gtk_style_context_get (gtk_widget_get_style_context (widget),
                         gtk_widget_get_state_flags (widget), "min-width",
                         minimum, NULL);
  *natural = *minimum;
  for (guint i = 0; i < column->children->len; i++) {
    int least, wanted;

    gtk_widget_get_preferred_width (g_ptr_array_index (column->children, i),
                                    &least, &wanted);
    *minimum = MAX (*minimum, least);
    *natural = MAX (*natural, wanted);
  }
}

static void
side_column_get_preferred_height (GtkWidget *widget, int *minimum, int *natural)
{
  SideColumn *column = HULL2VD_SIDE_COLUMN (widget);

  *minimum = *natural = 0;
  for (guint i = 0; i < column->children->len; i++) {
    int least, wanted;

    gtk_widget_get_preferred_height (g_ptr_array_index (column->children, i),
                                     &least, &wanted);
    *minimum += least;
    *natural += wanted;
  }
}

/* Of the lower child; the upper one has the rest. */
static int
get_height (SideColumn *column, const GtkAllocation *all)
{
  GtkWidget *upper = g_ptr_array_index (column->children, 0);
  GtkWidget *lower = g_ptr_array_index (column->children, 1);
  int wanted, least, most;

  gtk_widget_get_preferred_height_for_width (upper, all->width, NULL, &wanted);
  gtk_widget_get_preferred_height_for_width (lower, all->width, &least, &most);
  least = MAX (least, MIN (most, (int)(column->share * all->height)));
  return CLAMP (all->height - wanted, least, MAX (least, most));
}

/* Each child is told its height once: what scrolls in it would lose its place
 * if it were larger for a moment. */
static void
side_column_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  GPtrArray *children = HULL2VD_SIDE_COLUMN (widget)->children;
  GtkWidget *upper = g_ptr_array_index (children, 0);
  GtkWidget *lower = g_ptr_array_index (children, 1);
  GtkAllocation above = *allocation, below = *allocation;

  gtk_widget_set_allocation (widget, allocation);
  if (gtk_widget_get_visible (upper) && gtk_widget_get_visible (lower)) {
    below.height = get_height (HULL2VD_SIDE_COLUMN (widget), allocation);
    above.height -= below.height;
    below.y += above.height;
  }
  if (gtk_widget_get_visible (upper))
    gtk_widget_size_allocate (upper, &above);
  if (gtk_widget_get_visible (lower))
    gtk_widget_size_allocate (lower, &below);
}

static gboolean
side_column_draw (GtkWidget *widget, cairo_t *cr)
{
  gtk_render_background (gtk_widget_get_style_context (widget), cr, 0, 0,
                         gtk_widget_get_allocated_width (widget),
                         gtk_widget_get_allocated_height (widget));
  return GTK_WIDGET_CLASS (side_column_parent_class)->draw (widget, cr);
}

/* Life */

static void
side_column_finalize (GObject *object)
{
  g_ptr_array_unref (HULL2VD_SIDE_COLUMN (object)->children);
  G_OBJECT_CLASS (side_column_parent_class)->finalize (object);
}

static void
side_column_class_init (SideColumnClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);
  GtkContainerClass *container_class = GTK_CONTAINER_CLASS (class);

  G_OBJECT_CLASS (class)->finalize = side_column_finalize;
  container_class->add = side_column_add;
  container_class->remove = side_column_remove;
  container_class->forall = side_column_forall;
  container_class->child_type = side_column_child_type;
  gtk_container_class_handle_border_width (container_class);
  widget_class->get_request_mode = side_column_get_request_mode;
  widget_class->get_preferred_width = side_column_get_preferred_width;
  widget_class->get_preferred_height = side_column_get_preferred_height;
  widget_class->size_allocate = side_column_size_allocate;
  widget_class->draw = side_column_draw;
  gtk_widget_class_set_accessible_role (widget_class, ATK_ROLE_FILLER);
}

static void
side_column_init (SideColumn *column)
{
  gtk_widget_set_has_window (GTK_WIDGET (column), FALSE);
  column->children = g_ptr_array_new ();
}
