#include "narration-template.h"
#include "planar-trace.h"

/* The marker of strings to translate; the caller does it. */
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

static const char *
flat_template (const SiteSet *set)
{
  if (set->n_distinct == 0)
    return N_ ("There are no sites, so there is nothing to build.");
  if (set->n_distinct == 1)
    return N_ ("One site: it is its own hull.");
  if (set->n_distinct == 2)
    return N_ ("Two sites: their hull is the segment between them.");
  return N_ ("All {n} sites lie on one line: their hull is the segment between "
             "the outermost two.");
}

static bool
was_corner (const PlanarTrace *trace, uint32_t site, uint32_t step)
{
  return trace->corner_from[site] < step;
}

static const char *
ignore_template (const PlanarTrace *trace, uint32_t site, uint32_t step)
{
  if (was_corner (trace, site, step))
    return N_ ("{p} was a corner and lies inside now: it is ignored.");
  return step <= trace->start_end
             ? N_ ("{p} sees no edge: it lies inside and is ignored.")
             : N_ ("{p} waited at a retired edge and sees none of the new "
                   "ones: it lies inside now and is ignored.");
}

static const char *
select_template (const PlanarTrace *trace,
                 const PlanarEvent *event,
                 uint32_t step)
{
  uint32_t i, n = 0;

  for (i = 0; i < trace->n_claims; i++)
    n += trace->claims[i].edge == event->edge
         && span_has (trace->claims[i].span, step - 1);
  return n == 1
             ? N_ ("{p} is the only site in the outside set of {e}: it comes "
                   "next.")
             : N_ ("{p} comes next: of the sites in the outside set of {e} it "
                   "is the furthest from {e}.");
}

static const char *
event_template (const PlanarTrace *trace,
                const PlanarEvent *event,
                uint32_t step)
{
  switch (event->kind) {
  case PLANAR_DUPLICATE:
    return N_ ("{p} equals {q}: it is the same point of the plane and counts "
               "once.");
  case PLANAR_FLAT:
    return flat_template (trace->set);
  case PLANAR_SIMPLEX:
    return N_ ("{e} from {a} to {b} is an edge of the first triangle.");
  case PLANAR_CLAIM:
    return step <= trace->start_end
               ? N_ ("{p} sees {e} and joins its outside set.")
               : N_ ("{p} waited at a retired edge; it sees {e} and joins its "
                     "outside set.");
  case PLANAR_IGNORE:
    return ignore_template (trace, event->site, step);
  case PLANAR_SELECT:
    return select_template (trace, event, step);
  case PLANAR_VISIBLE:
    return N_ ("{p} sees {e}: it lies on the outer side of it.");
  case PLANAR_HORIZON:
    return N_ ("{a} is on the horizon: {p} sees the edge on one side of it, "
               "but not {e} on the other.");
  case PLANAR_CONE:
    return N_ ("The cone grows: {e} joins {a} to {b}.");
  case PLANAR_RETIRE:
    return N_ ("{e} is inside the hull now: it retires.");
  case PLANAR_COMPLETE:
    return trace->is_flat ? flat_template (trace->set)
                          : N_ ("No outside set is left: the hull is complete, "
                                "and it has {n} corners.");
  }
  return "";
}

static uint32_t
count_corners (const PlanarTrace *trace, uint32_t step)
{
  uint32_t i, n = 0;

  for (i = 0; i < trace->n_edges; i++)
    n += span_has (trace->edges[i].span, step);
  return n;
}

void
planar_narration_write (const PlanarTrace *trace,
                        uint32_t step,
                        NarrationTranslate translate,
                        char text[NARRATION_ROOM])
{
  const char *template = start_template (trace->set);
  NarrationParts parts = { .number = trace->set->n_sites };

  if (step > 0) {
    const PlanarEvent *event = &trace->events[step - 1];

    template = event_template (trace, event, step);
    parts = (NarrationParts){ .site = event->site,
                              .facet = event->edge,
                              .ridge = { event->corner[0], event->corner[1] },
                              .number = trace->set->n_distinct };
    if (event->kind == PLANAR_DUPLICATE)
      parts.other = trace->set->first[event->site];
    if (event->kind == PLANAR_COMPLETE && !trace->is_flat)
      parts.number = count_corners (trace, step);
  }
  narration_fill (translate != NULL ? translate (template) : template, &parts,
                  text);
}

typedef enum Line {
  LINE_TRIANGLE,
  LINE_PARTITION,
  LINE_WHILE,
  LINE_EDGE,
  LINE_FURTHEST,
  LINE_VISIBLE,
  LINE_HORIZON,
  LINE_CONE,
  LINE_RETIRE,
  LINE_HAND_OVER,
  LINE_IGNORE,
} Line;

#define N_LINES (LINE_IGNORE + 1)

static const PseudocodeLine lines[N_LINES] = {
  [LINE_TRIANGLE] = { N_ ("start with a first triangle"), 0 },
  [LINE_PARTITION] = { N_ ("give each site outside to an edge it sees"), 0 },
  [LINE_WHILE] = { N_ ("while an outside set is not empty"), 0 },
  [LINE_EDGE] = { N_ ("e ← the oldest such edge"), 1 },
  [LINE_FURTHEST] = { N_ ("p ← its furthest site"), 1 },
  [LINE_VISIBLE] = { N_ ("V ← the edges that p sees"), 1 },
  [LINE_HORIZON] = { N_ ("H ← the two corners that bound V"), 1 },
  [LINE_CONE] = { N_ ("C ← the edges from p to H"), 1 },
  [LINE_RETIRE] = { N_ ("retire V"), 1 },
  [LINE_HAND_OVER] = { N_ ("hand V’s outside sites to C"), 1 },
  [LINE_IGNORE] = { N_ ("ignore what lies inside"), 1 },
};

const PseudocodeLine *
planar_pseudocode_lines (uint32_t *n_lines)
{
  *n_lines = N_LINES;
  return lines;
}

uint32_t
planar_pseudocode_line (const PlanarTrace *trace, uint32_t step)
{
  const bool is_start = step <= trace->start_end;

  if (step == 0)
    return INDEX_NONE;
  switch (trace->events[step - 1].kind) {
  case PLANAR_DUPLICATE:
  case PLANAR_FLAT:
  case PLANAR_SIMPLEX:
    return LINE_TRIANGLE;
  case PLANAR_CLAIM:
    return is_start ? LINE_PARTITION : LINE_HAND_OVER;
  case PLANAR_IGNORE:
    return is_start ? LINE_PARTITION : LINE_IGNORE;
  case PLANAR_SELECT:
    return LINE_FURTHEST;
  case PLANAR_VISIBLE:
    return LINE_VISIBLE;
  case PLANAR_HORIZON:
    return LINE_HORIZON;
  case PLANAR_CONE:
    return LINE_CONE;
  case PLANAR_RETIRE:
    return LINE_RETIRE;
  case PLANAR_COMPLETE:
    return LINE_WHILE;
  }
  return INDEX_NONE;
}
