#include "pseudocode.h"

typedef enum Line {
  LINE_SIMPLEX,
  LINE_PARTITION,
  LINE_WHILE,
  LINE_FACET,
  LINE_FURTHEST,
  LINE_VISIBLE,
  LINE_HORIZON,
  LINE_CONE,
  LINE_RETIRE,
  LINE_HAND_OVER,
  LINE_LOWER,
} Line;

#define N_LINES (LINE_LOWER + 1)

/* The marker of strings to translate; the caller does it. */
#define N_(text) text

static const PseudocodeLine lines[N_LINES] = {
  [LINE_SIMPLEX] = { N_ ("start with a first simplex"), 0 },
  [LINE_PARTITION] = { N_ ("give each other site to a facet it sees"), 0 },
  [LINE_WHILE] = { N_ ("while an outside set is not empty"), 0 },
  [LINE_FACET] = { N_ ("f ← the oldest such facet"), 1 },
  [LINE_FURTHEST] = { N_ ("p ← its furthest site"), 1 },
  [LINE_VISIBLE] = { N_ ("V ← the facets that p sees"), 1 },
  [LINE_HORIZON] = { N_ ("H ← horizon ridges of V"), 1 },
  [LINE_CONE] = { N_ ("C ← cone from p over H"), 1 },
  [LINE_RETIRE] = { N_ ("retire V"), 1 },
  [LINE_HAND_OVER] = { N_ ("hand V’s outside sites to C"), 1 },
  [LINE_LOWER] = { N_ ("lower facets → Delaunay → Voronoi"), 0 },
};

const PseudocodeLine *
pseudocode_lines (uint32_t *n_lines)
{
  *n_lines = N_LINES;
  return lines;
}

uint32_t
pseudocode_line (const Trace *trace, uint32_t step)
{
  if (step == 0)
    return INDEX_NONE;
  switch (trace_event (trace, step - 1).kind) {
  case EVENT_DUPLICATE:
  case EVENT_FLAT:
  case EVENT_SIMPLEX:
    return LINE_SIMPLEX;
  case EVENT_CLAIM:
    return step <= trace->start_end ? LINE_PARTITION : LINE_HAND_OVER;
  case EVENT_SELECT:
    return LINE_FURTHEST;
  case EVENT_VISIBLE:
    return LINE_VISIBLE;
  case EVENT_HORIZON:
    return LINE_HORIZON;
  case EVENT_CONE:
    return LINE_CONE;
  case EVENT_RETIRE:
    return LINE_RETIRE;
  case EVENT_COMPLETE:
    return LINE_LOWER;
  }
  return INDEX_NONE;
}
