#include "shortcuts-window.h"

#include "action-groups.h"
#include "keys.h"

#include <glib/gi18n.h>

static GtkWidget *
make_shortcut (const char *keys, const char *sentence)
{
  return gtk_widget_new (GTK_TYPE_SHORTCUTS_SHORTCUT, "visible", TRUE,
                         "accelerator", keys, "title", sentence, NULL);
}

static void
add_shortcut (GtkContainer *group, const char *keys, const char *sentence)
{
  gtk_container_add (group, make_shortcut (keys, sentence));
}

static GtkWidget *
add_group (GtkWidget *section, const char *title)
{
  GtkWidget *group = gtk_widget_new (GTK_TYPE_SHORTCUTS_GROUP, "visible", TRUE,
                                     "title", title, NULL);

  gtk_container_add (GTK_CONTAINER (section), group);
  return group;
}

/* What the views do with keys themselves. */
static void
add_view_keys (GtkWidget *section)
{
  GtkContainer *group = GTK_CONTAINER (add_group (section, _ ("In a picture")));

  add_shortcut (group, "Tab <Shift>Tab",
                _ ("Go to the next or previous site or facet"));
  add_shortcut (group, "<Primary>Tab", _ ("Leave the picture"));
  add_shortcut (group, "Left Right Up Down",
                _ ("Move the site, and all that are selected with it"));
  add_shortcut (group, "Return", _ ("Add a site, or select the one in focus"));
  add_shortcut (group, "<Primary>Return",
                _ ("Add the site in focus to the selection, or remove it"));
  add_shortcut (group, "Menu <Shift>F10", _ ("Show what can be done with it"));
  add_shortcut (group, "Insert", _ ("Add a site in the middle"));
  add_shortcut (group, "plus minus", _ ("Zoom in or out"));
  add_shortcut (group, "<Shift>Left <Shift>Right <Shift>Up <Shift>Down",
                _ ("Move the plane or turn space"));
}

static void
add_gesture (GtkContainer *group,
             GtkShortcutType type,
             const char *title,
             const char *what)
{
  gtk_container_add (group, gtk_widget_new (GTK_TYPE_SHORTCUTS_SHORTCUT,
                                            "visible", TRUE, "shortcut-type",
                                            type, "title", title, "subtitle",
                                            what, "subtitle-set", TRUE, NULL));
}

/* What the mouse does, which is not the same with the paper's bindings. */
static void
add_mouse (GtkWidget *section)
{
  static const struct {
    const char *what, *how;
  } rows[] = {
    { N_ ("Add a site"),
      N_ ("Click the empty plane, double-click or Ctrl+click a triangle") },
    { N_ ("Try a site"),
      N_ ("Hold the button on the empty plane; Enter keeps the site") },
    { N_ ("Select a site, a triangle or a facet"), N_ ("Click it") },
    { N_ ("Select several sites"),
      N_ ("Shift+click or Ctrl+click each, or Ctrl+drag a band round them") },
    { N_ ("Move a site, and all that are selected with it"), N_ ("Drag it") },
    { N_ ("Show what can be done"), N_ ("Right-click") },
    { N_ ("Move the plane"),
      N_ ("Drag away from the sites, or with the middle or right button") },
    { N_ ("Turn space"), N_ ("Drag") },
    { N_ ("Zoom"), N_ ("Scroll") },
  };
  static const struct {
    const char *what, *how;
  } paper_rows[] = {
    { N_ ("Add a site"), N_ ("Right-click") },
    { N_ ("Select a site or a triangle"), N_ ("Left-click it") },
    { N_ ("Move a site"), N_ ("Drag it with the left button") },
  };
  GtkContainer *group = GTK_CONTAINER (add_group (section, _ ("Mouse")));
  GtkContainer *paper = GTK_CONTAINER (
      add_group (section, _ ("Mouse, with “Paper’s Mouse Buttons”")));

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    add_gesture (group, GTK_SHORTCUT_GESTURE, _ (rows[i].what),
                 _ (rows[i].how));
  for (guint i = 0; i < G_N_ELEMENTS (paper_rows); i++)
    add_gesture (paper, GTK_SHORTCUT_GESTURE, _ (paper_rows[i].what),
                 _ (paper_rows[i].how));
}

static void
add_touch (GtkWidget *section)
{
  GtkContainer *group = GTK_CONTAINER (add_group (section, _ ("Touch")));

  add_gesture (group, GTK_SHORTCUT_GESTURE_PINCH, _ ("Zoom out"),
               _ ("Two fingers together"));
  add_gesture (group, GTK_SHORTCUT_GESTURE_STRETCH, _ ("Zoom in"),
               _ ("Two fingers apart"));
  add_gesture (group, GTK_SHORTCUT_GESTURE, _ ("Move the picture"),
               _ ("Drag with two fingers"));
  add_gesture (group, GTK_SHORTCUT_GESTURE, _ ("Show what can be done"),
               _ ("Press and hold"));
}

static GtkWidget *
add_section (GtkWidget *window, const char *name, const char *title)
{
  GtkWidget *section = gtk_widget_new (GTK_TYPE_SHORTCUTS_SECTION, "visible",
                                       TRUE, "section-name", name, "title",
                                       title, "max-height", 16, NULL);

  gtk_container_add (GTK_CONTAINER (window), section);
  return section;
}

static void
add_actions (GtkWidget *section, guint group)
{
  GtkContainer *container
      = GTK_CONTAINER (add_group (section, action_group_title (group)));
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    g_autofree char *keys = g_strjoinv (" ", (GStrv)keys_of (&actions[i]));

    if (keys[0] != '\0' && action_group_of (&actions[i]) == group)
      add_shortcut (container, keys, _ (actions[i].sentence));
  }
}

/* GTK writes the names of keys, such as Page_Down, where there is no word for
 * them. */
static void
spell_key (GtkLabel *label)
{
  g_autoptr (GString) text = g_string_new (gtk_label_get_text (label));

  if (text->len > 1 && g_string_replace (text, "_", " ", 0) > 0)
    gtk_label_set_text (label, text->str);
}

#define MOST_CHARACTERS 48 /* of a line, that the window fits on any screen */

static void
mend_labels (GtkWidget *widget, gpointer user)
{
  if (GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), mend_labels, user);
  if (!GTK_IS_LABEL (widget))
    return;
  if (gtk_style_context_has_class (gtk_widget_get_style_context (widget),
                                   "keycap")) {
    spell_key (GTK_LABEL (widget));
    return;
  }
  gtk_label_set_line_wrap (GTK_LABEL (widget), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (widget), MOST_CHARACTERS);
}

/* Two columns beside each other need this much. */
#define WIDE_PX 1400
#define HIGH_PX 1040

static gboolean
is_small (GtkWindow *parent)
{
  GdkDisplay *display = gtk_widget_get_display (GTK_WIDGET (parent));
  GdkMonitor *monitor = gdk_display_get_monitor_at_window (
      display, gtk_widget_get_window (GTK_WIDGET (parent)));
  GdkRectangle room;

  gdk_monitor_get_workarea (monitor, &room);
  return room.width < WIDE_PX || room.height < HIGH_PX;
}

/* On a small screen each group is a section: one column. */
static void
fill (GtkWidget *window, gboolean is_small)
{
  static const struct {
    const char *name, *title;
    void (*fill) (GtkWidget *section);
  } others[] = {
    { "view", N_ ("In a picture"), add_view_keys },
    { "mouse", N_ ("Mouse"), add_mouse },
    { "touch", N_ ("Touch"), add_touch },
  };
  GtkWidget *section = add_section (
      window, "keys", is_small ? action_group_title (0) : _ ("Keys"));

  for (guint i = 0; i < N_ACTION_GROUPS; i++) {
    if (i > 0 && is_small)
      section = add_section (window, action_group_title (i),
                             action_group_title (i));
    add_actions (section, i);
  }
  for (guint i = 0; i < G_N_ELEMENTS (others); i++) {
    if (is_small)
      section = add_section (window, others[i].name, _ (others[i].title));
    others[i].fill (section);
  }
}

/* GTK's window of shortcuts leaves a style behind when it is destroyed, which
 * is asked for its widget when the theme changes: it is hidden and kept. */
void
shortcuts_window_show (GtkWindow *parent)
{
  GtkWidget *window = g_object_get_data (G_OBJECT (parent), "shortcuts");

  if (window == NULL) {
    window = gtk_widget_new (GTK_TYPE_SHORTCUTS_WINDOW, "modal", TRUE,
                             "transient-for", parent, "destroy-with-parent",
                             TRUE, NULL);
    fill (window, is_small (parent));
    mend_labels (window, NULL);
    g_signal_connect (window, "delete-event",
                      G_CALLBACK (gtk_widget_hide_on_delete), NULL);
    g_object_set_data (G_OBJECT (parent), "shortcuts", window);
  }
  gtk_window_present (GTK_WINDOW (window));
}

void
shortcuts_window_forget (GtkWindow *parent)
{
  g_object_set_data (G_OBJECT (parent), "shortcuts", NULL);
}
