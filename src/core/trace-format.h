/* The lines of a trace file that are events, for its writer and its reader.
 * Private to trace-file. */
#ifndef TRACE_FORMAT_H
#define TRACE_FORMAT_H

#include "event.h"

#define TRACE_MAGIC "hull2vd-trace"

/* Returns: the fields after an event's name, a letter each: f its facet, a
 *          and b the ends of its ridge, s its site. */
const char *trace_format_fields (EventKind kind);

/* Returns: the place of the field in the event. */
uint32_t *trace_format_field (Event *event, char field);

/* Returns: "f" for facets, "s" for sites. */
char trace_format_letter (char field);

#endif
