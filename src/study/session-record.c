#include "session-record.h"

#include "record-lines.h"
#include "session-private.h"

#include <glib/gi18n.h>
#include <string.h>

struct SessionRecord {
  Session *session;
  gulong handler;
  Session *shadow;      /* carries out what is recorded */
  StopState *base;      /* where the current stop begins; NULL: no sites yet */
  StopState *now;       /* of the session */
  ThemeKind theme;      /* shown now */
  guint stop;           /* of the lesson */
  gboolean is_dressed;  /* something else than time has changed since base */
  GString *head, *done; /* text of the lesson's beginning and of whole stops */
  guint n_stops;
};

/* Without a lesson the first sites make one. */
static void
begin_lesson (SessionRecord *record)
{
  const guint n_sites = record->now->run->set->n_sites;
  g_autofree Site *sites = run_given (record->now->run);
  g_autofree char *text = record_sites_text (sites, n_sites);

  if (n_sites == 0 || !session_set_sites (record->shadow, sites, n_sites, NULL))
    return;
  session_put_step (record->shadow, 0);
  record->base = session_get_state (record->shadow);
  g_string_printf (record->head,
                   "# %s\n\n```lesson\nformat 1\nsites %s\n```\n\n",
                   _ ("A recorded lesson"), text);
}

static void
begin (SessionRecord *record)
{
  Session *session = record->session;

  if (session->lesson == NULL) {
    begin_lesson (record);
    return;
  }
  session_put_state (record->shadow, NULL,
                     lesson_stop (session->lesson, session->stop)->state);
  record->base = session_get_state (record->shadow);
}

/* Writes the current stop; the shadow stands at its end then.
 *
 * Returns: whether there is something in it. */
static gboolean
write_stop (SessionRecord *record, GString *text)
{
  g_autoptr (GPtrArray) lines = NULL;
  g_autofree char *sentence = NULL;

  if (record->base == NULL)
    return FALSE;
  session_put_state (record->shadow, NULL, record->base);
  record->shadow->n_sites_made = 0;
  lines = record_lines (record->shadow, record->now, record->theme);
  if (lines->len == 0)
    return FALSE;
  sentence = session_narrate (record->shadow);
  g_string_append_printf (text, _ ("## Recorded stop %u"), record->n_stops + 1);
  g_string_append_printf (text, "\n\n%s\n\n```steps\n", sentence);
  for (guint i = 0; i < lines->len; i++)
    g_string_append_printf (text, "%s\n",
                            (const char *)g_ptr_array_index (lines, i));
  g_string_append (text, "```\n\n");
  return TRUE;
}

void
session_record_cut (SessionRecord *record)
{
  record->is_dressed = FALSE;
  if (!write_stop (record, record->done))
    return;
  record->n_stops += 1;
  stop_state_free (record->base);
  record->base = session_get_state (record->shadow);
}

char *
session_record_text (SessionRecord *record)
{
  GString *text = g_string_new (NULL);

  if (record->base != NULL) {
    g_string_append (text, record->head->str);
    g_string_append (text, record->done->str);
    write_stop (record, text);
  }
  return g_string_free (text, FALSE);
}

/* Following */

static gboolean
are_same (const double *a, const double *b, guint n)
{
  for (guint i = 0; i < n; i++)
    if (a[i] != b[i])
      return FALSE;
  return TRUE;
}

static gboolean
is_same_look (const SceneLook *a, const SceneLook *b)
{
  return a->layers == b->layers && a->focus == b->focus && a->lift == b->lift
         && a->raise == b->raise
         && are_same (a->body_fade, b->body_fade, N_BODIES)
         && are_same (a->role_fade, b->role_fade, N_ROLES)
         && object_equal (a->selection, b->selection)
         && object_equal (a->measured, b->measured);
}

/* Whether all but the time is the same. */
static gboolean
is_same_dress (const StopState *a, const StopState *b)
{
  return a->run == b->run && a->exhibit_kind == b->exhibit_kind
         && is_same_look (&a->look, &b->look)
         && camera_equal (&a->camera, &b->camera) && a->views == b->views
         && a->listing == b->listing && a->compares_space == b->compares_space
         && memcmp (&a->turn, &b->turn, sizeof a->turn) == 0;
}

static gboolean
is_same_time (const StopState *a, const StopState *b)
{
  return a->run != b->run || a->exhibit_kind != b->exhibit_kind
         || (a->exhibit_kind <= EXHIBIT_COMPARE
                 ? a->step == b->step
                 : a->exhibit_step == b->exhibit_step);
}

static void
on_changed (Session *session, guint changes, SessionRecord *record)
{
  StopState *now;
  const ThemeKind theme = session->appearance.theme;
  const gboolean is_other_stop
      = (changes & CHANGED_LESSON) != 0 && session->stop != record->stop;

  if (session->is_replaying)
    return;
  now = session_get_state (session);
  if (is_other_stop || (record->is_dressed && !is_same_time (record->now, now)))
    session_record_cut (record);
  if (!is_same_dress (record->now, now) || theme != record->theme)
    record->is_dressed = TRUE;
  stop_state_free (record->now);
  record->now = now;
  record->theme = theme;
  record->stop = session->stop;
  if (record->base == NULL)
    begin_lesson (record);
}

SessionRecord *
session_record_new (Session *session)
{
  SessionRecord *record = g_new0 (SessionRecord, 1);

  record->session = g_object_ref (session);
  record->head = g_string_new (NULL);
  record->done = g_string_new (NULL);
  record->now = session_get_state (session);
  record->theme = session->appearance.theme;
  record->stop = session->stop;
  record->shadow = session_new ();
  record->shadow->is_replaying = TRUE;
  session_set_own_appearance (record->shadow, &session->own);
  begin (record);
  record->handler
      = g_signal_connect (session, "changed", G_CALLBACK (on_changed), record);
  return record;
}

void
session_record_free (SessionRecord *record)
{
  g_signal_handler_disconnect (record->session, record->handler);
  g_object_unref (record->session);
  g_object_unref (record->shadow);
  g_clear_pointer (&record->base, stop_state_free);
  stop_state_free (record->now);
  g_string_free (record->head, TRUE);
  g_string_free (record->done, TRUE);
  g_free (record);
}
