#include "hull2vd-window.h"

#include "focus-order.h"
#include "lesson-list.h"
#include "settings.h"
#include "site-readout.h"
#include "space-note.h"
#include "tooltips.h"
#include "window-private.h"

#include <glib/gi18n.h>

G_DEFINE_TYPE (Hull2vdWindow, hull2vd_window, GTK_TYPE_APPLICATION_WINDOW)

Session *
hull2vd_window_get_session (Hull2vdWindow *window)
{
  return window->session;
}

/* Title */

static char *
lesson_subtitle (Hull2vdWindow *window, const Lesson *lesson)
{
  const guint number = lesson_list_number (lesson->path);
  const guint stop = session_get_stop (window->session) + 1;

  if (number == 0)
    return g_strdup_printf (_ ("Stop %u of %u"), stop, lesson->stops->len);
  return g_strdup_printf (_ ("Lesson %u · stop %u of %u"), number, stop,
                          lesson->stops->len);
}

static char *
sites_subtitle (Hull2vdWindow *window)
{
  const guint n_sites = session_get_set (window->session)->n_sites;

  return g_strdup_printf (ngettext ("%u site", "%u sites", n_sites), n_sites);
}

static char *
sites_title (Hull2vdWindow *window)
{
  if (window->path == NULL)
    return g_strdup (_ ("New sites"));
  return g_filename_display_basename (window->path);
}

/* Names of files differ at their ends as often as at their beginnings. */
static void
ellipsize_in_the_middle (GtkWidget *widget, gpointer user)
{
  if (GTK_IS_BOX (widget))
    gtk_container_forall (GTK_CONTAINER (widget), ellipsize_in_the_middle,
                          user);
  if (GTK_IS_LABEL (widget))
    gtk_label_set_ellipsize (GTK_LABEL (widget), PANGO_ELLIPSIZE_MIDDLE);
}

void
hull2vd_window_update_title (Hull2vdWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);
  g_autofree char *title
      = lesson != NULL ? g_strdup (lesson->title) : sites_title (window);
  g_autofree char *subtitle = lesson != NULL ? lesson_subtitle (window, lesson)
                                             : sites_subtitle (window);
  g_autofree char *whole = g_strdup_printf ("%s – Hull2VD", title);

  gtk_window_set_title (GTK_WINDOW (window), whole);
  /* After the window's, which the bar would take over. */
  gtk_header_bar_set_title (window->header_bar, title);
  gtk_header_bar_set_subtitle (window->header_bar, subtitle);
  gtk_container_forall (GTK_CONTAINER (window->header_bar),
                        ellipsize_in_the_middle, NULL);
}

/* Hints where a picture is empty */

#define HINT_CHARACTERS 19 /* to a line: two lines of one length */
#define MOST_CHARACTERS 60 /* one line, if there is room */

static void
set_hint (GtkLabel *label, const char *text)
{
  gtk_label_set_text (label, text != NULL ? text : "");
  gtk_widget_set_visible (GTK_WIDGET (label), text != NULL);
}

static const char *
space_hint (const SiteSet *set, const Trace *trace)
{
  if (set->n_sites == 0)
    return _ ("Here the sites are lifted onto a paraboloid");
  if (!trace->is_flat)
    return NULL;
  if (set->n_distinct < 4)
    return _ ("A hull in space begins with four sites");
  return _ ("No simplex: all lifts lie in one plane");
}

static const char *
plane_hint (Hull2vdWindow *window, const SiteSet *set)
{
  if (set->n_sites > 0)
    return NULL;
  return plane_view_get_paper_bindings (window->plane_view)
             ? _ ("Right-click in the plane to add the first site")
             : _ ("Click in the plane to add the first site");
}

static void
update_hints (Hull2vdWindow *window)
{
  const SiteSet *set = session_get_set (window->session);
  const Trace *trace = session_get_trace (window->session);

  set_hint (window->plane_hint, plane_hint (window, set));
  set_hint (window->space_hint, space_hint (set, trace));
  /* The lifts of more sites may be as high as a second line. */
  gtk_label_set_max_width_chars (window->space_hint, set->n_distinct < 4
                                                         ? HINT_CHARACTERS
                                                         : MOST_CHARACTERS);
}

void
hull2vd_window_set_paper_bindings (Hull2vdWindow *window, gboolean has_them)
{
  plane_view_set_paper_bindings (window->plane_view, has_them);
  lesson_panel_set_right_button_adds (window->lesson_panel, has_them);
  update_hints (window);
}

/* The undo buttons say what they undo. */
static void
update_history (Hull2vdWindow *window)
{
  const char *undo = session_get_undo_label (window->session);
  const char *redo = session_get_redo_label (window->session);

  tooltips_set (window->undo_button, "undo", undo);
  tooltips_set (window->redo_button, "redo", redo);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if (changes & CHANGED_WORK)
    window_files_follow_work (window);
  if (changes & (CHANGED_SITES | CHANGED_LESSON)) {
    window_files_stop_reading (window);
    hull2vd_window_update_title (window);
    update_hints (window);
  }
  if (changes & CHANGED_HISTORY)
    update_history (window);
}

/* Keys */

static gboolean
presses_button (GtkWidget *focus, const GdkEventKey *event)
{
  return GTK_IS_BUTTON (focus)
         && (event->keyval == GDK_KEY_space || event->keyval == GDK_KEY_Return
             || event->keyval == GDK_KEY_KP_Enter);
}

/* Whether the focus may have a key before the accelerators: letters in
 * entries, Space on a button, arrows in a menu or on a site. */
static gboolean
wants_key (GtkWidget *focus, const GdkEventKey *event)
{
  if (focus == NULL)
    return FALSE;
  if (GTK_IS_EDITABLE (focus)
      || gtk_widget_get_ancestor (focus, GTK_TYPE_POPOVER) != NULL)
    return TRUE;
  if (HULL2VD_IS_CANVAS (focus))
    return canvas_wants_key (HULL2VD_CANVAS (focus), event);
  return presses_button (focus, event);
}

/* Buttons have no keys of their own: it is their window that presses them, but
 * not before it has looked for an action that has the key. */
static gboolean
give_to_focus (GtkWindow *window, GdkEventKey *event)
{
  GtkWidget *focus = gtk_window_get_focus (window);

  if (!wants_key (focus, event))
    return FALSE;
  return gtk_window_propagate_key_event (window, event)
         || (presses_button (focus, event)
             && gtk_window_activate_focus (window));
}

gboolean
hull2vd_window_forward_key (Hull2vdWindow *window,
                            GtkWindow *other,
                            GdkEventKey *event)
{
  return window_cover_key (window, event) || give_to_focus (other, event)
         || gtk_window_activate_key (GTK_WINDOW (window), event);
}

/* The key that has gone on all the time, where the lesson has no more stops. */
static gboolean
is_going_on (const GdkEventKey *event)
{
  return event->keyval == GDK_KEY_Page_Down
         || event->keyval == GDK_KEY_KP_Page_Down;
}

static gboolean
hull2vd_window_key_press (GtkWidget *widget, GdkEventKey *event)
{
  GtkWindow *window = GTK_WINDOW (widget);
  Session *session = HULL2VD_WINDOW (widget)->session;

  if (window_cover_key (HULL2VD_WINDOW (widget), event))
    return TRUE;
  if (event->keyval == GDK_KEY_Escape && session_give_up (session))
    return TRUE;
  if (give_to_focus (window, event))
    return TRUE;
  if (GTK_WIDGET_CLASS (hull2vd_window_parent_class)
          ->key_press_event (widget, event))
    return TRUE;
  if (is_going_on (event))
    return lesson_panel_show_next_lesson (
        HULL2VD_WINDOW (widget)->lesson_panel);
  if (event->keyval != GDK_KEY_Escape)
    return FALSE;
  gtk_window_unfullscreen (window);
  return TRUE;
}

/* Life */

static void
connect_session (Hull2vdWindow *window)
{
  Session *session = window->session;

  canvas_set_session (HULL2VD_CANVAS (window->plane_view), session);
  canvas_set_session (HULL2VD_CANVAS (window->space_view), session);
  lesson_panel_set_session (window->lesson_panel, session);
  code_panel_set_session (window->code_panel, session);
  counters_panel_set_session (window->counters_panel, session);
  legend_panel_set_session (window->legend_panel, session);
  space_note_attach (
      GTK_OVERLAY (gtk_widget_get_parent (GTK_WIDGET (window->space_view))),
      session);
  narration_bar_set_session (window->narration_bar, session);
  transport_set_session (window->transport, session);
  site_readout_attach (window->plane_readout, session);
  window->coordinate_entry = coordinate_entry_new (window->plane_view);
  work_bar_set_session (window->work_bar, session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), window,
                           0);
}

static void
hull2vd_window_dispose (GObject *object)
{
  Hull2vdWindow *window = HULL2VD_WINDOW (object);

  window_record_end (window);
  window_recovery_end (window);
  window_lecturer_end (window);
  window_message_end (window);
  if (window->session != NULL)
    session_give_up (window->session);
  g_clear_pointer (&window->watch, lesson_watch_free);
  g_clear_object (&window->session);
  g_clear_object (&window->settings);
  g_clear_pointer (&window->path, g_free);
  g_clear_pointer (&window->saved, g_bytes_unref);
  g_clear_pointer (&window->awaited, g_free);
  G_OBJECT_CLASS (hull2vd_window_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, Hull2vdWindow, name)

static void
bind_children (GtkWidgetClass *widget_class)
{
  BIND (header_bar);
  BIND (lessons_button);
  BIND (view_button);
  BIND (main_button);
  BIND (undo_button);
  BIND (redo_button);
  BIND (info_bar);
  BIND (info_label);
  BIND (recovery_bar);
  BIND (recovery_label);
  BIND (work_bar);
  BIND (columns);
  BIND (lesson_paned);
  BIND (view_paned);
  BIND (left_column);
  BIND (right_column);
  BIND (right_box);
  BIND (tabs);
  BIND (stack);
  BIND (space_buttons);
  BIND (plane_view);
  BIND (space_view);
  BIND (plane_hint);
  BIND (space_hint);
  BIND (plane_readout);
  BIND (plane_title);
  BIND (space_title);
  BIND (plane_box);
  BIND (space_box);
  BIND (lesson_panel);
  BIND (code_panel);
  BIND (counters_panel);
  BIND (legend_panel);
  BIND (narration_bar);
  BIND (transport);
}

static void
ensure_types (void)
{
  g_type_ensure (COLUMNS_TYPE);
  g_type_ensure (SIDE_COLUMN_TYPE);
  g_type_ensure (LESSON_PANEL_TYPE);
  g_type_ensure (CODE_PANEL_TYPE);
  g_type_ensure (COUNTERS_PANEL_TYPE);
  g_type_ensure (LEGEND_PANEL_TYPE);
  g_type_ensure (PLANE_VIEW_TYPE);
  g_type_ensure (SPACE_VIEW_TYPE);
  g_type_ensure (NARRATION_BAR_TYPE);
  g_type_ensure (TRANSPORT_TYPE);
  g_type_ensure (WORK_BAR_TYPE);
}

static void
hull2vd_window_class_init (Hull2vdWindowClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = hull2vd_window_dispose;
  widget_class->key_press_event = hull2vd_window_key_press;
  ensure_types ();
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/window.ui");
  bind_children (widget_class);
}

static void
hull2vd_window_init (Hull2vdWindow *window)
{
  gtk_widget_init_template (GTK_WIDGET (window));
  window->session = session_new ();
  session_set_patient (window->session, TRUE);
  window->settings = settings_new ();
  window_progress_init (window);
  connect_session (window);
  window_message_init (window);
  window_panes_init (window);
  window_layout_init (window);
  window_theme_init (window);
  window_actions_init (window);
  window_menus_init (window);
  window_files_init (window);
  window_recovery_init (window);
  window_space_init (window);
  window_cover_add (window, GTK_WIDGET (window));
  focus_order_of_paned (window->lesson_paned);
  focus_order_of_paned (window->view_paned);
  tooltips_add (GTK_WIDGET (window));
  hull2vd_window_update_title (window);
  update_hints (window);
  update_history (window);
  gtk_widget_grab_focus (GTK_WIDGET (window->plane_view));
}

Hull2vdWindow *
hull2vd_window_new (GtkApplication *application)
{
  return g_object_new (HULL2VD_WINDOW_TYPE, "application", application, NULL);
}
