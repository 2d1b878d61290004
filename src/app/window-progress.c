/* Progress in lessons, and results, as the window has them. */
#include "window-private.h"

#include "lesson-list.h"
#include "progress-keeper.h"
#include "results-dialog.h"

#include <glib/gi18n.h>

static gboolean
say_message (gpointer user)
{
  Hull2vdWindow *window = user;
  g_autofree char *message = progress_keeper_take_message ();

  if (message != NULL && window->session != NULL)
    window_message_say (window, NULL, message);
  return G_SOURCE_REMOVE;
}

/* Not before the first lesson is there, which takes messages away. */
static void
say_later (Hull2vdWindow *window)
{
  g_idle_add_full (G_PRIORITY_LOW, say_message, g_object_ref (window),
                   g_object_unref);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if ((changes & (CHANGED_LESSON | CHANGED_QUESTION)) == 0)
    return;
  progress_keeper_touch ();
  say_message (window);
}

void
window_progress_init (Hull2vdWindow *window)
{
  session_set_progress (window->session, progress_keeper_get ());
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  say_later (window);
}

void
window_progress_clear (Hull2vdWindow *window)
{
  g_autofree char *kept = NULL, *text = NULL;

  progress_keeper_flush (); /* all of it is kept */
  kept = session_clear_progress (window->session);
  progress_keeper_flush ();
  text = kept == NULL
             ? g_strdup (_ ("Your progress in all lessons is forgotten."))
             : g_strdup_printf (_ ("Your progress in all lessons is forgotten. "
                                   "A copy is kept as %s."),
                                kept);
  hull2vd_window_say (window, text);
}

void
window_progress_export (Hull2vdWindow *window)
{
  progress_keeper_flush ();
  results_dialog_show (window, progress_keeper_get ());
}

void
window_progress_next_lesson (Hull2vdWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);
  g_autofree char *next
      = lesson == NULL ? NULL : lesson_list_next (lesson->path);

  if (next != NULL)
    window_files_open_path (window, next);
  else
    hull2vd_window_say (window, _ ("This is the last lesson."));
}
