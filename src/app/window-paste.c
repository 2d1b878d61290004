/* Points in text, pasted or dropped: of many a thread reads them. */
#include "window-private.h"

#include "point-import.h"

#include <glib/gi18n.h>
#include <string.h>

/* Points by the thousand. */
#define LONG_BYTES 100000

typedef struct Pasting {
  Hull2vdWindow *window;
  char *text;
  gsize length;
  const char *origin, *edit; /* never freed */
  SiteSet *set;
  ChoreTask *task;
} Pasting;

static void
pasting_free (gpointer data)
{
  Pasting *pasting = data;

  if (pasting->window->reading == pasting->task)
    pasting->window->reading = NULL;
  g_object_unref (pasting->window);
  g_clear_pointer (&pasting->set, site_set_free);
  g_free (pasting->text);
  g_free (pasting);
}

static gboolean
read_text (ChoreTask *task, gpointer data, GError **error)
{
  Pasting *pasting = data;

  (void)task;
  pasting->set = point_import_read_text (pasting->text, pasting->length,
                                         pasting->origin, error);
  return pasting->set != NULL;
}

static void
on_read (gpointer data, const GError *error)
{
  Pasting *pasting = data;
  Hull2vdWindow *window = pasting->window;
  g_autoptr (GError) refusal = NULL;

  window->reading = NULL;
  if (error != NULL)
    window_message_say (window, "paste", error->message);
  else if (!point_import_replace (window->session,
                                  g_steal_pointer (&pasting->set),
                                  pasting->edit, &refusal))
    window_message_say (window, "paste", refusal->message);
  else
    window_message_settle (window, "paste");
}

static void
read_later (Hull2vdWindow *window,
            const char *text,
            const char *origin,
            const char *edit)
{
  Pasting *pasting = g_new0 (Pasting, 1);

  pasting->window = g_object_ref (window);
  pasting->text = g_strdup (text);
  pasting->length = strlen (text);
  pasting->origin = origin;
  pasting->edit = edit;
  window->reading = pasting->task
      = chore_task_begin (window->session, _ ("The text is being read"),
                          read_text, on_read, pasting, pasting_free);
}

void
window_paste_text (Hull2vdWindow *window,
                   const char *text,
                   const char *origin,
                   const char *edit)
{
  g_autoptr (GError) error = NULL;

  window_files_stop_reading (window);
  if (strlen (text) > LONG_BYTES)
    read_later (window, text, origin, edit);
  else if (!point_import_text (window->session, text, origin, edit, &error))
    window_message_say (window, "paste", error->message);
  else
    window_message_settle (window, "paste");
}

static void
on_clipboard_text (GtkClipboard *clipboard, const char *text, gpointer user)
{
  g_autoptr (Hull2vdWindow) window = user;

  (void)clipboard;
  if (window->session == NULL)
    return;
  if (text == NULL)
    window_message_say (window, "paste", _ ("The clipboard holds no text"));
  else
    window_paste_text (window, text, _ ("clipboard"), _ ("paste"));
}

void
window_paste (Hull2vdWindow *window)
{
  gtk_clipboard_request_text (
      gtk_widget_get_clipboard (GTK_WIDGET (window), GDK_SELECTION_CLIPBOARD),
      on_clipboard_text, g_object_ref (window));
}
