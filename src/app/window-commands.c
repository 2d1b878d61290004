#include "window-private.h"

#include "generate-dialog.h"
#include "keys-dialog.h"
#include "shortcuts-window.h"

#include <glib/gi18n.h>

/* Panels as switches. */

static const struct {
  const char *name;
  WindowPanel panel;
} panels[] = {
  { "panel-lesson", PANEL_LESSON },
  { "panel-code", PANEL_CODE },
  { "panel-counters", PANEL_COUNTERS },
  { "panel-legend", PANEL_LEGEND },
};

static gboolean
toggle_panel (Hull2vdWindow *window, const char *name)
{
  GtkWidget *bar = GTK_WIDGET (window->narration_bar);

  for (guint i = 0; i < G_N_ELEMENTS (panels); i++)
    if (g_str_equal (name, panels[i].name)) {
      window_layout_show (window, panels[i].panel,
                          !window_layout_shows (window, panels[i].panel));
      return TRUE;
    }
  if (!g_str_equal (name, "panel-narration"))
    return FALSE;
  gtk_widget_set_visible (bar, !gtk_widget_get_visible (bar));
  return TRUE;
}

static gboolean
is_fullscreen (Hull2vdWindow *window)
{
  GdkWindow *gdk_window = gtk_widget_get_window (GTK_WIDGET (window));

  return gdk_window != NULL
         && (gdk_window_get_state (gdk_window) & GDK_WINDOW_STATE_FULLSCREEN)
                != 0;
}

GVariant *
window_command_state (Hull2vdWindow *window, const char *name)
{
  for (guint i = 0; i < G_N_ELEMENTS (panels); i++)
    if (g_str_equal (name, panels[i].name))
      return g_variant_new_boolean (
          window_layout_shows (window, panels[i].panel));
  if (g_str_equal (name, "panel-narration"))
    return g_variant_new_boolean (
        gtk_widget_get_visible (GTK_WIDGET (window->narration_bar)));
  if (g_str_equal (name, "fullscreen"))
    return g_variant_new_boolean (is_fullscreen (window));
  if (g_str_equal (name, "blank"))
    return g_variant_new_boolean (window_cover_is_black (window));
  if (g_str_equal (name, "freeze"))
    return g_variant_new_boolean (window_cover_is_frozen (window));
  if (g_str_equal (name, "lecturer"))
    return g_variant_new_boolean (window_lecturer_is_open (window));
  if (g_str_equal (name, "clock"))
    return g_variant_new_boolean (window_lecturer_is_running (window));
  if (g_str_equal (name, "record"))
    return g_variant_new_boolean (window_record_is_on (window));
  if (g_str_equal (name, "detach-space"))
    return g_variant_new_boolean (window_space_is_detached (window));
  if (g_str_equal (name, "paper-bindings"))
    return g_variant_new_boolean (
        plane_view_get_paper_bindings (window->plane_view));
  return NULL;
}

/* Commands */

static void
run_open_file (Hull2vdWindow *window, GVariant *parameter)
{
  window_files_open_path (window, g_variant_get_string (parameter, NULL));
}

/* Says why not. */
static gboolean
can_edit (Hull2vdWindow *window)
{
  g_autoptr (GError) error = NULL;

  if (session_can_edit (window->session, &error))
    return TRUE;
  hull2vd_window_say (window, error->message);
  return FALSE;
}

static void
run_add_site_at (Hull2vdWindow *window)
{
  if (can_edit (window))
    coordinate_entry_add (window->coordinate_entry);
}

static void
run_move_site_to (Hull2vdWindow *window)
{
  const Object selection = session_get_look (window->session)->selection;

  if (selection.kind == OBJECT_SITE && can_edit (window))
    coordinate_entry_move (window->coordinate_entry, selection.number);
}

static void
run_generate (Hull2vdWindow *window)
{
  if (!can_edit (window))
    return;
  if (window->generate_dialog == NULL)
    window->generate_dialog
        = generate_dialog_new (GTK_WINDOW (window), window->session);
  gtk_window_present (GTK_WINDOW (window->generate_dialog));
}

static void
run_paper_bindings (Hull2vdWindow *window)
{
  const gboolean has_them = !plane_view_get_paper_bindings (window->plane_view);

  hull2vd_window_set_paper_bindings (window, has_them);
  if (window->settings != NULL)
    g_settings_set_boolean (window->settings, "paper-bindings", has_them);
}

static void
run_detach_space (Hull2vdWindow *window)
{
  window_space_detach (window, !window_space_is_detached (window));
}

static void
run_about (Hull2vdWindow *window)
{
  gtk_show_about_dialog (
      GTK_WINDOW (window), "program-name", "Hull2VD", "logo-icon-name",
      "io.github.hull2vd.Hull2VD", "version", HULL2VD_VERSION, "comments",
      _ ("Convex hulls, Delaunay triangulations and Voronoi diagrams, step by "
         "step.\nAfter Hull2VD by John Fisher, 2004."),
      "license-type", GTK_LICENSE_GPL_3_0, NULL);
}

static void
run_fullscreen (Hull2vdWindow *window)
{
  if (is_fullscreen (window))
    gtk_window_unfullscreen (GTK_WINDOW (window));
  else
    gtk_window_fullscreen (GTK_WINDOW (window));
}

static void
run_close (Hull2vdWindow *window)
{
  gtk_window_close (GTK_WINDOW (window));
}

static void
run_quit (Hull2vdWindow *window)
{
  g_action_group_activate_action (
      G_ACTION_GROUP (gtk_window_get_application (GTK_WINDOW (window))), "quit",
      NULL);
}

static void
run_shortcuts (Hull2vdWindow *window)
{
  shortcuts_window_show (GTK_WINDOW (window));
}

static void
run_change_keys (Hull2vdWindow *window)
{
  if (window->keys_dialog == NULL)
    window->keys_dialog = keys_dialog_new (GTK_WINDOW (window));
  gtk_window_present (GTK_WINDOW (window->keys_dialog));
}

typedef struct Command {
  const char *name;
  void (*run) (Hull2vdWindow *window);
} Command;

static const Command commands[] = {
  { "new", window_files_new },
  { "save", window_files_save },
  { "restore-unsaved", window_recovery_restore },
  { "discard-unsaved", window_recovery_discard },
  { "adapt-lesson", window_files_adapt },
  { "copy", window_files_copy },
  { "paste", window_paste },
  { "copy-picture", window_picture_copy },
  { "clear-progress", window_progress_clear },
  { "next-lesson", window_progress_next_lesson },
  { "record", window_record_toggle },
  { "record-stop", window_record_cut },
  { "record-copy", window_record_copy },
  { "shortcuts", run_shortcuts },
  { "about", run_about },
  { "close", run_close },
  { "quit", run_quit },
  { "fullscreen", run_fullscreen },
  { "blank", window_cover_toggle_black },
  { "freeze", window_lecturer_toggle_freeze },
  { "lecturer", window_lecturer_toggle },
  { "clock", window_lecturer_toggle_clock },
  { "clock-reset", window_lecturer_reset_clock },
  { "overview", window_lecturer_show_overview },
  { "add-site-at", run_add_site_at },
  { "move-site-to", run_move_site_to },
  { "generate", run_generate },
  { "paper-bindings", run_paper_bindings },
  { "detach-space", run_detach_space },
};

/* Those that open a dialog whatever happens. */
static const Command dialogs[] = {
  { "open", window_files_open },
  { "save-as", window_files_save_as },
  { "export-picture", window_picture_export },
  { "storyboard", window_files_storyboard },
  { "handout", window_files_handout },
  { "export-results", window_progress_export },
  { "change-keys", run_change_keys },
};

static const Command *
find_command (const Command *rows, guint n, const char *name)
{
  for (guint i = 0; i < n; i++)
    if (g_str_equal (name, rows[i].name))
      return &rows[i];
  return NULL;
}

gboolean
window_command_run (Hull2vdWindow *window,
                    const char *name,
                    GVariant *parameter)
{
  const Command *command
      = find_command (commands, G_N_ELEMENTS (commands), name);
  const Command *dialog = find_command (dialogs, G_N_ELEMENTS (dialogs), name);

  if (g_str_equal (name, "open-file"))
    run_open_file (window, parameter);
  else if (command != NULL)
    command->run (window);
  else if (dialog == NULL)
    return toggle_panel (window, name);
  else if (!window_dialog_refuse (window, NULL))
    dialog->run (window);
  return TRUE;
}
