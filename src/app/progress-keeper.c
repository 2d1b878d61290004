#include "progress-keeper.h"

/* What a crash may cost. */
#define SOON_MS 2000

static Progress *kept;
static char *message;
static gboolean has_failed; /* to write: told once */
static guint source;

Progress *
progress_keeper_get (void)
{
  if (kept == NULL) {
    g_autofree char *path = progress_default_path ();

    kept = progress_new (path);
    message = progress_open (kept);
  }
  return kept;
}

char *
progress_keeper_take_message (void)
{
  return g_steal_pointer (&message);
}

void
progress_keeper_flush (void)
{
  g_autoptr (GError) error = NULL;

  g_clear_handle_id (&source, g_source_remove);
  if (kept == NULL || progress_write (kept, &error) || has_failed)
    return;
  has_failed = TRUE;
  g_free (message);
  message = g_strdup (error->message);
}

static gboolean
on_soon (gpointer user)
{
  (void)user;
  source = 0;
  progress_keeper_flush ();
  return G_SOURCE_REMOVE;
}

void
progress_keeper_touch (void)
{
  if (source == 0 && kept != NULL && kept->is_changed)
    source = g_timeout_add (SOON_MS, on_soon, NULL);
}
