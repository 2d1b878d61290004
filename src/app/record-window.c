#include "record-window.h"

#include <glib/gi18n.h>
#include <string.h>

/* While something is dragged the text need not follow each pixel. */
#define SETTLE_MS 120

struct _RecordWindow {
  GtkWindow parent_instance;
  Session *session;
  SessionRecord *record; /* borrowed; NULL: over */
  guint source;
  GtkTextView *text;
  GtkLabel *state;
  GtkStack *stack;
  GtkWidget *copy;
};

G_DEFINE_TYPE (RecordWindow, record_window, GTK_TYPE_WINDOW)

static char *
get_text (RecordWindow *window)
{
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (window->text);
  GtkTextIter start, end;

  gtk_text_buffer_get_bounds (buffer, &start, &end);
  return gtk_text_buffer_get_text (buffer, &start, &end, FALSE);
}

/* The end is what was done last. */
static void
scroll_to_end (RecordWindow *window)
{
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (window->text);
  GtkTextIter end;

  gtk_text_buffer_get_end_iter (buffer, &end);
  gtk_text_buffer_place_cursor (buffer, &end);
  gtk_text_view_scroll_mark_onscreen (window->text,
                                      gtk_text_buffer_get_insert (buffer));
}

static void
update (RecordWindow *window)
{
  g_autofree char *now = get_text (window);
  g_autofree char *text = NULL;

  if (window->record == NULL)
    return;
  text = session_record_text (window->record);
  gtk_stack_set_visible_child_name (window->stack,
                                    *text == '\0' ? "nothing" : "text");
  gtk_widget_set_sensitive (window->copy, *text != '\0');
  if (g_str_equal (now, text))
    return;
  gtk_text_buffer_set_text (gtk_text_view_get_buffer (window->text), text, -1);
  scroll_to_end (window);
}

static gboolean
on_settled (gpointer user)
{
  RecordWindow *window = user;

  window->source = 0;
  update (window);
  return G_SOURCE_REMOVE;
}

static void
on_changed (Session *session, guint changes, RecordWindow *window)
{
  (void)session;
  (void)changes;
  if (window->record != NULL && window->source == 0)
    window->source = g_timeout_add (SETTLE_MS, on_settled, window);
}

void
record_window_set_record (RecordWindow *window, SessionRecord *record)
{
  if (record == NULL)
    update (window);
  window->record = record;
  gtk_label_set_text (window->state,
                      record != NULL
                          ? _ ("Recording what you do in the pictures")
                          : _ ("Recorded. Paste it into a lesson."));
  update (window);
}

void
record_window_copy (RecordWindow *window)
{
  g_autofree char *text = NULL;

  update (window);
  text = get_text (window);
  if (*text != '\0')
    gtk_clipboard_set_text (
        gtk_widget_get_clipboard (GTK_WIDGET (window), GDK_SELECTION_CLIPBOARD),
        text, -1);
}

RecordWindow *
record_window_new (GtkApplicationWindow *parent, Session *session)
{
  RecordWindow *window
      = g_object_new (RECORD_WINDOW_TYPE, "transient-for", parent,
                      "destroy-with-parent", TRUE, NULL);

  window->session = g_object_ref (session);
  gtk_widget_insert_action_group (GTK_WIDGET (window), "win",
                                  G_ACTION_GROUP (parent));
  /* After the record itself has followed. */
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), window,
                           G_CONNECT_AFTER);
  return window;
}

static gboolean
record_window_key_press (GtkWidget *widget, GdkEventKey *event)
{
  if (GTK_WIDGET_CLASS (record_window_parent_class)
          ->key_press_event (widget, event))
    return TRUE;
  if (event->keyval != GDK_KEY_Escape)
    return FALSE;
  gtk_window_close (GTK_WINDOW (widget));
  return TRUE;
}

static void
record_window_dispose (GObject *object)
{
  RecordWindow *window = HULL2VD_RECORD_WINDOW (object);

  g_clear_handle_id (&window->source, g_source_remove);
  g_clear_object (&window->session);
  G_OBJECT_CLASS (record_window_parent_class)->dispose (object);
}

static void
record_window_class_init (RecordWindowClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = record_window_dispose;
  widget_class->key_press_event = record_window_key_press;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/record-window.ui");
  gtk_widget_class_bind_template_child (widget_class, RecordWindow, text);
  gtk_widget_class_bind_template_child (widget_class, RecordWindow, state);
  gtk_widget_class_bind_template_child (widget_class, RecordWindow, stack);
  gtk_widget_class_bind_template_child (widget_class, RecordWindow, copy);
}

static void
record_window_init (RecordWindow *window)
{
  gtk_widget_init_template (GTK_WIDGET (window));
}
