/* A fuzz target: one function that takes any bytes and stops the program when
 * a promise is broken. Linked with libFuzzer (./dev fuzz) or with fuzz-main.c,
 * which runs it on seeds. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Returns: 0. */
int LLVMFuzzerTestOneInput (const uint8_t *data, size_t size);

/* As assert(), in every build. */
#define fuzz_assert(condition)                                                 \
  do {                                                                         \
    if (!(condition)) {                                                        \
      fprintf (stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__,            \
               #condition);                                                    \
      abort ();                                                                \
    }                                                                          \
  } while (0)

#endif
