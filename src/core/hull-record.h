/* QuickHull with the recorder compiled in where else the hook is called.
 * Private to trace. */
#ifndef HULL_RECORD_H
#define HULL_RECORD_H

#include "hull.h"
#include "trace-log.h"

/* What else is asked of a run; either may be missing. */
typedef struct HullWishes {
  const HullChoices *choices;
  HullWanted is_wanted;
  void *user; /* of is_wanted */
} HullWishes;

/* Logs what hull_build() and its like would tell a hook.
 *
 * Returns: false when it was given up. */
bool hull_record (const SiteSet *set,
                  const Order *order,
                  const HullWishes *wishes,
                  TraceLog *log);

#endif
