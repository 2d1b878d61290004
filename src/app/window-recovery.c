#include "window-recovery.h"

#include "document.h"
#include "recovery.h"
#include "window-ask.h"
#include "window-private.h"

#include <glib/gi18n.h>

/* What a crash may cost, beside the time that writing takes. */
#define SOON_MS 2000

/* What a thread writes, for the window does not wait for the disk. */
typedef struct Job {
  Recovery *recovery;
  GBytes *sites; /* NULL: none that are anybody's */
  GBytes *saved; /* what is in the file; NULL: there is none */
  char *origin;
  GError *error;
  int is_over; /* atomic */
} Job;

struct WindowRecovery {
  Recovery *own;  /* what is edited here */
  Recovery *left; /* what is being offered, or NULL */
  GThread *thread;
  Job *job;
  guint soon;          /* the source of the next job */
  gboolean is_due;     /* changed since this one began */
  gboolean has_failed; /* told once */
};

/* Keeping */

static void
job_free (Job *job)
{
  g_clear_pointer (&job->sites, g_bytes_unref);
  g_clear_pointer (&job->saved, g_bytes_unref);
  g_free (job->origin);
  g_clear_error (&job->error);
  g_free (job);
}

static Job *
job_new (Hull2vdWindow *window)
{
  Job *job = g_new0 (Job, 1);

  job->recovery = window->recovery->own;
  /* A lesson is there to be played with. */
  if (session_get_lesson (window->session) != NULL)
    return job;
  job->sites = document_sites (window->session);
  job->saved = window->saved != NULL ? g_bytes_ref (window->saved) : NULL;
  job->origin = g_strdup (window->path);
  return job;
}

static gboolean
is_worth_keeping (const Job *job)
{
  return job->sites != NULL && g_bytes_get_size (job->sites) > 0
         && (job->saved == NULL || !g_bytes_equal (job->sites, job->saved));
}

static void
keep (Job *job)
{
  g_autofree char *text = NULL;

  if (!is_worth_keeping (job)) {
    recovery_clear (job->recovery);
    return;
  }
  text = document_sites_text (job->sites);
  recovery_write (job->recovery, job->origin, text, &job->error);
}

/* Waits for the job that is on its way, if there is one. */
static void
finish (Hull2vdWindow *window)
{
  WindowRecovery *recovery = window->recovery;

  if (recovery->thread == NULL)
    return;
  g_thread_join (g_steal_pointer (&recovery->thread));
  if (recovery->job->error != NULL && !recovery->has_failed) {
    recovery->has_failed = TRUE;
    window_message_say (window, NULL, recovery->job->error->message);
  }
  g_clear_pointer (&recovery->job, job_free);
}

static void touch (Hull2vdWindow *window);

/* The job may have been waited for, and another begun. */
static gboolean
on_over (gpointer user)
{
  Hull2vdWindow *window = user;
  WindowRecovery *recovery = window->recovery;

  if (recovery == NULL || recovery->thread == NULL
      || !g_atomic_int_get (&recovery->job->is_over))
    return G_SOURCE_REMOVE;
  finish (window);
  if (recovery->is_due)
    touch (window);
  return G_SOURCE_REMOVE;
}

static gpointer
work (gpointer user)
{
  Hull2vdWindow *window = user;
  Job *job = window->recovery->job;

  keep (job);
  g_atomic_int_set (&job->is_over, TRUE);
  g_idle_add_full (G_PRIORITY_DEFAULT_IDLE, on_over, window, g_object_unref);
  return NULL;
}

static gboolean
on_soon (gpointer user)
{
  Hull2vdWindow *window = user;
  WindowRecovery *recovery = window->recovery;

  recovery->soon = 0;
  recovery->is_due = FALSE;
  recovery->job = job_new (window);
  recovery->thread = g_thread_new ("recovery", work, g_object_ref (window));
  return G_SOURCE_REMOVE;
}

static void
touch (Hull2vdWindow *window)
{
  WindowRecovery *recovery = window->recovery;

  recovery->is_due = TRUE;
  if (recovery->soon == 0 && recovery->thread == NULL)
    recovery->soon = g_timeout_add (SOON_MS, on_soon, window);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if (changes & (CHANGED_SITES | CHANGED_LESSON))
    touch (window);
}

void
window_recovery_flush (Hull2vdWindow *window)
{
  WindowRecovery *recovery = window->recovery;
  Job *job;

  finish (window);
  if (!recovery->is_due)
    return;
  job = job_new (window);
  keep (job);
  job_free (job);
}

void
window_recovery_clear (Hull2vdWindow *window)
{
  finish (window);
  recovery_clear (window->recovery->own);
  g_clear_handle_id (&window->recovery->soon, g_source_remove);
  window->recovery->is_due = FALSE;
}

/* Offering */

static char *
describe (const Recovery *left)
{
  const char *origin = recovery_get_origin (left);
  g_autoptr (GDateTime) time = recovery_get_time (left);
  g_autofree char *name
      = origin != NULL ? g_filename_display_basename (origin) : NULL;
  g_autofree char *moment
      = time != NULL ? g_date_time_format (time, _ ("%-d %B %Y, %H:%M"))
                     : g_strdup ("");

  if (name != NULL)
    return g_strdup_printf (
        _ ("%s had changes that were not saved when the program ended: %s."),
        name, moment);
  return g_strdup_printf (
      _ ("New sites were not saved when the program ended: %s."), moment);
}

void
window_recovery_offer (Hull2vdWindow *window)
{
  g_autofree char *folder = recovery_default_folder ();
  g_autofree char *text = NULL;
  Recovery *left = recovery_claim (folder);

  window->recovery->left = left;
  gtk_widget_set_visible (GTK_WIDGET (window->recovery_bar), left != NULL);
  if (left == NULL)
    return;
  text = describe (left);
  gtk_label_set_text (window->recovery_label, text);
}

/* Says so, if there is nothing. */
static gboolean
is_offering (Hull2vdWindow *window)
{
  if (window->recovery->left != NULL)
    return TRUE;
  hull2vd_window_say (window, _ ("There are no unsaved sites to restore"));
  return FALSE;
}

static void
restore (Hull2vdWindow *window, const char *path)
{
  (void)path;
  if (window->recovery->left != NULL)
    window_files_load (window, recovery_get_path (window->recovery->left));
}

void
window_recovery_restore (Hull2vdWindow *window)
{
  if (is_offering (window))
    window_ask (window, ASK_OPEN, restore, NULL);
}

void
window_recovery_discard (Hull2vdWindow *window)
{
  if (!is_offering (window))
    return;
  recovery_clear (window->recovery->left);
  g_clear_pointer (&window->recovery->left, recovery_free);
  window_recovery_offer (window);
}

gboolean
window_recovery_take (Hull2vdWindow *window, const char *path, char **origin)
{
  WindowRecovery *recovery = window->recovery;

  if (recovery->left == NULL
      || !g_str_equal (path, recovery_get_path (recovery->left)))
    return FALSE;
  window_recovery_clear (window);
  recovery_free (recovery->own);
  recovery->own = g_steal_pointer (&recovery->left);
  *origin = g_strdup (recovery_get_origin (recovery->own));
  window_recovery_offer (window);
  return TRUE;
}

/* Life */

/* What is not answered is offered on the next start. */
static void
on_response (GtkInfoBar *bar, int response, Hull2vdWindow *window)
{
  (void)response;
  gtk_widget_hide (GTK_WIDGET (bar));
  g_clear_pointer (&window->recovery->left, recovery_free);
}

void
window_recovery_init (Hull2vdWindow *window)
{
  g_autofree char *folder = recovery_default_folder ();

  window->recovery = g_new0 (WindowRecovery, 1);
  window->recovery->own = recovery_new (folder);
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  g_signal_connect (window->recovery_bar, "response", G_CALLBACK (on_response),
                    window);
}

void
window_recovery_end (Hull2vdWindow *window)
{
  WindowRecovery *recovery = window->recovery;

  if (recovery == NULL)
    return;
  finish (window);
  g_clear_handle_id (&recovery->soon, g_source_remove);
  recovery_free (recovery->own);
  recovery_free (recovery->left);
  g_clear_pointer (&window->recovery, g_free);
}
