/* The hand-over: each site that waited at a retired facet goes to one cone
 * facet that it sees. All cone facets share the apex, so seen from there the
 * determinant of each is a short sum (cone.h).
 *
 * Where the choice is told, it is the first facet that the site sees, exactly,
 * and the furthest site heads a set, exactly. With HULL_LOWER it is the first
 * that rounding leaves no doubt of, and the head is the furthest as rounded:
 * a site may wait at any facet that it sees, and no hull depends on it. */
#include "cone-four.h"
#include "hull-builder.h"
#include "memory.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* The cone and what waits for it, as seen from the apex. */
typedef struct View {
  const Site *sites;
  uint32_t *next_outside, *claimed_by;
  const ConeBlock *cone;
  ConeSet *sets;
  uint32_t n_facets;
  Site apex;
  /* A determinant at d is off by less than square_doubt · |d|² +
   * offset_doubt · (|d.x| + |d.y|). */
  double square_doubt, offset_doubt;
} View;

void
hull_make_cone_room (HullBuilder *b, uint32_t n)
{
  uint32_t n_blocks = b->cone_room / CONE_LANES;

  if (n <= b->cone_room)
    return;
  b->cone
      = memory_grow (b->cone, &n_blocks, n / CONE_LANES + 1, sizeof *b->cone);
  b->cone_room = n_blocks * CONE_LANES;
  free (b->cone_sets);
  b->cone_sets = memory_new (b->cone_room, sizeof *b->cone_sets);
}

/* Empties the sets of the cone, and the lanes of its last block where there
 * is no facet. */
static void
begin_sets (HullBuilder *b)
{
  const uint32_t n = b->n_horizon;
  uint32_t i;

  for (i = 0; i < n; i++)
    b->cone_sets[i] = (ConeSet){ { -INFINITY, 0 }, b->n_sites, b->n_sites };
  for (; i % CONE_LANES != 0; i++)
    b->cone[i / CONE_LANES].area[i % CONE_LANES] = -INFINITY;
}

/* Each of a determinant's three terms is off by less than 12 half ulps of its
 * greatest value, where |area| <= 2 reach² and |normal| <= 4 reach³. The height
 * of the site at infinity is within reach², so that this holds for it, too. */
static View
view_from (const HullBuilder *b, uint32_t apex)
{
  const double reach = sqrt (b->reach_square);
  const double half_ulp = b->is_whole ? 0 : DBL_EPSILON / 2;
  const double unit = 14 * half_ulp * reach * reach;

  return (View){ .sites = b->sites,
                 .next_outside = b->next_outside,
                 .claimed_by = b->claimed_by,
                 .cone = b->cone,
                 .sets = b->cone_sets,
                 .n_facets = b->n_horizon,
                 .apex = b->sites[apex],
                 .square_doubt = 2 * unit,
                 .offset_doubt = 4 * unit * reach };
}

static inline double
greater (double a, double b)
{
  return a > b ? a : b;
}

/* Whether a site lies further from cone facet @i than the head of its set, when
 * rounding leaves that open: exactly, and then what is known of the head. */
static bool __attribute__ ((noinline, cold))
leads_exactly (const HullBuilder *b, uint32_t site, uint32_t i, Rounded front)
{
  ConeSet *set = &b->cone_sets[i];
  const bool leads = b->is_whole ? site < set->head
                                 : outside_is_further (b, site, set->head,
                                                       hull_cone_facet (b, i));

  if (leads)
    set->furthest = front;
  return leads;
}

/* Puts a site at the head of the set of cone facet @i if it lies further than
 * the head. Without branches: in short lists nobody can guess it.
 *
 * Returns: which of the two follows. */
static inline uint32_t
settle_head (const HullBuilder *b, uint32_t site, uint32_t i, Rounded front)
{
  ConeSet *set = &b->cone_sets[i];
  Rounded *furthest = &set->furthest;
  const double lead = front.value - furthest->value;
  bool leads = lead > 0;
  uint32_t swap;

  if (fabs (lead) <= front.doubt + furthest->doubt) {
    leads = leads_exactly (b, site, i, front);
  } else {
    furthest->value = greater (front.value, furthest->value);
    furthest->doubt = greater (front.doubt, furthest->doubt);
  }
  swap = (site ^ set->head) & -(uint32_t)leads;
  set->head ^= swap;
  return site ^ swap;
}

/* The same as rounded. With a branch: it takes time where lists are long, and
 * the further down one is, the rarer is a new head. */
static inline uint32_t
settle_rounded_head (ConeSet *set, uint32_t site, double front)
{
  const uint32_t head = set->head;

  if (front <= set->furthest.value)
    return site;
  set->furthest.value = front;
  set->head = site;
  return head;
}

/* Puts a site that sees cone facet @i into its outside set, which the furthest
 * site heads. */
static inline void
claim (const HullBuilder *b,
       const View *view,
       uint32_t site,
       uint32_t i,
       Rounded front)
{
  ConeSet *set = &view->sets[i];
  const uint32_t follower = HULL_IS_LOWER
                                ? settle_rounded_head (set, site, front.value)
                                : settle_head (b, site, i, front);

  view->next_outside[follower] = set->others;
  set->others = follower;
  if (view->claimed_by != NULL)
    view->claimed_by[site] = hull_cone_facet (b, i);
  hull_tell (b, EVENT (EVENT_CLAIM, hull_cone_facet (b, i), site));
}

static inline double
doubt_at (const View *view, const Offset *at)
{
  return view->square_doubt * at->square
         + view->offset_doubt * (fabs (at->x) + fabs (at->y)) + DBL_MIN;
}

static inline double
front_at (const View *view, uint32_t i, const Offset *at)
{
  const ConePlane plane
      = cone_block_plane (&view->cone[i / CONE_LANES], i % CONE_LANES);

  return cone_front (&plane, at);
}

/* Every lift is extreme, so only a site that equals the apex sees no facet of
 * the cone: it is done.
 *
 * Returns: false, for it is not to be inserted. */
static inline bool
drop (const View *view, uint32_t site, const Offset *at)
{
  (void)at;
  assert (at->square == 0);
  if (view->claimed_by != NULL)
    view->claimed_by[site] = INDEX_NONE;
  return false;
}

/* Returns: a cone facet that the site sees, of those that reach to infinity or
 *          of the others, or their number when there is none. */
static uint32_t
find_seen (const HullBuilder *b, uint32_t site, bool is_unbounded)
{
  uint32_t i;

  for (i = 0; i < b->n_horizon; i++) {
    const uint32_t facet = hull_cone_facet (b, i);

    if (hull_is_unbounded (b, facet) == is_unbounded
        && hull_sees_exactly (b, site, facet))
      break;
  }
  return i;
}

/* The same where rounding leaves all in doubt. Where all lifts nearly lie in
 * one plane, every site outside the hull in the plane is such a site, and waits
 * where a sign in the plane says so. */
static uint32_t __attribute__ ((noinline, cold))
find_seen_exactly (const HullBuilder *b, uint32_t site)
{
  const uint32_t i = find_seen (b, site, true);

  return i < b->n_horizon ? i : find_seen (b, site, false);
}

/* Gives the site to a cone facet that it sees.
 *
 * Returns: whether it is still to be inserted. */
static inline bool
hand_over_to_any (const HullBuilder *b, const View *view, uint32_t site)
{
  const Offset at = offset_of (&view->sites[site], &view->apex);
  const double doubt = doubt_at (view, &at);
  double front[CONE_LANES];
  uint32_t first;

  for (first = 0; first < view->n_facets; first += CONE_LANES) {
    const uint32_t seen
        = cone_fronts (&view->cone[first / CONE_LANES], &at, doubt, front);

    if (seen != 0) {
      const uint32_t lane = (uint32_t)__builtin_ctz (seen);

      claim (b, view, site, first + lane, (Rounded){ front[lane], doubt });
      return true;
    }
  }
  first = at.square == 0 ? view->n_facets : find_seen_exactly (b, site);
  if (first == view->n_facets)
    return drop (view, site, &at);
  claim (b, view, site, first, (Rounded){ front_at (view, first, &at), doubt });
  return true;
}

static bool __attribute__ ((noinline, cold))
sees_exactly (const HullBuilder *b, uint32_t site, uint32_t i)
{
  return !b->is_whole && hull_sees_exactly (b, site, hull_cone_facet (b, i));
}

/* Gives the site to the first cone facet that it sees.
 *
 * Returns: whether it is still to be inserted. */
static inline bool
hand_over_to_first (const HullBuilder *b, const View *view, uint32_t site)
{
  const Offset at = offset_of (&view->sites[site], &view->apex);
  const double doubt = doubt_at (view, &at);
  double front[CONE_LANES];
  uint32_t first;

  for (first = 0; first < view->n_facets; first += CONE_LANES) {
    const ConeBlock *block = &view->cone[first / CONE_LANES];
    uint32_t seen = cone_fronts (block, &at, -doubt, front);

    for (; seen != 0; seen &= seen - 1) {
      const uint32_t lane = (uint32_t)__builtin_ctz (seen), i = first + lane;

      if ((front[lane] > doubt || sees_exactly (b, site, i))
          && hull_may_claim (b, site, hull_cone_facet (b, i))) {
        claim (b, view, site, i, (Rounded){ front[lane], doubt });
        return true;
      }
    }
  }
  return drop (view, site, &at);
}

static inline bool
hand_over_one (const HullBuilder *b, const View *view, uint32_t site)
{
  return HULL_IS_LOWER ? hand_over_to_any (b, view, site)
                       : hand_over_to_first (b, view, site);
}

/* Lets the facets of the cone have what waits at them. */
static void
end_sets (HullBuilder *b)
{
  uint32_t i;

  outside_make_room (b, b->n_horizon);
  for (i = 0; i < b->n_horizon; i++) {
    const ConeSet *set = &b->cone_sets[i];
    const uint32_t facet = hull_cone_facet (b, i);

    b->next_outside[set->head] = set->others;
    b->facets[facet].outside = set->head < b->n_sites ? set->head : INDEX_NONE;
    outside_enqueue (b, facet);
  }
}

/* Whether anything but the apex waits. */
static bool
has_orphans (const HullBuilder *b, uint32_t apex)
{
  return b->n_orphans > 1
         || (b->n_orphans == 1
             && (b->orphans[0] != apex || b->next_outside[apex] != b->n_sites));
}

/* Four sites at a time pay where one instruction asks four and where they lie
 * far from each other in memory: in the batch build they are near. */
#if defined(__AVX2__) && !defined(HULL_BATCH)

/* Asks all orphans first: what is asked of one does not wait for what becomes
 * of another. */
static void
ask_all (const View *view, ConeOrphans *orphans)
{
  const ConeDoubt doubt = { view->square_doubt, view->offset_doubt };
  uint32_t k;

  for (k = 0; k < orphans->n; k++) {
    const Site *site = &view->sites[orphans->site[k]];

    orphans->x[k / 4][k % 4] = site->x - view->apex.x;
    orphans->y[k / 4][k % 4] = site->y - view->apex.y;
  }
  for (; k % 4 != 0; k++)
    orphans->x[k / 4][k % 4] = orphans->y[k / 4][k % 4] = 0;
  for (k = 0; k < orphans->n; k += 4)
    cone_ask (view->cone, view->n_facets, &doubt, orphans, k / 4);
}

/* Hands them over.
 *
 * Returns: how many of them are still to be inserted. */
static uint32_t
hand_over_many (const HullBuilder *b, const View *view, ConeOrphans *orphans)
{
  uint32_t k, n_claims = 0;

  ask_all (view, orphans);
  for (k = 0; k < orphans->n; k++) {
    const uint32_t site = orphans->site[k];
    const uint32_t i = (uint32_t)orphans->facet[k / 4][k % 4];
    const Rounded front
        = { orphans->front[k / 4][k % 4], orphans->doubt[k / 4][k % 4] };

    if (front.value > front.doubt
        && hull_may_claim (b, site, hull_cone_facet (b, i))) {
      claim (b, view, site, i, front);
      n_claims += 1;
    } else {
      n_claims += hand_over_one (b, view, site);
    }
  }
  orphans->n = 0;
  return n_claims;
}

static uint64_t
hand_over_all (const HullBuilder *b, const View *view, uint32_t apex)
{
  const uint32_t end = b->n_sites;
  uint64_t n_claims = 0;
  ConeOrphans orphans;
  uint32_t i, site;

  orphans.n = 0;
  for (i = 0; i < b->n_orphans; i++)
    for (site = b->orphans[i]; site != end;) {
      orphans.site[orphans.n] = site;
      orphans.n += site != apex;
      site = view->next_outside[site];
      if (orphans.n == CONE_ORPHANS)
        n_claims += hand_over_many (b, view, &orphans);
    }
  return n_claims + hand_over_many (b, view, &orphans);
}

#else

static uint64_t
hand_over_all (const HullBuilder *b, const View *view, uint32_t apex)
{
  const uint32_t end = b->n_sites;
  uint64_t n_claims = 0;
  uint32_t i, site, next;

  for (i = 0; i < b->n_orphans; i++)
    for (site = b->orphans[i]; site != end; site = next) {
      next = view->next_outside[site];
      if (site != apex)
        n_claims += hand_over_one (b, view, site);
    }
  return n_claims;
}

#endif

void
hand_over (HullBuilder *b, uint32_t apex)
{
  View view;

  if (!has_orphans (b, apex))
    return;
  horizon_planes (b, apex);
  begin_sets (b);
  view = view_from (b, apex);
  b->counts.redistributions += hand_over_all (b, &view, apex);
  end_sets (b);
}
