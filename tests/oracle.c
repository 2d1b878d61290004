#include "oracle.h"

JsonArray *
oracle_item (JsonArray *list, guint i)
{
  return json_array_get_array_element (list, i);
}

static bool
is_active (const Oracle *oracle, gint64 site)
{
  for (uint32_t i = 0; i < oracle->n_active; i++)
    if (oracle->active[i] == site)
      return true;
  return false;
}

uint32_t
oracle_site (const Oracle *oracle, JsonArray *list, guint k)
{
  const gint64 site = json_array_get_int_element (list, k);

  oracle_assert (oracle, is_active (oracle, site));
  return (uint32_t)site;
}

static JsonArray *
list (const Oracle *oracle, const char *key)
{
  oracle_assert (oracle, json_object_has_member (oracle->root, key));
  return json_object_get_array_member (oracle->root, key);
}

static bool
is_equal (const SiteSet *set, uint32_t a, uint32_t b)
{
  return set->sites[a].x == set->sites[b].x
         && set->sites[a].y == set->sites[b].y;
}

/* Returns: the lowest index of an equal site. */
static uint32_t
first_equal (const SiteSet *set, uint32_t site)
{
  uint32_t first = 0;

  while (!is_equal (set, first, site))
    first++;
  return first;
}

static void
judge_points (const Oracle *oracle)
{
  JsonArray *points = list (oracle, "points");
  const uint32_t n = oracle->set->n_sites;

  oracle_assert (oracle, json_object_get_int_member (oracle->root, "n") == n);
  oracle_assert (oracle, json_array_get_length (points) == n);
  for (uint32_t i = 0; i < n; i++) {
    JsonArray *point = oracle_item (points, i);
    const Site given = site_set_given (oracle->set, i);

    oracle_assert (oracle, json_array_get_length (point) == 2);
    oracle_assert (oracle, json_array_get_double_element (point, 0) == given.x);
    oracle_assert (oracle, json_array_get_double_element (point, 1) == given.y);
  }
}

static void
judge_duplicates (const Oracle *oracle)
{
  const bool is_there = json_object_has_member (oracle->root, "duplicates");
  uint32_t n = 0;

  for (uint32_t i = 0; i < oracle->set->n_sites; i++)
    n += first_equal (oracle->set, i) != i;
  oracle_assert (oracle, is_there == (n > 0));
  if (n == 0)
    return;
  oracle_assert (oracle,
                 json_array_get_length (list (oracle, "duplicates")) == n);
  for (uint32_t i = 0, k = 0; i < oracle->set->n_sites; i++) {
    const uint32_t first = first_equal (oracle->set, i);
    JsonArray *pair;

    if (first == i)
      continue;
    pair = oracle_item (list (oracle, "duplicates"), k++);
    oracle_assert (oracle, json_array_get_int_element (pair, 0) == i);
    oracle_assert (oracle, json_array_get_int_element (pair, 1) == first);
  }
}

static void
find_active (Oracle *oracle)
{
  oracle->active = g_new (uint32_t, oracle->set->n_sites + 1);
  if (json_object_has_member (oracle->root, "active")) {
    JsonArray *active = list (oracle, "active");

    for (guint i = 0; i < json_array_get_length (active); i++)
      oracle->active[oracle->n_active++]
          = (uint32_t)json_array_get_int_element (active, i);
    return;
  }
  for (uint32_t i = 0; i < oracle->set->n_sites; i++)
    if (first_equal (oracle->set, i) == i)
      oracle->active[oracle->n_active++] = i;
}

static void
find_hull (Oracle *oracle)
{
  oracle->corners = g_new (uint32_t, oracle->n_active + 2);
  oracle->n_corners = judge_hull (oracle->judge, oracle->active,
                                  oracle->n_active, oracle->corners);
  for (uint32_t i = 0; i < oracle->n_active; i++)
    oracle->n_boundary += judge_inside (oracle->judge, oracle->corners,
                                        oracle->n_corners, oracle->active[i])
                          == 0;
  oracle->dimension = MIN ((int)oracle->n_corners, 3) - 1;
  oracle_assert (oracle, json_object_get_int_member (oracle->root, "dimension")
                             == oracle->dimension);
}

static void
judge_hull2d (const Oracle *oracle)
{
  JsonArray *hull = list (oracle, "hull2d");
  const uint32_t n = oracle->n_corners;
  uint32_t shift = 0;

  oracle_assert (oracle, json_array_get_length (hull) == n);
  while (shift < n && oracle_site (oracle, hull, shift) != oracle->corners[0])
    shift++;
  for (uint32_t i = 0; i < n; i++)
    oracle_assert (oracle, oracle_site (oracle, hull, (shift + i) % n)
                               == oracle->corners[i]);
}

static void
read_triple (const Oracle *oracle, JsonArray *triple, uint32_t site[3])
{
  oracle_assert (oracle, json_array_get_length (triple) == 3);
  for (guint k = 0; k < 3; k++)
    site[k] = oracle_site (oracle, triple, k);
}

/* No site may lie on the wrong side of a circle: -1 inside, +1 outside. */
static void
judge_circle_of (const Oracle *oracle, const uint32_t site[3], int wrong)
{
  for (uint32_t i = 0; i < oracle->n_active; i++)
    oracle_assert (oracle, judge_circle (oracle->judge, site, oracle->active[i])
                               != wrong);
}

static void
judge_triangles (const Oracle *oracle)
{
  JsonArray *triangles = list (oracle, "triangles");
  const uint32_t n = json_array_get_length (triangles);

  oracle_assert (oracle,
                 n
                     == (oracle->dimension < 2
                             ? 0
                             : 2 * oracle->n_active - 2 - oracle->n_boundary));
  for (uint32_t i = 0; i < n; i++) {
    uint32_t site[3];

    read_triple (oracle, oracle_item (triangles, i), site);
    oracle_assert (
        oracle, judge_orient (oracle->judge, site[0], site[1], site[2]) == 1);
    judge_circle_of (oracle, site, -1);
  }
}

/* Each site of a line but one begins a segment to its next. */
static void
judge_segments (const Oracle *oracle)
{
  const bool is_there = json_object_has_member (oracle->root, "segments");

  oracle_assert (oracle, is_there == (oracle->dimension == 1));
  if (!is_there)
    return;
  oracle_assert (oracle, json_array_get_length (list (oracle, "segments"))
                             == oracle->n_active - 1);
  for (uint32_t i = 0; i + 1 < oracle->n_active; i++) {
    JsonArray *pair = oracle_item (list (oracle, "segments"), i);
    const Site *a = &oracle->set->sites[oracle_site (oracle, pair, 0)];
    const Site *b = &oracle->set->sites[oracle_site (oracle, pair, 1)];

    for (uint32_t k = 0; k < oracle->n_active; k++) {
      const Site *c = &oracle->set->sites[oracle->active[k]];

      oracle_assert (oracle,
                     c == a || c == b
                         || (site_compare (a, c) != site_compare (c, b)));
    }
  }
}

/* Returns: whether the three sites are a triangle of the list, whichever way
 *          it turns. */
static bool
is_triangle (const Oracle *oracle, const uint32_t site[3])
{
  JsonArray *triangles = list (oracle, "triangles");

  for (guint i = 0; i < json_array_get_length (triangles); i++) {
    uint32_t corner[3], n_common = 0;

    read_triple (oracle, oracle_item (triangles, i), corner);
    for (uint32_t k = 0; k < 9; k++)
      n_common += corner[k / 3] == site[k % 3];
    if (n_common == 3)
      return true;
  }
  return false;
}

/* All sites lie on one side of the line under a vertical facet. */
static void
judge_vertical (const Oracle *oracle, const uint32_t site[3])
{
  int side = 0;

  for (uint32_t i = 0; i < oracle->n_active; i++) {
    const int turn
        = judge_orient (oracle->judge, site[0], site[1], oracle->active[i]);

    oracle_assert (oracle, turn == 0 || side == 0 || turn == side);
    side = turn != 0 ? turn : side;
  }
}

/* Returns: the kind that the facet must have. */
static const char *
judge_facet (const Oracle *oracle, const uint32_t site[3])
{
  const int turn = judge_orient (oracle->judge, site[0], site[1], site[2]);

  if (turn == 0) {
    judge_vertical (oracle, site);
    return "vertical";
  }
  judge_circle_of (oracle, site, turn);
  if (turn > 0)
    return "upper";
  oracle_assert (oracle, is_triangle (oracle, site));
  return "lower";
}

/* Every ridge is walked once in each direction. */
static void
judge_closed (const Oracle *oracle, JsonArray *facets)
{
  const uint32_t n = oracle->set->n_sites;
  g_autofree uint8_t *n_walks = g_new0 (uint8_t, (gsize)n * n);

  for (guint i = 0; i < json_array_get_length (facets); i++) {
    uint32_t site[3];

    read_triple (oracle, oracle_item (facets, i), site);
    for (uint32_t k = 0; k < 3; k++)
      n_walks[site[k] * n + site[(k + 1) % 3]] += 1;
  }
  for (uint32_t i = 0; i < n * n; i++) {
    oracle_assert (oracle, n_walks[i] <= 1);
    oracle_assert (oracle, n_walks[i] == n_walks[i % n * n + i / n]);
  }
}

static void
judge_facets (const Oracle *oracle, JsonObject *hull)
{
  JsonArray *facets = json_object_get_array_member (hull, "facets");
  JsonArray *kinds = json_object_get_array_member (hull, "kinds");
  const guint n = json_array_get_length (facets);
  guint n_lower = 0, n_vertical = 0;

  oracle_assert (oracle, json_array_get_length (kinds) == n);
  oracle_assert (oracle, n == 2 * oracle->n_active - 4);
  for (guint i = 0; i < n; i++) {
    const char *kind = json_array_get_string_element (kinds, i);
    uint32_t site[3];

    read_triple (oracle, oracle_item (facets, i), site);
    oracle_assert (oracle, g_str_equal (kind, judge_facet (oracle, site)));
    n_lower += g_str_equal (kind, "lower");
    n_vertical += g_str_equal (kind, "vertical");
  }
  oracle_assert (oracle, n_vertical == oracle->n_boundary - oracle->n_corners);
  oracle_assert (oracle,
                 n_lower == json_array_get_length (list (oracle, "triangles")));
  judge_closed (oracle, facets);
}

/* Returns: whether all active sites lie on one circle. */
static bool
is_circle (const Oracle *oracle)
{
  for (uint32_t i = 0; i < oracle->n_active; i++)
    if (judge_circle (oracle->judge, oracle->corners, oracle->active[i]) != 0)
      return false;
  return true;
}

static void
judge_hull3d (const Oracle *oracle)
{
  JsonObject *hull = json_object_get_object_member (oracle->root, "hull3d");
  const gint64 dimension = json_object_get_int_member (hull, "dimension");

  if (oracle->dimension == 2 && !is_circle (oracle)) {
    oracle_assert (oracle, dimension == 3);
    judge_facets (oracle, hull);
    return;
  }
  oracle_assert (oracle, dimension == MIN ((gint64)oracle->n_active - 1, 2));
  oracle_assert (oracle, json_array_get_length (
                             json_object_get_array_member (hull, "facets"))
                             == 0);
  oracle_assert (oracle, json_array_get_length (
                             json_object_get_array_member (hull, "kinds"))
                             == 0);
}

void
oracle_judge (const char *json, const SiteSet *set, const char *name)
{
  g_autoptr (JsonParser) parser = json_parser_new_immutable ();
  g_autoptr (GError) error = NULL;
  Oracle oracle = { .name = name, .set = set, .judge = judge_new (set) };

  if (!json_parser_load_from_data (parser, json, -1, &error))
    g_error ("%s: %s", name, error->message);
  oracle.root = json_node_get_object (json_parser_get_root (parser));
  judge_points (&oracle);
  judge_duplicates (&oracle);
  find_active (&oracle);
  find_hull (&oracle);
  judge_hull2d (&oracle);
  judge_triangles (&oracle);
  judge_segments (&oracle);
  judge_hull3d (&oracle);
  oracle_judge_voronoi (&oracle);
  judge_free (oracle.judge);
  g_free (oracle.active);
  g_free (oracle.corners);
}
