/* What the bench programs share: sites from a file, and times. C and C++. */
#ifndef BENCH_H
#define BENCH_H

#include "site.h"

#include <stdio.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct BenchSites {
  Site *sites;
  uint32_t n_sites;
} BenchSites;

/* Returns: false after the reason is on stderr. */
bool bench_read (const char *path, BenchSites *sites);

/* REPEATS runs, after one that is not counted. */
typedef struct BenchTimes {
  double *ns;
  uint32_t n, n_runs;
  double started;
} BenchTimes;

bool bench_times_init (BenchTimes *times, const char *repeats);
void bench_times_clear (BenchTimes *times);
bool bench_next (const BenchTimes *times);
void bench_start (BenchTimes *times);
void bench_stop (BenchTimes *times);
double bench_min (const BenchTimes *times, uint32_t n_sites);
double bench_median (BenchTimes *times, uint32_t n_sites);

#ifdef __cplusplus
}
#endif

#endif
