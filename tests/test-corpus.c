/* Every file of the corpus must come out as its MANIFEST.tsv says: one row a
 * file, one column a number. */
#include "certify.h"
#include "fixture.h"
#include "site-file.h"

#include <stdlib.h>
#include <string.h>

/* The counts of whole results, and of n-gons where neighbouring facets that
 * lie in one plane are merged. */
typedef struct Counts {
  const Fixture *fixture;
  Frame frame;
  gint64 merged[FACING_VERTICAL + 1];
} Counts;

static bool
is_plane (const Counts *counts)
{
  return counts->frame.delaunay.dimension == 2;
}

static gint64
count_n (const Counts *counts)
{
  return counts->fixture->set->n_sites;
}

static gint64
count_distinct (const Counts *counts)
{
  return counts->fixture->set->n_distinct;
}

static gint64
count_dimension (const Counts *counts)
{
  return counts->frame.delaunay.dimension;
}

static gint64
count_hull2d (const Counts *counts)
{
  return counts->frame.delaunay.n_extreme;
}

static gint64
count_boundary (const Counts *counts)
{
  return is_plane (counts) ? counts->frame.delaunay.n_boundary : 0;
}

static gint64
count_triangles (const Counts *counts)
{
  return counts->frame.counts.triangles;
}

static gint64
count_delaunay_edges (const Counts *counts)
{
  return counts->frame.counts.delaunay_edges;
}

/* Circle groups of more than one triangle. */
static gint64
count_cells (const Counts *counts)
{
  const Delaunay *delaunay = &counts->frame.delaunay;
  g_autofree guint *n = g_new0 (guint, delaunay->n_groups + 1);
  gint64 n_cells = 0;

  for (uint32_t i = 0; i < delaunay->n_triangles; i++)
    n_cells += n[delaunay->triangles[i].group]++ == 1;
  return n_cells;
}

static gint64
count_vertices (const Counts *counts)
{
  return counts->frame.counts.voronoi_vertices;
}

static gint64
count_finite (const Counts *counts)
{
  return is_plane (counts)
             ? counts->frame.counts.voronoi_edges - counts->frame.counts.rays
             : 0;
}

static gint64
count_rays (const Counts *counts)
{
  return counts->frame.counts.rays;
}

static gint64
count_lift_dimension (const Counts *counts)
{
  return counts->frame.delaunay.lift_dimension;
}

static gint64
count_facets (const Counts *counts)
{
  return counts->frame.counts.facets;
}

static gint64
count_lower (const Counts *counts)
{
  return counts->merged[FACING_LOWER];
}

static gint64
count_upper (const Counts *counts)
{
  return counts->merged[FACING_UPPER];
}

static gint64
count_vertical (const Counts *counts)
{
  return counts->merged[FACING_VERTICAL];
}

/* The columns with numbers, from the fourth on. */
static const struct {
  const char *name;
  gint64 (*count) (const Counts *counts);
} columns[] = {
  { "n", count_n },
  { "distinct", count_distinct },
  { "dimension", count_dimension },
  { "hull2d", count_hull2d },
  { "boundary_points", count_boundary },
  { "triangles", count_triangles },
  { "delaunay_edges", count_delaunay_edges },
  { "cocircular_cells", count_cells },
  { "voronoi_vertices", count_vertices },
  { "voronoi_edges", count_finite },
  { "voronoi_rays", count_rays },
  { "hull3d_dimension", count_lift_dimension },
  { "facets_triangulated", count_facets },
  { "lower_merged", count_lower },
  { "upper_merged", count_upper },
  { "vertical_merged", count_vertical },
};

enum { COLUMN_FILE, COLUMN_BYTES, COLUMN_EXPECTED, FIRST_COUNT };

static uint32_t
root (uint32_t *parent, uint32_t facet)
{
  while (parent[facet] != facet)
    facet = parent[facet] = parent[parent[facet]];
  return facet;
}

/* A coplanar ridge between two polygons of the hull makes them one. */
static void
count_merged (Counts *counts)
{
  const Trace *trace = counts->fixture->trace;
  const Frame *frame = &counts->frame;
  g_autofree uint32_t *parent = g_new (uint32_t, trace->n_facets + 1);

  for (uint32_t i = 0; i < trace->n_facets; i++)
    parent[i] = i;
  for (uint32_t i = 0; i < frame->n_facets; i++)
    counts->merged[trace->facets[frame->facets[i].facet].facing] += 1;
  for (uint32_t i = 0; i < frame->n_ridges; i++) {
    const RidgeRow row = trace_ridge (trace, frame->ridges[i].ridge);
    uint32_t a, b;

    if (!frame->ridges[i].is_coplanar)
      continue;
    a = root (parent, row.facet[0]);
    b = root (parent, row.facet[1]);
    if (a != b)
      counts->merged[trace->facets[a].facing] -= 1;
    parent[a] = b;
  }
  /* Sites on one circle: the polygon has two sides. */
  if (is_plane (counts) && frame->delaunay.lift_dimension == 2)
    counts->merged[FACING_LOWER] = counts->merged[FACING_UPPER] = 1;
}

static void
certify_step (const Fixture *fixture, uint32_t step)
{
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  frame_init (&frame, fixture->trace, step);
  if (!certify_frame (&frame, why))
    g_error ("%s, step %u: %s", fixture->name, step, why);
  frame_clear (&frame);
}

/* All rounds of small sets, the last of large ones. */
static void
certify_rounds (const Fixture *fixture)
{
  const uint32_t last = fixture->trace->n_events;
  uint32_t step = fixture->set->n_distinct <= 60 ? 0 : last;

  certify_step (fixture, step);
  while (step < last) {
    step = timeline_next (fixture->trace, step, GRAIN_ROUND);
    certify_step (fixture, step);
  }
}

static void
assert_counts (const Fixture *fixture, char **row)
{
  Counts counts = { .fixture = fixture };

  frame_init (&counts.frame, fixture->trace, fixture->trace->n_events);
  count_merged (&counts);
  for (gsize i = 0; i < G_N_ELEMENTS (columns); i++) {
    const gint64 count = columns[i].count (&counts);

    if (count != g_ascii_strtoll (row[FIRST_COUNT + i], NULL, 10))
      g_error ("%s: %s is %" G_GINT64_FORMAT " instead of %s", fixture->name,
               columns[i].name, count, row[FIRST_COUNT + i]);
  }
  frame_clear (&counts.frame);
}

typedef struct Case {
  char *folder;
  char **row;
} Case;

static void
test_file_is_as_listed (const void *data)
{
  const Case *test = data;
  g_autofree char *path
      = g_build_filename (test->folder, test->row[COLUMN_FILE], NULL);
  g_autofree char *text = NULL;
  gsize length;
  SiteFileError fault = { 0, "" };
  SiteSet *set;
  unsigned int line;

  g_assert_true (g_file_get_contents (path, &text, &length, NULL));
  g_assert_cmpuint (length, ==,
                    g_ascii_strtoull (test->row[COLUMN_BYTES], NULL, 10));
  set = site_file_parse (text, length, &fault);
  if (sscanf (test->row[COLUMN_EXPECTED], "refuse %u", &line) == 1) {
    g_assert_null (set);
    g_assert_cmpuint (fault.line, ==, line);
  } else {
    g_autoptr (Fixture) fixture = fixture_take (
        g_strdup (test->row[COLUMN_FILE]), set, &(Order){ ORDER_FURTHEST, 0 });

    assert_counts (fixture, test->row);
    certify_rounds (fixture);
  }
}

static void
free_case (void *data)
{
  Case *test = data;

  g_free (test->folder);
  g_strfreev (test->row);
  g_free (test);
}

static Case *
case_new (const char *folder, const char *line)
{
  Case *test = g_new (Case, 1);

  test->folder = g_strdup (folder);
  test->row = g_strsplit (line, "\t", -1);
  g_assert_cmpuint (g_strv_length (test->row), >=,
                    FIRST_COUNT + G_N_ELEMENTS (columns));
  return test;
}

/* Takes over @test. */
static void
add_case (Case *test, const char *suite)
{
  g_autofree char *path
      = g_strdup_printf ("/%s/%s-is-as-listed", suite, test->row[COLUMN_FILE]);

  g_test_add_data_func_full (path, test, test_file_is_as_listed, free_case);
}

/* The columns must be those that are counted here, in this order. */
static void
check_head (const char *line)
{
  g_auto (GStrv) names = g_strsplit (line, "\t", -1);

  for (gsize i = 0; i < G_N_ELEMENTS (columns); i++)
    g_assert_cmpstr (names[FIRST_COUNT + i], ==, columns[i].name);
}

static void
add_folder (const char *folder, const char *suite)
{
  g_autofree char *path = g_build_filename (folder, "MANIFEST.tsv", NULL);
  g_autofree char *text = NULL;
  g_auto (GStrv) lines = NULL;

  if (!g_file_get_contents (path, &text, NULL, NULL))
    g_error ("%s cannot be read", path);
  lines = g_strsplit (text, "\n", -1);
  check_head (lines[0]);
  for (char **line = lines + 1; *line != NULL; line++)
    if (**line != '\0')
      add_case (case_new (folder, *line), suite);
}

int
main (int argc, char **argv)
{
  const char *peers = g_getenv ("HULL2VD_PEERS");
  g_autofree char *folder = fixture_path ("corpus", "", "");

  g_test_init (&argc, &argv, NULL);
  add_folder (folder, "corpus");
  if (peers != NULL && *peers != '\0')
    add_folder (peers, "corpus-of-peers");
  return g_test_run ();
}
