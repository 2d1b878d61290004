/* peer-qhull FILE REPEATS: qhull's Delaunay triangulation, with the options
 * that SciPy gives it, through its library. */
#include "bench.h"

#include <libqhull_r/qhull_ra.h>

int
main (int argc, char **argv)
{
  static char command[] = "qhull d Qt Qbb Qc Qz Q12";
  BenchSites sites;
  BenchTimes times;
  int n_facets = 0;

  if (argc != 3 || !bench_times_init (&times, argv[2])
      || !bench_read (argv[1], &sites))
    return 64;
  while (bench_next (&times)) {
    qhT *qh = calloc (1, sizeof *qh);
    int current, total;

    bench_start (&times);
    qh_zero (qh, stderr);
    qh_new_qhull (qh, 2, (int)sites.n_sites, (coordT *)sites.sites, False,
                  command, NULL, stderr);
    bench_stop (&times);
    n_facets = qh->num_good;
    qh_freeqhull (qh, !qh_ALL);
    qh_memfreeshort (qh, &current, &total);
    free (qh);
  }
  printf ("{\"n\":%u,\"ns_per_site_min\":%.1f,\"ns_per_site_median\":%.1f,"
          "\"triangles\":%d}\n",
          sites.n_sites, bench_min (&times, sites.n_sites),
          bench_median (&times, sites.n_sites), n_facets);
  bench_times_clear (&times);
  free (sites.sites);
  return 0;
}
