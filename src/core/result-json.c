#include "result-json.h"

#include "merged.h"
#include "number.h"

#include <math.h>

/* What stands before an item of a list. */
static const char *
separator (uint32_t item)
{
  return item == 0 ? "" : ", ";
}

static void
write_number (double number, FILE *file)
{
  char text[NUMBER_ROOM];

  number_write (number, text);
  fputs (text, file);
}

/* A number that was computed: nearly always all its digits count, so none is
 * saved by looking for fewer. */
static void
write_computed (double number, FILE *file)
{
  char text[NUMBER_ROOM];

  number_write_whole (number, text);
  fputs (text, file);
}

static void
write_pair (double x, double y, FILE *file)
{
  write_number (x, file);
  fputs (", ", file);
  write_number (y, file);
}

/* As fprintf() with %u, without its cost: a result is mostly indices. */
static void
write_index (uint32_t index, FILE *file)
{
  char text[10];
  size_t n = sizeof text;

  do {
    text[--n] = (char)('0' + index % 10);
    index /= 10;
  } while (index > 0);
  fwrite (text + n, 1, sizeof text - n, file);
}

static void
write_indices (const uint32_t *indices, uint32_t n, FILE *file)
{
  for (uint32_t i = 0; i < n; i += 1) {
    fputs (separator (i), file);
    write_index (indices[i], file);
  }
}

static void
write_points (const SiteSet *set, FILE *file)
{
  fputs ("  \"points\": [", file);
  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    const Site given = site_set_given (set, i);

    fprintf (file, "%s[", separator (i));
    write_pair (given.x, given.y, file);
    fputs ("]", file);
  }
  fputs ("],\n", file);
}

static void
write_duplicates (const SiteSet *set, FILE *file)
{
  uint32_t n_written = 0;

  if (set->n_distinct == set->n_sites)
    return;
  fputs ("  \"duplicates\": [", file);
  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    if (set->first[i] == i)
      continue;
    fprintf (file, "%s[%u, %u]", separator (n_written), i, set->first[i]);
    n_written += 1;
  }
  fputs ("],\n", file);
}

static void
write_active (const Delaunay *delaunay, FILE *file)
{
  fputs ("  \"active\": [", file);
  write_indices (delaunay->active, delaunay->n_active, file);
  fputs ("],\n", file);
}

static void
write_hull2d (const Delaunay *delaunay, FILE *file)
{
  uint32_t n_written = 0;

  fputs ("  \"hull2d\": [", file);
  for (uint32_t i = 0; i < delaunay->n_boundary; i += 1) {
    if (!delaunay_is_extreme (delaunay, i))
      continue;
    fprintf (file, "%s%u", separator (n_written), delaunay->boundary[i]);
    n_written += 1;
  }
  fputs ("],\n", file);
}

static void
write_segments (const Delaunay *delaunay, FILE *file)
{
  if (delaunay->dimension != 1)
    return;
  fputs ("  \"segments\": [", file);
  for (uint32_t i = 0; i < delaunay->n_edges; i += 1)
    fprintf (file, "%s[%u, %u]", separator (i), delaunay->edges[i].site[0],
             delaunay->edges[i].site[1]);
  fputs ("],\n", file);
}

static void
write_triangles (const Delaunay *delaunay, FILE *file)
{
  fputs ("  \"triangles\": [", file);
  for (uint32_t i = 0; i < delaunay->n_triangles; i += 1) {
    fputs (i == 0 ? "[" : ", [", file);
    write_indices (delaunay->triangles[i].site, 3, file);
    fputs ("]", file);
  }
  fputs ("],\n", file);
}

/* A centre that overflows when it goes back to the given scale is null. */
static void
write_vertices (const Voronoi *voronoi, FILE *file)
{
  const int exponent = voronoi->delaunay->set->exponent;

  fputs ("    \"vertices\": [", file);
  for (uint32_t i = 0; i < voronoi->n_vertices; i += 1) {
    const double x = ldexp (voronoi->vertices[i].at.x, exponent);
    const double y = ldexp (voronoi->vertices[i].at.y, exponent);
    const bool is_finite = isfinite (x) && isfinite (y);

    fputs (separator (i), file);
    if (!is_finite) {
      fputs ("null", file);
      continue;
    }
    fputs ("[", file);
    write_computed (x, file);
    fputs (", ", file);
    write_computed (y, file);
    fputs ("]", file);
  }
  fputs ("],\n", file);
}

static void
write_vertex_of_triangle (const Delaunay *delaunay, FILE *file)
{
  if (delaunay->dimension != 2)
    return;
  fputs ("    \"vertex_of_triangle\": [", file);
  for (uint32_t i = 0; i < delaunay->n_triangles; i += 1) {
    fputs (separator (i), file);
    write_index (delaunay->triangles[i].group, file);
  }
  fputs ("],\n", file);
}

/* Two sites, two ends (-1: none), the direction of a ray or line, and a point
 * of a line. */
static void
write_edge (const VoronoiEdge *edge, int exponent, FILE *file)
{
  fputs ("[", file);
  write_indices (edge->site, 2, file);
  for (int end = 0; end < 2; end += 1) {
    fputs (", ", file);
    if (edge->vertex[end] == INDEX_NONE)
      fputs ("-1", file);
    else
      write_index (edge->vertex[end], file);
  }
  if (edge->vertex[1] == INDEX_NONE) {
    fputs (", ", file);
    write_pair (edge->direction.x, edge->direction.y, file);
  }
  if (edge->vertex[0] == INDEX_NONE) {
    fputs (", ", file);
    write_pair (ldexp (edge->through.x, exponent),
                ldexp (edge->through.y, exponent), file);
  }
  fputs ("]", file);
}

static void
write_voronoi (const Voronoi *voronoi, FILE *file)
{
  const Delaunay *delaunay = voronoi->delaunay;

  fputs ("  \"voronoi\": {\n", file);
  write_vertices (voronoi, file);
  write_vertex_of_triangle (delaunay, file);
  fputs ("    \"edges\": [", file);
  for (uint32_t i = 0; i < voronoi->n_edges; i += 1) {
    fputs (separator (i), file);
    write_edge (&voronoi->edges[i], delaunay->set->exponent, file);
  }
  fputs ("]\n  },\n", file);
}

static const char *
facing_name (Facing part)
{
  switch (part) {
  case FACING_LOWER:
    return "lower";
  case FACING_UPPER:
    return "upper";
  case FACING_VERTICAL:
    return "vertical";
  }
  return "";
}

static void
write_facets (const Result *result, FILE *file)
{
  fputs (",\n    \"facets\": [", file);
  for (uint32_t i = 0; i < result->n_facets; i += 1) {
    fputs (i == 0 ? "[" : ", [", file);
    write_indices (result->facets[i], 3, file);
    fputs ("]", file);
  }
  fputs ("]", file);
}

static void
write_kinds (const Result *result, FILE *file)
{
  const Site *sites = result->set->sites;

  fputs (",\n    \"kinds\": [", file);
  for (uint32_t i = 0; i < result->n_facets; i += 1) {
    const uint32_t *s = result->facets[i];

    fprintf (file, "%s\"%s\"", separator (i),
             facing_name (facing (&sites[s[0]], &sites[s[1]], &sites[s[2]])));
  }
  fputs ("]", file);
}

static void
write_polygons (const Result *result, FILE *file)
{
  Merged merged;

  merged_init (&merged, result);
  fputs (",\n    \"facets\": [", file);
  for (uint32_t i = 0; i < merged.n_polygons; i += 1) {
    fprintf (file, "%s[", separator (i));
    write_indices (merged.sites + merged.polygons[i].first,
                   merged.polygons[i].n_sites, file);
    fputs ("]", file);
  }
  fputs ("],\n    \"kinds\": [", file);
  for (uint32_t i = 0; i < merged.n_polygons; i += 1)
    fprintf (file, "%s\"%s\"", separator (i),
             facing_name (merged.polygons[i].facing));
  fputs ("]", file);
  merged_clear (&merged);
}

static void
write_hull3d (const Result *result, bool is_merged, FILE *file)
{
  fprintf (file, "  \"hull3d\": {\n    \"dimension\": %d",
           result->delaunay.lift_dimension);
  if (is_merged) {
    write_polygons (result, file);
  } else {
    write_facets (result, file);
    write_kinds (result, file);
  }
  fputs ("\n  }\n", file);
}

bool
result_json_write (const Result *result, ResultForm form, FILE *file)
{
  const Delaunay *delaunay = &result->delaunay;
  const SiteSet *set = delaunay->set;

  fprintf (file, "{\n  \"n\": %u,\n  \"dimension\": %d,\n", set->n_sites,
           delaunay->dimension);
  write_points (set, file);
  write_duplicates (set, file);
  if (!form.is_whole)
    write_active (delaunay, file);
  write_hull2d (delaunay, file);
  write_segments (delaunay, file);
  write_triangles (delaunay, file);
  write_voronoi (&result->voronoi, file);
  write_hull3d (result, form.is_merged, file);
  fputs ("}\n", file);
  return !ferror (file);
}
