#include "planar-frame.h"

#include "memory.h"

#include <stdlib.h>

static const PlanarRound *
current_round (const PlanarFrame *frame)
{
  return frame->is_in_round ? &frame->trace->rounds[frame->round] : NULL;
}

static uint32_t
roles_of (const PlanarFrame *frame, uint32_t edge)
{
  const PlanarEdge *row = &frame->trace->edges[edge];
  const PlanarRound *round = current_round (frame);
  const bool stands = span_has (row->span, frame->base);
  const bool is_born
      = span_has (row->span, frame->step) && row->round == frame->round + 1;
  uint32_t roles = stands ? FACET_STANDS : 0;

  if (round == NULL)
    return roles;
  if (frame->base == frame->step)
    return is_born ? roles | FACET_NEW : roles;
  if (is_born)
    roles |= FACET_CONE;
  if (!stands)
    return roles;
  if (edge == round->edge)
    roles |= FACET_SELECTED;
  if (row->seen <= frame->step)
    roles |= FACET_VISIBLE;
  if (row->span.death <= frame->step)
    roles |= FACET_RETIRED;
  return roles;
}

static void
add_edges (PlanarFrame *frame)
{
  PlanarCounts *counts = &frame->counts;
  uint32_t edge;

  frame->edges = memory_new (frame->trace->n_edges, sizeof *frame->edges);
  for (edge = 0; edge < frame->trace->n_edges; edge++) {
    const uint32_t roles = roles_of (frame, edge);

    if (roles == 0)
      continue;
    frame->edges[frame->n_edges++] = (PlanarFrameEdge){ edge, roles };
    counts->visible += (roles & FACET_VISIBLE) != 0;
    counts->retired += (roles & FACET_RETIRED) != 0;
    counts->cone += (roles & (FACET_CONE | FACET_NEW)) != 0;
  }
}

/* The ends of the line; one site has one end, none has none. */
static void
find_line_ends (PlanarFrame *frame)
{
  const SiteSet *set = frame->trace->set;
  uint32_t ends[2] = { 0, 0 }, site;

  for (site = 1; site < set->n_sites; site++) {
    if (site_compare (&set->sites[site], &set->sites[ends[0]]) < 0)
      ends[0] = site;
    if (site_compare (&set->sites[site], &set->sites[ends[1]]) > 0)
      ends[1] = site;
  }
  frame->corners = memory_new (2, sizeof *frame->corners);
  if (set->n_distinct > 0)
    frame->corners[frame->n_corners++] = ends[0];
  if (set->n_distinct > 1)
    frame->corners[frame->n_corners++] = ends[1];
}

/* Walks round the hull shown, from edge to edge. */
static void
find_corners (PlanarFrame *frame)
{
  const PlanarTrace *trace = frame->trace;
  uint32_t *head_of = memory_new (trace->set->n_sites, sizeof *head_of);
  uint32_t i, start = INDEX_NONE, corner;

  frame->corners = memory_new (frame->n_edges, sizeof *frame->corners);
  for (i = 0; i < frame->n_edges; i++) {
    const PlanarEdge *row = &trace->edges[frame->edges[i].edge];

    if (!(frame->edges[i].roles & FACET_STANDS))
      continue;
    head_of[row->corner[0]] = row->corner[1];
    frame->counts.corners += 1;
    if (start == INDEX_NONE)
      start = row->corner[0];
  }
  corner = start;
  /* While the first triangle is told there is no loop yet. */
  while (frame->counts.corners >= 3) {
    frame->corners[frame->n_corners++] = corner;
    corner = head_of[corner];
    if (corner == start)
      break;
  }
  free (head_of);
}

static SiteState
state_of (const PlanarFrame *frame, uint32_t site)
{
  const PlanarTrace *trace = frame->trace;
  const PlanarRound *round = current_round (frame);

  if (trace->set->first[site] != site)
    return SITE_DUPLICATE;
  if (round != NULL && round->site == site)
    return SITE_APEX;
  if (trace->inside_from[site] <= frame->step)
    return SITE_IGNORED;
  return trace->corner_from[site] <= frame->step ? SITE_INSERTED : SITE_WAITING;
}

static void
mark_outside (PlanarFrame *frame)
{
  const PlanarTrace *trace = frame->trace;
  const PlanarRound *round = current_round (frame);
  bool *has_set = memory_new (trace->n_edges, sizeof *has_set);
  uint32_t i;

  for (i = 0; i < trace->n_claims; i++) {
    const PlanarClaim *row = &trace->claims[i];

    if (!span_has (row->span, frame->step))
      continue;
    frame->counts.outside_sets += !has_set[row->edge];
    has_set[row->edge] = true;
    if (round != NULL && row->edge == round->edge)
      frame->sites[row->site].state = SITE_OUTSIDE;
  }
  free (has_set);
}

static void
add_sites (PlanarFrame *frame)
{
  PlanarCounts *counts = &frame->counts;
  uint32_t site;

  frame->n_sites = frame->trace->set->n_sites;
  frame->sites = memory_new (frame->n_sites, sizeof *frame->sites);
  for (site = 0; site < frame->n_sites; site++) {
    FrameSite *row = &frame->sites[site];

    row->site = site;
    row->state = state_of (frame, site);
    counts->inside += row->state == SITE_IGNORED;
    counts->waiting
        += row->state == SITE_WAITING
           || (row->state == SITE_APEX && frame->base != frame->step);
  }
  mark_outside (frame);
}

/* Sites on one line: the ends are corners, all others lie between them. */
static void
finish_flat (PlanarFrame *frame)
{
  uint32_t site, i;

  find_line_ends (frame);
  for (site = 0; site < frame->n_sites; site++) {
    FrameSite *row = &frame->sites[site];

    if (row->state == SITE_DUPLICATE)
      continue;
    row->state = SITE_IGNORED;
    for (i = 0; i < frame->n_corners; i++)
      if (frame->trace->set->first[frame->corners[i]] == site)
        row->state = SITE_INSERTED;
    frame->counts.inside += row->state == SITE_IGNORED;
  }
  frame->counts.waiting = 0;
  frame->counts.corners = frame->n_corners;
}

static void
find_horizon (PlanarFrame *frame)
{
  const PlanarTrace *trace = frame->trace;
  uint32_t i;

  if (!frame->is_in_round)
    return;
  for (i = trace->rounds[frame->round].select; i < frame->step; i++)
    if (trace->events[i].kind == PLANAR_HORIZON)
      frame->horizon[frame->counts.horizon++] = trace->events[i].corner[0];
}

static bool
is_flat_told (const PlanarFrame *frame)
{
  const PlanarTrace *trace = frame->trace;

  return trace->is_flat && frame->step + 1 >= trace->n_events;
}

void
planar_frame_init (PlanarFrame *frame, const PlanarTrace *trace, uint32_t step)
{
  *frame = (PlanarFrame){ .trace = trace,
                          .step = step,
                          .base = planar_trace_base (trace, step),
                          .place = course_place (&trace->course, step),
                          .round = planar_trace_round (trace, step) };
  frame->is_in_round
      = frame->round != INDEX_NONE && step <= trace->rounds[frame->round].end;
  add_edges (frame);
  add_sites (frame);
  if (is_flat_told (frame))
    finish_flat (frame);
  else
    find_corners (frame);
  find_horizon (frame);
}

void
planar_frame_clear (PlanarFrame *frame)
{
  free (frame->sites);
  free (frame->edges);
  free (frame->corners);
}
