#include "certify-mesh.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static const uint32_t *
facet_sites (const Frame *frame, uint32_t facet)
{
  return frame->trace->facets[facet].site;
}

static Facing
facet_facing (const Frame *frame, uint32_t facet)
{
  const Site *sites = frame->trace->set->sites;
  const uint32_t *corner = facet_sites (frame, facet);

  return facing (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]]);
}

typedef uint32_t Corners[3];

/* Returns: the sites of the standing facets; free with free(). */
static Corners *
list_standing (const Frame *frame, uint32_t *n_facets)
{
  Corners *facets = memory_new (frame->n_facets, sizeof *facets);

  *n_facets = 0;
  for (uint32_t i = 0; i < frame->n_facets; i += 1) {
    const uint32_t *corner = facet_sites (frame, frame->facets[i].facet);

    if ((frame->facets[i].roles & FACET_STANDS) == 0)
      continue;
    for (uint32_t k = 0; k < 3; k += 1)
      facets[*n_facets][k] = corner[k];
    *n_facets += 1;
  }
  return facets;
}

static bool
check_hull (const Frame *frame, char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = &frame->delaunay;
  uint32_t n_facets;
  Corners *facets = list_standing (frame, &n_facets);
  bool is_good = true;

  if (delaunay->lift_dimension == 3)
    is_good = certify_hull (delaunay->set, (const Corners *)facets, n_facets,
                            delaunay->active, delaunay->n_active, why);
  else if (delaunay->n_active > 0 && n_facets > 0)
    is_good = certify_fault (why, "flat sites have facets");
  free (facets);
  return is_good;
}

static bool
is_reversed (const uint32_t a[3], const uint32_t b[3])
{
  for (uint32_t k = 0; k < 3; k += 1)
    if (a[0] == b[k] && a[1] == b[(k + 2) % 3] && a[2] == b[(k + 1) % 3])
      return true;
  return false;
}

/* Returns: for each facet ever born whether it stands; free with free(). */
static bool *
mark_standing (const Frame *frame)
{
  bool *stands = memory_new (frame->trace->n_facets, sizeof *stands);

  for (uint32_t i = 0; i < frame->n_facets; i += 1)
    stands[frame->facets[i].facet]
        = (frame->facets[i].roles & FACET_STANDS) != 0;
  return stands;
}

/* Whether a triangle is the shadow of its facet; flat sites have none. */
static bool
is_shadow (const Frame *frame, const bool *stands, uint32_t index)
{
  const Triangle *triangle = &frame->delaunay.triangles[index];

  if (frame->delaunay.lift_dimension < 3)
    return triangle->facet == index;
  return triangle->facet < frame->trace->n_facets && stands[triangle->facet]
         && is_reversed (triangle->site, facet_sites (frame, triangle->facet));
}

/* Checks that every triangle is the shadow of its own facet. Both are as many
 * by their counts. */
static bool
check_shadows (const Frame *frame, char why[CERTIFY_ROOM])
{
  bool *stands = mark_standing (frame);
  uint32_t i = 0;

  while (i < frame->delaunay.n_triangles && is_shadow (frame, stands, i))
    i += 1;
  free (stands);
  return i == frame->delaunay.n_triangles
         || certify_fault (why, "triangle %u is not a facet's shadow", i);
}

static bool
check_count (const char *noun,
             uint32_t n,
             uint32_t expected,
             char why[CERTIFY_ROOM])
{
  if (n != expected)
    return certify_fault (why, "%u %s counted instead of %u", n, noun,
                          expected);
  return true;
}

/* Checks each standing facet's facing and their counts. */
static bool
check_facings (const Frame *frame, char why[CERTIFY_ROOM])
{
  const FrameCounts *counts = &frame->counts;
  uint32_t n[FACING_VERTICAL + 1] = { 0 };

  for (uint32_t i = 0; i < frame->n_facets; i += 1) {
    const uint32_t facet = frame->facets[i].facet;

    if (facet_facing (frame, facet) != frame->trace->facets[facet].facing)
      return certify_fault (why, "f%u faces elsewhere", facet);
    if ((frame->facets[i].roles & FACET_STANDS) != 0)
      n[facet_facing (frame, facet)] += 1;
  }
  return check_count ("facets", counts->facets,
                      counts->lower + counts->upper + counts->vertical, why)
         && check_count ("lower facets", counts->lower, n[FACING_LOWER], why)
         && check_count ("upper facets", counts->upper, n[FACING_UPPER], why)
         && check_count ("vertical facets", counts->vertical,
                         n[FACING_VERTICAL], why);
}

static bool
check_diagram_counts (const Frame *frame, char why[CERTIFY_ROOM])
{
  const FrameCounts *counts = &frame->counts;
  const Delaunay *delaunay = &frame->delaunay;
  const Voronoi *voronoi = &frame->voronoi;

  return check_count ("sites", counts->n_inserted, delaunay->n_active, why)
         && check_count ("triangles", counts->triangles, delaunay->n_triangles,
                         why)
         && check_count ("Delaunay edges", counts->delaunay_edges,
                         delaunay->n_edges, why)
         && check_count ("Voronoi vertices", counts->voronoi_vertices,
                         voronoi->n_vertices, why)
         && check_count ("Voronoi edges", counts->voronoi_edges,
                         voronoi->n_edges, why)
         && check_count ("rays", counts->rays, voronoi->n_rays, why);
}

/* Three numbers in rotation, the lowest first, as one. */
typedef struct Rotation {
  uint32_t site[3];
} Rotation;

static Rotation
rotation_of (uint32_t a, uint32_t b, uint32_t c)
{
  if (a < b && a < c)
    return (Rotation){ { a, b, c } };
  return b < c ? (Rotation){ { b, c, a } } : (Rotation){ { c, a, b } };
}

/* Sorts by the third site, then by the second, then by the first: each time
 * those of one site stay in their order. */
static void
sort_rotations (Rotation *rotations, uint32_t n, uint32_t n_sites)
{
  Rotation *sorted = memory_new (n, sizeof *sorted);

  for (int k = 2; k >= 0; k -= 1) {
    uint32_t *place = memory_new ((size_t)n_sites + 1, sizeof *place);

    for (uint32_t i = 0; i < n; i += 1)
      place[rotations[i].site[k] + 1] += 1;
    for (uint32_t i = 0; i < n_sites; i += 1)
      place[i + 1] += place[i];
    for (uint32_t i = 0; i < n; i += 1) {
      sorted[place[rotations[i].site[k]]] = rotations[i];
      place[rotations[i].site[k]] += 1;
    }
    memcpy (rotations, sorted, n * sizeof *sorted);
    free (place);
  }
  free (sorted);
}

/* Checks that the triangles are just the shadows of the lower facets. */
static bool
check_triangles (const Result *result, char why[CERTIFY_ROOM])
{
  const Site *sites = result->set->sites;
  const Delaunay *delaunay = &result->delaunay;
  Rotation *lower = memory_new (result->n_facets, sizeof *lower);
  Rotation *shadows = memory_new (delaunay->n_triangles, sizeof *shadows);
  uint32_t n_lower = 0, i;
  bool is_good;

  for (i = 0; i < result->n_facets; i += 1) {
    const uint32_t *s = result->facets[i];

    if (facing (&sites[s[0]], &sites[s[1]], &sites[s[2]]) == FACING_LOWER)
      lower[n_lower++] = rotation_of (s[0], s[2], s[1]);
  }
  for (i = 0; i < delaunay->n_triangles; i += 1) {
    const uint32_t *s = delaunay->triangles[i].site;

    shadows[i] = rotation_of (s[0], s[1], s[2]);
  }
  sort_rotations (lower, n_lower, result->set->n_sites);
  sort_rotations (shadows, delaunay->n_triangles, result->set->n_sites);
  is_good = n_lower == delaunay->n_triangles
            && memcmp (lower, shadows, n_lower * sizeof *lower) == 0;
  free (lower);
  free (shadows);
  return is_good
         || certify_fault (why, "the triangles are not the lower facets' "
                                "shadows");
}

bool
certify_result (const Result *result, char why[CERTIFY_ROOM])
{
  const Delaunay *delaunay = &result->delaunay;

  if (!certify_delaunay (delaunay, why)
      || !certify_voronoi (&result->voronoi, why))
    return false;
  if (delaunay->lift_dimension == 3)
    return certify_hull (result->set, (const Corners *)result->facets,
                         result->n_facets, delaunay->active, delaunay->n_active,
                         why)
           && check_triangles (result, why);
  return result->n_facets == 0 || certify_fault (why, "flat sites have facets");
}

bool
certify_frame (const Frame *frame, char why[CERTIFY_ROOM])
{
  return certify_delaunay (&frame->delaunay, why)
         && certify_voronoi (&frame->voronoi, why) && check_hull (frame, why)
         && check_shadows (frame, why) && check_facings (frame, why)
         && check_diagram_counts (frame, why);
}
