#include "trace-recorder.h"

#include "memory.h"
#include "trace-rows.h"
#include "trace-rules.h"

#include <stdlib.h>

struct TraceRecorder {
  const SiteSet *set;
  Order order;
  TraceLog log;
  TraceRules *rules; /* NULL until something is to be checked */
};

TraceRecorder *
trace_recorder_new (const SiteSet *set, const Order *order)
{
  TraceRecorder *r = memory_new (1, sizeof *r);

  r->set = set;
  r->order = *order;
  trace_log_init (&r->log, set->n_sites);
  return r;
}

void
trace_recorder_hook (const Event *event, void *recorder)
{
  TraceRecorder *r = recorder;

  trace_log_add (&r->log, event);
}

const char *
trace_recorder_add (TraceRecorder *r, const Event *event)
{
  const char *why;

  if (r->rules == NULL)
    r->rules = trace_rules_new (r->set);
  why = trace_rules_take (r->rules, event);
  if (why == NULL)
    trace_log_add (&r->log, event);
  return why;
}

Trace *
trace_recorder_finish (TraceRecorder *r)
{
  Trace *trace = NULL;

  if (r->log.is_complete)
    trace = trace_rows_new (r->set, &r->order, &r->log);
  else
    trace_log_clear (&r->log);
  trace_rules_free (r->rules);
  free (r);
  return trace;
}
