/* What holds of the hull of every set. */
#ifndef FUZZ_CHECK_H
#define FUZZ_CHECK_H

#include "certify.h"
#include "trace.h"

/* All orders give a certified result, with as many polygons once merged. */
void fuzz_check_orders (const SiteSet *set);

/* Every round of the trace is certified. */
void fuzz_check_rounds (const Trace *trace);

#endif
