/* What may come when: the grammar of event streams. Private to
 * trace-recorder. */
#ifndef TRACE_RULES_H
#define TRACE_RULES_H

#include "event.h"

typedef struct TraceRules TraceRules;

TraceRules *trace_rules_new (const SiteSet *set);
void trace_rules_free (TraceRules *rules);

/* Takes the next event, if it may come here.
 *
 * Returns: NULL, or why the event cannot follow those taken so far. */
const char *trace_rules_take (TraceRules *rules, const Event *event);

#endif
