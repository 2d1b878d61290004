#include "event.h"

static const char *const kind_names[N_EVENT_KINDS] = {
  [EVENT_DUPLICATE] = "duplicate", [EVENT_FLAT] = "flat",
  [EVENT_SIMPLEX] = "simplex",     [EVENT_CLAIM] = "claim",
  [EVENT_SELECT] = "select",       [EVENT_VISIBLE] = "visible",
  [EVENT_HORIZON] = "horizon",     [EVENT_CONE] = "cone",
  [EVENT_RETIRE] = "retire",       [EVENT_COMPLETE] = "complete",
};

const char *
event_kind_name (EventKind kind)
{
  return kind_names[kind];
}
