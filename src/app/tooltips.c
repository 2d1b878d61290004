#include "tooltips.h"

#include "action.h"
#include "keys.h"

#include <glib/gi18n.h>

/* The first key, as it is written on keyboards; NULL: none. */
static char *
key_text (const Action *action)
{
  const char *const *keys = keys_of (action);
  GdkModifierType modifiers;
  guint key;

  if (keys[0] == NULL)
    return NULL;
  gtk_accelerator_parse (keys[0], &key, &modifiers);
  return key == 0 ? NULL : gtk_accelerator_get_label (key, modifiers);
}

void
tooltips_set (GtkWidget *button, const char *name, const char *text)
{
  const Action *action = action_find (name);
  g_autofree char *key = NULL;
  g_autofree char *tooltip = NULL;

  if (action == NULL)
    return;
  if (text == NULL)
    text = _ (action->sentence);
  key = key_text (action);
  tooltip
      = key == NULL ? g_strdup (text) : g_strdup_printf ("%s (%s)", text, key);
  gtk_widget_set_tooltip_text (button, tooltip);
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
