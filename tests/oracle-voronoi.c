#include "oracle.h"

#include <float.h>
#include <math.h>

static JsonObject *
voronoi (const Oracle *oracle)
{
  return json_object_get_object_member (oracle->root, "voronoi");
}

static JsonArray *
triangles (const Oracle *oracle)
{
  return json_object_get_array_member (oracle->root, "triangles");
}

static void
corners_of (const Oracle *oracle, guint triangle, uint32_t site[3])
{
  for (guint k = 0; k < 3; k++)
    site[k]
        = oracle_site (oracle, oracle_item (triangles (oracle), triangle), k);
}

static gint64
vertex_of (const Oracle *oracle, guint triangle)
{
  return json_array_get_int_element (
      json_object_get_array_member (voronoi (oracle), "vertex_of_triangle"),
      triangle);
}

/* The circumcentre as a rational number, from the given coordinates. */
typedef struct Centre {
  mpq_t x, y;
} Centre;

/* square = u² + v²; u and v become the way from @from to @to. */
static void
way (mpq_t u, mpq_t v, mpq_t square, const Site *from, const Site *to)
{
  mpq_t part;

  mpq_init (part);
  mpq_set_d (u, to->x);
  mpq_set_d (part, from->x);
  mpq_sub (u, u, part);
  mpq_set_d (v, to->y);
  mpq_set_d (part, from->y);
  mpq_sub (v, v, part);
  mpq_mul (square, u, u);
  mpq_mul (part, v, v);
  mpq_add (square, square, part);
  mpq_clear (part);
}

/* result = a b - c d */
static void
cross (mpq_t result, mpq_t a, mpq_t b, mpq_t c, mpq_t d)
{
  mpq_t right;

  mpq_init (right);
  mpq_mul (result, a, b);
  mpq_mul (right, c, d);
  mpq_sub (result, result, right);
  mpq_clear (right);
}

/* Solves the equations of two perpendicular bisectors by Cramer's rule. */
static void
centre_init (Centre *centre, const Site *a, const Site *b, const Site *c)
{
  mpq_t bx, by, b_square, cx, cy, c_square, doubled, corner;

  mpq_inits (bx, by, b_square, cx, cy, c_square, doubled, corner, NULL);
  mpq_inits (centre->x, centre->y, NULL);
  way (bx, by, b_square, a, b);
  way (cx, cy, c_square, a, c);
  cross (doubled, bx, cy, by, cx);
  mpq_add (doubled, doubled, doubled);
  cross (centre->x, b_square, cy, by, c_square);
  cross (centre->y, bx, c_square, b_square, cx);
  mpq_div (centre->x, centre->x, doubled);
  mpq_div (centre->y, centre->y, doubled);
  mpq_set_d (corner, a->x);
  mpq_add (centre->x, centre->x, corner);
  mpq_set_d (corner, a->y);
  mpq_add (centre->y, centre->y, corner);
  mpq_clears (bx, by, b_square, cx, cy, c_square, doubled, corner, NULL);
}

/* One part in 1.4e14. Whether |value - exact| <= 2^-47 |exact| + the smallest
 * double. */
static bool
is_near (double value, mpq_t exact)
{
  mpq_t error, bound, least;
  bool is_good;

  mpq_inits (error, bound, least, NULL);
  mpq_set_d (error, value);
  mpq_sub (error, error, exact);
  mpq_abs (error, error);
  mpq_abs (bound, exact);
  mpq_div_2exp (bound, bound, 47);
  mpq_set_d (least, DBL_TRUE_MIN);
  mpq_add (bound, bound, least);
  is_good = mpq_cmp (error, bound) <= 0;
  mpq_clears (error, bound, least, NULL);
  return is_good;
}

static bool
is_beyond_doubles (mpq_t exact)
{
  mpq_t limit, size;
  bool is_beyond;

  mpq_inits (limit, size, NULL);
  mpq_set_d (limit, DBL_MAX);
  mpq_abs (size, exact);
  is_beyond = mpq_cmp (size, limit) > 0;
  mpq_clears (limit, size, NULL);
  return is_beyond;
}

static void
judge_vertex (const Oracle *oracle, guint triangle, JsonNode *vertex)
{
  uint32_t site[3];
  Site corner[3];
  Centre centre;

  corners_of (oracle, triangle, site);
  for (int k = 0; k < 3; k++)
    corner[k] = site_set_given (oracle->set, site[k]);
  centre_init (&centre, &corner[0], &corner[1], &corner[2]);
  if (json_node_is_null (vertex)) {
    oracle_assert (oracle, is_beyond_doubles (centre.x)
                               || is_beyond_doubles (centre.y));
  } else {
    JsonArray *at = json_node_get_array (vertex);

    oracle_assert (oracle, !is_beyond_doubles (centre.x)
                               && !is_beyond_doubles (centre.y));
    oracle_assert (oracle,
                   is_near (json_array_get_double_element (at, 0), centre.x));
    oracle_assert (oracle,
                   is_near (json_array_get_double_element (at, 1), centre.y));
  }
  mpq_clears (centre.x, centre.y, NULL);
}

static bool
is_one_circle (const Oracle *oracle, guint a, guint b)
{
  uint32_t circle[3], site[3];

  corners_of (oracle, a, circle);
  corners_of (oracle, b, site);
  for (int k = 0; k < 3; k++)
    if (judge_circle (oracle->judge, circle, site[k]) != 0)
      return false;
  return true;
}

/* Two triangles have one vertex if and only if they have one circle. */
static void
judge_vertices (const Oracle *oracle)
{
  JsonArray *vertices
      = json_object_get_array_member (voronoi (oracle), "vertices");
  const guint n = json_array_get_length (triangles (oracle));
  const guint n_vertices = json_array_get_length (vertices);
  g_autofree bool *is_used = g_new0 (bool, n_vertices + 1);

  for (guint i = 0; i < n; i++) {
    const gint64 vertex = vertex_of (oracle, i);

    oracle_assert (oracle, vertex >= 0 && vertex < n_vertices);
    is_used[vertex] = true;
    judge_vertex (oracle, i, json_array_get_element (vertices, (guint)vertex));
    for (guint k = 0; k < i; k++)
      oracle_assert (oracle, (vertex_of (oracle, k) == vertex)
                                 == is_one_circle (oracle, i, k));
  }
  for (guint i = 0; i < n_vertices; i++)
    oracle_assert (oracle, is_used[i]);
}

/* Returns: the triangle with the side from @tail to @head, or -1; sets
 *          *@third to its other corner. */
static gint64
triangle_left_of (const Oracle *oracle,
                  uint32_t tail,
                  uint32_t head,
                  uint32_t *third)
{
  for (guint i = 0; i < json_array_get_length (triangles (oracle)); i++) {
    uint32_t site[3];

    corners_of (oracle, i, site);
    for (guint k = 0; k < 3; k++) {
      *third = site[(k + 2) % 3];
      if (site[k] == tail && site[(k + 1) % 3] == head)
        return i;
    }
  }
  return -1;
}

/* Returns: how many edges of triangles are not inside a circle group. */
static guint
count_edges (const Oracle *oracle)
{
  guint n_edges = 0;

  if (oracle->dimension < 2)
    return oracle->dimension == 1 ? oracle->n_active - 1 : 0;
  for (guint i = 0; i < 3 * json_array_get_length (triangles (oracle)); i++) {
    uint32_t site[3], third;
    gint64 other;

    corners_of (oracle, i / 3, site);
    other = triangle_left_of (oracle, site[(i + 1) % 3], site[i % 3], &third);
    n_edges += other < 0
               || (other < i / 3
                   && vertex_of (oracle, (guint)other)
                          != vertex_of (oracle, i / 3));
  }
  return n_edges;
}

/* Checks that the direction is at right angles to the way between the sites;
 * @side: 1 it must lie to the left, -1 to the right, 0 either. */
static void
judge_direction (const Oracle *oracle, JsonArray *edge, int side)
{
  const Site *tail = &oracle->set->sites[oracle_site (oracle, edge, 0)];
  const Site *head = &oracle->set->sites[oracle_site (oracle, edge, 1)];
  const double x = head->x - tail->x, y = head->y - tail->y;
  const double dx = json_array_get_double_element (edge, 4);
  const double dy = json_array_get_double_element (edge, 5);
  const double left = x * dy - y * dx;

  oracle_assert (oracle, fabs (x * dx + y * dy) <= 1e-14 * fabs (left));
  oracle_assert (oracle, side == 0 ? left != 0 : left * side > 0);
}

static void
judge_ray (const Oracle *oracle, JsonArray *edge)
{
  const uint32_t i = oracle_site (oracle, edge, 0);
  const uint32_t j = oracle_site (oracle, edge, 1);
  uint32_t third;
  const gint64 left = triangle_left_of (oracle, i, j, &third);
  const gint64 right = triangle_left_of (oracle, j, i, &third);

  oracle_assert (oracle, json_array_get_length (edge) == 6);
  oracle_assert (oracle, (left < 0) != (right < 0));
  oracle_assert (oracle, json_array_get_int_element (edge, 2)
                             == vertex_of (oracle, (guint)MAX (left, right)));
  judge_direction (oracle, edge, left < 0 ? 1 : -1);
}

static void
judge_finite (const Oracle *oracle, JsonArray *edge)
{
  const uint32_t i = oracle_site (oracle, edge, 0);
  const uint32_t j = oracle_site (oracle, edge, 1);
  const gint64 u = json_array_get_int_element (edge, 2);
  const gint64 w = json_array_get_int_element (edge, 3);
  uint32_t third;
  const gint64 left = triangle_left_of (oracle, i, j, &third);
  const gint64 right = triangle_left_of (oracle, j, i, &third);

  oracle_assert (oracle, json_array_get_length (edge) == 4);
  oracle_assert (oracle, left >= 0 && right >= 0 && u != w);
  oracle_assert (oracle, u == vertex_of (oracle, (guint)left)
                             || u == vertex_of (oracle, (guint)right));
  oracle_assert (oracle, w == vertex_of (oracle, (guint)left)
                             || w == vertex_of (oracle, (guint)right));
}

static void
judge_line (const Oracle *oracle, JsonArray *edge)
{
  const Site tail = site_set_given (oracle->set, oracle_site (oracle, edge, 0));
  const Site head = site_set_given (oracle->set, oracle_site (oracle, edge, 1));
  const double x = json_array_get_double_element (edge, 6);
  const double y = json_array_get_double_element (edge, 7);

  oracle_assert (oracle, oracle->dimension == 1);
  oracle_assert (oracle, json_array_get_length (edge) == 8);
  oracle_assert (oracle, x == tail.x / 2 + head.x / 2);
  oracle_assert (oracle, y == tail.y / 2 + head.y / 2);
  judge_direction (oracle, edge, 0);
}

static void
judge_edge (const Oracle *oracle, JsonArray *edge)
{
  if (json_array_get_int_element (edge, 3) >= 0)
    judge_finite (oracle, edge);
  else if (json_array_get_int_element (edge, 2) >= 0)
    judge_ray (oracle, edge);
  else
    judge_line (oracle, edge);
}

void
oracle_judge_voronoi (const Oracle *oracle)
{
  JsonArray *edges = json_object_get_array_member (voronoi (oracle), "edges");
  const guint n = oracle->set->n_sites;
  g_autofree bool *is_there = g_new0 (bool, (gsize)n *n + 1);

  oracle_assert (oracle,
                 json_object_has_member (voronoi (oracle), "vertex_of_triangle")
                     == (oracle->dimension == 2));
  judge_vertices (oracle);
  oracle_assert (oracle, json_array_get_length (edges) == count_edges (oracle));
  for (guint i = 0; i < json_array_get_length (edges); i++) {
    JsonArray *edge = oracle_item (edges, i);
    const uint32_t a = oracle_site (oracle, edge, 0);
    const uint32_t b = oracle_site (oracle, edge, 1);
    bool *mark = &is_there[MIN (a, b) * n + MAX (a, b)];

    oracle_assert (oracle, !*mark);
    *mark = true;
    judge_edge (oracle, edge);
  }
}
