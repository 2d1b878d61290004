/* A run: one set of sites and the trace of its hull, shared by reference.
 * It never changes; an edit makes another. */
#ifndef RUN_H
#define RUN_H

#include "trace.h"

#include <glib.h>

G_BEGIN_DECLS

typedef struct Run {
  int reference_count;
  SiteSet *set;
  GBytes *given; /* the sites as given, one Site after the other; undo shares
                    them */
  Trace *trace;
  guint32 *hues; /* per site: SceneLook.hues */
} Run;

/* Returns: (transfer full): the run of @sites in @order, or NULL when no exact
 *          scaling fits them. */
Run *run_new (const Site *sites, guint n_sites, const Order *order);

/* Returns: (transfer full): the run of the same sites, in the same hues, where
 *          somebody has chosen what QuickHull leaves open. */
Run *run_new_chosen (const Run *like, const HullChoices *choices);

/* What a thread tells of a run that it makes, and is told: atomic. */
typedef struct RunWatch {
  gint n_done;       /* sites so far */
  gint is_cancelled; /* nobody waits for the run any more */
} RunWatch;

/* The same, seen from another thread.
 *
 * Returns: NULL also when it was cancelled, within a round of that. */
Run *run_new_watched (const Site *sites,
                      guint n_sites,
                      const Order *order,
                      RunWatch *watch);
Run *run_ref (Run *run);
void run_unref (Run *run);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Run, run_unref)

/* Returns: (transfer full): the coordinates as given, n_sites of them. */
Site *run_given (const Run *run);

/* Lets sites that were there before keep their hues, however they are numbered
 * now; new ones get others. A run that is shared already keeps its own. */
void run_inherit_hues (Run *run, const Run *before);

/* Returns: whether it is the run of exactly these sites in this order. */
gboolean run_is_of (const Run *run,
                    const Site *sites,
                    guint n_sites,
                    const Order *order);

/* Returns: whether both are of the same sites, in whichever order they are
 *          inserted. */
gboolean run_has_sites_of (const Run *run, const Run *other);

/* Returns: the step of @to at the same place as @step of @from: as far into
 *          the same phase of the same round. At the end it stays at the end,
 *          and a place that does not exist becomes the end. */
guint run_same_place (const Run *from, guint step, const Run *to);

G_END_DECLS

#endif
