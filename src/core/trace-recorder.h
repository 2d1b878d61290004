/* The hook that turns events into a trace. */
#ifndef TRACE_RECORDER_H
#define TRACE_RECORDER_H

#include "trace.h"

typedef struct TraceRecorder TraceRecorder;

TraceRecorder *trace_recorder_new (const SiteSet *set, const Order *order);

/* For HullHook: believes the event, which comes from hull_build(). */
void trace_recorder_hook (const Event *event, void *recorder);

/* Believes nothing: an event that is not legal at its place is refused, so
 * that a trace file can be read through the recorder too. Either this or the
 * hook is called for all events of a trace.
 *
 * Returns: NULL, or why the event cannot come here. */
const char *trace_recorder_add (TraceRecorder *recorder, const Event *event);

/* Ends the recorder.
 *
 * Returns: the trace, for the caller to free; NULL when the last event was
 *          not COMPLETE. */
Trace *trace_recorder_finish (TraceRecorder *recorder);

#endif
