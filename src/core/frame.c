#include "frame.h"

#include "memory.h"
#include "predicate.h"
#include "trace-ridges.h"

#include <stdlib.h>
#include <string.h>

/* The current round at the frame's step, until its end; NULL between rounds
 * and after the last. */
static const RoundRow *
current_round (const Frame *frame)
{
  const RoundRow *row;

  if (frame->round == INDEX_NONE)
    return NULL;
  row = &frame->trace->rounds[frame->round];
  return frame->step <= row->end ? row : NULL;
}

/* Whether the triangulation shown is still that before the round. */
static bool
is_inside_round (const Frame *frame)
{
  return frame->base != frame->step;
}

static uint32_t
roles_of (const Frame *frame, uint32_t facet)
{
  const FacetRow *row = &frame->trace->facets[facet];
  const RoundRow *round = current_round (frame);
  const bool stands = span_has (row->span, frame->base);
  const bool is_born
      = span_has (row->span, frame->step) && row->round == frame->round + 1;
  uint32_t roles = stands ? FACET_STANDS : 0;

  if (round == NULL)
    return roles;
  if (!is_inside_round (frame))
    return is_born ? roles | FACET_NEW : roles;
  if (is_born)
    roles |= FACET_CONE;
  if (!stands)
    return roles;
  if (facet == round->facet)
    roles |= FACET_SELECTED;
  if (row->seen <= frame->step)
    roles |= FACET_VISIBLE;
  if (row->span.death <= frame->step)
    roles |= FACET_RETIRED;
  return roles;
}

static void
add_facets (Frame *frame)
{
  const Trace *trace = frame->trace;
  uint32_t room = 0;
  uint32_t facet;

  for (facet = 0; facet < trace->n_facets; facet++) {
    const uint32_t roles = roles_of (frame, facet);

    if (roles == 0)
      continue;
    if (frame->n_facets == room)
      frame->facets
          = memory_grow (frame->facets, &room, room + 1, sizeof *frame->facets);
    frame->facets[frame->n_facets++] = (FrameFacet){ facet, roles };
  }
}

/* The third site of a facet; a sum, for nobody can guess which it is. */
static uint32_t
opposite_site (const FacetRow *facet, const uint32_t ridge[2])
{
  return facet->site[0] + facet->site[1] + facet->site[2] - ridge[0] - ridge[1];
}

static bool
is_coplanar (const Trace *trace, const FrameRidge *ridge)
{
  const Site *sites = trace->set->sites;
  const uint32_t *left = trace->facets[ridge->facet[0]].site;
  const uint32_t right
      = opposite_site (&trace->facets[ridge->facet[1]], ridge->site);

  return is_on_circle (&sites[left[0]], &sites[left[1]], &sites[left[2]],
                       &sites[right]);
}

static void
add_ridge (Frame *frame, uint32_t ridge, uint32_t facet, const BornRidge *born)
{
  const FacetRow *row = &frame->trace->facets[facet];
  FrameRidge *place;

  if (!span_has (frame->trace->facets[born->right].span, frame->base)
      || frame->base < frame->trace->simplex_end)
    return;
  place = &frame->ridges[frame->n_ridges++];
  place->ridge = ridge;
  place->site[0] = row->site[born->k];
  place->site[1] = row->site[(born->k + 1) % 3];
  place->facet[0] = facet;
  place->facet[1] = born->right;
  place->is_coplanar = is_coplanar (frame->trace, place);
}

static void
add_ridges (Frame *frame)
{
  RidgeCursor cursor = RIDGE_CURSOR;
  uint32_t i, k;

  frame->ridges
      = memory_new (3 * (size_t)frame->n_facets, sizeof *frame->ridges);
  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;
    BornRidge born[3];
    uint32_t n;

    if ((frame->facets[i].roles & FACET_STANDS) == 0)
      continue;
    n = trace_born_ridges (frame->trace, &cursor, facet, born);
    for (k = 0; k < n; k++)
      add_ridge (frame, trace_first_ridge (&cursor, facet) + k, facet,
                 &born[k]);
  }
}

/* How many of the steps first … last have been taken. */
static uint32_t
taken (const Frame *frame, uint32_t first, uint32_t last)
{
  const uint32_t step = frame->step < last ? frame->step : last;

  return step < first ? 0 : step - first + 1;
}

static void
add_horizon (Frame *frame)
{
  const RoundRow *round = current_round (frame);
  uint32_t i;

  if (round == NULL)
    return;
  frame->n_horizon = taken (frame, round->first_horizon, round->last_horizon);
  frame->horizon = memory_new (frame->n_horizon, sizeof *frame->horizon);
  for (i = 0; i < frame->n_horizon; i++) {
    const Event event
        = trace_event (frame->trace, round->first_horizon - 1 + i);

    frame->horizon[i]
        = (FrameHorizon){ { event.ridge[0], event.ridge[1] }, event.facet };
    frame->sites[event.ridge[0]].is_changed = true;
  }
}

static void
add_sites (Frame *frame)
{
  const Trace *trace = frame->trace;
  const RoundRow *round = current_round (frame);
  ClaimRange range;
  uint32_t i;

  frame->n_sites = trace->set->n_sites;
  frame->sites = memory_new (frame->n_sites, sizeof *frame->sites);
  for (i = 0; i < frame->n_sites; i++) {
    FrameSite *row = &frame->sites[i];

    row->site = i;
    if (trace->set->first[i] != i)
      row->state = SITE_DUPLICATE;
    else if (trace->inserted[i] <= frame->step)
      row->state = SITE_INSERTED;
  }
  if (round == NULL)
    return;
  frame->sites[round->site].state = SITE_APEX;
  range = trace_claims_with (trace, round->facet);
  for (i = range.first; i < range.end; i++) {
    const ClaimRow claim = trace_claim (trace, i);

    if (claim.facet == round->facet && span_has (claim.span, frame->step))
      frame->sites[claim.site].state = SITE_OUTSIDE;
  }
}

static void
mark_dying (Frame *frame)
{
  uint32_t i;

  frame->is_dying
      = memory_new (frame->voronoi.n_vertices, sizeof *frame->is_dying);
  if (!is_inside_round (frame))
    return;
  for (i = 0; i < frame->delaunay.n_triangles; i++) {
    const Triangle *triangle = &frame->delaunay.triangles[i];

    if (frame_facet_roles (frame, triangle->facet) & FACET_VISIBLE)
      frame->is_dying[triangle->group] = true;
  }
}

static void
count_facets (Frame *frame)
{
  FrameCounts *counts = &frame->counts;
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++) {
    if ((frame->facets[i].roles & FACET_STANDS) == 0)
      continue;
    counts->facets += 1;
    switch (frame->trace->facets[frame->facets[i].facet].facing) {
    case FACING_LOWER:
      counts->lower += 1;
      break;
    case FACING_UPPER:
      counts->upper += 1;
      break;
    case FACING_VERTICAL:
      counts->vertical += 1;
      break;
    }
  }
}

/* The counts of the current round stay until the next begins. */
static void
count_round (Frame *frame)
{
  const RoundRow *round;
  FrameCounts *counts = &frame->counts;

  if (frame->round == INDEX_NONE)
    return;
  round = &frame->trace->rounds[frame->round];
  counts->visible = taken (frame, round->first_visible, round->last_visible);
  counts->horizon = taken (frame, round->first_horizon, round->last_horizon);
  counts->cone = taken (frame, round->first_cone, round->last_cone);
  counts->retired = taken (frame, round->first_retire, round->last_retire);
}

/* Counts the facets that got an outside set in the round in which @facet was
 * born, and have it: a site leaves it when it is selected, all others when the
 * facet retires. */
static void
count_outside_sets (Frame *frame, uint32_t facet, bool *is_counted)
{
  const Trace *trace = frame->trace;
  const ClaimRange range = trace_claims_with (trace, facet);
  const RoundRow *round = current_round (frame);
  const uint32_t apex = round == NULL ? INDEX_NONE : round->site;
  const uint32_t birth
      = facet < 4 ? trace->simplex_end
                  : trace->rounds[trace->facets[facet].round - 1].last_retire;
  uint32_t i;

  for (i = range.first; i < range.end; i++) {
    const LogClaim *claim = &trace->log.claims[i];

    if (birth + 1 + (i - range.first) > frame->step)
      break;
    if (claim->site == apex || is_counted[claim->facet]
        || !span_has (trace->facets[claim->facet].span, frame->step))
      continue;
    is_counted[claim->facet] = true;
    frame->counts.outside_sets += 1;
  }
}

static void
count_outside (Frame *frame)
{
  const Trace *trace = frame->trace;
  bool *is_counted = memory_new (trace->n_facets, sizeof *is_counted);
  uint32_t i, round = INDEX_NONE;

  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;

    if (trace->facets[facet].round == round
        || !span_has (trace->facets[facet].span, frame->step))
      continue;
    round = trace->facets[facet].round;
    count_outside_sets (frame, facet, is_counted);
  }
  free (is_counted);
  for (i = 0; i < trace->set->n_sites; i++) {
    if (trace->inserted[i] <= frame->step)
      frame->counts.n_inserted += 1;
    else if (trace->set->first[i] == i)
      frame->counts.waiting += 1;
  }
}

static void
count_diagrams (Frame *frame)
{
  FrameCounts *counts = &frame->counts;

  counts->triangles = frame->delaunay.n_triangles;
  counts->delaunay_edges = frame->delaunay.n_edges;
  counts->voronoi_vertices = frame->voronoi.n_vertices;
  counts->voronoi_edges = frame->voronoi.n_edges;
  counts->rays = frame->voronoi.n_rays;
}

void
frame_begin (Frame *frame, const Trace *trace, uint32_t step)
{
  memset (frame, 0, sizeof *frame);
  frame->trace = trace;
  frame->step = step;
  frame->base = trace_base (trace, step);
  frame->place = timeline_place (trace, step);
  frame->round = trace_round (trace, step);
}

void
frame_add_hull (Frame *frame)
{
  add_facets (frame);
  add_ridges (frame);
  add_sites (frame);
  add_horizon (frame);
  count_facets (frame);
  count_round (frame);
  count_outside (frame);
}

void
frame_add_diagrams (Frame *frame)
{
  delaunay_init (&frame->delaunay, frame->trace, frame->step);
  voronoi_init (&frame->voronoi, &frame->delaunay);
}

void
frame_end (Frame *frame)
{
  mark_dying (frame);
  count_diagrams (frame);
}

void
frame_init (Frame *frame, const Trace *trace, uint32_t step)
{
  frame_begin (frame, trace, step);
  frame_add_hull (frame);
  frame_add_diagrams (frame);
  frame_end (frame);
}

void
frame_clear (Frame *frame)
{
  free (frame->sites);
  free (frame->facets);
  free (frame->ridges);
  free (frame->horizon);
  free (frame->is_dying);
  voronoi_clear (&frame->voronoi);
  delaunay_clear (&frame->delaunay);
  memset (frame, 0, sizeof *frame);
}

uint32_t
frame_facet_roles (const Frame *frame, uint32_t facet)
{
  uint32_t low = 0, high = frame->n_facets;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (frame->facets[middle].facet < facet)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == frame->n_facets || frame->facets[low].facet != facet)
    return 0;
  return frame->facets[low].roles;
}

/* Source: Fowler, Noll, Vo, FNV-1a. */
static uint64_t
hash_bytes (uint64_t hash, const void *bytes, size_t n)
{
  const unsigned char *byte = bytes;
  size_t i;

  for (i = 0; i < n; i++)
    hash = (hash ^ byte[i]) * UINT64_C (0x100000001b3);
  return hash;
}

#define HASH_ARRAY(hash, array, n)                                             \
  hash_bytes ((hash), (array), (size_t)(n) * sizeof *(array))

uint64_t
frame_hash (const Frame *frame)
{
  const Delaunay *delaunay = &frame->delaunay;
  const Voronoi *voronoi = &frame->voronoi;
  uint64_t hash = UINT64_C (0xcbf29ce484222325);

  hash = HASH_ARRAY (hash, &frame->step, 1);
  hash = HASH_ARRAY (hash, &frame->base, 1);
  hash = HASH_ARRAY (hash, frame->sites, frame->n_sites);
  hash = HASH_ARRAY (hash, frame->facets, frame->n_facets);
  hash = HASH_ARRAY (hash, frame->ridges, frame->n_ridges);
  hash = HASH_ARRAY (hash, frame->horizon, frame->n_horizon);
  hash = HASH_ARRAY (hash, frame->is_dying, voronoi->n_vertices);
  hash = HASH_ARRAY (hash, &frame->counts, 1);
  hash = HASH_ARRAY (hash, delaunay->active, delaunay->n_active);
  hash = HASH_ARRAY (hash, delaunay->triangles, delaunay->n_triangles);
  hash = HASH_ARRAY (hash, delaunay->boundary, delaunay->n_boundary);
  hash = HASH_ARRAY (hash, voronoi->vertices, voronoi->n_vertices);
  hash = HASH_ARRAY (hash, voronoi->edges, voronoi->n_edges);
  return hash;
}
