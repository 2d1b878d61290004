#include "narration.h"

#include "flat.h"
#include "memory.h"
#include "narration-template.h"

#include <stdlib.h>

/* The marker of strings to translate. */
#define N_(text) text

static const char *
start_template (const SiteSet *set)
{
  if (set->n_sites == 0)
    return N_ ("There are no sites yet.");
  if (set->n_sites == 1)
    return N_ ("One site waits in the plane.");
  return N_ ("{n} sites wait in the plane.");
}

/* All lifts lie in one plane; why depends on how the sites lie. */
static const char *
flat_template (const SiteSet *set)
{
  uint32_t *active = memory_new (set->n_sites, sizeof *active);
  uint32_t site, n = 0;
  int dimension;

  for (site = 0; site < set->n_sites; site++)
    if (set->first[site] == site)
      active[n++] = site;
  dimension = flat_sort (set, active, n);
  free (active);
  if (n == 0)
    return N_ ("There are no sites, so there is nothing to build.");
  if (n == 1)
    return N_ ("One site: its Voronoi cell is the whole plane.");
  if (n == 2)
    return N_ ("Two sites: one Voronoi line lies halfway between them.");
  if (dimension == 1)
    return N_ ("All {n} sites lie on one line: there is no triangle and no "
               "simplex, and the Voronoi lines are parallel.");
  if (n == 3)
    return N_ ("Three sites make one triangle; a simplex needs a fourth site "
               "off its circle.");
  return N_ ("All {n} sites lie on one circle, so all lifts lie in one plane: "
             "there is no simplex.");
}

static const char *
simplex_template (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return N_ ("{f} is a lower facet of the first simplex: its shadow is a "
               "Delaunay triangle.");
  case FACING_UPPER:
    return N_ ("{f} is an upper facet of the first simplex: it faces away "
               "from the plane.");
  case FACING_VERTICAL:
    return N_ ("{f} is a vertical facet of the first simplex: its shadow is "
               "only a segment.");
  }
  return "";
}

static const char *
visible_template (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return N_ ("{p} sees {f}: its circle contains {p}.");
  case FACING_UPPER:
    return N_ ("{p} sees {f}, an upper facet: {p} is outside its circle.");
  case FACING_VERTICAL:
    return N_ ("{p} sees {f}, a vertical facet: {p} is beyond this hull "
               "edge.");
  }
  return "";
}

static const char *
cone_template (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return N_ ("The cone grows: {f} joins {p} to ridge {a} {b}; it is a lower "
               "facet, so its shadow is a new triangle.");
  case FACING_UPPER:
    return N_ ("The cone grows: {f} joins {p} to ridge {a} {b}; it is an "
               "upper facet.");
  case FACING_VERTICAL:
    return N_ ("The cone grows: {f} joins {p} to ridge {a} {b}; it is a "
               "vertical facet, over a straight hull edge.");
  }
  return "";
}

static const char *
retire_template (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return N_ ("{f} is inside the hull now: it retires, and its triangle goes "
               "with it.");
  case FACING_UPPER:
    return N_ ("{f} is inside the hull now: it retires; no triangle goes.");
  case FACING_VERTICAL:
    return N_ ("{f} is inside the hull now: it retires; the straight edge "
               "below it is no longer a hull edge.");
  }
  return "";
}

static const char *
select_template (const Trace *trace, const Event *event, uint32_t step)
{
  if (trace->order.kind != ORDER_FURTHEST)
    return N_ ("{p} comes next; it waits in the outside set of {f}.");
  if (trace_n_waiting (trace, event->facet, step - 1) == 1)
    return N_ ("{p} is the only site in the outside set of {f}: it comes "
               "next.");
  return N_ ("{p} comes next: of the sites in the outside set of {f} it is "
             "the furthest from {f}.");
}

static const char *
complete_template (const Trace *trace)
{
  if (trace->is_flat)
    return flat_template (trace->set);
  return N_ ("No outside set is left: the hull is complete, and its {n} lower "
             "facets are the Delaunay triangulation.");
}

static uint32_t
count_lower (const Trace *trace, uint32_t step)
{
  uint32_t i, n = 0;

  for (i = 0; i < trace->n_facets; i++)
    n += trace->facets[i].facing == FACING_LOWER
         && span_has (trace->facets[i].span, step);
  return n;
}

static const char *
event_template (const Trace *trace, const Event *event, uint32_t step)
{
  const Facing facing = event->facet == INDEX_NONE
                            ? FACING_LOWER
                            : trace->facets[event->facet].facing;

  switch (event->kind) {
  case EVENT_DUPLICATE:
    return N_ ("{p} equals {q}: it is the same point of the plane and counts "
               "once.");
  case EVENT_FLAT:
    return flat_template (trace->set);
  case EVENT_SIMPLEX:
    return simplex_template (facing);
  case EVENT_CLAIM:
    return step <= trace->start_end
               ? N_ ("{p} sees {f} and joins its outside set.")
               : N_ ("{p} waited at a retired facet; it sees {f} and joins its "
                     "outside set.");
  case EVENT_SELECT:
    return select_template (trace, event, step);
  case EVENT_VISIBLE:
    return visible_template (facing);
  case EVENT_HORIZON:
    return N_ ("Ridge {a} {b} is on the horizon: {p} sees the facet on one "
               "side of it, but not {f} on the other.");
  case EVENT_CONE:
    return cone_template (facing);
  case EVENT_RETIRE:
    return retire_template (facing);
  case EVENT_COMPLETE:
    return complete_template (trace);
  }
  return "";
}

static NarrationParts
parts_of (const Trace *trace, const Event *event, uint32_t step)
{
  NarrationParts parts = { .site = event->site,
                           .facet = event->facet,
                           .ridge = { event->ridge[0], event->ridge[1] } };

  if (event->kind == EVENT_DUPLICATE)
    parts.other = trace->set->first[event->site];
  parts.number = event->kind == EVENT_COMPLETE && !trace->is_flat
                     ? count_lower (trace, step)
                     : trace->set->n_distinct;
  return parts;
}

void
narration_write (const Trace *trace,
                 uint32_t step,
                 NarrationTranslate translate,
                 char text[NARRATION_ROOM])
{
  const char *template;
  NarrationParts parts = { .number = trace->set->n_sites };

  if (step == 0) {
    template = start_template (trace->set);
  } else {
    const Event event = trace_event (trace, step - 1);

    template = event_template (trace, &event, step);
    parts = parts_of (trace, &event, step);
  }
  narration_fill (translate != NULL ? translate (template) : template, &parts,
                  text);
}
