/* trace-bench FILE REPEATS: what a drag costs: QuickHull with its whole trace,
 * triangulation and Voronoi diagram at the end; with its trace alone; QuickHull
 * alone; QuickHull with a hook that keeps every event, and with one that keeps
 * all but claims. */
#include "bench.h"
#include "memory.h"
#include "voronoi.h"

/* All that was told; the room stays from run to run. */
typedef struct Log {
  Event *events;
  uint32_t n_events, room;
  bool has_claims;
} Log;

static void
keep (const Event *event, void *user)
{
  Log *log = user;

  if (event->kind == EVENT_CLAIM && !log->has_claims)
    return;
  if (log->n_events == log->room)
    log->events = memory_grow (log->events, &log->room, log->n_events + 1,
                               sizeof *log->events);
  log->events[log->n_events++] = *event;
}

static void
time_log (BenchTimes *times, Log *log, const SiteSet *set, const Order *order)
{
  const HullHook hook = { keep, log };

  log->n_events = 0;
  bench_start (times);
  hull_build (set, order, &hook);
  bench_stop (times);
}

static void
time_record (BenchTimes *times, const SiteSet *set, const Order *order)
{
  Trace *trace;

  bench_start (times);
  trace = trace_record (set, order);
  bench_stop (times);
  trace_free (trace);
}

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
  BenchTimes hull, record, trace, every, most;
  Log all = { .has_claims = true }, few = { .has_claims = false };
  uint32_t n_vertices = 0;
  SiteSet *set;

  memory_keep ();
  if (argc != 3 || !bench_times_init (&hull, argv[2])
      || !bench_times_init (&record, argv[2])
      || !bench_times_init (&trace, argv[2])
      || !bench_times_init (&every, argv[2])
      || !bench_times_init (&most, argv[2]) || !bench_read (argv[1], &sites))
    return 64;
  set = site_set_new (sites.sites, sites.n_sites);
  while (bench_next (&hull)) {
    bench_start (&hull);
    hull_build (set, &order, NULL);
    bench_stop (&hull);
    time_record (&record, set, &order);
    time_log (&every, &all, set, &order);
    time_log (&most, &few, set, &order);
    bench_start (&trace);
    n_vertices = draw (set, &order);
    bench_stop (&trace);
  }
  printf ("{\"n\":%u,\"hull_ns_per_site_min\":%.1f,"
          "\"record_ns_per_site_min\":%.1f,\"log_ns_per_site_min\":%.1f,"
          "\"log_without_claims_ns_per_site_min\":%.1f,"
          "\"log_without_claims_bytes_per_site\":%.0f,"
          "\"ns_per_site_min\":%.1f,\"ms_min\":%.3f,\"voronoi_vertices\":%u}\n",
          sites.n_sites, bench_min (&hull, sites.n_sites),
          bench_min (&record, sites.n_sites), bench_min (&every, sites.n_sites),
          bench_min (&most, sites.n_sites),
          (double)few.n_events * sizeof *few.events / sites.n_sites,
          bench_min (&trace, sites.n_sites), bench_min (&trace, 1000000),
          n_vertices);
  bench_times_clear (&record);
  bench_times_clear (&every);
  bench_times_clear (&most);
  free (all.events);
  free (few.events);
  bench_times_clear (&hull);
  bench_times_clear (&trace);
  site_set_free (set);
  free (sites.sites);
  return 0;
}
