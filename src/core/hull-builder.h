/* What the parts of QuickHull share: the facets and the current round.
 * Private to batch, hull, simplex, outside, hand-over, horizon and walk.
 *
 * These parts are compiled several times from one source. As they are, they
 * tell a hook of every event. With HULL_BATCH they tell nothing, so that no
 * event costs anything; a cone takes over the numbers of the facets that
 * retire, so that only the hull is kept; and listed sites may be located by
 * walking. With HULL_RECORD they write a log instead of calling a hook. All
 * come a second time for processors with AVX2. HULL_PREFIX tells the builds
 * apart.
 *
 * With HULL_LOWER they build the lower hull alone, closed by facets to a site
 * at infinity, straight above, whose number is n_sites. It is one more point
 * in convex position, and all else is as before; but which of those facets a
 * site sees is a question of the plane, which a filter nearly always settles.
 * So is where sites wait that lie on one circle but for rounding. */
#ifndef HULL_BUILDER_H
#define HULL_BUILDER_H

#include "choice.h"
#include "cone.h"
#include "event.h"
#include "hull-mesh.h"
#include "order.h"
#include "predicate.h"
#include "trace-log.h"

#include <stddef.h>
#include <string.h>

#ifdef HULL_LOWER
enum { HULL_IS_LOWER = 1 };
#else
enum { HULL_IS_LOWER = 0 };
#endif

#ifdef HULL_PREFIX
#define HULL_PASTE(prefix, name) prefix##name
#define HULL_EXPAND(prefix, name) HULL_PASTE (prefix, name)
#define HULL_NAME(name) HULL_EXPAND (HULL_PREFIX, name)
#define hull_run HULL_NAME (hull_run)
#define simplex_find HULL_NAME (simplex_find)
#define simplex_build HULL_NAME (simplex_build)
#define outside_partition HULL_NAME (outside_partition)
#define outside_next_facet HULL_NAME (outside_next_facet)
#define outside_select HULL_NAME (outside_select)
#define outside_make_room HULL_NAME (outside_make_room)
#define outside_is_further HULL_NAME (outside_is_further)
#define hull_sees_exactly HULL_NAME (hull_sees_exactly)
#define hand_over HULL_NAME (hand_over)
#define horizon_collect_visible HULL_NAME (horizon_collect_visible)
#define horizon_planes HULL_NAME (horizon_planes)
#define hull_make_cone_room HULL_NAME (hull_make_cone_room)
#define horizon_collect HULL_NAME (horizon_collect)
#define walk_to HULL_NAME (walk_to)
#endif

typedef struct HorizonRidge {
  uint32_t tail;   /* its head is the tail of the next */
  HullEdge beyond; /* the edge in the facet that is not visible */
} HorizonRidge;

/* An edge of a visible facet that the search for the horizon comes back to. */
typedef struct PendingEdge {
  Offset head;
  HullEdge edge;
} PendingEdge;

/* A facet with an outside set; stale when the facet's mark is another. */
typedef struct QueueEntry {
  uint32_t facet, birth;
} QueueEntry;

typedef struct HullBuilder {
  const Site *sites;
  uint32_t n_sites;
  const uint32_t *first; /* of a SiteSet; NULL: duplicates are found and
                            dropped on the way */
  const HullHook *hook;  /* looked at in the builds that call it alone */
  TraceLog *log;         /* and this, in those that write it */
  HullWanted is_wanted;  /* never looked at in the batch build; NULL: to the
                            end */
  void *user;            /* who is asked */
  bool is_given_up;

  HullFacet *facets;
  uint32_t n_facets, facets_room;
  uint32_t round;      /* 1 for the first insertion */
  double doubt;        /* bounds rounding in the lift_orient() of any sites */
  double orient_doubt; /* and in their orient() */
  bool is_whole; /* sites lie on so small a grid that nothing is rounded */
  uint32_t simplex[4]; /* its sites, base first, then the top */

  /* The first n_listed sites to insert are listed; then the furthest of the
   * oldest facet. Listed sites wait in outside sets, or are walked to. */
  const uint32_t *list; /* all sites; NULL: as they come */
  uint32_t n_listed, list_position;
  bool walks;
  uint32_t near; /* where the next walk starts: a lower facet, or one of the
                    last cone */
  uint32_t *claimed_by; /* the facet a site waits at, while sites are listed
                           and not walked to */

  uint32_t *next_outside; /* a site's follower in its outside set; n_sites is
                             the end, and has a row of its own */
  double *head_fronts;    /* with HULL_LOWER, while sites are partitioned: how
                             far the head of each facet's outside set is */
  /* Facets with outside sets: a stack of the first n_stacked, and from
   * queue_head to queue_end a queue, the oldest first. Beyond n_young_max the
   * queue becomes part of the stack; an empty one begins again with the top
   * of the stack. */
  QueueEntry *queue;
  uint32_t n_stacked, queue_head, queue_end, queue_room;
  uint32_t n_young_max;

  uint32_t *visible; /* in the batch build also the cone's numbers */
  uint32_t n_visible, visible_room;
  PendingEdge *pending; /* in the batch build: edges of visible facets */
  uint32_t *orphans;    /* heads of the visible facets' outside sets */
  uint32_t n_orphans, orphans_room;
  HorizonRidge *horizon;
  uint32_t n_horizon, horizon_room;
  ConeBlock *cone;
  ConeSet *cone_sets;
  uint32_t cone_room;  /* in facets, whole blocks */
  double reach_square; /* of the horizon site furthest from the apex */
  double height;       /* with HULL_LOWER: the site at infinity, seen from the
                          apex, lies in this direction: (0, 0, height) */
  uint32_t first_cone; /* the first number of the cone */

  HullCounts counts;

  /* Never looked at in the batch build; NULL: nothing is chosen. */
  const HullChoices *choices;
} HullBuilder;

/* hull.c: builds the hull of the sites; all else starts at zero.
 *
 * Returns: false when all lifts lie in one plane: nothing is built. */
bool hull_run (HullBuilder *b);

/* Its other builds: with a log; without a hook, with the horizon's ridges in
 * the order of lessons and in the fastest one; and, with HULL_HAS_AVX2, for
 * AVX2. */
bool record_hull_run (HullBuilder *b);
bool record_avx2_hull_run (HullBuilder *b);
bool lesson_hull_run (HullBuilder *b);
bool batch_hull_run (HullBuilder *b);
bool avx2_hull_run (HullBuilder *b);
bool batch_avx2_hull_run (HullBuilder *b);

/* Frees all but the facets. */
void hull_clear (HullBuilder *b);

/* simplex.c: finds the first simplex, and builds it.
 *
 * Returns: false when all lifts lie in one plane. */
bool simplex_find (HullBuilder *b);
void simplex_build (HullBuilder *b);

/* outside.c: outside sets, and whose turn it is. */
void outside_partition (HullBuilder *b);
uint32_t outside_next_facet (HullBuilder *b);
uint32_t outside_select (HullBuilder *b, uint32_t facet);

/* Whether the site lies further from the facet than another, exactly; a tie
 * goes to the lower index. */
bool outside_is_further (const HullBuilder *b,
                         uint32_t site,
                         uint32_t other,
                         uint32_t facet);

/* Whether the site sees the facet, whatever rounding does. */
bool hull_sees_exactly (const HullBuilder *b, uint32_t site, uint32_t facet);

/* Makes room for so many more facets that wait. */
void outside_make_room (HullBuilder *b, uint32_t n);

/* Lets a facet wait for its turn if it has an outside set. */
static inline void
outside_enqueue (HullBuilder *b, uint32_t facet)
{
  const HullFacet *row = &b->facets[facet];

  b->queue[b->queue_end] = (QueueEntry){ facet, row->mark };
  b->queue_end += row->outside != INDEX_NONE;
}

/* hand-over.c: gives the orphans to the cone. */
void hull_make_cone_room (HullBuilder *b, uint32_t n);
void hand_over (HullBuilder *b, uint32_t apex);

/* horizon.c: the visible facets and their boundary in loop order. */
void horizon_collect_visible (HullBuilder *b, uint32_t facet, uint32_t apex);
void horizon_collect (HullBuilder *b, uint32_t apex);

/* Writes the planes of the cone on it. */
void horizon_planes (HullBuilder *b, uint32_t apex);

/* walk.c: walks from the last cone through the shadows of lower facets.
 *
 * Returns: a facet that the site sees, or INDEX_NONE when the site equals a
 *          vertex of the hull. */
uint32_t walk_to (HullBuilder *b, uint32_t site);

/* The number of the cone's facet on horizon ridge @i. */
static inline uint32_t
hull_cone_facet (const HullBuilder *b, uint32_t i)
{
#ifdef HULL_BATCH
  return b->visible[i];
#else
  return b->first_cone + i;
#endif
}

/* Writes the plane of cone facet @i, the squared distance of whose ridge's
 * tail is given. */
static inline void
hull_set_plane (HullBuilder *b,
                uint32_t i,
                const ConePlane *plane,
                double square)
{
  ConeBlock *block = &b->cone[i / CONE_LANES];
  const uint32_t lane = i % CONE_LANES;

  block->area[lane] = plane->area;
  block->normal_x[lane] = plane->normal_x;
  block->normal_y[lane] = plane->normal_y;
  b->reach_square
      = i > 0 && b->reach_square > square ? b->reach_square : square;
}

/* An event that concerns no ridge. */
#define EVENT(kind, facet, site)                                               \
  (Event)                                                                      \
  {                                                                            \
    (kind), (facet), (site), { INDEX_NONE, INDEX_NONE }                        \
  }

/* Whoever listens reads an event as a whole, and would wait until words that
 * were written one by one have come to lie in memory. */
typedef uint32_t EventWords __attribute__ ((vector_size (16)));

static inline void
hull_tell (const HullBuilder *b, Event event)
{
#ifdef HULL_BATCH
  (void)b;
  (void)event;
#elif defined(HULL_RECORD)
  trace_log_add (b->log, &event);
#else
  if (b->hook != NULL) {
    const EventWords words
        = { event.kind, event.facet, event.site, event.ridge[0] };
    Event told;

    memcpy (&told, &words, sizeof words);
    told.ridge[1] = event.ridge[1];
    b->hook->on_event (&told, b->hook->user);
  }
#endif
}

/* Whether the number is that of the site at infinity. */
static inline bool
hull_is_infinite (const HullBuilder *b, uint32_t site)
{
  return HULL_IS_LOWER && site == b->n_sites;
}

/* The corner of a facet that is the site at infinity, or 3. */
static inline uint32_t
hull_infinite_corner (const HullBuilder *b, const uint32_t corner[3])
{
  uint32_t k = 0;

  while (k < 3 && !hull_is_infinite (b, corner[k]))
    k++;
  return k;
}

static inline bool
hull_is_unbounded (const HullBuilder *b, uint32_t facet)
{
  return hull_infinite_corner (b, b->facets[facet].site) < 3;
}

/* Whether a site waits at a facet that it sees: at the first one, unless it
 * was chosen otherwise. */
static inline bool
hull_may_claim (const HullBuilder *b, uint32_t site, uint32_t facet)
{
#ifdef HULL_BATCH
  (void)b;
  (void)site;
  (void)facet;
  return true;
#else
  const HullChoice *choice;

  if (b->choices == NULL)
    return true;
  choice = hull_choices_find (b->choices, EVENT_CLAIM, b->round, site);
  return choice == NULL || choice->facet == facet;
#endif
}

/* The determinant of a site, rounded. */
static inline double
hull_front (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  const uint32_t *corner = b->facets[facet].site;
  const Site *p = &b->sites[site], *s0 = &b->sites[corner[0]];
  const Site *s1 = &b->sites[corner[1]], *s2 = &b->sites[corner[2]];
  const double ax = s0->x - p->x, ay = s0->y - p->y;
  const double bx = s1->x - p->x, by = s1->y - p->y;
  const double cx = s2->x - p->x, cy = s2->y - p->y;

  return -((ax * ax + ay * ay) * (bx * cy - cx * by)
           + (bx * bx + by * by) * (cx * ay - ax * cy)
           + (cx * cx + cy * cy) * (ax * by - bx * ay));
}

/* Whether a site sees a facet, with a filter for the whole set first. */
static inline bool
hull_sees (const HullBuilder *b, uint32_t site, uint32_t facet)
{
  double front;

  if (hull_is_unbounded (b, facet))
    return hull_sees_exactly (b, site, facet);
  front = hull_front (b, site, facet);
  if (front < -b->doubt || b->is_whole)
    return front > 0;
  return front > b->doubt || hull_sees_exactly (b, site, facet);
}

#endif
