#include "legend-panel.h"

#include "legend.h"

#include <glib/gi18n.h>

#define SWATCH_WIDTH 30
#define NAME_CHARACTERS 14 /* to a line; longer ones have two */
#define SWATCH_HEIGHT 18

struct _LegendPanel {
  GtkBox parent_instance;
  Session *session;
  GPtrArray *views;  /* of Canvas */
  GtkGrid *grids[2]; /* what is there without the pointer; what it brings */
  GPtrArray *rows;   /* of LegendRow, that are shown */
  GtkWidget *boxes[N_LEGEND_MARKS];
  GtkWidget *swatches[N_LEGEND_MARKS], *names[N_LEGEND_MARKS];
  SceneItem samples[N_LEGEND_MARKS];
  gboolean is_arranged; /* the boxes that are shown */
  int n_columns;
};

G_DEFINE_TYPE (LegendPanel, legend_panel, GTK_TYPE_BOX)

/* Rows */

static guint
count_rows (LegendPanel *panel, gboolean is_of_pointer)
{
  guint n = 0;

  for (guint i = 0; i < panel->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (panel->rows, i);

    n += row->is_of_pointer == is_of_pointer;
  }
  return n;
}

/* Puts the rows of a grid one below the other, in columns. */
static void
arrange_grid (LegendPanel *panel, gboolean is_of_pointer)
{
  const guint n_columns = (guint)panel->n_columns;
  const guint n = count_rows (panel, is_of_pointer);
  const guint height = (n + n_columns - 1) / n_columns;
  guint place = 0;

  for (guint i = 0; i < panel->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (panel->rows, i);

    if (row->is_of_pointer != is_of_pointer)
      continue;
    gtk_container_child_set (GTK_CONTAINER (panel->grids[is_of_pointer]),
                             panel->boxes[row->mark], "left-attach",
                             (int)(place / height), "top-attach",
                             (int)(place % height), NULL);
    place++;
  }
  gtk_widget_set_visible (GTK_WIDGET (panel->grids[is_of_pointer]), n > 0);
}

static void
arrange (LegendPanel *panel)
{
  for (gboolean is_of_pointer = FALSE; is_of_pointer <= TRUE; is_of_pointer++)
    arrange_grid (panel, is_of_pointer);
  panel->is_arranged = TRUE;
}

/* Whether a lesson or a person shows the picture at all. */
static gboolean
is_picture_shown (Canvas *view)
{
  GtkWidget *widget = GTK_WIDGET (view);

  for (; widget != NULL && !gtk_widget_is_toplevel (widget);
       widget = gtk_widget_get_parent (widget))
    if (!gtk_widget_get_visible (widget))
      return FALSE;
  return canvas_is_shown (view);
}

static void
take_rows (LegendPanel *panel)
{
  const Theme *theme = canvas_get_theme (g_ptr_array_index (panel->views, 0));
  LegendMarks marks = { 0 };

  for (guint i = 0; i < panel->views->len; i++) {
    Canvas *view = g_ptr_array_index (panel->views, i);

    if (is_picture_shown (view))
      legend_marks_merge (&marks, canvas_get_marks (view));
  }
  g_ptr_array_unref (panel->rows);
  panel->rows = legend_rows (panel->session, &marks, theme);
}

static gboolean
is_same_sample (const SceneItem *a, const SceneItem *b)
{
  return a->role == b->role && a->shape == b->shape
         && a->emphasis == b->emphasis && a->lit == b->lit && a->hue == b->hue;
}

static void
update_row (LegendPanel *panel, const LegendRow *row)
{
  const SceneLook *look = session_get_look (panel->session);
  const int mark = row->mark;
  GtkWidget *box = panel->boxes[mark];
  g_autofree char *tooltip = NULL, *told = NULL;
  gboolean is_on;

  gtk_label_set_text (GTK_LABEL (panel->names[mark]), row->text);
  if (!is_same_sample (&panel->samples[mark], &row->sample))
    gtk_widget_queue_draw (panel->swatches[mark]);
  panel->samples[mark] = row->sample;
  if (!legend_mark_is_switch (mark))
    return;
  is_on = look->role_fade[mark] < 1;
  tooltip = g_strdup_printf (is_on ? _ ("%s: click to hide it")
                                   : _ ("%s: hidden, click to show it"),
                             row->text);
  told = gtk_widget_get_tooltip_text (box);
  if (g_strcmp0 (told, tooltip) == 0)
    return;
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (box), is_on);
  gtk_widget_set_tooltip_text (box, tooltip);
  atk_object_set_name (gtk_widget_get_accessible (box), row->text);
}

/* Rows move only when others come or go: to put them where they are would
 * lay out the panel each time that the pointer moves. */
static void
update (LegendPanel *panel)
{
  gboolean is_shown[N_LEGEND_MARKS] = { FALSE };

  if (panel->views->len == 0)
    return;
  take_rows (panel);
  for (guint i = 0; i < panel->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (panel->rows, i);

    is_shown[row->mark] = TRUE;
    update_row (panel, row);
  }
  for (int mark = 0; mark < N_LEGEND_MARKS; mark++) {
    if (panel->boxes[mark] == NULL)
      continue;
    if (is_shown[mark] != gtk_widget_get_visible (panel->boxes[mark]))
      panel->is_arranged = FALSE;
    gtk_widget_set_visible (panel->boxes[mark], is_shown[mark]);
  }
  if (!panel->is_arranged)
    arrange (panel);
}

void
legend_panel_set_columns (LegendPanel *panel, int n_columns)
{
  panel->n_columns = n_columns;
  /* Who points cannot scroll: where there is little room this comes first. */
  gtk_box_reorder_child (GTK_BOX (panel), GTK_WIDGET (panel->grids[1]),
                         n_columns == 1 ? 1 : -1);
  arrange (panel);
}

static void
on_changed (Session *session, guint changes, LegendPanel *panel)
{
  (void)session;
  if (changes & (CHANGED_SITES | CHANGED_STEP | CHANGED_LOOK | CHANGED_STAGING))
    update (panel);
  if (changes & CHANGED_APPEARANCE) {
    update (panel);
    gtk_widget_queue_draw (GTK_WIDGET (panel));
  }
}

/* On the pictures' own background, whatever the desktop's theme is. */
static gboolean
on_draw_swatch (GtkWidget *widget, cairo_t *cr, gpointer user)
{
  LegendPanel *panel = HULL2VD_LEGEND_PANEL (
      gtk_widget_get_ancestor (widget, LEGEND_PANEL_TYPE));
  const Theme *theme = canvas_get_theme (g_ptr_array_index (panel->views, 0));
  const int mark = GPOINTER_TO_INT (user);
  const Colour ground = theme->background;

  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_paint (cr);
  painter_swatch (cr, &panel->samples[mark], theme,
                  gtk_widget_get_allocated_width (widget),
                  gtk_widget_get_allocated_height (widget));
  return TRUE;
}

/* A row is a switch: what it names can be hidden in both pictures. */
static void
on_toggled (GtkToggleButton *row, LegendPanel *panel)
{
  const Role role
      = (Role)GPOINTER_TO_INT (g_object_get_data (G_OBJECT (row), "role"));
  Session *session = panel->session;
  const gboolean is_on = gtk_toggle_button_get_active (row);

  /* A role that is half transparent is not made opaque by being told of. */
  if (is_on != (session_get_look (session)->role_fade[role] < 1))
    session_set_role_opacity (session, role, is_on ? 1 : 0);
}

static GtkWidget *
box_new (LegendPanel *panel, int mark)
{
  GtkWidget *box;

  if (!legend_mark_is_switch (mark))
    return gtk_event_box_new ();
  box = gtk_toggle_button_new ();
  gtk_button_set_relief (GTK_BUTTON (box), GTK_RELIEF_NONE);
  gtk_widget_set_focus_on_click (box, FALSE);
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (box), TRUE);
  gtk_style_context_add_class (gtk_widget_get_style_context (box),
                               "legend-row");
  g_object_set_data (G_OBJECT (box), "role", GINT_TO_POINTER (mark));
  g_signal_connect (box, "toggled", G_CALLBACK (on_toggled), panel);
  return box;
}

static void
add_box (LegendPanel *panel, int mark)
{
  GtkWidget *box = box_new (panel, mark);
  GtkWidget *parts = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 8);
  GtkWidget *swatch = gtk_drawing_area_new ();
  GtkWidget *name = gtk_label_new (NULL);

  gtk_widget_set_size_request (swatch, SWATCH_WIDTH, SWATCH_HEIGHT);
  gtk_widget_set_valign (swatch, GTK_ALIGN_CENTER);
  g_signal_connect (swatch, "draw", G_CALLBACK (on_draw_swatch),
                    GINT_TO_POINTER (mark));
  gtk_label_set_xalign (GTK_LABEL (name), 0);
  gtk_label_set_line_wrap (GTK_LABEL (name), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (name), NAME_CHARACTERS);
  gtk_widget_set_hexpand (name, TRUE);
  gtk_container_add (GTK_CONTAINER (parts), swatch);
  gtk_container_add (GTK_CONTAINER (parts), name);
  gtk_container_add (GTK_CONTAINER (box), parts);
  gtk_widget_show_all (box);
  gtk_widget_hide (box);
  gtk_grid_attach (panel->grids[legend_mark_is_of_pointer (mark)], box, 0, mark,
                   1, 1);
  panel->boxes[mark] = box;
  panel->swatches[mark] = swatch;
  panel->names[mark] = name;
}

void
legend_panel_set_session (LegendPanel *panel, Session *session)
{
  g_assert (panel->session == NULL);
  panel->session = g_object_ref (session);
  /* After the views, whose scenes are read. */
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), panel,
                           G_CONNECT_AFTER);
}

void
legend_panel_add_view (LegendPanel *panel, Canvas *view)
{
  g_ptr_array_add (panel->views, g_object_ref (view));
  g_signal_connect_object (view, "renewed", G_CALLBACK (update), panel,
                           G_CONNECT_SWAPPED);
  update (panel);
}

static void
legend_panel_dispose (GObject *object)
{
  LegendPanel *panel = HULL2VD_LEGEND_PANEL (object);

  g_clear_pointer (&panel->views, g_ptr_array_unref);
  g_clear_pointer (&panel->rows, g_ptr_array_unref);
  g_clear_object (&panel->session);
  G_OBJECT_CLASS (legend_panel_parent_class)->dispose (object);
}

static void
legend_panel_class_init (LegendPanelClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = legend_panel_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/legend-panel.ui");
  gtk_widget_class_bind_template_child_full (
      widget_class, "grid", FALSE, G_STRUCT_OFFSET (LegendPanel, grids[0]));
  gtk_widget_class_bind_template_child_full (
      widget_class, "pointer_grid", FALSE,
      G_STRUCT_OFFSET (LegendPanel, grids[1]));
}

static void
legend_panel_init (LegendPanel *panel)
{
  gtk_widget_init_template (GTK_WIDGET (panel));
  panel->n_columns = 2;
  panel->views = g_ptr_array_new_with_free_func (g_object_unref);
  panel->rows = g_ptr_array_new ();
  for (int mark = 0; mark < N_LEGEND_MARKS; mark++)
    if (legend_mark_has_words (mark))
      add_box (panel, mark);
}
