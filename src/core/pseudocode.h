/* The listing of the pseudo-code panel, and which of its lines an event
 * carries out. hull.c is written so that the loop of the listing is the loop
 * that runs. */
#ifndef PSEUDOCODE_H
#define PSEUDOCODE_H

#include "timeline.h"

typedef struct PseudocodeLine {
  const char *text; /* English; translated by the caller */
  int indent;       /* levels */
} PseudocodeLine;

/* Returns: the lines; sets *@n_lines. */
const PseudocodeLine *pseudocode_lines (uint32_t *n_lines);

/* Returns: the line carried out by the event that led to @step, or
 *          INDEX_NONE at step 0. */
uint32_t pseudocode_line (const Trace *trace, uint32_t step);

#endif
