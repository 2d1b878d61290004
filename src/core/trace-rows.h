/* The rows of a trace: births and deaths, written down when its log is
 * complete. Private to trace-recorder. */
#ifndef TRACE_ROWS_H
#define TRACE_ROWS_H

#include "trace.h"

/* Takes a complete log.
 *
 * Owns: the caller frees with trace_free(). */
Trace *
trace_rows_new (const SiteSet *set, const Order *order, const TraceLog *log);

#endif
