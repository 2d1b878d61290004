#include "tooltips.h"

#include "action.h"
#include "keys.h"

#include <glib/gi18n.h>

#define ACTION "tooltip-action"
#define TEXT "tooltip-text-alone"

/* With the first key. */
static void
show_text (GtkWidget *button, const Action *action, const char *text)
{
  const char *const *keys = keys_of (action);
  g_autofree char *key = keys[0] == NULL ? NULL : keys_label (keys[0]);
  g_autofree char *tooltip
      = key == NULL ? g_strdup (text) : g_strdup_printf ("%s (%s)", text, key);

  gtk_widget_set_tooltip_text (button, tooltip);
  g_object_set_data (G_OBJECT (button), ACTION, (gpointer)action);
  g_object_set_data_full (G_OBJECT (button), TEXT, g_strdup (text), g_free);
}

void
tooltips_set (GtkWidget *button, const char *name, const char *text)
{
  const Action *action = action_find (name);

  if (action == NULL)
    return;
  if (text == NULL)
    text = _ (action->sentence);
  show_text (button, action, text);
  atk_object_set_name (gtk_widget_get_accessible (button), text);
}

static void
add_one (GtkWidget *widget, gpointer user)
{
  const char *name;

  (void)user;
  if (GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), add_one, NULL);
  if (!GTK_IS_BUTTON (widget) || gtk_widget_get_has_tooltip (widget))
    return;
  name = gtk_actionable_get_action_name (GTK_ACTIONABLE (widget));
  if (name != NULL && g_str_has_prefix (name, "win."))
    tooltips_set (widget, name + strlen ("win."), NULL);
}

void
tooltips_add (GtkWidget *root)
{
  add_one (root, NULL);
}

static void
update_one (GtkWidget *widget, gpointer user)
{
  const Action *action = g_object_get_data (G_OBJECT (widget), ACTION);

  (void)user;
  if (GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), update_one, NULL);
  if (action != NULL) {
    g_autofree char *text
        = g_strdup (g_object_get_data (G_OBJECT (widget), TEXT));

    show_text (widget, action, text);
  }
}

void
tooltips_update (GtkWidget *root)
{
  update_one (root, NULL);
}
