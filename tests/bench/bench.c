#include "bench.h"

#include "site-file.h"

#include <time.h>

bool
bench_read (const char *path, BenchSites *sites)
{
  FILE *file = fopen (path, "rb");
  SiteFileError error;
  SiteSet *set;
  char *text;
  long length;

  if (file == NULL) {
    perror (path);
    return false;
  }
  fseek (file, 0, SEEK_END);
  length = ftell (file);
  rewind (file);
  text = malloc ((size_t)length + 1);
  length = (long)fread (text, 1, (size_t)length, file);
  fclose (file);
  set = site_file_parse (text, (size_t)length, &error);
  free (text);
  if (set == NULL) {
    fprintf (stderr, "%s:%u: %s\n", path, error.line, error.reason);
    return false;
  }
  sites->sites = malloc (set->n_sites * sizeof *sites->sites);
  sites->n_sites = set->n_sites;
  for (uint32_t i = 0; i < set->n_sites; i++)
    sites->sites[i] = set->sites[i];
  site_set_free (set);
  return true;
}

bool
bench_times_init (BenchTimes *times, const char *repeats)
{
  const long n = strtol (repeats, NULL, 10);

  if (n < 1 || n > 10000)
    return false;
  *times = (BenchTimes){ .ns = malloc ((size_t)n * sizeof (double)),
                         .n = (uint32_t)n };
  return true;
}

void
bench_times_clear (BenchTimes *times)
{
  free (times->ns);
}

bool
bench_next (const BenchTimes *times)
{
  return times->n_runs <= times->n;
}

static double
now (void)
{
  struct timespec time;

  clock_gettime (CLOCK_MONOTONIC, &time);
  return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

void
bench_start (BenchTimes *times)
{
  times->started = now ();
}

void
bench_stop (BenchTimes *times)
{
  if (times->n_runs > 0)
    times->ns[times->n_runs - 1] = now () - times->started;
  times->n_runs += 1;
}

static int
compare (const void *a, const void *b)
{
  const double left = *(const double *)a, right = *(const double *)b;

  return (left > right) - (left < right);
}

double
bench_median (BenchTimes *times, uint32_t n_sites)
{
  qsort (times->ns, times->n, sizeof *times->ns, compare);
  return times->ns[times->n / 2] / n_sites;
}

double
bench_min (const BenchTimes *times, uint32_t n_sites)
{
  double least = times->ns[0];

  for (uint32_t i = 1; i < times->n; i++)
    if (times->ns[i] < least)
      least = times->ns[i];
  return least / n_sites;
}
