/* Ways to spoil a frame, each of which certify must find. */
#ifndef FAULT_H
#define FAULT_H

#include "fixture.h"
#include "frame.h"

typedef struct Fault {
  const char *name;  /* of the subtest */
  const char *sites; /* of the curated set whose last frame is spoiled */
  const char *words; /* which certify must say */
  void (*spoil) (Frame *frame);
} Fault;

/* Adds a subtest for each of @n faults. */
void fault_add_tests (const Fault *faults, size_t n);

void fault_swap (uint32_t *a, uint32_t *b);

/* Returns: whether the triangle has the edge from @tail to @head; sets
 *          *@third to its other site. */
bool fault_has_edge (const uint32_t site[3],
                     uint32_t tail,
                     uint32_t head,
                     uint32_t *third);

#endif
