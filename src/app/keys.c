#include "keys.h"

#include "settings.h"

#include <glib/gi18n.h>
#include <gtk/gtk.h>

static GSettings *settings; /* NULL: there is no schema */
static GHashTable *own;     /* names of actions to their keys, as in it */
static GHashTable *known;   /* actions to what keys_of() has found */
static struct {
  void (*on_changed) (gpointer user);
  gpointer user;
} listener;

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

static gboolean
has_key (const char *keys, const char *key)
{
  g_autofree char *name = name_of (key);
  g_auto (GStrv) parts = g_strsplit (keys, " ", -1);

  for (guint i = 0; name != NULL && parts[i] != NULL; i++) {
    g_autofree char *other = name_of (parts[i]);

    if (g_strcmp0 (other, name) == 0)
      return TRUE;
  }
  return FALSE;
}

/* The setting */

static void
read_setting (void)
{
  g_autoptr (GVariant) setting = NULL;
  GVariantIter iter;
  const char *name, *keys;

  if (own == NULL)
    own = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, g_free);
  g_hash_table_remove_all (own);
  if (settings == NULL)
    return;
  setting = g_settings_get_value (settings, "keys");
  g_variant_iter_init (&iter, setting);
  while (g_variant_iter_next (&iter, "{&s&s}", &name, &keys))
    g_hash_table_insert (own, g_strdup (name), g_strdup (keys));
}

static void
write_setting (void)
{
  GVariantBuilder builder;
  GHashTableIter iter;
  gpointer name, keys;

  if (settings == NULL)
    return;
  g_variant_builder_init (&builder, G_VARIANT_TYPE ("a{ss}"));
  g_hash_table_iter_init (&iter, own);
  while (g_hash_table_iter_next (&iter, &name, &keys))
    g_variant_builder_add (&builder, "{ss}", name, keys);
  g_settings_set_value (settings, "keys", g_variant_builder_end (&builder));
}

static void
forget_known (void)
{
  if (known != NULL)
    g_hash_table_remove_all (known);
  listener.on_changed (listener.user);
}

static void
on_setting (void)
{
  read_setting ();
  forget_known ();
}

/* Written, it is read again; without a setting nobody tells. */
static void
commit (void)
{
  if (settings != NULL)
    write_setting ();
  else
    forget_known ();
}

static void
check_keys (const char *keys)
{
  g_auto (GStrv) parts = g_strsplit (keys, " ", -1);

  for (guint i = 0; parts[i] != NULL; i++) {
    g_autofree char *key = name_of (parts[i]);

    if (key == NULL && parts[i][0] != '\0')
      g_printerr (_ ("hull2vd: the setting “keys”: “%s” is not a key\n"),
                  parts[i]);
  }
}

static void
check_setting (void)
{
  GHashTableIter iter;
  gpointer name, keys;

  g_hash_table_iter_init (&iter, own);
  while (g_hash_table_iter_next (&iter, &name, &keys)) {
    if (action_find (name) == NULL)
      g_printerr (_ ("hull2vd: the setting “keys”: there is no action “%s”\n"),
                  (const char *)name);
    check_keys (keys);
  }
}

void
keys_init (void (*on_changed) (gpointer user), gpointer user)
{
  listener.on_changed = on_changed;
  listener.user = user;
  settings = settings_new ();
  read_setting ();
  check_setting ();
  if (settings != NULL)
    g_signal_connect (settings, "changed::keys", G_CALLBACK (on_setting), NULL);
}

/* What an action has */

gboolean
keys_can_do (const Action *action)
{
  return (action->where & ACTION_IN_WINDOW) != 0 && action->parameter == NULL
         && (action->run != NULL || action->get_state == NULL);
}

/* Whether the person has given the key to an action of another name. */
static gboolean
is_taken (const char *key, const char *by_other_than)
{
  GHashTableIter iter;
  gpointer name, keys;

  g_hash_table_iter_init (&iter, own);
  while (g_hash_table_iter_next (&iter, &name, &keys))
    if (!g_str_equal (name, by_other_than) && has_key (keys, key))
      return TRUE;
  return FALSE;
}

static GStrv
choose (const Action *action)
{
  g_autoptr (GStrvBuilder) chosen = g_strv_builder_new ();
  const char *mine = g_hash_table_lookup (own, action->name);
  const char *keys = mine != NULL           ? mine
                     : action->keys == NULL ? ""
                                            : action->keys;
  g_auto (GStrv) parts = g_strsplit (keys, " ", -1);

  for (guint i = 0; parts[i] != NULL; i++) {
    g_autofree char *key = name_of (parts[i]);

    if (key != NULL && (mine != NULL || !is_taken (key, action->name)))
      g_strv_builder_add (chosen, parts[i]);
  }
  return g_strv_builder_end (chosen);
}

const char *const *
keys_of (const Action *action)
{
  GStrv keys;

  if (known == NULL)
    known = g_hash_table_new_full (g_direct_hash, g_direct_equal, NULL,
                                   (GDestroyNotify)g_strfreev);
  keys = g_hash_table_lookup (known, action);
  if (keys == NULL) {
    keys = choose (action);
    g_hash_table_insert (known, (gpointer)action, keys);
  }
  return (const char *const *)keys;
}

gboolean
keys_are_own (const Action *action)
{
  return g_hash_table_contains (own, action->name);
}

const Action *
keys_find_action (const char *key)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    g_autofree char *keys = g_strjoinv (" ", (GStrv)keys_of (&actions[i]));

    if (has_key (keys, key))
      return &actions[i];
  }
  return NULL;
}

/* Changes */

/* From those that have it by the person's choice; from the others it goes by
 * itself. */
static void
take_from_others (const char *key, const char *name)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint i = 0; i < n_actions; i++) {
    const char *keys = g_hash_table_lookup (own, actions[i].name);
    g_autoptr (GString) rest = g_string_new (NULL);
    g_auto (GStrv) parts = NULL;

    if (keys == NULL || g_str_equal (actions[i].name, name)
        || !has_key (keys, key))
      continue;
    parts = g_strsplit (keys, " ", -1);
    for (guint k = 0; parts[k] != NULL; k++)
      if (!has_key (parts[k], key))
        g_string_append_printf (rest, "%s%s", rest->len > 0 ? " " : "",
                                parts[k]);
    g_hash_table_insert (own, g_strdup (actions[i].name),
                         g_string_free (g_steal_pointer (&rest), FALSE));
  }
}

void
keys_set (const Action *action, const char *const *keys)
{
  char *joined = g_strjoinv (" ", (GStrv)keys);

  for (guint i = 0; keys[i] != NULL; i++)
    take_from_others (keys[i], action->name);
  g_hash_table_insert (own, g_strdup (action->name), joined);
  commit ();
}

void
keys_reset (const Action *action)
{
  if (g_hash_table_remove (own, action->name))
    commit ();
}

void
keys_reset_all (void)
{
  if (g_hash_table_size (own) == 0)
    return;
  g_hash_table_remove_all (own);
  commit ();
}

/* Words */

/* GTK writes the names of keys, such as Page_Down, where there is no word for
 * them. */
char *
keys_label (const char *key)
{
  g_autoptr (GString) text = NULL;
  g_autofree char *label = NULL;
  GdkModifierType modifiers;
  guint value;

  gtk_accelerator_parse (key, &value, &modifiers);
  label = gtk_accelerator_get_label (value, modifiers);
  text = g_string_new (label);
  if (value != GDK_KEY_underscore)
    g_string_replace (text, "_", " ", 0);
  return g_string_free (g_steal_pointer (&text), FALSE);
}

char *
keys_label_all (const Action *action)
{
  const char *const *keys = keys_of (action);
  g_autoptr (GStrvBuilder) labels = g_strv_builder_new ();
  g_auto (GStrv) words = NULL;

  for (guint i = 0; keys[i] != NULL; i++) {
    g_autofree char *label = keys_label (keys[i]);

    g_strv_builder_add (labels, label);
  }
  words = g_strv_builder_end (labels);
  return g_strjoinv (", ", words);
}
