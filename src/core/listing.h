/* The listings that the code panel can show: QuickHull as it runs, and the
 * two listings of J. Fisher, Hull2VD, 2004, as they were printed and as they
 * should be. What was printed is shown, never run: it has no current line. */
#ifndef LISTING_H
#define LISTING_H

#include "pseudocode.h"

typedef enum Listing {
  LISTING_QUICKHULL,          /* pseudocode.h */
  LISTING_HULL_2004,          /* pseudo-code 1, as printed */
  LISTING_HULL_CORRECTED,     /* with its loops in order */
  LISTING_DIAGRAMS_2004,      /* pseudo-code 2, as printed */
  LISTING_DIAGRAMS_CORRECTED, /* each edge once, ties and rays too */
} Listing;

#define N_LISTINGS (LISTING_DIAGRAMS_CORRECTED + 1)

/* Returns: "quickhull", "hull-2004", "hull-corrected", "diagrams-2004",
 *          "diagrams-corrected". */
const char *listing_name (Listing listing);
bool listing_parse (const char *name, Listing *listing);

/* Returns: its heading; English, translated by the caller. */
const char *listing_title (Listing listing);

/* Returns: the lines; sets *@n_lines. */
const PseudocodeLine *listing_lines (Listing listing, uint32_t *n_lines);

/* Returns: the line carried out by the event that led to @step, or
 *          INDEX_NONE when there is none. */
uint32_t listing_line (Listing listing, const Trace *trace, uint32_t step);

#endif
