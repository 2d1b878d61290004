#include "code-panel.h"

#include "direction.h"
#include "focus-order.h"
#include "pseudocode.h"
#include "scroll-to.h"
#include "whole-rows.h"

#include <glib/gi18n.h>
#include <string.h>

#define ARROW " ← "
#define INDENT_PX 16
#define ROW_PX 22 /* about one line is seen above and below the current one */

struct _CodePanel {
  GtkBox parent_instance;
  Session *session;
  GtkLabel *title;
  GtkListBox *lines;
  const PseudocodeLine *shown; /* the listing */
  gboolean is_masked;          /* its loop would answer the question */
  guint current;               /* line, or INDEX_NONE */
};

G_DEFINE_TYPE (CodePanel, code_panel, GTK_TYPE_BOX)

static void
mark (CodePanel *panel, guint line, gboolean is_current)
{
  GtkListBoxRow *row = gtk_list_box_get_row_at_index (panel->lines, (int)line);
  GtkWidget *widget = GTK_WIDGET (row);
  AtkObject *accessible;

  if (row == NULL)
    return;
  if (is_current)
    gtk_style_context_add_class (gtk_widget_get_style_context (widget),
                                 "current");
  else
    gtk_style_context_remove_class (gtk_widget_get_style_context (widget),
                                    "current");
  accessible = gtk_widget_get_accessible (widget);
  atk_object_set_description (accessible, is_current ? _ ("current line") : "");
}

/* What the rest of a line hangs behind where it takes several rows, so that
 * none of them looks like a line of its own.
 *
 * Returns: how many bytes are its number, "7: ", what it sets, "V ← ", or else
 *          its first word. */
static gsize
marker_length (const char *text)
{
  const char *arrow = g_utf8_next_char (text);
  const char *space = strchr (text, ' ');

  if (g_str_has_prefix (arrow, ARROW))
    return (gsize)(arrow - text) + strlen (ARROW);
  return space != NULL ? (gsize)(space - text) + 1 : 0;
}

static void
add_part (GtkBox *box, const char *text)
{
  GtkWidget *label = gtk_label_new (text);

  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_widget_set_valign (label, GTK_ALIGN_START);
  gtk_box_pack_start (box, label, FALSE, FALSE, 0);
}

/* Whoever is asked for the order of the phases could copy it. */
static gboolean
would_answer (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);

  return session_is_asking (session) && exercise != NULL
         && exercise->question->kind == QUESTION_ORDER
         && exercise->question->order == ORDER_OF_PHASES;
}

static void
add_line (CodePanel *panel, const PseudocodeLine *line)
{
  const char *text
      = panel->is_masked && line->indent > 0 ? "?" : _ (line->text);
  g_autofree char *marker = g_strndup (text, marker_length (text));
  GtkWidget *row = gtk_list_box_row_new ();
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 0);

  if (*marker != '\0')
    add_part (GTK_BOX (box), marker);
  add_part (GTK_BOX (box), text + strlen (marker));
  gtk_widget_set_valign (box, GTK_ALIGN_CENTER);
  gtk_container_add (GTK_CONTAINER (row), box);
  atk_object_set_name (gtk_widget_get_accessible (row), text);
  /* Which side the start is on is asked when it is set. */
  direction_keep (row);
  gtk_widget_set_margin_start (box, INDENT_PX * line->indent);
  gtk_list_box_row_set_activatable (GTK_LIST_BOX_ROW (row), FALSE);
  gtk_widget_set_can_focus (row, FALSE);
  gtk_widget_show_all (row);
  gtk_container_add (GTK_CONTAINER (panel->lines), row);
}

/* Where no line is the current one, the listing begins at its top. */
void
code_panel_scroll (CodePanel *panel)
{
  const int line = panel->current == INDEX_NONE ? 0 : (int)panel->current;
  GtkListBoxRow *row = gtk_list_box_get_row_at_index (panel->lines, line);

  if (row != NULL)
    scroll_to_line (GTK_WIDGET (row), ROW_PX);
}

/* The listing of what is shown. */
static void
show_listing (CodePanel *panel)
{
  guint n_lines;
  const PseudocodeLine *lines = session_get_lines (panel->session, &n_lines);
  const gboolean is_masked = would_answer (panel->session);

  if (lines == panel->shown && is_masked == panel->is_masked)
    return;
  panel->is_masked = is_masked;
  while (gtk_list_box_get_row_at_index (panel->lines, 0) != NULL)
    gtk_widget_destroy (
        GTK_WIDGET (gtk_list_box_get_row_at_index (panel->lines, 0)));
  for (guint i = 0; i < n_lines; i++)
    add_line (panel, &lines[i]);
  gtk_label_set_text (panel->title,
                      _ (session_get_listing_title (panel->session)));
  panel->shown = lines;
  panel->current = INDEX_NONE;
}

static void
update (CodePanel *panel)
{
  const guint line = session_is_asking (panel->session)
                         ? INDEX_NONE
                         : session_get_line (panel->session);

  show_listing (panel);
  if (line == panel->current)
    return;
  mark (panel, panel->current, FALSE);
  mark (panel, line, TRUE);
  panel->current = line;
  code_panel_scroll (panel);
}

static void
on_changed (Session *session, guint changes, CodePanel *panel)
{
  (void)session;
  if (changes
      & (CHANGED_SITES | CHANGED_STEP | CHANGED_STAGING | CHANGED_LESSON
         | CHANGED_QUESTION))
    update (panel);
}

void
code_panel_set_session (CodePanel *panel, Session *session)
{
  g_assert (panel->session == NULL);
  panel->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), panel,
                           0);
  update (panel);
}

static void
code_panel_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_CODE_PANEL (object)->session);
  G_OBJECT_CLASS (code_panel_parent_class)->dispose (object);
}

static void
code_panel_class_init (CodePanelClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = code_panel_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/code-panel.ui");
  gtk_widget_class_bind_template_child (widget_class, CodePanel, title);
  gtk_widget_class_bind_template_child (widget_class, CodePanel, lines);
}

static void
code_panel_init (CodePanel *panel)
{
  panel->current = INDEX_NONE;
  gtk_widget_init_template (GTK_WIDGET (panel));
  focus_order_pass_over (panel->lines);
  whole_rows_keep (GTK_CONTAINER (panel->lines));
}
