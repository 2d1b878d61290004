/* Events: the vocabulary of the whole program. QuickHull says nothing but
 * these, in this order:
 *
 *   DUPLICATE…                       sites that equal an earlier one
 *   FLAT | SIMPLEX×4 CLAIM…          no tetrahedron, or the first one
 *   then for each round              the insertion of one site
 *     SELECT VISIBLE… HORIZON… CONE… RETIRE… CLAIM…
 *   COMPLETE
 *
 * A whole program; tests compile it from here and run it:
 *
 *   #include "hull.h"
 *   #include <stdio.h>
 *
 *   static void
 *   count_cones (const Event *event, void *n_cones)
 *   {
 *     *(int *)n_cones += event->kind == EVENT_CONE;
 *   }
 *
 *   int
 *   main (void)
 *   {
 *     Site sites[5] = { { 0, 0 }, { 4, 0 }, { 0, 4 }, { 3, 3 }, { 1, 1 } };
 *     SiteSet *set = site_set_new (sites, 5);
 *     int n_cones = 0;
 *     HullHook hook = { count_cones, &n_cones };
 *
 *     hull_build (set, &(Order){ ORDER_FURTHEST, 0 }, &hook);
 *     printf ("%d cone facets\n", n_cones);
 *     site_set_free (set);
 *   }
 *
 * More of them are in tests/examples/.
 *
 * The words, in the order of a round:
 *
 *   select   The site is the furthest in the outside set of a facet: of all
 *            sites that wait there the one with the greatest determinant, an
 *            exact tie going to the lower index. It is the apex of the round.
 *            Other orders than ORDER_FURTHEST select the site that is next
 *            in theirs, and a facet that it sees.
 *   visible  The apex sees the facet: it lies strictly on its outer side. A
 *            lower facet is seen from inside its circle, an upper one from
 *            outside, a vertical one from beyond its hull edge. The first is
 *            the facet that was selected, each other a neighbour of one that
 *            came before.
 *   horizon  The ridges between a visible facet and one that is not, in loop
 *            order, the visible side on the left. There are two more than
 *            visible facets.
 *   cone     The facet that joins a horizon ridge to the apex, in the order
 *            of the horizon.
 *   retire   A visible facet leaves the hull; its outside set is orphaned.
 *   claim    An orphan goes to the first cone facet that it sees; before the
 *            first round every site goes to the first facet of the simplex.
 *
 * Facets and sites are named by numbers. A facet's number is never reused;
 * facets are numbered in the order of their birth from 0.
 */
#ifndef EVENT_H
#define EVENT_H

#include "site.h"

typedef enum EventKind {
  EVENT_DUPLICATE, /* site equals an earlier one and is done */
  EVENT_FLAT,      /* all lifts lie in one plane: there is no simplex */
  EVENT_SIMPLEX,   /* facet (ridge[0], ridge[1], site) of the first simplex */
  EVENT_CLAIM,     /* site joins the outside set of facet, which it sees */
  EVENT_SELECT,    /* site, furthest in facet's outside set, is next */
  EVENT_VISIBLE,   /* site sees facet */
  EVENT_HORIZON,   /* ridge bounds the visible facets; facet lies beyond it */
  EVENT_CONE,      /* facet (ridge[0], ridge[1], site) is born on ridge */
  EVENT_RETIRE,    /* facet dies */
  EVENT_COMPLETE,  /* no outside set is left */
} EventKind;

#define N_EVENT_KINDS (EVENT_COMPLETE + 1)

typedef struct Event {
  EventKind kind;
  uint32_t facet;    /* or INDEX_NONE */
  uint32_t site;     /* index into the SiteSet, or INDEX_NONE */
  uint32_t ridge[2]; /* tail and head sites, or INDEX_NONE; the interior of
                        the visible or cone facet is on the left */
} Event;

/* Called for every event, in order. It must not change the sites. */
typedef struct HullHook {
  void (*on_event) (const Event *event, void *user);
  void *user;
} HullHook;

/* Whether whoever listens, HullHook.user, still wants to. */
typedef bool (*HullWanted) (void *user);

/* Returns: the kind in lower case, as in trace files: "horizon". */
const char *event_kind_name (EventKind kind);

#endif
