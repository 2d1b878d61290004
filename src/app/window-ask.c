#include "window-ask.h"

#include <glib/gi18n.h>

/* What waits for an answer. */
typedef struct Pending {
  AskThen then;
  char *path;
} Pending;

static const struct {
  const char *question, *discard;
} words[] = {
  [ASK_CLOSE]
  = { N_ ("Save the sites before closing?"), N_ ("Close _without Saving") },
  [ASK_NEW] = { N_ ("Save the sites before starting over?"),
                N_ ("Start Over _without Saving") },
  [ASK_OPEN] = { N_ ("Save the sites before opening others?"),
                 N_ ("Open _without Saving") },
};

static void
pending_free (gpointer data)
{
  Pending *pending = data;

  g_free (pending->path);
  g_free (pending);
}

void
window_ask_forget (Hull2vdWindow *window)
{
  g_object_set_data (G_OBJECT (window), "pending", NULL);
}

void
window_ask_saved (Hull2vdWindow *window)
{
  Pending *pending = g_object_steal_data (G_OBJECT (window), "pending");

  if (pending == NULL)
    return;
  pending->then (window, pending->path);
  pending_free (pending);
}

static void
on_answer (GtkDialog *dialog, int answer, Hull2vdWindow *window)
{
  gtk_widget_destroy (GTK_WIDGET (dialog));
  if (answer == GTK_RESPONSE_ACCEPT)
    window_files_save_now (window);
  else if (answer == GTK_RESPONSE_REJECT)
    window_ask_saved (window);
  else
    window_ask_forget (window);
}

static void
show_question (Hull2vdWindow *window, AskWhy why)
{
  GtkWidget *dialog = gtk_message_dialog_new (
      GTK_WINDOW (window), GTK_DIALOG_MODAL | GTK_DIALOG_USE_HEADER_BAR,
      GTK_MESSAGE_QUESTION, GTK_BUTTONS_NONE, "%s", _ (words[why].question));

  gtk_message_dialog_format_secondary_text (GTK_MESSAGE_DIALOG (dialog),
                                            _ ("Unsaved sites will be lost."));
  gtk_dialog_add_buttons (GTK_DIALOG (dialog), _ (words[why].discard),
                          GTK_RESPONSE_REJECT, _ ("_Cancel"),
                          GTK_RESPONSE_CANCEL, _ ("_Save"), GTK_RESPONSE_ACCEPT,
                          NULL);
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
  gtk_style_context_add_class (
      gtk_widget_get_style_context (gtk_dialog_get_widget_for_response (
          GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT)),
      GTK_STYLE_CLASS_SUGGESTED_ACTION);
  g_signal_connect (dialog, "response", G_CALLBACK (on_answer), window);
  gtk_widget_show (dialog);
}

void
window_ask (Hull2vdWindow *window, AskWhy why, AskThen then, const char *path)
{
  const gboolean is_modified = window_files_is_modified (window);
  Pending *pending;

  if (is_modified && window_dialog_refuse (window, path))
    return;
  pending = g_new0 (Pending, 1);
  pending->then = then;
  pending->path = g_strdup (path);
  g_object_set_data_full (G_OBJECT (window), "pending", pending, pending_free);
  if (is_modified)
    show_question (window, why);
  else
    window_ask_saved (window);
}
