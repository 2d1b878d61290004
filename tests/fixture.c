#include "fixture.h"

#include "site-file.h"

#include <math.h>
#include <stdlib.h>

const char *const *
fixture_names (void)
{
  static const char *const names[] = {
    "lecture8",    "lecture8b",  "mixed8",    "base4-in",  "base4-outl",
    "base4-outlu", "base4-outu", "cross5",    "convex4",   "inner4",
    "line3-1",     "square4",    "square5",   "flip5-in",  "flip5-tie",
    "flip5-out",   "tie6",       "near-far6", "gap6",      "obtuse6",
    "mwt4",        "wheel8",     "grid9",     "vertical5", "furthest8",
    "line4",       "duplicates", "point1",    "none",      NULL,
  };

  return names;
}

char *
fixture_path (const char *folder, const char *name, const char *end)
{
  const char *source = g_getenv ("HULL2VD_SOURCE");
  g_autofree char *file = g_strconcat (name, end, NULL);

  g_assert_nonnull (source);
  return g_build_filename (source, "tests", folder, file, NULL);
}

Fixture *
fixture_take (char *name, SiteSet *set, const Order *order)
{
  Fixture *fixture = g_new0 (Fixture, 1);

  g_assert_nonnull (set);
  fixture->name = name;
  fixture->set = set;
  fixture->trace = trace_record (set, order);
  return fixture;
}

void
fixture_free (Fixture *fixture)
{
  trace_free (fixture->trace);
  site_set_free (fixture->set);
  g_free (fixture->name);
  g_free (fixture);
}

/* Sets that are shipped lie with the lessons. */
char *
fixture_set_path (const char *name)
{
  g_autofree char *path = fixture_path ("sites", name, ".txt");
  g_autofree char *file = g_strconcat (name, ".txt", NULL);

  if (g_file_test (path, G_FILE_TEST_EXISTS))
    return g_steal_pointer (&path);
  return g_build_filename (g_getenv ("HULL2VD_SOURCE"), "lessons", "sites",
                           file, NULL);
}

static SiteSet *
read_set (const char *path)
{
  g_autofree char *text = NULL;
  gsize length;
  SiteFileError fault;
  SiteSet *set;

  if (!g_file_get_contents (path, &text, &length, NULL))
    g_error ("%s cannot be read", path);
  set = site_file_parse (text, length, &fault);
  if (set == NULL)
    g_error ("%s:%u: %s", path, fault.line, fault.reason);
  return set;
}

Fixture *
fixture_load (const char *name, OrderKind order)
{
  g_autofree char *path = fixture_set_path (name);

  return fixture_take (g_strdup (name), read_set (path), &(Order){ order, 0 });
}

SiteSet *
fixture_corpus_set (const char *name)
{
  g_autofree char *path = fixture_path ("corpus", name, ".txt");

  return read_set (path);
}

static void
shuffle (GArray *sites, GRand *rand)
{
  for (guint i = sites->len; i > 1; i--) {
    const guint j = (guint)g_rand_int_range (rand, 0, (gint32)i);
    const Site last = g_array_index (sites, Site, i - 1);

    g_array_index (sites, Site, i - 1) = g_array_index (sites, Site, j);
    g_array_index (sites, Site, j) = last;
  }
}

static void
add (GArray *sites, double x, double y)
{
  const Site site = { x, y };

  g_array_append_val (sites, site);
}

/* Each draw is a statement of its own: compilers differ in which argument of a
 * call is evaluated first, and the sets would differ with them. */
static void
add_square (GArray *sites, GRand *rand, guint n, int radius)
{
  for (guint i = 0; i < n; i++) {
    const int y = g_rand_int_range (rand, -radius, radius + 1);

    add (sites, g_rand_int_range (rand, -radius, radius + 1), y);
  }
}

static void
add_grid (GArray *sites, GRand *rand, guint n)
{
  const int width = g_rand_int_range (rand, 2, (int)(n / 2) + 1);
  const int height = MAX (2, (int)n / width);

  for (int i = 0; i < width * height; i++)
    add (sites, i % width, i / width); // NOLINT(bugprone-integer-division)
}

/* x² + y² = 65² has 36 integer points. */
static void
add_circle (GArray *sites, GRand *rand, guint n)
{
  for (int x = -65; x <= 65; x++) {
    const int square = 65 * 65 - x * x;
    const int y = (int)lround (sqrt (square));

    if (y * y != square)
      continue;
    add (sites, x, y);
    add (sites, x, -y); /* twice the same for y = 0: a duplicate */
  }
  shuffle (sites, rand);
  g_array_set_size (sites, MIN (n, sites->len));
  add_square (sites, rand, g_rand_int (rand) % 4, 20);
}

static void
add_line (GArray *sites, GRand *rand, guint n)
{
  const int slope = g_rand_int_range (rand, -2, 3);

  for (guint i = 0; i < n; i++) {
    const int x = g_rand_int_range (rand, -100, 101);

    add (sites, x, slope * x + 3);
  }
  add_square (sites, rand, g_rand_int (rand) % 4, 50);
}

static void
add_clusters (GArray *sites, GRand *rand, guint n)
{
  Site centre = { 0, 0 };

  for (guint i = 0; i < n; i++) {
    double y;

    if (i % 5 == 0)
      centre = (Site){ g_rand_int_range (rand, -50, 51),
                       g_rand_int_range (rand, -50, 51) };
    y = centre.y + ldexp (g_rand_int_range (rand, -3, 4), -40);
    add (sites, centre.x + ldexp (g_rand_int_range (rand, -3, 4), -40), y);
  }
}

static void
add_ulps (GArray *sites, GRand *rand, guint n)
{
  for (guint i = 0; i < n; i++) {
    const double x = g_rand_double_range (rand, 12, 24);

    add (sites, x, nextafter (x, g_rand_boolean (rand) ? 0 : 100));
  }
  add (sites, 0.5, 0.5);
}

static void
add_family (GArray *sites, Family family, GRand *rand, guint n)
{
  switch (family) {
  case FAMILY_RANDOM:
    add_square (sites, rand, n, 1 << 20);
    break;
  case FAMILY_TIES:
    add_square (sites, rand, n, 3);
    break;
  case FAMILY_GRID:
    add_grid (sites, rand, n);
    break;
  case FAMILY_CIRCLE:
    add_circle (sites, rand, n);
    break;
  case FAMILY_LINE:
    add_line (sites, rand, n);
    break;
  case FAMILY_CLUSTERS:
    add_clusters (sites, rand, n);
    break;
  case FAMILY_ULPS:
    add_ulps (sites, rand, n);
    break;
  }
}

Fixture *
fixture_new (Family family, guint32 seed, guint n, OrderKind order)
{
  static const char *const names[]
      = { "random", "ties", "grid", "circle", "line", "clusters", "ulps" };
  g_autoptr (GArray) sites = g_array_new (FALSE, FALSE, sizeof (Site));
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);

  add_family (sites, family, rand, n);
  shuffle (sites, rand);
  return fixture_take (
      g_strdup_printf ("%s %u", names[family], seed),
      site_set_new ((const Site *)(void *)sites->data, sites->len),
      &(Order){ order, seed });
}

static guint
positive_of (const char *variable)
{
  const char *number = g_getenv (variable);

  return number == NULL ? 1
                        : (guint)MAX (1, g_ascii_strtoull (number, NULL, 10));
}

guint
fixture_soak_factor (void)
{
  return positive_of ("HULL2VD_SOAK");
}

guint
fixture_n_seeds (guint n)
{
  return MAX (1, n * fixture_soak_factor () / positive_of ("HULL2VD_SAMPLE"));
}

void
fixture_for_each (guint n,
                  guint n_sites,
                  OrderKind order,
                  void (*check) (const Fixture *fixture))
{
  const guint n_seeds = fixture_n_seeds (n);

  for (guint i = 0; i < n_seeds * N_FAMILIES; i++) {
    g_autoptr (Fixture) fixture
        = fixture_new (i % N_FAMILIES, i / N_FAMILIES, n_sites, order);

    check (fixture);
  }
}

uint32_t
fixture_facet (const Fixture *fixture, uint32_t a, uint32_t b, uint32_t c)
{
  for (uint32_t i = 0; i < fixture->trace->n_facets; i++) {
    const uint32_t *site = fixture->trace->facets[i].site;
    guint n = 0;

    for (guint k = 0; k < 3; k++)
      n += site[k] == a || site[k] == b || site[k] == c;
    if (n == 3)
      return i;
  }
  return INDEX_NONE;
}

bool
fixture_ends_with (const Fixture *fixture, uint32_t a, uint32_t b, uint32_t c)
{
  const uint32_t facet = fixture_facet (fixture, a, b, c);

  return facet != INDEX_NONE
         && span_has (fixture->trace->facets[facet].span,
                      fixture->trace->n_events);
}
