/* hull-bench FILE ORDER REPEATS: times the batch engine on the sites of a
 * file, and prints one line of JSON. Timed is everything from points in
 * memory to facets with their neighbours: spatial sort, duplicates, hull.
 * HULL_BENCH_WITHOUT_AVX2 in the environment shows what AVX2 is worth. */
#include "batch.h"
#include "bench.h"
#include "predicate.h"

#include <inttypes.h>
#include <malloc.h>

/* The most memory that was in use at once; the linker passes all calls of
 * the engine through here. */
static size_t n_bytes, peak_bytes;

void *__real_malloc (size_t size);
void *__real_calloc (size_t n, size_t size);
void *__real_realloc (void *memory, size_t size);
void __real_free (void *memory);
void *__wrap_malloc (size_t size);
void *__wrap_calloc (size_t n, size_t size);
void *__wrap_realloc (void *memory, size_t size);
void __wrap_free (void *memory);

static void *
enter (void *memory)
{
  n_bytes += malloc_usable_size (memory);
  if (n_bytes > peak_bytes)
    peak_bytes = n_bytes;
  return memory;
}

static void
leave (void *memory)
{
  n_bytes -= malloc_usable_size (memory);
}

void *
__wrap_malloc (size_t size)
{
  return enter (__real_malloc (size));
}

void *
__wrap_calloc (size_t n, size_t size)
{
  return enter (__real_calloc (n, size));
}

void *
__wrap_realloc (void *memory, size_t size)
{
  leave (memory);
  return enter (__real_realloc (memory, size));
}

void
__wrap_free (void *memory)
{
  leave (memory);
  __real_free (memory);
}

static uint32_t
count_lower (const Batch *batch, const Site *sites)
{
  uint32_t i, n = 0;

  for (i = 0; i < batch->n_facets; i++) {
    const uint32_t *s = batch->facets[i].site;

    if (s[0] != INDEX_NONE && s[1] != INDEX_NONE && s[2] != INDEX_NONE)
      n += facing (&sites[s[0]], &sites[s[1]], &sites[s[2]]) == FACING_LOWER;
  }
  return n;
}

int
main (int argc, char **argv)
{
  BenchSites sites;
  BenchTimes times;
  Order order = { ORDER_FURTHEST, 1 };
  uint32_t n_triangles = 0;
  uint64_t n_created = 0;

  if (argc != 4 || !order_kind_parse (argv[2], &order.kind)
      || !bench_times_init (&times, argv[3])) {
    fprintf (stderr, "usage: hull-bench FILE ORDER REPEATS\n");
    return 64;
  }
  if (!bench_read (argv[1], &sites))
    return 66;
  batch_use_avx2 (getenv ("HULL_BENCH_WITHOUT_AVX2") == NULL);
  while (bench_next (&times)) {
    Batch *batch;

    n_bytes = peak_bytes = 0;
    bench_start (&times);
    batch = batch_build (sites.sites, sites.n_sites, &order, BATCH_LOCAL);
    bench_stop (&times);
    n_triangles = count_lower (batch, sites.sites);
    n_created = batch->counts.facets_created;
    batch_free (batch);
  }
  printf ("{\"n\":%u,\"order\":\"%s\",\"ns_per_site_min\":%.1f,"
          "\"ns_per_site_median\":%.1f,\"peak_bytes\":%zu,\"triangles\":%u,"
          "\"facets_created\":%" PRIu64 "}\n",
          sites.n_sites, argv[2], bench_min (&times, sites.n_sites),
          bench_median (&times, sites.n_sites), peak_bytes, n_triangles,
          n_created);
  bench_times_clear (&times);
  free (sites.sites);
  return 0;
}
