/* What threads of others work on: told of as long as it lasts, and given up
 * when the person wants that. */
#include "session-chore.h"

#include "session-private.h"

typedef struct Chore {
  guint number;
  char *sentence;
  SessionGiveUp give_up; /* NULL: it has been asked to */
  gpointer user;
} Chore;

static void
chore_clear (gpointer data)
{
  g_free (((Chore *)data)->sentence);
}

void
session_chores_init (Session *session)
{
  session->chores = g_array_new (FALSE, FALSE, sizeof (Chore));
  g_array_set_clear_func (session->chores, chore_clear);
}

void
session_chores_clear (Session *session)
{
  g_array_unref (session->chores);
}

guint
session_begin_chore (Session *session,
                     const char *sentence,
                     SessionGiveUp give_up,
                     gpointer user)
{
  const Chore chore
      = { ++session->n_chores, g_strdup (sentence), give_up, user };

  g_array_append_val (session->chores, chore);
  session_tell (session, CHANGED_WORK);
  return chore.number;
}

void
session_end_chore (Session *session, guint number)
{
  for (guint i = 0; i < session->chores->len; i++)
    if (g_array_index (session->chores, Chore, i).number == number) {
      g_array_remove_index (session->chores, i);
      session_tell (session, CHANGED_WORK);
      return;
    }
}

/* Returns: the last one that is wanted, or NULL. */
static Chore *
last_wanted (Session *session)
{
  for (guint i = session->chores->len; i > 0; i--) {
    Chore *chore = &g_array_index (session->chores, Chore, i - 1);

    if (chore->give_up != NULL)
      return chore;
  }
  return NULL;
}

const char *
session_get_chore (Session *session)
{
  const Chore *chore = last_wanted (session);

  return chore != NULL ? chore->sentence : NULL;
}

gboolean
session_give_up (Session *session)
{
  const gboolean is_working = session_is_working (session, NULL);
  Chore *chore = last_wanted (session);

  if (chore == NULL && !is_working)
    return FALSE;
  session_hold (session);
  session_cancel (session);
  for (; chore != NULL; chore = last_wanted (session)) {
    SessionGiveUp give_up = chore->give_up;

    chore->give_up = NULL;
    session_tell (session, CHANGED_WORK);
    give_up (chore->user);
  }
  session_release (session);
  return TRUE;
}
