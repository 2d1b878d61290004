#include "window-message.h"

#include "window-private.h"

/* Slow readers need as long as this for a letter, and to notice. */
#define LETTER_MS 60
#define NOTICE_MS 1000

#define CHANGES_OF_DOCUMENT                                                    \
  (CHANGED_SITES | CHANGED_LESSON | CHANGED_QUESTION | CHANGED_HISTORY)

/* Commands that lead to the same end: where one of them failed, another may do
 * what was wanted. All others are of a kind of their own. */
static const struct {
  const char *command, *kind;
} kinds[] = {
  { "open-file", "open" },       { "next-lesson", "open" },
  { "adapt-lesson", "open" },    { "new", "open" },
  { "restore-unsaved", "open" }, { "save-as", "save" },
  { "record-stop", "record" },   { "record-copy", "record" },
  { "clock-reset", "lecturer" },
};

static const char *
kind_of (const char *command)
{
  for (guint i = 0; i < G_N_ELEMENTS (kinds); i++)
    if (g_str_equal (command, kinds[i].command))
      return kinds[i].kind;
  return command;
}

static void
stop_waiting (Hull2vdWindow *window)
{
  if (window->message_source != 0)
    g_source_remove (window->message_source);
  window->message_source = 0;
}

static void
hide (Hull2vdWindow *window)
{
  stop_waiting (window);
  g_clear_pointer (&window->message_kind, g_free);
  gtk_info_bar_set_revealed (window->info_bar, FALSE);
}

void
window_message_say (Hull2vdWindow *window,
                    const char *command,
                    const char *message)
{
  stop_waiting (window);
  g_free (window->message_kind);
  window->message_kind = command == NULL ? NULL : g_strdup (kind_of (command));
  window->message_read_at
      = g_get_monotonic_time ()
        + (NOTICE_MS + LETTER_MS * (gint64)g_utf8_strlen (message, -1))
              * G_TIME_SPAN_MILLISECOND;
  gtk_label_set_text (window->info_label, message);
  gtk_info_bar_set_revealed (window->info_bar, TRUE);
}

void
hull2vd_window_say (Hull2vdWindow *window, const char *message)
{
  window_message_say (window, window->command, message);
}

void
window_message_settle (Hull2vdWindow *window, const char *command)
{
  if (window->message_kind != NULL
      && g_str_equal (window->message_kind, kind_of (command)))
    hide (window);
}

static gboolean
on_read (gpointer user)
{
  Hull2vdWindow *window = user;

  window->message_source = 0;
  hide (window);
  return G_SOURCE_REMOVE;
}

/* Who goes on has no more use for it, but must have had time to see why. */
static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  const gint64 rest = window->message_read_at - g_get_monotonic_time ();

  (void)session;
  if (window->message_kind == NULL || (changes & CHANGES_OF_DOCUMENT) == 0)
    return;
  if (rest <= 0)
    hide (window);
  else if (window->message_source == 0)
    window->message_source = g_timeout_add (
        (guint)(rest / G_TIME_SPAN_MILLISECOND) + 1, on_read, window);
}

static void
on_response (GtkInfoBar *bar, int response, Hull2vdWindow *window)
{
  (void)bar;
  (void)response;
  hide (window);
}

void
window_message_init (Hull2vdWindow *window)
{
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  g_signal_connect_object (window->info_bar, "response",
                           G_CALLBACK (on_response), window, 0);
}

void
window_message_end (Hull2vdWindow *window)
{
  stop_waiting (window);
  g_clear_pointer (&window->message_kind, g_free);
}
