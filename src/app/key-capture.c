#include "key-capture.h"

#include "announcement.h"
#include "canvas-keys.h"
#include "keys.h"

#include <glib/gi18n.h>

typedef struct Capture {
  const Action *action;
  gboolean is_added;
  char *key; /* pressed, and another action has it; NULL: none yet */
  GtkLabel *words;
  GtkWidget *dialog, *take;
} Capture;

/* As GTK writes accelerators: Shift belongs to a key only where it does not
 * make another one of it. */
static char *
read_key (const GdkEventKey *event)
{
  GdkKeymap *keymap
      = gdk_keymap_get_for_display (gdk_window_get_display (event->window));
  GdkModifierType modifiers
      = event->state & gtk_accelerator_get_default_mod_mask ();
  GdkModifierType consumed = 0;
  guint value = event->keyval;

  gdk_keymap_translate_keyboard_state (
      keymap, event->hardware_keycode, event->state & ~GDK_LOCK_MASK,
      event->group, &value, NULL, NULL, &consumed);
  modifiers &= ~consumed;
  if (value == GDK_KEY_ISO_Left_Tab)
    value = GDK_KEY_Tab;
  if (gdk_keyval_to_lower (value) != value
      || (event->state & GDK_SHIFT_MASK & ~consumed) != 0)
    modifiers |= GDK_SHIFT_MASK;
  return gtk_accelerator_name (gdk_keyval_to_lower (value), modifiers);
}

static void
say (Capture *capture, const char *words)
{
  gtk_label_set_text (capture->words, words);
  announce (GTK_WIDGET (capture->words), words);
}

static void
give (Capture *capture, const char *key)
{
  const char *const *had = keys_of (capture->action);
  g_autoptr (GStrvBuilder) keys = g_strv_builder_new ();
  g_auto (GStrv) all = NULL;

  for (guint i = 0; capture->is_added && had[i] != NULL; i++)
    g_strv_builder_add (keys, had[i]);
  g_strv_builder_add (keys, key);
  all = g_strv_builder_end (keys);
  keys_set (capture->action, (const char *const *)all);
}

/* Says what another action loses, and waits for the button. */
static void
ask_whether_to_take (Capture *capture, const char *key, const Action *other)
{
  g_autofree char *label = keys_label (key);
  g_autofree char *words
      = g_strdup_printf (_ ("%s is a key of “%s”, which will lose it."), label,
                         _ (other->sentence));

  g_free (capture->key);
  capture->key = g_strdup (key);
  say (capture, words);
  gtk_widget_show (capture->take);
  gtk_widget_grab_focus (capture->take);
}

static void
refuse (Capture *capture, const char *key)
{
  g_autofree char *label = keys_label (key);
  g_autofree char *words = g_strdup_printf (
      _ ("%s has a use of its own in the window. Press another key."), label);

  g_clear_pointer (&capture->key, g_free);
  gtk_widget_hide (capture->take);
  say (capture, words);
}

/* Keys that go about in any window, and those that pictures keep. */
static gboolean
is_kept (const char *key)
{
  GdkModifierType modifiers;
  guint value;

  gtk_accelerator_parse (key, &value, &modifiers);
  return value == GDK_KEY_Tab || value == GDK_KEY_Menu
         || (value == GDK_KEY_F10 && modifiers == GDK_SHIFT_MASK)
         || canvas_keeps_key (value, modifiers);
}

static void
take_key (Capture *capture, const char *key)
{
  const Action *other = keys_find_action (key);

  if (is_kept (key))
    refuse (capture, key);
  else if (other != NULL && other != capture->action)
    ask_whether_to_take (capture, key, other);
  else {
    /* A key that it has already is not added again. */
    if (other == NULL || !capture->is_added)
      give (capture, key);
    gtk_dialog_response (GTK_DIALOG (capture->dialog), GTK_RESPONSE_CANCEL);
  }
}

/* With the question, these press its buttons. */
static gboolean
is_for_buttons (guint value)
{
  return value == GDK_KEY_Return || value == GDK_KEY_KP_Enter
         || value == GDK_KEY_space || value == GDK_KEY_Tab
         || value == GDK_KEY_ISO_Left_Tab;
}

static gboolean
on_key_press (GtkWidget *widget, GdkEventKey *event, Capture *capture)
{
  g_autofree char *key = NULL;

  (void)widget;
  if (event->is_modifier
      || (capture->key != NULL && is_for_buttons (event->keyval)))
    return GDK_EVENT_PROPAGATE;
  key = read_key (event);
  if (g_str_equal (key, "Escape"))
    return GDK_EVENT_PROPAGATE; /* the dialog closes */
  take_key (capture, key);
  return GDK_EVENT_STOP;
}

static void
on_response (GtkDialog *dialog, int response, Capture *capture)
{
  if (response == GTK_RESPONSE_ACCEPT && capture->key != NULL)
    give (capture, capture->key);
  gtk_widget_destroy (GTK_WIDGET (dialog));
}

static void
capture_free (gpointer data, GClosure *closure)
{
  Capture *capture = data;

  (void)closure;
  g_free (capture->key);
  g_free (capture);
}

static void
add_words (Capture *capture)
{
  GtkWidget *box = gtk_dialog_get_content_area (GTK_DIALOG (capture->dialog));
  GtkWidget *sentence = gtk_widget_new (
      GTK_TYPE_LABEL, "visible", TRUE, "label", _ (capture->action->sentence),
      "wrap", TRUE, "max-width-chars", 44, NULL);

  capture->words = GTK_LABEL (
      gtk_widget_new (GTK_TYPE_LABEL, "visible", TRUE, "label",
                      _ ("Press the new key. Escape changes nothing."), "wrap",
                      TRUE, "width-chars", 44, "max-width-chars", 44, NULL));
  gtk_style_context_add_class (gtk_widget_get_style_context (sentence),
                               "heading");
  gtk_container_add (GTK_CONTAINER (box), sentence);
  gtk_container_add (GTK_CONTAINER (box), GTK_WIDGET (capture->words));
}

void
key_capture_ask (GtkWindow *parent, const Action *action, gboolean is_added)
{
  Capture *capture = g_new0 (Capture, 1);

  capture->action = action;
  capture->is_added = is_added;
  capture->dialog = gtk_dialog_new_with_buttons (
      is_added ? _ ("One More Key") : _ ("New Key"), parent,
      GTK_DIALOG_MODAL | GTK_DIALOG_DESTROY_WITH_PARENT
          | GTK_DIALOG_USE_HEADER_BAR,
      _ ("_Cancel"), GTK_RESPONSE_CANCEL, _ ("_Take the Key"),
      GTK_RESPONSE_ACCEPT, NULL);
  capture->take = gtk_dialog_get_widget_for_response (
      GTK_DIALOG (capture->dialog), GTK_RESPONSE_ACCEPT);
  gtk_widget_hide (capture->take);
  gtk_window_set_resizable (GTK_WINDOW (capture->dialog), FALSE);
  gtk_style_context_add_class (gtk_widget_get_style_context (capture->dialog),
                               "hull2vd");
  gtk_style_context_add_class (gtk_widget_get_style_context (capture->dialog),
                               "key-capture");
  add_words (capture);
  g_signal_connect (capture->dialog, "key-press-event",
                    G_CALLBACK (on_key_press), capture);
  g_signal_connect_data (capture->dialog, "response", G_CALLBACK (on_response),
                         capture, capture_free, 0);
  gtk_window_present (GTK_WINDOW (capture->dialog));
}
