/* peer-cgal FILE REPEATS: CGAL's Delaunay triangulation, exact predicates,
 * range insertion with its own spatial sort; the vector of points is ready. */
#include "bench.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_2<Kernel> Triangulation;

int
main (int argc, char **argv)
{
  BenchSites sites;
  BenchTimes times;
  std::vector<Triangulation::Point> points;
  size_t n_triangles = 0;

  if (argc != 3 || !bench_times_init (&times, argv[2])
      || !bench_read (argv[1], &sites))
    return 64;
  for (uint32_t i = 0; i < sites.n_sites; i++)
    points.emplace_back (sites.sites[i].x, sites.sites[i].y);
  while (bench_next (&times)) {
    std::vector<Triangulation::Point> copy (points);
    Triangulation *triangulation;

    bench_start (&times);
    triangulation = new Triangulation;
    triangulation->insert (copy.begin (), copy.end ());
    bench_stop (&times);
    n_triangles = triangulation->number_of_faces ();
    delete triangulation;
  }
  printf ("{\"n\":%u,\"ns_per_site_min\":%.1f,\"ns_per_site_median\":%.1f,"
          "\"triangles\":%zu}\n",
          sites.n_sites, bench_min (&times, sites.n_sites),
          bench_median (&times, sites.n_sites), n_triangles);
  bench_times_clear (&times);
  free (sites.sites);
  return 0;
}
