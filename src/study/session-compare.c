/* A second run of the same sites in another order, in step by round. */
#include "session-private.h"

#include "laws.h"
#include "narration-template.h"
#include "quantity.h"

#include <glib/gi18n.h>
#include <string.h>

#define OTHER "other-"

Order
session_get_other_order (Session *session)
{
  return session->other_order;
}

static void
drop_other (Session *session)
{
  g_clear_pointer (&session->other_frame, kept_frame_unref);
  g_clear_pointer (&session->other, run_unref);
}

void
session_renew_other (Session *session)
{
  drop_other (session);
}

static gboolean
is_same_order (const Order *a, const Order *b)
{
  return a->kind == b->kind && a->seed == b->seed;
}

void
session_put_other_order (Session *session, const Order *order)
{
  if (is_same_order (order, &session->other_order))
    return;
  drop_other (session);
  session->other_order = *order;
  session_tell (session, CHANGED_EXHIBIT | CHANGED_SITES | CHANGED_STEP);
}

gboolean
session_defer_compare (Session *session, const Order orders[2])
{
  const Order order = session->run->trace->order;
  g_autofree Site *sites = NULL;
  Edit edit = { .kind = EDIT_COMPARE,
                .n_sites = session->run->set->n_sites,
                .order = orders[0],
                .other = orders[1] };

  if (session->ready_other != NULL
      || (session->other != NULL && is_same_order (&order, &orders[0])
          && is_same_order (&session->other_order, &orders[1])))
    return FALSE;
  sites = run_given (session->run);
  edit.sites = sites;
  return session_defer (session, &edit);
}

void
session_compare (Session *session, const Order orders[2])
{
  if (session_defer_compare (session, orders))
    return;
  session_hold (session);
  session_put_exhibit (session, EXHIBIT_LIFTS, session->step);
  session_set_order (session, &orders[0]);
  session_put_other_order (session, &orders[1]);
  session_put_exhibit (session, EXHIBIT_COMPARE, session->step);
  if (session->is_replaying)
    session->n_sites_made += session->run->set->n_sites;
  session_release (session);
}

void
session_take_ready_other (Session *session)
{
  const Run *ready = session->ready_other;

  if (session->exhibit_kind == EXHIBIT_COMPARE && session->other == NULL
      && ready != NULL
      && is_same_order (&ready->trace->order, &session->other_order)
      && run_has_sites_of (session->run, ready))
    session->other = g_steal_pointer (&session->ready_other);
}

static Run *
get_other (Session *session)
{
  g_autofree Site *sites = NULL;

  session_take_ready_other (session);
  if (session->other != NULL)
    return session->other;
  sites = run_given (session->run);
  /* They have a run already, so they have another. */
  session->other
      = run_new (sites, session->run->set->n_sites, &session->other_order);
  return session->other;
}

const Trace *
session_get_other_trace (Session *session)
{
  return get_other (session)->trace;
}

/* As far into the same phase of the same round; where the one run is at the
 * end of a phase, so is the other. */
guint
session_other_step_of (const Run *run, guint step, const Run *other)
{
  const Place place = timeline_place (run->trace, step);
  guint end, other_end;

  if (timeline_find (run->trace, place, false, &end) && end == step
      && timeline_find (other->trace, place, false, &other_end))
    return other_end;
  return run_same_place (run, step, other);
}

guint
session_get_other_step (Session *session)
{
  return session_other_step_of (session->run, session->step,
                                get_other (session));
}

/* Returns: (transfer full): what a thread has made, if it is for this. */
static KeptFrame *
take_ready_other_frame (Session *session, guint step)
{
  const KeptFrame *ready = session->ready_other_frame;

  return ready != NULL && ready->frame.trace == session->other->trace
                 && ready->frame.step == step
             ? g_steal_pointer (&session->ready_other_frame)
             : NULL;
}

KeptFrame *
session_keep_other_frame (Session *session)
{
  const guint step = session_get_other_step (session);

  if (session->other_frame != NULL && session->other_frame->frame.step == step)
    return session->other_frame;
  g_clear_pointer (&session->other_frame, kept_frame_unref);
  session->other_frame = take_ready_other_frame (session, step);
  if (session->other_frame == NULL)
    session->other_frame
        = kept_frame_new (session_get_other_trace (session), step);
  kept_frame_share (session->other_frame, get_other (session));
  return session->other_frame;
}

const Frame *
session_get_other_frame (Session *session)
{
  return &session_keep_other_frame (session)->frame;
}

gboolean
session_get_compares_space (Session *session)
{
  return session->compares_space;
}

void
session_set_compares_space (Session *session, gboolean space)
{
  if (space == session->compares_space)
    return;
  session->compares_space = space;
  session_tell (session, CHANGED_EXHIBIT | CHANGED_LOOK);
}

/* Numbers */

InsertionCost
session_get_cost (Session *session, guint pane)
{
  return pane == 0 ? insertion_cost (session->run->trace, session->step)
                   : insertion_cost (session_get_other_trace (session),
                                     session_get_other_step (session));
}

static gboolean
count_cost (const InsertionCost *cost, const char *key, guint *count)
{
  const struct {
    const char *key;
    guint count;
  } rows[] = {
    { "facets-created", cost->facets_created },
    { "facets-seen", cost->facets_seen },
    { "redistributions", cost->redistributions },
    { "cone-facets", cost->cone_facets },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    if (g_str_equal (key, rows[i].key)) {
      *count = rows[i].count;
      return TRUE;
    }
  return FALSE;
}

gboolean
session_count_run (Session *session, const char *key, guint *count)
{
  const gboolean is_other = g_str_has_prefix (key, OTHER);
  InsertionCost cost;
  Quantity quantity;

  if (is_other && session->exhibit_kind != EXHIBIT_COMPARE)
    return FALSE;
  if (is_other)
    key += strlen (OTHER);
  cost = session_get_cost (session, is_other ? 1 : 0);
  if (count_cost (&cost, key, count))
    return TRUE;
  if (!quantity_parse (key, &quantity))
    return FALSE;
  *count = quantity_value (is_other ? session_get_other_frame (session)
                                    : session_get_frame (session),
                           quantity);
  return TRUE;
}

static void
add_both (GPtrArray *laws, const char *key, const char *name, guint a, guint b)
{
  /* Translators: the counts of two runs, beside each other. */
  laws_add (laws, key, name, _ ("%u | %u"), a, b);
}

#define DECIMALS_ROOM G_ASCII_DTOSTR_BUF_SIZE

/* The same in every language, as in the pictures. */
static void
write_decimals (double number, char text[DECIMALS_ROOM])
{
  g_ascii_formatd (text, DECIMALS_ROOM, "%.2f", number);
}

GPtrArray *
session_compare_laws (Session *session)
{
  char left[DECIMALS_ROOM], right[DECIMALS_ROOM];
  const InsertionCost a = session_get_cost (session, 0);
  const InsertionCost b = session_get_cost (session, 1);
  GPtrArray *laws = laws_new ();

  add_both (laws, "facets", _ ("facets"),
            session_get_frame (session)->counts.facets,
            session_get_other_frame (session)->counts.facets);
  add_both (laws, "facets-created", _ ("facets created"), a.facets_created,
            b.facets_created);
  add_both (laws, "facets-seen", _ ("found visible"), a.facets_seen,
            b.facets_seen);
  add_both (laws, "redistributions", _ ("handed over"), a.redistributions,
            b.redistributions);
  if (a.n_cones == 0)
    return laws;
  write_decimals ((double)a.cone_facets / a.n_cones, left);
  write_decimals (b.n_cones == 0 ? 0 : (double)b.cone_facets / b.n_cones,
                  right);
  laws_add (laws, "cone-mean", _ ("mean cone"), "%s | %s", left, right);
  write_decimals (a.expected_cone, left);
  laws_add (laws, "cone-expected", _ ("random order: 6 − 12/k"), "%s", left);
  return laws;
}

/* Words */

static const char *
translate (const char *english)
{
  return _ (english);
}

char *
session_narrate_pane (Session *session, guint pane)
{
  char text[NARRATION_ROOM];

  if (pane == 0)
    narration_write (session->run->trace, session->step, translate, text);
  else
    narration_write (session_get_other_trace (session),
                     session_get_other_step (session), translate, text);
  return g_strdup (text);
}

guint
session_get_pane_apex (Session *session, guint pane)
{
  const Frame *frame = pane == 0 ? session_get_frame (session)
                                 : session_get_other_frame (session);

  return frame->round == INDEX_NONE ? INDEX_NONE
                                    : frame->trace->rounds[frame->round].site;
}

static const char *
compare_template (Session *session, const guint apex[2])
{
  if (session->step == session->run->trace->n_events)
    return N_ ("Both hulls are complete, and they have the same facets apart "
               "from ties.");
  if (apex[0] == INDEX_NONE || apex[1] == INDEX_NONE)
    return N_ ("Two runs of the same sites, before their first round.");
  return apex[0] == apex[1]
             ? N_ ("Round {n}: both runs insert {p}.")
             : N_ ("Round {n}: the left run inserts {p}, the right one {q}.");
}

void
session_narrate_compare (Session *session,
                         NarrationTranslate translator,
                         char text[NARRATION_ROOM])
{
  const guint apex[2] = { session_get_pane_apex (session, 0),
                          session_get_pane_apex (session, 1) };
  const char *template = compare_template (session, apex);
  const NarrationParts parts
      = { .site = apex[0],
          .other = apex[1],
          .number = timeline_place (session->run->trace, session->step).round };

  narration_fill (translator != NULL ? translator (template) : template, &parts,
                  text);
}

char *
session_order_name (const Order *order)
{
  const char *name = order_kind_name (order->kind);

  return order->kind != ORDER_RANDOM
             ? g_strdup (name)
             : g_strdup_printf ("%s %" G_GUINT64_FORMAT, name, order->seed);
}
