#include "keys.h"

#include "settings.h"

#include <glib/gi18n.h>
#include <gtk/gtk.h>

/* Accelerators are compared as GTK reads them: <Ctrl>P and <Primary>p are the
 * same. */
static char *
name_of (const char *key)
{
  GdkModifierType modifiers;
  guint value;

  gtk_accelerator_parse (key, &value, &modifiers);
  return value == 0 ? NULL : gtk_accelerator_name (value, modifiers);
}

static GVariant *
read_setting (void)
{
  g_autoptr (GSettings) settings = settings_new ();

  return settings == NULL ? g_variant_ref_sink (g_variant_new ("a{ss}", NULL))
                          : g_settings_get_value (settings, "keys");
}

static GVariant *
get_setting (void)
{
  static GVariant *setting;

  if (setting == NULL)
    setting = read_setting ();
  return setting;
}

void
keys_check (void)
{
  GVariantIter iter;
  const char *name, *keys;

  g_variant_iter_init (&iter, get_setting ());
  while (g_variant_iter_next (&iter, "{&s&s}", &name, &keys)) {
    g_auto (GStrv) parts = g_strsplit (keys, " ", -1);

    if (action_find (name) == NULL)
      g_printerr (_ ("hull2vd: the setting “keys”: there is no action “%s”\n"),
                  name);
    for (guint i = 0; parts[i] != NULL; i++) {
      g_autofree char *key = name_of (parts[i]);

      if (key == NULL && parts[i][0] != '\0')
        g_printerr (_ ("hull2vd: the setting “keys”: “%s” is not a key\n"),
                    parts[i]);
    }
  }
}

/* Whether the person has given the key to an action of another name. */
static gboolean
is_taken (const char *key, const char *by_other_than)
{
  GVariantIter iter;
  const char *name, *keys;

  g_variant_iter_init (&iter, get_setting ());
  while (g_variant_iter_next (&iter, "{&s&s}", &name, &keys)) {
    g_auto (GStrv) parts = g_strsplit (keys, " ", -1);

    for (guint i = 0; parts[i] != NULL; i++) {
      g_autofree char *other = name_of (parts[i]);

      if (!g_str_equal (name, by_other_than) && g_strcmp0 (other, key) == 0)
        return TRUE;
    }
  }
  return FALSE;
}

static GStrv
choose (const Action *action)
{
  g_autoptr (GStrvBuilder) chosen = g_strv_builder_new ();
  g_auto (GStrv) parts = NULL;
  const char *own;
  const gboolean has_own
      = g_variant_lookup (get_setting (), action->name, "&s", &own);

  parts = g_strsplit (has_own                ? own
                      : action->keys == NULL ? ""
                                             : action->keys,
                      " ", -1);
  for (guint i = 0; parts[i] != NULL; i++) {
    g_autofree char *key = name_of (parts[i]);

    if (key != NULL && (has_own || !is_taken (key, action->name)))
      g_strv_builder_add (chosen, parts[i]);
  }
  return g_strv_builder_end (chosen);
}

const char *const *
keys_of (const Action *action)
{
  static GHashTable *known;
  GStrv keys;

  if (known == NULL)
    known = g_hash_table_new (g_direct_hash, g_direct_equal);
  keys = g_hash_table_lookup (known, action);
  if (keys == NULL) {
    keys = choose (action);
    g_hash_table_insert (known, (gpointer)action, keys);
  }
  return (const char *const *)keys;
}
