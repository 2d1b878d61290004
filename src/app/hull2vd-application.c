#include "hull2vd-application.h"

#include "action.h"
#include "keys-dialog.h"
#include "keys.h"
#include "lesson-list.h"
#include "progress-keeper.h"
#include "shortcuts-window.h"
#include "tooltips.h"
#include "window-private.h"

#include <glib-unix.h>
#include <glib/gi18n.h>
#include <sysexits.h>

struct _Hull2vdApplication {
  GtkApplication parent_instance;
};

G_DEFINE_TYPE (Hull2vdApplication, hull2vd_application, GTK_TYPE_APPLICATION)

/* Start */

static void
load_style (void)
{
  g_autoptr (GtkCssProvider) style = gtk_css_provider_new ();

  gtk_css_provider_load_from_resource (style,
                                       "/io/github/hull2vd/Hull2VD/style.css");
  gtk_style_context_add_provider_for_screen (
      gdk_screen_get_default (), GTK_STYLE_PROVIDER (style),
      GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
}

/* Where no desktop says which font, this one. */
static void
choose_font (void)
{
  GtkSettings *settings = gtk_settings_get_default ();
  g_autofree char *font = NULL;

  g_object_get (settings, "gtk-font-name", &font, NULL);
  if (g_strcmp0 (font, "Sans 10") == 0)
    g_object_set (settings, "gtk-font-name", "Cantarell,Sans 11", NULL);
}

static void
set_accelerators (GtkApplication *application)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    g_autofree char *name = NULL;

    if (!keys_can_do (&actions[i]))
      continue;
    name = g_strconcat ("win.", actions[i].name, NULL);
    gtk_application_set_accels_for_action (application, name,
                                           keys_of (&actions[i]));
  }
  gtk_application_set_accels_for_action (application, "app.quit",
                                         keys_of (action_find ("quit")));
}

/* Menus follow by themselves. */
static void
on_keys_changed (gpointer user)
{
  GList *windows = gtk_window_list_toplevels ();

  set_accelerators (user);
  for (GList *node = windows; node != NULL; node = node->next) {
    tooltips_update (node->data);
    shortcuts_window_forget (node->data);
    if (HULL2VD_IS_KEYS_DIALOG (node->data))
      keys_dialog_update (node->data);
  }
  g_list_free (windows);
}

/* No window is closed while it is below a modal one. */
static void
close_modal_windows (void)
{
  GList *windows = gtk_window_list_toplevels ();

  for (GList *node = windows; node != NULL; node = node->next)
    if (gtk_window_get_modal (node->data)
        && gtk_widget_get_visible (node->data))
      gtk_window_close (node->data);
  g_list_free (windows);
}

static void
on_quit (GSimpleAction *action, GVariant *parameter, gpointer user)
{
  GList *windows
      = g_list_copy (gtk_application_get_windows (GTK_APPLICATION (user)));

  (void)action;
  (void)parameter;
  close_modal_windows ();
  /* Each window may ask whether to save. */
  for (GList *node = windows; node != NULL; node = node->next)
    gtk_window_close (node->data);
  g_list_free (windows);
}

static void
check_renderer (void)
{
  static const char *const names[] = { "", "gl", "cairo", NULL };
  const char *name = g_getenv ("HULL2VD_RENDERER");

  if (name != NULL && !g_strv_contains (names, name))
    g_printerr (_ ("HULL2VD_RENDERER=%s: expected gl or cairo\n"), name);
}

/* What is in no file is kept for the next start: nobody is there to be
 * asked. */
static gboolean
on_terminate (gpointer user)
{
  GList *windows
      = g_list_copy (gtk_application_get_windows (GTK_APPLICATION (user)));

  for (GList *node = windows; node != NULL; node = node->next)
    if (HULL2VD_IS_WINDOW (node->data)) {
      window_recovery_flush (node->data);
      gtk_widget_destroy (node->data);
    }
  g_list_free (windows);
  progress_keeper_flush ();
  g_application_quit (user);
  return G_SOURCE_CONTINUE;
}

static void
watch_signals (GApplication *application)
{
  static const int numbers[] = { SIGHUP, SIGINT, SIGTERM };

  for (guint i = 0; i < G_N_ELEMENTS (numbers); i++)
    g_unix_signal_add (numbers[i], on_terminate, application);
}

static void
hull2vd_application_startup (GApplication *application)
{
  static const GActionEntry entries[]
      = { { "quit", on_quit, NULL, NULL, NULL, { 0 } } };

  G_APPLICATION_CLASS (hull2vd_application_parent_class)->startup (application);
  g_set_application_name ("Hull2VD");
  gtk_window_set_default_icon_name (HULL2VD_APPLICATION_ID);
  choose_font ();
  load_style ();
  g_action_map_add_action_entries (G_ACTION_MAP (application), entries,
                                   G_N_ELEMENTS (entries), application);
  keys_init (on_keys_changed, application);
  check_renderer ();
  set_accelerators (GTK_APPLICATION (application));
  watch_signals (application);
}

/* Windows */

/* The first one asks about what is left over. */
static Hull2vdWindow *
new_window (GApplication *application)
{
  const gboolean is_first
      = gtk_application_get_windows (GTK_APPLICATION (application)) == NULL;
  Hull2vdWindow *window = hull2vd_window_new (GTK_APPLICATION (application));

  if (is_first)
    window_recovery_offer (window);
  return window;
}

static Hull2vdWindow *
get_window (GApplication *application)
{
  GtkWindow *window
      = gtk_application_get_active_window (GTK_APPLICATION (application));

  if (HULL2VD_IS_WINDOW (window))
    return HULL2VD_WINDOW (window);
  return new_window (application);
}

/* The lesson that the person was in, else the first one. */
static void
load_first_lesson (Hull2vdWindow *window)
{
  g_autofree char *last = lesson_list_last (progress_keeper_get ());
  g_autofree char *path
      = last != NULL ? g_steal_pointer (&last) : lesson_list_first ();

  if (path != NULL)
    window_files_load (window, path);
}

static void
hull2vd_application_activate (GApplication *application)
{
  const gboolean is_first
      = gtk_application_get_windows (GTK_APPLICATION (application)) == NULL;
  Hull2vdWindow *window = get_window (application);

  if (is_first)
    load_first_lesson (window);
  gtk_window_present (GTK_WINDOW (window));
}

/* As the person gave it, so that messages are those of the terminal. */
static char *
path_of (GFile *file)
{
  g_autofree char *folder = g_get_current_dir ();
  g_autoptr (GFile) here = g_file_new_for_path (folder);
  char *path = g_file_get_relative_path (here, file);

  return path != NULL ? path : g_file_get_parse_name (file);
}

static void
open_in (Hull2vdWindow *window, const char *path, gboolean is_new)
{
  if (!window_files_load (window, path) && is_new) {
    load_first_lesson (window);
    window_files_load (window, path); /* says again why not */
  }
  gtk_window_present (GTK_WINDOW (window));
}

static void
open_file (GApplication *application, GFile *file, gboolean is_alone)
{
  g_autofree char *path = path_of (file);
  GList *windows = gtk_application_get_windows (GTK_APPLICATION (application));
  Hull2vdWindow *window
      = windows != NULL && !is_alone ? get_window (application) : NULL;

  /* Work that is in no file keeps its window. */
  if (window != NULL && !window_files_is_modified (window))
    open_in (window, path, FALSE);
  else
    open_in (new_window (application), path, TRUE);
}

/* Of several files the first may take the place of what is there, the others
 * have windows of their own. */
static void
hull2vd_application_open (GApplication *application,
                          GFile **files,
                          int n_files,
                          const char *hint)
{
  const gboolean are_alone = g_str_equal (hint, HULL2VD_OPEN_ALONE);

  for (int i = 0; i < n_files; i++)
    open_file (application, files[i], are_alone || i > 0);
}

/* Life */

static int
hull2vd_application_handle_local_options (GApplication *application,
                                          GVariantDict *options)
{
  (void)application;
  if (g_variant_dict_contains (options, "version")) {
    g_print ("hull2vd %s\n", HULL2VD_VERSION);
    return EX_OK;
  }
  if (!gtk_init_check (NULL, NULL)) {
    g_printerr ("hull2vd: %s\n", _ ("cannot open the display"));
    return EX_UNAVAILABLE;
  }
  return -1;
}

static void
hull2vd_application_class_init (Hull2vdApplicationClass *class)
{
  GApplicationClass *application_class = G_APPLICATION_CLASS (class);

  application_class->startup = hull2vd_application_startup;
  application_class->activate = hull2vd_application_activate;
  application_class->open = hull2vd_application_open;
  application_class->handle_local_options
      = hull2vd_application_handle_local_options;
}

static void
hull2vd_application_init (Hull2vdApplication *application)
{
  GApplication *app = G_APPLICATION (application);

  g_application_add_main_option (app, "version", 0, G_OPTION_FLAG_NONE,
                                 G_OPTION_ARG_NONE, N_ ("Print the version"),
                                 NULL);
  g_application_set_option_context_parameter_string (app,
                                                     _ ("[LESSON|POINTS…]"));
  g_application_set_option_context_summary (
      app,
      _ ("Convex hulls, Delaunay triangulations and Voronoi diagrams, step by "
         "step."));
}

Hull2vdApplication *
hull2vd_application_new (void)
{
  return g_object_new (HULL2VD_APPLICATION_TYPE, "application-id",
                       HULL2VD_APPLICATION_ID, "flags",
                       G_APPLICATION_HANDLES_OPEN, NULL);
}
