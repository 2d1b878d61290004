/* Spatial order: sites near each other in the list lie near each other in the
 * plane, which keeps walks short and memory close. */
#ifndef HILBERT_H
#define HILBERT_H

#include "site.h"

/* Lists 0 … n - 1 along a Hilbert curve over the sites' bounding box.
 *
 * Source: Hilbert 1891; keys of 20 bits an axis, radix sort.
 * Cost:   O(n).
 */
void hilbert_sort (const Site *sites, uint32_t n, uint32_t *list);

/* The same in biased randomized insertion order: rounds of which each holds
 * one site in eight of those that follow, each along the curve.
 *
 * Source: Amenta, Choi, Rote 2003, "Incremental constructions con BRIO".
 */
void hilbert_brio (const Site *sites, uint32_t n, uint32_t *list);

#endif
