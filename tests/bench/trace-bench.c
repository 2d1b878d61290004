/* trace-bench FILE REPEATS: what a drag costs: QuickHull with its whole trace,
 * triangulation and Voronoi diagram at the end, and QuickHull alone. */
#include "bench.h"
#include "memory.h"
#include "voronoi.h"

static uint32_t
draw (const SiteSet *set, const Order *order)
{
  Trace *trace = trace_record (set, order);
  Delaunay delaunay;
  Voronoi voronoi;
  uint32_t n_vertices;

  delaunay_init (&delaunay, trace, trace->n_events);
  voronoi_init (&voronoi, &delaunay);
  n_vertices = voronoi.n_vertices;
  voronoi_clear (&voronoi);
  delaunay_clear (&delaunay);
  trace_free (trace);
  return n_vertices;
}

int
main (int argc, char **argv)
{
  const Order order = { ORDER_FURTHEST, 0 };
  BenchSites sites;
  BenchTimes hull, trace;
  uint32_t n_vertices = 0;
  SiteSet *set;

  memory_keep ();
  if (argc != 3 || !bench_times_init (&hull, argv[2])
      || !bench_times_init (&trace, argv[2]) || !bench_read (argv[1], &sites))
    return 64;
  set = site_set_new (sites.sites, sites.n_sites);
  while (bench_next (&hull)) {
    bench_start (&hull);
    hull_build (set, &order, NULL);
    bench_stop (&hull);
    bench_start (&trace);
    n_vertices = draw (set, &order);
    bench_stop (&trace);
  }
  printf ("{\"n\":%u,\"hull_ns_per_site_min\":%.1f,\"ns_per_site_min\":%.1f,"
          "\"ms_min\":%.3f,\"voronoi_vertices\":%u}\n",
          sites.n_sites, bench_min (&hull, sites.n_sites),
          bench_min (&trace, sites.n_sites), bench_min (&trace, 1000000),
          n_vertices);
  bench_times_clear (&hull);
  bench_times_clear (&trace);
  site_set_free (set);
  free (sites.sites);
  return 0;
}
