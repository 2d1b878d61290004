/* Events: the vocabulary of the whole program. QuickHull says nothing but
 * these, in this order:
 *
 *   DUPLICATE…                       sites that equal an earlier one
 *   FLAT | SIMPLEX×4 CLAIM…          no tetrahedron, or the first one
 *   then for each round              the insertion of one site
 *     SELECT VISIBLE… HORIZON… CONE… RETIRE… CLAIM…
 *   COMPLETE
 *
 * A hook that counts the facets that were ever made:
 *
 *   static void
 *   count_facets (const Event *event, void *user)
 *   {
 *     uint32_t *n_facets = user;
 *
 *     if (event->kind == EVENT_SIMPLEX || event->kind == EVENT_CONE)
 *       *n_facets += 1;
 *   }
 *
 *   uint32_t n_facets = 0;
 *   HullHook hook = { count_facets, &n_facets };
 *   hull_build (set, &(Order){ ORDER_FURTHEST, 0 }, &hook);
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

/* Returns: the kind in lower case, as in trace files: "horizon". */
const char *event_kind_name (EventKind kind);

#endif
