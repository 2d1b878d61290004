#include "legend.h"

#include <glib/gi18n.h>

#define MEANING_BREAK "; "

/* Short, for two columns. NULL: speaks for itself. {p} is the current site,
 * f the facet selected. */
static const char *const mark_texts[N_LEGEND_MARKS] = {
  [ROLE_SHEET] = N_ ("paraboloid"),
  [ROLE_CELL] = N_ ("Voronoi cell"),
  [LEGEND_NEW_CELL] = N_ ("cell of {p}"),
  [LEGEND_OTHER_NEW_CELL] = N_ ("cell of {p}"),
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
  [LEGEND_SELECTED_VERTEX] = N_ ("selected vertex"),
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
  [ROLE_VISIBLE_EDGE] = N_ ("{p} sees: edge"),
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
  [ROLE_DROP] = N_ ("distance from f"),
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
  [LEGEND_POINTED] = N_ ("pointed at"),
  [LEGEND_POINTED_VERTEX] = N_ ("its Voronoi vertex"),
  [LEGEND_POINTED_CELL] = N_ ("its cell"),
  [LEGEND_POINTED_LIFT] = N_ ("its lift"),
  [LEGEND_SELECTED_CELL] = N_ ("selected cell"),
  [LEGEND_SELECTED_LIFT] = N_ ("selected lift"),
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
steep_text (int role, const Frame *frame)
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
    return mark_texts[role];
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
template_of (int mark, Session *session)
{
  if (mark == ROLE_VISIBLE_UPPER || mark == ROLE_CONE_UPPER)
    return steep_text (mark, session_get_frame (session));
  if (mark == ROLE_SITE && !has_hull (session))
    return N_ ("site");
  return mark < N_ROLES && session_get_exhibit_kind (session) == EXHIBIT_PLANAR
                 && planar_texts[mark] != NULL
             ? planar_texts[mark]
             : mark_texts[mark];
}

/* {p}; two runs side by side have one each, of which only cells differ. */
static guint
apex_of (int mark, Session *session)
{
  if (mark == LEGEND_NEW_CELL)
    return session_get_pane_apex (session, 0);
  if (mark == LEGEND_OTHER_NEW_CELL)
    return session_get_pane_apex (session, 1);
  return session_get_apex (session);
}

static char *
text_of (int mark, Session *session, guint apex)
{
  g_autoptr (GString) text = g_string_new (_ (template_of (mark, session)));
  g_autofree char *site = NULL;

  if (apex == INDEX_NONE)
    site = g_strdup ("p");
  else
    site = g_strdup_printf ("s%u", apex);
  g_string_replace (text, "{p}", site, 0);
  return g_string_free (g_steal_pointer (&text), FALSE);
}

/* What the pointer brings comes last: it comes and goes, and what is there
 * without it stays where it is. */
gboolean
legend_mark_is_of_pointer (int mark)
{
  switch (mark) {
  case LEGEND_POINTED:
  case LEGEND_POINTED_VERTEX:
  case LEGEND_POINTED_CELL:
  case LEGEND_POINTED_LIFT:
  case ROLE_PREVIEW_TRIANGLE:
  case ROLE_PREVIEW_STOLEN:
  case ROLE_PREVIEW_EDGE:
  case ROLE_PREVIEW_CELL:
  case ROLE_PREVIEW_SITE:
    return TRUE;
  default:
    return FALSE;
  }
}

/* A theme without hues has no cells, only what bounds them. */
static gboolean
is_seen (int mark, const Theme *theme)
{
  const gboolean is_cell = mark == ROLE_CELL || mark == LEGEND_NEW_CELL
                           || mark == LEGEND_OTHER_NEW_CELL
                           || mark == ROLE_FURTHEST_CELL;

  return !is_cell || theme->cell_chroma > 0;
}

static ObjectKind
kind_of (int mark, const SceneLook *look)
{
  return mark == LEGEND_POINTED ? look->hover.kind : look->selection.kind;
}

static LegendRow *
row_new (Session *session, const LegendMarks *marks, int mark, guint apex)
{
  LegendRow *row = g_new0 (LegendRow, 1);

  row->mark = mark;
  row->sample = legend_mark_sample (marks, mark,
                                    kind_of (mark, session_get_look (session)));
  row->text = text_of (mark, session, apex);
  row->is_of_pointer = legend_mark_is_of_pointer (mark);
  return row;
}

static void
free_row (LegendRow *row)
{
  g_free (row->text);
  g_free (row);
}

/* The order of rows that are no role: after which one they stand. */
static int
role_before (int mark)
{
  switch (mark) {
  case LEGEND_NEW_CELL:
  case LEGEND_OTHER_NEW_CELL:
    return ROLE_CELL;
  case LEGEND_SELECTED_VERTEX:
    return ROLE_CIRCLE_SELECTED;
  case LEGEND_SELECTED_CELL:
  case LEGEND_SELECTED_LIFT:
    return ROLE_LIT;
  default:
    return mark;
  }
}

static int
compare_rows (gconstpointer left, gconstpointer right)
{
  const LegendRow *a = *(const LegendRow *const *)left;
  const LegendRow *b = *(const LegendRow *const *)right;

  if (a->is_of_pointer != b->is_of_pointer)
    return a->is_of_pointer - b->is_of_pointer;
  if (role_before (a->mark) != role_before (b->mark))
    return role_before (a->mark) - role_before (b->mark);
  return a->mark - b->mark;
}

static gboolean
is_told_of (const LegendMarks *marks, int mark, const Theme *theme)
{
  return marks->shapes[mark] != 0 && mark_texts[mark] != NULL
         && is_seen (mark, theme);
}

GPtrArray *
legend_rows (Session *session, const LegendMarks *marks, const Theme *theme)
{
  GPtrArray *rows = legend_new ();

  for (int mark = 0; mark < N_LEGEND_MARKS; mark++)
    if (is_told_of (marks, mark, theme))
      g_ptr_array_add (rows,
                       row_new (session, marks, mark, apex_of (mark, session)));
  g_ptr_array_sort (rows, compare_rows);
  return rows;
}

/* Of many moments */

GPtrArray *
legend_new (void)
{
  return g_ptr_array_new_with_free_func ((GDestroyNotify)free_row);
}

static LegendRow *
find_row (const GPtrArray *rows, int mark)
{
  for (guint i = 0; i < rows->len; i++) {
    LegendRow *row = g_ptr_array_index (rows, i);

    if (row->mark == mark)
      return row;
  }
  return NULL;
}

/* Adds what a mark means here, where it has meant something else before. */
static void
add_meaning (LegendRow *row, const char *text)
{
  g_auto (GStrv) known = g_strsplit (row->text, MEANING_BREAK, -1);
  char *both;

  if (g_strv_contains ((const char *const *)known, text))
    return;
  both = g_strconcat (row->text, MEANING_BREAK, text, NULL);
  g_free (row->text);
  row->text = both;
}

/* What is pale at one moment may not be so at another. */
static void
add_strength (LegendRow *row, const LegendMarks *marks)
{
  if (row->sample.emphasis == EMPHASIS_PALE && marks->is_strong[row->mark])
    row->sample.emphasis = EMPHASIS_NORMAL;
}

/* Nobody has answered on paper, and missed nothing. */
static char *
general_text (int mark, Session *session)
{
  return mark == ROLE_ANSWER_MISSED ? g_strdup (_ ("the answer"))
                                    : text_of (mark, session, INDEX_NONE);
}

void
legend_gather (GPtrArray *rows,
               Session *session,
               const LegendMarks *marks,
               const Theme *theme)
{
  for (int mark = 0; mark < N_LEGEND_MARKS; mark++) {
    LegendRow *row = find_row (rows, mark);
    g_autofree char *text = NULL;

    if (mark == LEGEND_OTHER_NEW_CELL || !is_told_of (marks, mark, theme))
      continue;
    text = general_text (mark, session);
    if (row != NULL) {
      add_meaning (row, text);
      add_strength (row, marks);
      continue;
    }
    row = row_new (session, marks, mark, INDEX_NONE);
    g_free (row->text);
    row->text = g_steal_pointer (&text);
    g_ptr_array_add (rows, row);
  }
  g_ptr_array_sort (rows, compare_rows);
}

gboolean
legend_mark_is_switch (int mark)
{
  return mark < N_ROLES && mark != ROLE_LIT && mark_texts[mark] != NULL;
}

gboolean
legend_mark_has_words (int mark)
{
  return mark_texts[mark] != NULL;
}
