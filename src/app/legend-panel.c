#include "legend-panel.h"

#include <glib/gi18n.h>

#define SWATCH_WIDTH 30
#define NAME_CHARACTERS 14 /* to a line; longer ones have two */
#define SWATCH_HEIGHT 18

struct _LegendPanel {
  GtkBox parent_instance;
  Session *session;
  GPtrArray *views; /* of Canvas */
  GtkGrid *grid;
  GtkWidget *rows[N_ROLES];
  GtkWidget *names[N_ROLES];
  int n_shown;
  gboolean is_arranged; /* the rows that are shown */
  int n_columns;
};

G_DEFINE_TYPE (LegendPanel, legend_panel, GTK_TYPE_BOX)

/* Short, for two columns. NULL: speaks for itself. {p} is the current site,
 * f the facet selected. */
static const char *const role_texts[N_ROLES] = {
  [ROLE_SHEET] = N_ ("paraboloid"),
  [ROLE_FURTHEST_CELL] = N_ ("furthest cell"),
  [ROLE_TANGENT] = N_ ("tangent plane"),
  [ROLE_FACET] = N_ ("facet"),
  [ROLE_LOWER] = N_ ("lower facet"),
  [ROLE_UPPER] = N_ ("upper facet"),
  [ROLE_VERTICAL] = N_ ("vertical facet"),
  [ROLE_SIGN_LEFT] = N_ ("turns left"),
  [ROLE_SIGN_ZERO] = N_ ("in line"),
  [ROLE_SIGN_RIGHT] = N_ ("turns right"),
  [ROLE_HULL_AREA] = N_ ("inside the hull"),
  [ROLE_VISIBLE] = N_ ("{p} sees: lower"),
  [ROLE_VISIBLE_UPPER] = N_ ("{p} sees: upper"),
  [ROLE_RETIRED] = N_ ("retired"),
  [ROLE_CONE] = N_ ("cone: lower"),
  [ROLE_CONE_UPPER] = N_ ("cone: upper"),
  [ROLE_SELECTED_FACET] = N_ ("current facet f"),
  [ROLE_PREVIEW_TRIANGLE] = N_ ("would go"),
  [ROLE_PREVIEW_STOLEN] = N_ ("would be taken"),
  [ROLE_PLANE] = N_ ("plane of a facet"),
  [ROLE_CIRCLE] = N_ ("circumcircle"),
  [ROLE_CIRCLE_VISIBLE] = N_ ("contains {p}"),
  [ROLE_CIRCLE_UPPER] = N_ ("{p} is outside"),
  [ROLE_CIRCLE_SELECTED] = N_ ("selected circle"),
  [ROLE_ELLIPSE] = N_ ("ellipse over it"),
  [ROLE_VORONOI_EDGE] = N_ ("Voronoi edge"),
  [ROLE_DELAUNAY_EDGE] = N_ ("Delaunay edge"),
  [ROLE_TANGENT_EDGE] = N_ ("two planes meet"),
  [ROLE_FURTHEST_EDGE] = N_ ("furthest Delaunay"),
  [ROLE_FURTHEST_VORONOI] = N_ ("furthest Voronoi"),
  [ROLE_PREVIEW_EDGE] = N_ ("edge to be"),
  [ROLE_PREVIEW_CELL] = N_ ("cell to be"),
  [ROLE_CONTOUR] = N_ ("equal heights"),
  [ROLE_FREE_EDGE] = N_ ("free diagonal"),
  [ROLE_RIDGE] = N_ ("ridge"),
  [ROLE_VISIBLE_EDGE] = N_ ("edge will go"),
  [ROLE_CONE_EDGE] = N_ ("new edge"),
  [ROLE_SEEN_EDGE] = N_ ("{p} is beyond it"),
  [ROLE_LIT] = N_ ("selected"),
  [ROLE_HULL_EDGE] = N_ ("hull edge"),
  [ROLE_ROUNDED_EDGE] = N_ ("hull, rounded"),
  [ROLE_SIGN_NODE] = N_ ("current node"),
  [ROLE_EDGE_LINE] = N_ ("line of the edge"),
  [ROLE_HORIZON] = N_ ("horizon"),
  [ROLE_HORIZON_UPPER] = N_ ("horizon, upper"),
  [ROLE_LIFT] = N_ ("lift"),
  [ROLE_LIFT_APEX] = N_ ("lift of {p}"),
  [ROLE_LIFT_OUTSIDE] = N_ ("lift, outside set"),
  [ROLE_DROP] = N_ ("height above f"),
  [ROLE_GAP] = N_ ("power"),
  [ROLE_ANSWER_CHOSEN] = N_ ("your answer"),
  [ROLE_ANSWER_RIGHT] = N_ ("right"),
  [ROLE_ANSWER_WRONG] = N_ ("wrong"),
  [ROLE_ANSWER_MISSED] = N_ ("missed"),
  [ROLE_VORONOI_VERTEX] = N_ ("Voronoi vertex"),
  [ROLE_VORONOI_VERTEX_TIED] = N_ ("vertex of a tie"),
  [ROLE_VORONOI_VERTEX_DYING] = N_ ("vertex will go"),
  [ROLE_FURTHEST_VERTEX] = N_ ("furthest vertex"),
  [ROLE_PREVIEW_SITE] = N_ ("site to be"),
  [ROLE_FOOT] = N_ ("in the plane"),
  [ROLE_HORIZON_CORNER] = N_ ("horizon"),
  [ROLE_SITE] = N_ ("on the hull"),
  [ROLE_SITE_WAITING] = N_ ("waits"),
  [ROLE_SITE_OUTSIDE] = N_ ("outside set of f"),
  [ROLE_SITE_APEX] = N_ ("new site {p}"),
  [ROLE_SITE_DUPLICATE] = N_ ("duplicate"),
  [ROLE_SITE_LOST] = N_ ("lost by rounding"),
  [ROLE_SITE_IGNORED] = N_ ("inside, ignored"),
};

/* Of a hull in the plane, where they say something else. */
static const char *const planar_texts[N_ROLES] = {
  [ROLE_CONE] = N_ ("what it gains"),
  [ROLE_SELECTED_FACET] = N_ ("current edge e"),
  [ROLE_DROP] = N_ ("distance from e"),
  [ROLE_VISIBLE_EDGE] = N_ ("{p} sees it"),
  [ROLE_CONE_EDGE] = N_ ("cone"),
  [ROLE_SITE_OUTSIDE] = N_ ("outside set of e"),
};

/* What is not lower is upper, vertical, or some of either. */
static const char *
steep_text (Role role, const Frame *frame)
{
  const gboolean is_visible = role == ROLE_VISIBLE_UPPER;
  const guint roles = is_visible ? FACET_VISIBLE : FACET_CONE | FACET_NEW;
  gboolean has_upper = FALSE, has_vertical = FALSE;

  for (guint i = 0; i < frame->n_facets; i++) {
    const FrameFacet *row = &frame->facets[i];
    const Facing facing = frame->trace->facets[row->facet].facing;

    if ((row->roles & roles) == 0)
      continue;
    has_upper |= facing == FACING_UPPER;
    has_vertical |= facing == FACING_VERTICAL;
  }
  if (!has_vertical)
    return role_texts[role];
  if (is_visible)
    return has_upper ? N_ ("{p} sees: not lower") : N_ ("{p} sees: vertical");
  return has_upper ? N_ ("cone: not lower") : N_ ("cone: vertical");
}

/* Where no hull is drawn, a site is not said to be on it. */
static gboolean
has_hull (Session *session)
{
  return session_get_exhibit_kind (session) != EXHIBIT_LIFTS
         || (session_get_look (session)->layers & LAYER_HULL) != 0;
}

static const char *
template_of (Role role, Session *session)
{
  if (role == ROLE_VISIBLE_UPPER || role == ROLE_CONE_UPPER)
    return steep_text (role, session_get_frame (session));
  if (role == ROLE_SITE && !has_hull (session))
    return N_ ("site");
  return session_get_exhibit_kind (session) == EXHIBIT_PLANAR
                 && planar_texts[role] != NULL
             ? planar_texts[role]
             : role_texts[role];
}

static char *
text_of (Role role, Session *session)
{
  const guint apex = session_get_apex (session);
  g_autoptr (GString) text = g_string_new (_ (template_of (role, session)));
  g_autofree char *site = NULL;

  if (apex == INDEX_NONE)
    site = g_strdup ("p");
  else
    site = g_strdup_printf ("s%u", apex);
  g_string_replace (text, "{p}", site, 0);
  return g_string_free (g_steal_pointer (&text), FALSE);
}

/* Puts the rows that are shown one below the other, in columns. */
static void
arrange (LegendPanel *panel)
{
  const int n_rows = (panel->n_shown + panel->n_columns - 1) / panel->n_columns;
  int place = 0;

  for (Role role = 0; role < N_ROLES; role++) {
    if (panel->rows[role] == NULL
        || !gtk_widget_get_visible (panel->rows[role]))
      continue;
    gtk_container_child_set (GTK_CONTAINER (panel->grid), panel->rows[role],
                             "left-attach", place / n_rows, "top-attach",
                             place % n_rows, NULL);
    place++;
  }
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

static gboolean
is_in_view (LegendPanel *panel, Role role)
{
  for (guint i = 0; i < panel->views->len; i++) {
    Canvas *view = g_ptr_array_index (panel->views, i);

    if (is_picture_shown (view) && canvas_has_role (view, role))
      return TRUE;
  }
  return FALSE;
}

/* A facet stays selected where it is not on the hull yet, or no longer. */
static gboolean
is_selection_shown (Session *session)
{
  const Object selection = session_get_look (session)->selection;
  const Frame *frame = session_get_frame (session);

  if (selection.kind != OBJECT_FACET || frame->trace->is_flat
      || session_get_exhibit_kind (session) != EXHIBIT_LIFTS)
    return selection.kind != OBJECT_NONE;
  for (guint i = 0; i < frame->n_facets; i++)
    if (frame->facets[i].facet == selection.number)
      return TRUE;
  return FALSE;
}

/* What is selected is told of as long as it is to be seen; what the pointer is
 * over speaks for itself. */
static gboolean
is_told_of (LegendPanel *panel, Role role)
{
  const ObjectKind selected = session_get_look (panel->session)->selection.kind;

  if (role == ROLE_LIT)
    return is_selection_shown (panel->session);
  if (role == ROLE_CIRCLE_SELECTED
      && (selected == OBJECT_NONE || selected == OBJECT_SITE))
    return FALSE;
  return template_of (role, panel->session) != NULL && is_in_view (panel, role);
}

/* A selection is given up, not hidden. */
static gboolean
is_switch (Role role)
{
  return role != ROLE_LIT;
}

static void
update_row (LegendPanel *panel, Role role, const char *text)
{
  const SceneLook *look = session_get_look (panel->session);
  const gboolean is_on = look->role_fade[role] < 1;
  g_autofree char *tooltip = g_strdup_printf (
      is_on ? _ ("%s: click to hide it") : _ ("%s: hidden, click to show it"),
      text);
  g_autofree char *told = gtk_widget_get_tooltip_text (panel->rows[role]);

  gtk_label_set_text (GTK_LABEL (panel->names[role]), text);
  if (!is_switch (role) || g_strcmp0 (told, tooltip) == 0)
    return;
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (panel->rows[role]), is_on);
  gtk_widget_set_tooltip_text (panel->rows[role], tooltip);
  atk_object_set_name (gtk_widget_get_accessible (panel->rows[role]), text);
}

/* Rows move only when others come or go: to put them where they are would
 * lay out the panel each time that the pointer moves. */
static void
update (LegendPanel *panel)
{
  panel->n_shown = 0;
  for (Role role = 0; role < N_ROLES; role++) {
    g_autofree char *text = NULL;
    gboolean is_shown;

    if (panel->rows[role] == NULL)
      continue;
    is_shown = is_told_of (panel, role);
    if (is_shown != gtk_widget_get_visible (panel->rows[role]))
      panel->is_arranged = FALSE;
    gtk_widget_set_visible (panel->rows[role], is_shown);
    if (!is_shown)
      continue;
    panel->n_shown++;
    text = text_of (role, panel->session);
    update_row (panel, role, text);
  }
  if (!panel->is_arranged)
    arrange (panel);
}

void
legend_panel_set_columns (LegendPanel *panel, int n_columns)
{
  panel->n_columns = n_columns;
  arrange (panel);
}

static void
on_changed (Session *session, guint changes, LegendPanel *panel)
{
  (void)session;
  if (changes & (CHANGED_SITES | CHANGED_STEP | CHANGED_LOOK | CHANGED_STAGING))
    update (panel);
  if (changes & CHANGED_APPEARANCE)
    gtk_widget_queue_draw (GTK_WIDGET (panel));
}

/* A site that is selected has a ring, all else an outline. */
static Role
sample_of (LegendPanel *panel, Role role)
{
  const SceneLook *look = session_get_look (panel->session);

  return role == ROLE_LIT && look->selection.kind == OBJECT_SITE ? ROLE_SITE
                                                                 : role;
}

/* On the pictures' own background, whatever the desktop's theme is. */
static gboolean
on_draw_swatch (GtkWidget *widget, cairo_t *cr, gpointer user)
{
  LegendPanel *panel = HULL2VD_LEGEND_PANEL (
      gtk_widget_get_ancestor (widget, LEGEND_PANEL_TYPE));
  const Theme *theme = canvas_get_theme (g_ptr_array_index (panel->views, 0));
  const Role role = (Role)GPOINTER_TO_INT (user);
  const gboolean is_lit = role == ROLE_LIT || role == ROLE_CIRCLE_SELECTED;
  const Lit lit = is_lit ? LIT_SELECTED : LIT_NONE;
  const Colour ground = theme->background;

  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_paint (cr);
  painter_swatch (cr, sample_of (panel, role), lit, theme,
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
row_new (LegendPanel *panel, Role role)
{
  GtkWidget *row;

  if (!is_switch (role))
    return gtk_event_box_new ();
  row = gtk_toggle_button_new ();
  gtk_button_set_relief (GTK_BUTTON (row), GTK_RELIEF_NONE);
  gtk_widget_set_focus_on_click (row, FALSE);
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (row), TRUE);
  gtk_style_context_add_class (gtk_widget_get_style_context (row),
                               "legend-row");
  g_object_set_data (G_OBJECT (row), "role", GINT_TO_POINTER ((int)role));
  g_signal_connect (row, "toggled", G_CALLBACK (on_toggled), panel);
  return row;
}

static void
add_row (LegendPanel *panel, Role role)
{
  GtkWidget *row = row_new (panel, role);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 8);
  GtkWidget *swatch = gtk_drawing_area_new ();
  GtkWidget *name = gtk_label_new (NULL);

  gtk_widget_set_size_request (swatch, SWATCH_WIDTH, SWATCH_HEIGHT);
  gtk_widget_set_valign (swatch, GTK_ALIGN_CENTER);
  g_signal_connect (swatch, "draw", G_CALLBACK (on_draw_swatch),
                    GINT_TO_POINTER ((int)role));
  gtk_label_set_xalign (GTK_LABEL (name), 0);
  gtk_label_set_line_wrap (GTK_LABEL (name), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (name), NAME_CHARACTERS);
  gtk_widget_set_hexpand (name, TRUE);
  gtk_container_add (GTK_CONTAINER (box), swatch);
  gtk_container_add (GTK_CONTAINER (box), name);
  gtk_container_add (GTK_CONTAINER (row), box);
  gtk_widget_show_all (row);
  gtk_widget_hide (row);
  gtk_grid_attach (panel->grid, row, 0, (int)role, 1, 1);
  panel->rows[role] = row;
  panel->names[role] = name;
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
  gtk_widget_class_bind_template_child (widget_class, LegendPanel, grid);
}

static void
legend_panel_init (LegendPanel *panel)
{
  gtk_widget_init_template (GTK_WIDGET (panel));
  panel->n_columns = 2;
  panel->views = g_ptr_array_new_with_free_func (g_object_unref);
  for (Role role = 0; role < N_ROLES; role++)
    if (role_texts[role] != NULL || planar_texts[role] != NULL)
      add_row (panel, role);
}
