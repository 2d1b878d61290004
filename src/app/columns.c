#include "columns.h"

struct _Columns {
  GtkBox parent_instance;
  GtkWidget *folding; /* the child that gives way; borrowed */
  gboolean is_folded;
  guint fold_source;
};

G_DEFINE_TYPE (Columns, columns, GTK_TYPE_BOX)

enum { SIGNAL_FOLD, N_SIGNALS };
static guint signals[N_SIGNALS];

gboolean
columns_is_folded (Columns *columns)
{
  return columns->is_folded;
}

void
columns_set_folding (Columns *columns, GtkWidget *child)
{
  columns->folding = child;
}

static gboolean
on_fold_due (gpointer user)
{
  Columns *columns = user;

  columns->fold_source = 0;
  g_signal_emit (columns, signals[SIGNAL_FOLD], 0, columns->is_folded);
  return G_SOURCE_REMOVE;
}

void
columns_fold (Columns *columns)
{
  columns->is_folded = TRUE;
  g_signal_emit (columns, signals[SIGNAL_FOLD], 0, TRUE);
}

/* Children must not come and go while sizes are being given. */
static void
set_folded (Columns *columns, gboolean folded)
{
  if (columns->is_folded == folded)
    return;
  columns->is_folded = folded;
  if (columns->fold_source == 0)
    columns->fold_source
        = g_idle_add_full (G_PRIORITY_HIGH_IDLE, on_fold_due, columns, NULL);
}

static void
columns_get_preferred_width (GtkWidget *widget, int *minimum, int *natural)
{
  Columns *columns = HULL2VD_COLUMNS (widget);
  int width = 0;

  GTK_WIDGET_CLASS (columns_parent_class)
      ->get_preferred_width (widget, minimum, natural);
  if (columns->folding != NULL && gtk_widget_get_visible (columns->folding))
    gtk_widget_get_preferred_width (columns->folding, &width, NULL);
  *minimum -= width;
}

static void
columns_get_preferred_width_for_height (GtkWidget *widget,
                                        int height,
                                        int *minimum,
                                        int *natural)
{
  (void)height;
  columns_get_preferred_width (widget, minimum, natural);
}

static void
columns_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  Columns *columns = HULL2VD_COLUMNS (widget);
  GtkAllocation wide = *allocation;
  int minimum;

  /* For one frame before folding, the last child may stick out. */
  GTK_WIDGET_CLASS (columns_parent_class)
      ->get_preferred_width (widget, &minimum, NULL);
  wide.width = MAX (wide.width, minimum);
  GTK_WIDGET_CLASS (columns_parent_class)->size_allocate (widget, &wide);
  set_folded (columns, allocation->width < COLUMNS_FOLD_PX);
}

static void
columns_dispose (GObject *object)
{
  Columns *columns = HULL2VD_COLUMNS (object);

  if (columns->fold_source != 0)
    g_source_remove (columns->fold_source);
  columns->fold_source = 0;
  columns->folding = NULL;
  G_OBJECT_CLASS (columns_parent_class)->dispose (object);
}

static void
columns_class_init (ColumnsClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = columns_dispose;
  widget_class->get_preferred_width = columns_get_preferred_width;
  widget_class->get_preferred_width_for_height
      = columns_get_preferred_width_for_height;
  widget_class->size_allocate = columns_size_allocate;
  signals[SIGNAL_FOLD]
      = g_signal_new ("fold", COLUMNS_TYPE, G_SIGNAL_RUN_LAST, 0, NULL, NULL,
                      NULL, G_TYPE_NONE, 1, G_TYPE_BOOLEAN);
}

static void
columns_init (Columns *columns)
{
  (void)columns;
}
