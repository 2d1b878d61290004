#include "counters-panel.h"

#include "direction.h"
#include "laws.h"

struct _CountersPanel {
  GtkBox parent_instance;
  Session *session;
  GtkGrid *grid;
  GPtrArray *names, *values; /* labels, one of each a row */
};

G_DEFINE_TYPE (CountersPanel, counters_panel, GTK_TYPE_BOX)

static GtkWidget *
add_label (CountersPanel *panel, int column, const char *class)
{
  GtkWidget *label = gtk_label_new (NULL);

  gtk_label_set_xalign (GTK_LABEL (label), column == 0 ? 0 : 1);
  gtk_widget_set_hexpand (label, column == 1);
  /* Values are formulas. */
  if (column == 1)
    direction_keep (label);
  gtk_style_context_add_class (gtk_widget_get_style_context (label), class);
  gtk_grid_attach (panel->grid, label, column, (int)panel->values->len, 1, 1);
  return label;
}

static void
ensure_rows (CountersPanel *panel, guint n_rows)
{
  while (panel->values->len < n_rows) {
    g_ptr_array_add (panel->names, add_label (panel, 0, "name"));
    g_ptr_array_add (panel->values, add_label (panel, 1, "figures"));
  }
}

/* Labels are reused: while stepping, rows change but do not jump. */
static void
update (CountersPanel *panel)
{
  g_autoptr (GPtrArray) laws = session_get_laws (panel->session);

  if (session_is_asking (panel->session))
    laws_hide (laws);
  ensure_rows (panel, laws->len);
  for (guint i = 0; i < panel->values->len; i++) {
    GtkWidget *name = g_ptr_array_index (panel->names, i);
    GtkWidget *value = g_ptr_array_index (panel->values, i);
    const Law *law = i < laws->len ? g_ptr_array_index (laws, i) : NULL;

    gtk_widget_set_visible (name, law != NULL);
    gtk_widget_set_visible (value, law != NULL);
    if (law == NULL)
      continue;
    gtk_label_set_text (GTK_LABEL (name), law->name);
    gtk_label_set_text (GTK_LABEL (value), law->value);
  }
}

static void
on_changed (Session *session, guint changes, CountersPanel *panel)
{
  (void)session;
  if (changes
      & (CHANGED_SITES | CHANGED_STEP | CHANGED_LESSON | CHANGED_QUESTION))
    update (panel);
}

void
counters_panel_set_session (CountersPanel *panel, Session *session)
{
  g_assert (panel->session == NULL);
  panel->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), panel,
                           0);
  update (panel);
}

static void
counters_panel_dispose (GObject *object)
{
  CountersPanel *panel = HULL2VD_COUNTERS_PANEL (object);

  g_clear_pointer (&panel->names, g_ptr_array_unref);
  g_clear_pointer (&panel->values, g_ptr_array_unref);
  g_clear_object (&panel->session);
  G_OBJECT_CLASS (counters_panel_parent_class)->dispose (object);
}

static void
counters_panel_class_init (CountersPanelClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = counters_panel_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/counters-panel.ui");
  gtk_widget_class_bind_template_child (widget_class, CountersPanel, grid);
}

static void
counters_panel_init (CountersPanel *panel)
{
  panel->names = g_ptr_array_new ();
  panel->values = g_ptr_array_new ();
  gtk_widget_init_template (GTK_WIDGET (panel));
}
