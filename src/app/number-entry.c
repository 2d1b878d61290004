#include "number-entry.h"

#include "action.h"
#include "words.h"

#include <glib/gi18n.h>

typedef struct NumberEntry {
  Session *session; /* older than the popover */
  GtkWidget *popover, *entry, *fault;
} NumberEntry;

static gboolean
has_stops (Session *session)
{
  return session_get_n_stops (session) > 0;
}

static char *
question (Session *session)
{
  if (has_stops (session))
    return g_strdup_printf (_ ("Stop, 1 to %u:"),
                            session_get_n_stops (session));
  return g_strdup_printf (_ ("Step, 0 to %u:"), session_get_n_steps (session));
}

static gboolean
go (NumberEntry *self, GError **error)
{
  const char *text = gtk_entry_get_text (GTK_ENTRY (self->entry));
  guint64 number;

  if (words_parse_number (text, G_MAXUINT32, &number))
    return action_run (self->session,
                       has_stops (self->session) ? "stop" : "goto-step",
                       g_variant_new_uint32 ((guint32)number), error);
  g_set_error_literal (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                       _ ("type a whole number"));
  return FALSE;
}

static void
on_activate (NumberEntry *self)
{
  g_autoptr (GError) error = NULL;

  if (go (self, &error)) {
    gtk_popover_popdown (GTK_POPOVER (self->popover));
    return;
  }
  gtk_label_set_text (GTK_LABEL (self->fault), error->message);
  gtk_widget_show (self->fault);
  atk_object_set_description (gtk_widget_get_accessible (self->entry),
                              error->message);
}

static GtkWidget *
make_entry (const char *name)
{
  GtkWidget *entry = gtk_widget_new (
      GTK_TYPE_ENTRY, "visible", TRUE, "width-chars", 6, "max-length", 10,
      "input-purpose", GTK_INPUT_PURPOSE_DIGITS, NULL);

  atk_object_set_name (gtk_widget_get_accessible (entry), name);
  return entry;
}

static void
fill (NumberEntry *self)
{
  g_autofree char *text = question (self->session);
  GtkWidget *column = gtk_widget_new (GTK_TYPE_BOX, "visible", TRUE,
                                      "orientation", GTK_ORIENTATION_VERTICAL,
                                      "spacing", 6, "margin", 12, NULL);
  GtkWidget *row
      = gtk_widget_new (GTK_TYPE_BOX, "visible", TRUE, "spacing", 10, NULL);

  self->entry = make_entry (text);
  self->fault = gtk_widget_new (GTK_TYPE_LABEL, "wrap", TRUE, "xalign", 0.0,
                                "max-width-chars", 30, NULL);
  gtk_style_context_add_class (gtk_widget_get_style_context (self->fault),
                               "fault");
  gtk_container_add (
      GTK_CONTAINER (row),
      gtk_widget_new (GTK_TYPE_LABEL, "visible", TRUE, "label", text, NULL));
  gtk_container_add (GTK_CONTAINER (row), self->entry);
  gtk_container_add (GTK_CONTAINER (column), row);
  gtk_container_add (GTK_CONTAINER (column), self->fault);
  gtk_container_add (GTK_CONTAINER (self->popover), column);
}

/* Not while the popover speaks. */
static gboolean
destroy (gpointer popover)
{
  gtk_widget_destroy (popover);
  return G_SOURCE_REMOVE;
}

static void
on_closed (GtkWidget *popover)
{
  g_idle_add_full (G_PRIORITY_DEFAULT_IDLE, destroy, g_object_ref (popover),
                   g_object_unref);
}

void
number_entry_show (GtkWidget *at, Session *session)
{
  NumberEntry *self = g_new0 (NumberEntry, 1);

  self->session = session;
  self->popover = gtk_popover_new (at);
  gtk_style_context_add_class (gtk_widget_get_style_context (self->popover),
                               "coordinate-entry");
  gtk_popover_set_position (GTK_POPOVER (self->popover), GTK_POS_TOP);
  fill (self);
  g_object_set_data_full (G_OBJECT (self->popover), "number-entry", self,
                          g_free);
  g_signal_connect_swapped (self->entry, "activate", G_CALLBACK (on_activate),
                            self);
  g_signal_connect (self->popover, "closed", G_CALLBACK (on_closed), NULL);
  gtk_popover_popup (GTK_POPOVER (self->popover));
  gtk_widget_grab_focus (self->entry);
}
