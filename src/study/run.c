#include "run.h"

#include "timeline.h"

static GBytes *
given_of (const SiteSet *set)
{
  Site *sites = g_new (Site, MAX (set->n_sites, 1));

  for (guint i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, i);
  return g_bytes_new_take (sites, set->n_sites * sizeof *sites);
}

/* Takes @set and @trace. */
static Run *
put_together (SiteSet *set, Trace *trace)
{
  Run *run = g_new0 (Run, 1);

  run->reference_count = 1;
  run->set = set;
  run->given = given_of (set);
  run->trace = trace;
  run->hues = g_new (guint32, MAX (set->n_sites, 1));
  for (guint i = 0; i < set->n_sites; i++)
    run->hues[i] = i;
  return run;
}

Run *
run_new (const Site *sites, guint n_sites, const Order *order)
{
  SiteSet *set = site_set_new (sites, n_sites);

  if (set == NULL)
    return NULL;
  return put_together (set, trace_record (set, order));
}

Run *
run_new_chosen (const Run *like, const HullChoices *choices)
{
  g_autofree Site *sites = run_given (like);
  SiteSet *set = site_set_new (sites, like->set->n_sites);
  Run *run = put_together (set, trace_record_chosen (set, choices));

  run_inherit_hues (run, like);
  return run;
}

/* Asked before each round, that is for each site but a few. */
static bool
is_wanted (void *user)
{
  RunWatch *watch = user;

  g_atomic_int_inc (&watch->n_done);
  return !g_atomic_int_get (&watch->is_cancelled);
}

Run *
run_new_watched (const Site *sites,
                 guint n_sites,
                 const Order *order,
                 RunWatch *watch)
{
  SiteSet *set = site_set_new (sites, n_sites);
  Trace *trace;

  if (set == NULL)
    return NULL;
  trace = trace_record_while (set, order, is_wanted, watch);
  if (trace != NULL)
    return put_together (set, trace);
  site_set_free (set);
  return NULL;
}

Run *
run_ref (Run *run)
{
  g_atomic_int_inc (&run->reference_count);
  return run;
}

void
run_unref (Run *run)
{
  if (!g_atomic_int_dec_and_test (&run->reference_count))
    return;
  trace_free (run->trace);
  g_bytes_unref (run->given);
  site_set_free (run->set);
  g_free (run->hues);
  g_free (run);
}

Site *
run_given (const Run *run)
{
  gsize length;
  gconstpointer sites = g_bytes_get_data (run->given, &length);

  return g_memdup2 (sites, length);
}

gboolean
run_is_of (const Run *run, const Site *sites, guint n_sites, const Order *order)
{
  const Site *given = g_bytes_get_data (run->given, NULL);

  if (run->set->n_sites != n_sites || run->trace->order.kind != order->kind
      || run->trace->order.seed != order->seed)
    return FALSE;
  for (guint i = 0; i < n_sites; i++)
    if (given[i].x != sites[i].x || given[i].y != sites[i].y)
      return FALSE;
  return TRUE;
}

gboolean
run_has_sites_of (const Run *run, const Run *other)
{
  return run == other || g_bytes_equal (run->given, other->given);
}

guint
run_same_place (const Run *from, guint step, const Run *to)
{
  const Place place = timeline_place (from->trace, step);
  guint start, to_start, to_end;

  if (step == from->trace->n_events)
    return to->trace->n_events;
  if (!timeline_find (from->trace, place, true, &start)
      || !timeline_find (to->trace, place, true, &to_start)
      || !timeline_find (to->trace, place, false, &to_end))
    return to->trace->n_events;
  return MIN (to_start + (step - start), to_end);
}
