#include "listing.h"

#include <string.h>

/* The marker of strings to translate; the caller does it. */
#define N_(text) text

static const PseudocodeLine hull_2004[] = {
  { N_ ("1: initialize sets of facets CH(P) and F to empty"), 0 },
  { N_ ("2: set CH(P) to an arbitrary simplex of points in P"), 0 },
  { N_ ("3: for each p ∈ P"), 0 },
  { N_ ("4: for each facet f ∈ CH(P)"), 1 },
  { N_ ("5: if f is visible to p"), 2 },
  { N_ ("6: add f to F"), 3 },
  { N_ ("7: for each boundary edge e = v1v2 ∈ F"), 3 },
  { N_ ("8: add new facet (p, v1, v2) to CH(P)"), 4 },
  { N_ ("9: delete F"), 4 },
  { N_ ("10: end for"), 3 },
  { N_ ("11: end if"), 2 },
  { N_ ("12: end for"), 1 },
  { N_ ("13: end for"), 0 },
};

typedef enum HullLine {
  HULL_SIMPLEX,
  HULL_SITE,
  HULL_EMPTY,
  HULL_FACET,
  HULL_VISIBLE,
  HULL_RIDGE,
  HULL_CONE,
  HULL_RETIRE,
} HullLine;

static const PseudocodeLine hull_corrected[] = {
  [HULL_SIMPLEX] = { N_ ("CH(P) ← a first simplex"), 0 },
  [HULL_SITE] = { N_ ("for each other site p"), 0 },
  [HULL_EMPTY] = { N_ ("F ← empty"), 1 },
  [HULL_FACET] = { N_ ("for each facet f of CH(P)"), 1 },
  [HULL_VISIBLE] = { N_ ("if p sees f, add f to F"), 2 },
  [HULL_RIDGE] = { N_ ("for each ridge on the boundary of F"), 1 },
  [HULL_CONE] = { N_ ("add the facet of the ridge and p to CH(P)"), 2 },
  [HULL_RETIRE] = { N_ ("remove the facets of F from CH(P)"), 1 },
};

static const PseudocodeLine diagrams_2004[] = {
  { N_ ("1: initialize P′, DT(P) and V(P) to empty"), 0 },
  { N_ ("2: for each p = (px, py) ∈ P"), 0 },
  { N_ ("3: add p′ = (px, py, px² + py²) to P′"), 1 },
  { N_ ("4: end for"), 0 },
  { N_ ("5: compute CH(P′)"), 0 },
  { N_ ("6: for each facet f ∈ CH(P′)"), 0 },
  { N_ ("7: if f’s normal faces downwards"), 1 },
  { N_ ("8: for each edge e of f"), 2 },
  { N_ ("9: set z-values of each vertex in e to 0"), 3 },
  { N_ ("10: construct new edge e′ = e"), 3 },
  { N_ ("11: add e′ to DT(P)"), 3 },
  { N_ ("12: end for"), 2 },
  { N_ ("13: end if"), 1 },
  { N_ ("14: end for"), 0 },
  { N_ ("15: for each triangle t ∈ DT(P)"), 0 },
  { N_ ("16: for each triangle t′ that neighbors t"), 1 },
  { N_ ("17: create edge m by connecting circumcircle centers of t′ and t"),
    2 },
  { N_ ("18: add m to V(P)"), 2 },
  { N_ ("19: end for"), 1 },
  { N_ ("20: end for"), 0 },
};

static const PseudocodeLine diagrams_corrected[] = {
  { N_ ("for each lower facet f of CH(P′)"), 0 },
  { N_ ("add the shadow of f to DT(P), a triangle"), 1 },
  { N_ ("for each group of triangles with one circle"), 0 },
  { N_ ("add the centre of the circle to V(P), once"), 1 },
  { N_ ("for each edge e of DT(P), once"), 0 },
  { N_ ("if two groups meet in e, join their centres"), 1 },
  { N_ ("if e is an edge of the hull, add a ray at a right angle to e"), 1 },
};

#define N_OF(lines) (sizeof (lines) / sizeof *(lines))

typedef struct Row {
  const char *name, *title;
  const PseudocodeLine *lines;
  uint32_t n_lines;
} Row;

static const Row table[N_LISTINGS] = {
  [LISTING_QUICKHULL] = { "quickhull", N_ ("QuickHull"), NULL, 0 },
  [LISTING_HULL_2004] = { "hull-2004", N_ ("Hull, as printed in 2004"),
                          hull_2004, N_OF (hull_2004) },
  [LISTING_HULL_CORRECTED] = { "hull-corrected", N_ ("Hull, corrected"),
                               hull_corrected, N_OF (hull_corrected) },
  [LISTING_DIAGRAMS_2004]
  = { "diagrams-2004", N_ ("Diagrams, as printed in 2004"), diagrams_2004,
      N_OF (diagrams_2004) },
  [LISTING_DIAGRAMS_CORRECTED]
  = { "diagrams-corrected", N_ ("Diagrams, corrected"), diagrams_corrected,
      N_OF (diagrams_corrected) },
};

const char *
listing_name (Listing listing)
{
  return table[listing].name;
}

bool
listing_parse (const char *name, Listing *listing)
{
  int i;

  for (i = 0; i < N_LISTINGS; i++)
    if (strcmp (table[i].name, name) == 0) {
      *listing = (Listing)i;
      return true;
    }
  return false;
}

const char *
listing_title (Listing listing)
{
  return table[listing].title;
}

const PseudocodeLine *
listing_lines (Listing listing, uint32_t *n_lines)
{
  if (listing == LISTING_QUICKHULL)
    return pseudocode_lines (n_lines);
  *n_lines = table[listing].n_lines;
  return table[listing].lines;
}

/* Outside sets are QuickHull's own: what is told of them belongs to the line
 * before. */
static uint32_t
corrected_hull_line (const Trace *trace, uint32_t step)
{
  if (step == 0)
    return INDEX_NONE;
  switch (trace_event (trace, step - 1).kind) {
  case EVENT_DUPLICATE:
  case EVENT_FLAT:
  case EVENT_SIMPLEX:
    return HULL_SIMPLEX;
  case EVENT_CLAIM:
    return step <= trace->start_end ? HULL_SIMPLEX : HULL_RETIRE;
  case EVENT_SELECT:
    return HULL_SITE;
  case EVENT_VISIBLE:
    return HULL_VISIBLE;
  case EVENT_HORIZON:
    return HULL_RIDGE;
  case EVENT_CONE:
    return HULL_CONE;
  case EVENT_RETIRE:
    return HULL_RETIRE;
  case EVENT_COMPLETE:
    return INDEX_NONE;
  }
  return INDEX_NONE;
}

uint32_t
listing_line (Listing listing, const Trace *trace, uint32_t step)
{
  switch (listing) {
  case LISTING_QUICKHULL:
    return pseudocode_line (trace, step);
  case LISTING_HULL_CORRECTED:
    return corrected_hull_line (trace, step);
  case LISTING_HULL_2004:
  case LISTING_DIAGRAMS_2004:
  case LISTING_DIAGRAMS_CORRECTED:
    return INDEX_NONE;
  }
  return INDEX_NONE;
}
