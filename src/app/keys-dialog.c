#include "keys-dialog.h"

#include "action-groups.h"
#include "announcement.h"
#include "key-capture.h"
#include "keys.h"

#include <glib/gi18n.h>

struct _KeysDialog {
  GtkDialog parent_instance;
  GtkSearchEntry *search;
  GtkListBox *list;
  GtkLabel *status;
  GtkWidget *change, *add, *remove, *reset, *reset_all;
};

G_DEFINE_TYPE (KeysDialog, keys_dialog, GTK_TYPE_DIALOG)

/* Rows */

static const Action *
action_of (GtkListBoxRow *row)
{
  return g_object_get_data (G_OBJECT (row), "action");
}

static GtkLabel *
label_of (GtkListBoxRow *row)
{
  return g_object_get_data (G_OBJECT (row), "keys");
}

/* What is the person's own choice stands out, and is told. */
static void
update_row (GtkWidget *widget, gpointer user)
{
  GtkListBoxRow *row = GTK_LIST_BOX_ROW (widget);
  const Action *action = action_of (row);
  const char *sentence = _ (action->sentence);
  g_autofree char *keys = keys_label_all (action);
  GtkStyleContext *style
      = gtk_widget_get_style_context (GTK_WIDGET (label_of (row)));
  g_autofree char *name = NULL;

  (void)user;
  gtk_label_set_text (label_of (row), keys);
  if (keys_are_own (action))
    gtk_style_context_add_class (style, "own");
  else
    gtk_style_context_remove_class (style, "own");
  name = g_strdup_printf (keys_are_own (action) ? _ ("%s: %s, changed")
                                                : _ ("%s: %s"),
                          sentence, keys[0] == '\0' ? _ ("no key") : keys);
  atk_object_set_name (gtk_widget_get_accessible (widget), name);
}

static GtkWidget *
make_label (const char *text)
{
  return gtk_widget_new (GTK_TYPE_LABEL, "visible", TRUE, "label", text,
                         "xalign", 0.0, "wrap", TRUE, NULL);
}

static void
add_row (KeysDialog *self, const Action *action)
{
  GtkWidget *row = gtk_list_box_row_new ();
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 24);
  GtkWidget *sentence = make_label (_ (action->sentence));
  GtkWidget *keys = make_label (NULL);

  gtk_widget_set_hexpand (sentence, TRUE);
  gtk_style_context_add_class (gtk_widget_get_style_context (keys), "keys");
  gtk_container_add (GTK_CONTAINER (box), sentence);
  gtk_container_add (GTK_CONTAINER (box), keys);
  gtk_container_add (GTK_CONTAINER (row), box);
  g_object_set_data (G_OBJECT (row), "action", (gpointer)action);
  g_object_set_data (G_OBJECT (row), "keys", keys);
  gtk_widget_show_all (row);
  update_row (row, NULL);
  gtk_container_add (GTK_CONTAINER (self->list), row);
}

static void
add_rows (KeysDialog *self)
{
  guint n_actions;
  const Action *actions = action_table (&n_actions);

  for (guint group = 0; group < N_ACTION_GROUPS; group++)
    for (guint i = 0; i < n_actions; i++)
      if (keys_can_do (&actions[i]) && action_group_of (&actions[i]) == group)
        add_row (self, &actions[i]);
}

static void
put_heading (GtkListBoxRow *row, GtkListBoxRow *before, gpointer user)
{
  const guint group = action_group_of (action_of (row));
  GtkWidget *heading;

  (void)user;
  if (before != NULL && action_group_of (action_of (before)) == group) {
    gtk_list_box_row_set_header (row, NULL);
    return;
  }
  heading = make_label (action_group_title (group));
  gtk_style_context_add_class (gtk_widget_get_style_context (heading),
                               "heading");
  gtk_list_box_row_set_header (row, heading);
}

/* Search: words of the sentence, or a key. */

static gboolean
has_words (const char *text, const char *words)
{
  g_autofree char *folded = g_utf8_casefold (text, -1);

  return strstr (folded, words) != NULL;
}

static gboolean
is_wanted (GtkListBoxRow *row, gpointer user)
{
  const char *typed = gtk_entry_get_text (user);
  g_autofree char *words = g_utf8_casefold (typed, -1);

  return has_words (_ (action_of (row)->sentence), words)
         || has_words (gtk_label_get_text (label_of (row)), words);
}

static GtkListBoxRow *
first_row (KeysDialog *self)
{
  GtkListBoxRow *row;

  for (int i = 0; (row = gtk_list_box_get_row_at_index (self->list, i)) != NULL;
       i++)
    if (gtk_widget_get_child_visible (GTK_WIDGET (row)))
      return row;
  return NULL;
}

static void
on_search (GtkSearchEntry *entry, KeysDialog *self)
{
  (void)entry;
  gtk_list_box_invalidate_filter (self->list);
  gtk_list_box_select_row (self->list, first_row (self));
}

/* Enter in the search is Enter on what it has found. */
static void
on_search_activate (GtkEntry *entry, KeysDialog *self)
{
  (void)entry;
  gtk_widget_activate (self->change);
}

/* Escape ends the search first, then the dialog. */
static void
on_search_stop (GtkSearchEntry *entry, KeysDialog *self)
{
  if (gtk_entry_get_text_length (GTK_ENTRY (entry)) > 0)
    gtk_entry_set_text (GTK_ENTRY (entry), "");
  else
    gtk_window_close (GTK_WINDOW (self));
}

/* Changes */

static const Action *
chosen (KeysDialog *self)
{
  GtkListBoxRow *row = gtk_list_box_get_selected_row (self->list);

  return row == NULL ? NULL : action_of (row);
}

static void
update_buttons (KeysDialog *self)
{
  const Action *action = chosen (self);
  const gboolean has_keys = action != NULL && keys_of (action)[0] != NULL;

  gtk_widget_set_sensitive (self->change, action != NULL);
  gtk_widget_set_sensitive (self->add, has_keys);
  gtk_widget_set_sensitive (self->remove, has_keys);
  gtk_widget_set_sensitive (self->reset,
                            action != NULL && keys_are_own (action));
}

static void
on_selected (GtkListBox *list, GtkListBoxRow *row, KeysDialog *self)
{
  (void)list;
  (void)row;
  gtk_label_set_text (self->status, "");
  update_buttons (self);
}

static void
on_activated (GtkListBox *list, GtkListBoxRow *row, KeysDialog *self)
{
  (void)list;
  key_capture_ask (GTK_WINDOW (self), action_of (row), FALSE);
}

static void
on_change (GtkButton *button, KeysDialog *self)
{
  (void)button;
  key_capture_ask (GTK_WINDOW (self), chosen (self), FALSE);
}

static void
on_add (GtkButton *button, KeysDialog *self)
{
  (void)button;
  key_capture_ask (GTK_WINDOW (self), chosen (self), TRUE);
}

static void
on_remove (GtkButton *button, KeysDialog *self)
{
  static const char *const none[] = { NULL };

  (void)button;
  keys_set (chosen (self), none);
}

static void
say (KeysDialog *self, const char *words)
{
  gtk_label_set_text (self->status, words);
  announce (GTK_WIDGET (self->status), words);
}

/* A key that was given to another action stays there. */
static void
say_what_stays (KeysDialog *self, const Action *action)
{
  g_auto (GStrv) parts
      = g_strsplit (action->keys == NULL ? "" : action->keys, " ", -1);

  for (guint i = 0; parts[i] != NULL; i++) {
    const Action *other = keys_find_action (parts[i]);
    g_autofree char *key = keys_label (parts[i]);
    g_autofree char *words = NULL;

    if (other == NULL || other == action)
      continue;
    words = g_strdup_printf (_ ("%s stays with “%s”, to which you gave it."),
                             key, _ (other->sentence));
    say (self, words);
  }
}

static void
on_reset (GtkButton *button, KeysDialog *self)
{
  const Action *action = chosen (self);

  (void)button;
  keys_reset (action);
  say_what_stays (self, action);
}

static void
on_reset_all (GtkButton *button, KeysDialog *self)
{
  (void)button;
  keys_reset_all ();
  say (self, _ ("All actions have the keys they came with."));
}

void
keys_dialog_update (KeysDialog *self)
{
  gtk_label_set_text (self->status, "");
  gtk_container_foreach (GTK_CONTAINER (self->list), update_row, NULL);
  update_buttons (self);
}

/* Life */

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, KeysDialog, name)

static void
keys_dialog_class_init (KeysDialogClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/keys-dialog.ui");
  BIND (search);
  BIND (list);
  BIND (status);
  BIND (change);
  BIND (add);
  BIND (remove);
  BIND (reset);
  BIND (reset_all);
}

static void
keys_dialog_init (KeysDialog *self)
{
  gtk_widget_init_template (GTK_WIDGET (self));
  gtk_list_box_set_header_func (self->list, put_heading, NULL, NULL);
  gtk_list_box_set_filter_func (self->list, is_wanted, self->search, NULL);
  add_rows (self);
  g_signal_connect (self->search, "search-changed", G_CALLBACK (on_search),
                    self);
  g_signal_connect (self->search, "activate", G_CALLBACK (on_search_activate),
                    self);
  g_signal_connect (self->search, "stop-search", G_CALLBACK (on_search_stop),
                    self);
  g_signal_connect (self->list, "row-selected", G_CALLBACK (on_selected), self);
  g_signal_connect (self->list, "row-activated", G_CALLBACK (on_activated),
                    self);
  g_signal_connect (self->change, "clicked", G_CALLBACK (on_change), self);
  g_signal_connect (self->add, "clicked", G_CALLBACK (on_add), self);
  g_signal_connect (self->remove, "clicked", G_CALLBACK (on_remove), self);
  g_signal_connect (self->reset, "clicked", G_CALLBACK (on_reset), self);
  g_signal_connect (self->reset_all, "clicked", G_CALLBACK (on_reset_all),
                    self);
  g_signal_connect (self, "delete-event",
                    G_CALLBACK (gtk_widget_hide_on_delete), NULL);
  gtk_list_box_select_row (self->list, first_row (self));
}

GtkWidget *
keys_dialog_new (GtkWindow *parent)
{
  return g_object_new (KEYS_DIALOG_TYPE, "transient-for", parent,
                       "destroy-with-parent", TRUE, "modal", TRUE,
                       "use-header-bar", TRUE, NULL);
}
