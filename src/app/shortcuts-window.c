#include "shortcuts-window.h"

#include "action.h"

#include <glib/gi18n.h>

/* The first group whose prefix an action's name has takes it. */
static const struct {
  const char *title;
  const char *prefixes; /* separated by blanks */
} groups[] = {
  { N_ ("Steps"), "next back first last play previous goto" },
  { N_ ("Sites"), "select delete undo redo nudge copy paste" },
  { N_ ("Pictures"), "layer camera fit zoom" },
  { N_ ("Panels"), "panel fullscreen" },
  { N_ ("Files and window"), "" },
};

static guint
group_of (const Action *action)
{
  for (guint i = 0; i < G_N_ELEMENTS (groups); i++) {
    g_auto (GStrv) prefixes = g_strsplit (groups[i].prefixes, " ", -1);

    if (prefixes[0] == NULL)
      return i;
    for (guint k = 0; prefixes[k] != NULL; k++)
      if (g_str_has_prefix (action->name, prefixes[k]))
        return i;
  }
  return G_N_ELEMENTS (groups) - 1;
}

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

  add_shortcut (group, "Tab <Shift>Tab", _ ("Go to the next, previous site"));
  add_shortcut (group, "<Primary>Tab", _ ("Leave the picture"));
  add_shortcut (group, "Left Right Up Down", _ ("Move the site"));
  add_shortcut (group, "Return", _ ("Add a site, or select the one in focus"));
  add_shortcut (group, "Insert", _ ("Add a site in the middle"));
  add_shortcut (group, "plus minus", _ ("Zoom in, out"));
  add_shortcut (group, "<Shift>Left <Shift>Right <Shift>Up <Shift>Down",
                _ ("Move the plane, turn space"));
}

static GtkWidget *
make_section (void)
{
  GtkWidget *section
      = g_object_new (GTK_TYPE_SHORTCUTS_SECTION, "visible", TRUE,
                      "section-name", "keys", "max-height", 16, NULL);
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < G_N_ELEMENTS (groups); i++) {
    GtkWidget *group = add_group (section, _ (groups[i].title));

    for (guint k = 0; k < n_actions; k++)
      if (actions[k].keys != NULL && group_of (&actions[k]) == i)
        add_shortcut (GTK_CONTAINER (group), actions[k].keys,
                      _ (actions[k].sentence));
  }
  add_view_keys (section);
  return section;
}

static GtkWidget *
make_window (GtkWindow *parent)
{
  return gtk_widget_new (GTK_TYPE_SHORTCUTS_WINDOW, "modal", TRUE,
                         "transient-for", parent, "destroy-with-parent", TRUE,
                         NULL);
}

void
shortcuts_window_show (GtkWindow *parent)
{
  GtkWidget *window = make_window (parent);

  gtk_container_add (GTK_CONTAINER (window), make_section ());
  gtk_widget_show (window);
}
