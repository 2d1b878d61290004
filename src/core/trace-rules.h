/* What may come when: the grammar of event streams. Private to
 * trace-recorder.c. */
#ifndef TRACE_RULES_H
#define TRACE_RULES_H

#include "trace-rows.h"

/* Returns: NULL, or why the event cannot follow those recorded so far. */
const char *trace_rules_check (const TraceRows *rows, const Event *event);

#endif
