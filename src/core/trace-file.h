/* Trace files: the first line is "hull2vd-trace 1", then the sites, then one
 * event a line. Reading a file back gives the same trace, event by event.
 *
 *   hull2vd-trace 1
 *   order furthest        or: order random 7
 *   site 0 -0.6 -0.5      number, x, y
 *   …
 *   duplicate s5          site
 *   simplex f0 s0 s2 s1   facet, its three sites
 *   claim s4 f0           site, facet
 *   select f0 s4          facet, site
 *   visible f0 s4         facet, site
 *   horizon s0 s2 f1      tail, head, the facet beyond
 *   cone f4 s0 s2 s4      facet, its three sites, the apex last
 *   retire f0             facet
 *   flat                  instead of simplex and all rounds
 *   complete
 *
 * What an event means, and in which order they come: event.h.
 */
#ifndef TRACE_FILE_H
#define TRACE_FILE_H

#include "timeline.h"

#include <stdio.h>

#define TRACE_VERSION 1

/* Writes @trace. GRAIN_EVENT writes every event; coarser grains write one
 * line for each phase or round, with counts, and cannot be read back.
 *
 * Returns: false when writing failed (errno). */
bool trace_file_write (const Trace *trace, Grain grain, FILE *file);

typedef struct TraceFileError {
  uint32_t line;    /* from 1 */
  char reason[160]; /* English, without a full stop */
} TraceFileError;

/* Reads the events of a trace file of GRAIN_EVENT and its sites. Every line
 * must be written exactly as above; every event must be legal at its place
 * and true of the sites.
 *
 * Owns:    the caller frees *@set and the trace, in the other order.
 * Returns: the trace, or NULL with *@error filled. */
Trace *trace_file_parse (const char *text,
                         size_t length,
                         SiteSet **set,
                         TraceFileError *error);

#endif
