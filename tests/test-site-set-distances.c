/* Distances, centres and angles of the curated site sets. The numbers were
 * worked out in rational arithmetic before the engine was written. */
#include "exact.h"
#include "frame.h"
#include "standing.h"

#include <math.h>

#define assert_near(value, expected)                                           \
  g_assert_cmpfloat_with_epsilon ((value), (expected), 0.0006)

/* Least |power| / r² of a waiting site, over the facets that stand. */
static double
margin_of (const Fixture *fixture, uint32_t step)
{
  const Trace *trace = fixture->trace;
  const Site *sites = fixture->set->sites;
  double margin = INFINITY;

  for (uint32_t i = 0; i < trace->n_facets; i++) {
    const uint32_t *corner = trace->facets[i].site;
    const Site centre = exact_circumcentre (
        &sites[corner[0]], &sites[corner[1]], &sites[corner[2]]);
    const double radius
        = hypot (sites[corner[0]].x - centre.x, sites[corner[0]].y - centre.y);

    for (uint32_t k = 0; k < fixture->set->n_sites; k++)
      if (span_has (trace->facets[i].span, step) && trace->inserted[k] > step) {
        const double d = hypot (sites[k].x - centre.x, sites[k].y - centre.y);

        margin = fmin (margin, fabs (d * d / (radius * radius) - 1));
      }
  }
  return margin;
}

static void
test_margins (void)
{
  static const struct {
    const char *name;
    double margin;
  } facts[]
      = { { "lecture8", 0.16 }, { "lecture8b", 0.25 }, { "mixed8", 0.37 } };

  for (guint i = 0; i < G_N_ELEMENTS (facts); i++) {
    g_autoptr (Fixture) fixture = fixture_load (facts[i].name, ORDER_FURTHEST);
    double margin = INFINITY;

    for (uint32_t round = 0; round < fixture->trace->n_rounds; round++)
      margin
          = fmin (margin, margin_of (fixture,
                                     fixture->trace->rounds[round].select - 1));
    g_assert_cmpfloat_with_epsilon (margin, facts[i].margin, 0.01);
  }
}

typedef struct Vector {
  double x, y, z;
} Vector;

static Vector
lift (const Site *site)
{
  return (Vector){ site->x, site->y, site->x * site->x + site->y * site->y };
}

static Vector
minus (Vector a, Vector b)
{
  return (Vector){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static double
dot (Vector a, Vector b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static Vector
cross (Vector a, Vector b)
{
  return (Vector){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                   a.x * b.y - a.y * b.x };
}

/* How far a site's lift lies in front of the plane of three lifts. */
typedef struct Distance {
  double gap, perpendicular; /* vertical; along the normal */
} Distance;

static Distance
distance_to (const SiteSet *set, const uint32_t corner[3], uint32_t site)
{
  const Vector a = lift (&set->sites[corner[0]]);
  const Vector u = minus (lift (&set->sites[corner[1]]), a);
  const Vector v = minus (lift (&set->sites[corner[2]]), a);
  const Vector normal = cross (u, v);
  const double front = dot (normal, minus (lift (&set->sites[site]), a));

  return (Distance){ fabs (front / normal.z),
                     front / sqrt (dot (normal, normal)) };
}

static double
distance_to_segment (Vector p, Vector a, Vector b)
{
  const Vector edge = minus (b, a), way = minus (p, a);
  const double t = CLAMP (dot (way, edge) / dot (edge, edge), 0, 1);
  const Vector rest
      = { way.x - t * edge.x, way.y - t * edge.y, way.z - t * edge.z };

  return sqrt (dot (rest, rest));
}

/* Distance between a lift and a triangle of lifts. */
static double
distance_to_triangle (const SiteSet *set, const uint32_t c[3], uint32_t site)
{
  const Vector p = lift (&set->sites[site]);
  const Vector a[3] = { lift (&set->sites[c[0]]), lift (&set->sites[c[1]]),
                        lift (&set->sites[c[2]]) };
  const Vector normal = cross (minus (a[1], a[0]), minus (a[2], a[0]));
  double distance = INFINITY;
  bool is_over = true;

  for (guint i = 0; i < 3; i++) {
    const Vector next = a[(i + 1) % 3];

    is_over = is_over
              && dot (cross (minus (next, a[i]), minus (p, a[i])), normal) >= 0;
    distance = fmin (distance, distance_to_segment (p, a[i], next));
  }
  return is_over ? fabs (distance_to (set, c, site).perpendicular) : distance;
}

/* Distance between a lift and the first simplex. */
static double
distance_to_simplex (const Fixture *fixture, uint32_t site)
{
  double distance = INFINITY;

  for (uint32_t i = 0; i < 4; i++)
    distance = fmin (
        distance, distance_to_triangle (fixture->set,
                                        fixture->trace->facets[i].site, site));
  return distance;
}

static void
test_near_far6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("near-far6", ORDER_FURTHEST);
  const uint32_t facet = fixture_facet (fixture, 2, 3, 0);
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing
      = standing_new (fixture, judge, fixture->trace->start_end);
  g_autofree char *seen = standing_seen (standing, 4);
  g_autofree char *seen_by_5 = standing_seen (standing, 5);
  g_autofree char *name = g_strdup_printf ("%u", facet);

  g_assert_cmpstr (seen, ==, name);
  g_assert_cmpstr (seen_by_5, ==, name);
  assert_near (distance_to (fixture->set, fixture->trace->facets[facet].site, 4)
                   .perpendicular,
               0.2542);
  assert_near (distance_to (fixture->set, fixture->trace->facets[facet].site, 5)
                   .perpendicular,
               0.1508);
  assert_near (distance_to_simplex (fixture, 4), 0.2542);
  assert_near (distance_to_simplex (fixture, 5), 0.3001);
  g_assert_cmpuint (fixture->trace->rounds[0].site, ==, 4);
}

static void
test_gap6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("gap6", ORDER_FURTHEST);
  const uint32_t first = fixture_facet (fixture, 2, 3, 1);
  const uint32_t second = fixture_facet (fixture, 1, 3, 0);
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing
      = standing_new (fixture, judge, fixture->trace->start_end);
  g_autofree char *seen = standing_seen (standing, 4);
  g_autofree char *seen_by_5 = standing_seen (standing, 5);

  g_assert_cmpuint (first, ==, 2);
  g_assert_cmpuint (second, ==, 3);
  g_assert_cmpstr (seen, ==, "2");
  g_assert_cmpstr (seen_by_5, ==, "3");
  assert_near (
      distance_to (fixture->set, fixture->trace->facets[first].site, 4).gap,
      1.676);
  assert_near (distance_to (fixture->set, fixture->trace->facets[first].site, 4)
                   .perpendicular,
               0.210);
  assert_near (
      distance_to (fixture->set, fixture->trace->facets[second].site, 5).gap,
      0.614);
  assert_near (
      distance_to (fixture->set, fixture->trace->facets[second].site, 5)
          .perpendicular,
      0.432);
  g_assert_cmpuint (fixture->trace->rounds[0].site, ==, 4);
}

/* The least angle of a triangle, in degrees. */
static double
least_angle (const Site *a, const Site *b, const Site *c)
{
  const Site *corner[3] = { a, b, c };
  double least = 180;

  for (guint i = 0; i < 3; i++) {
    const Site *p = corner[i], *q = corner[(i + 1) % 3],
               *r = corner[(i + 2) % 3];
    const double turn
        = atan2 (q->y - p->y, q->x - p->x) - atan2 (r->y - p->y, r->x - p->x);

    least = fmin (least, acos (cos (turn)) * 180 / G_PI);
  }
  return least;
}

static void
test_mwt4 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mwt4", ORDER_FURTHEST);
  const Site *s = fixture->set->sites;

  g_assert_true (fixture_ends_with (fixture, 0, 1, 3));
  g_assert_true (fixture_ends_with (fixture, 1, 2, 3));
  assert_near (hypot (s[1].x - s[3].x, s[1].y - s[3].y), 1.288);
  assert_near (hypot (s[0].x - s[2].x, s[0].y - s[2].y), 0.760);
  g_assert_cmpfloat_with_epsilon (fmin (least_angle (&s[0], &s[1], &s[3]),
                                        least_angle (&s[1], &s[2], &s[3])),
                                  13.0, 0.06);
  g_assert_cmpfloat_with_epsilon (fmin (least_angle (&s[0], &s[1], &s[2]),
                                        least_angle (&s[0], &s[2], &s[3])),
                                  1.3, 0.06);
}

/* Returns: the Voronoi vertex of the triangle with these corners. */
static Site
centre_of (const Fixture *fixture, uint32_t a, uint32_t b, uint32_t c)
{
  const uint32_t facet = fixture_facet (fixture, a, b, c);
  Site centre = { NAN, NAN };
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (uint32_t i = 0; i < frame.delaunay.n_triangles; i++)
    if (frame.delaunay.triangles[i].facet == facet)
      centre = frame.voronoi.vertices[frame.delaunay.triangles[i].group].at;
  frame_clear (&frame);
  return centre;
}

static bool
is_in_triangle (const Site *p, const Site *a, const Site *b, const Site *c)
{
  const int turn = orient (a, b, c);

  return orient (a, b, p) == turn && orient (b, c, p) == turn
         && orient (c, a, p) == turn;
}

static void
test_obtuse6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("obtuse6", ORDER_FURTHEST);
  const Site *s = fixture->set->sites;
  const Site inner = centre_of (fixture, 0, 1, 5);
  const Site outer = centre_of (fixture, 1, 4, 5);
  const Site right = centre_of (fixture, 2, 3, 4);
  const Site left = centre_of (fixture, 3, 4, 5);
  const Site centre = centre_of (fixture, 1, 2, 4);

  g_assert_true (is_in_triangle (&inner, &s[0], &s[1], &s[5]));
  g_assert_true (is_in_triangle (&centre, &s[1], &s[2], &s[4]));
  g_assert_true (is_in_triangle (&outer, &s[0], &s[1], &s[5]));
  assert_near (outer.x, -0.158);
  assert_near (outer.y, 0.137);
  assert_near (right.x, 0.406);
  assert_near (right.y, -0.656);
  assert_near (left.x, -0.427);
  assert_near (left.y, -0.537);
  /* Both beyond a hull edge; and the Voronoi edge of s1 s5 stays on one side
   * of it. */
  g_assert_cmpint (orient (&s[3], &s[2], &right), <, 0);
  g_assert_cmpint (orient (&s[5], &s[3], &left), <, 0);
  g_assert_cmpint (orient (&s[1], &s[5], &inner), ==,
                   orient (&s[1], &s[5], &outer));
}

static void
test_tie6 (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("tie6", ORDER_FURTHEST);
  static const uint32_t plane[3] = { 0, 3, 1 };

  assert_near (distance_to (fixture->set, plane, 4).gap, 137.0 / 448);
  assert_near (distance_to (fixture->set, plane, 5).gap, 137.0 / 448);
}

static void
test_flip5 (void)
{
  static const struct {
    const char *name;
    double power;
  } facts[] = { { "flip5-in", -11.0 / 256 },
                { "flip5-tie", 0 },
                { "flip5-out", 13.0 / 256 } };
  static const uint32_t circle[3] = { 0, 1, 2 };

  for (guint i = 0; i < G_N_ELEMENTS (facts); i++) {
    g_autoptr (Fixture) fixture = fixture_load (facts[i].name, ORDER_FURTHEST);
    g_autoptr (Judge) judge = judge_new (fixture->set);
    const int side = judge_circle (judge, circle, 3);

    g_assert_cmpfloat_with_epsilon (
        side * distance_to (fixture->set, circle, 3).gap, facts[i].power,
        1e-12);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
#define ADD(name, test) g_test_add_func ("/site-sets/" name, test)
  ADD ("waiting-sites-are-far-from-the-circles", test_margins);
  ADD ("near-far6-takes-the-furthest-from-the-facet", test_near_far6);
  ADD ("gap6-has-a-wide-gap-and-a-short-perpendicular", test_gap6);
  ADD ("tie6-has-two-equal-gaps", test_tie6);
  ADD ("flip5-has-powers-of-both-signs-and-zero", test_flip5);
  ADD ("mwt4-takes-the-longer-diagonal-for-the-wider-angle", test_mwt4);
  ADD ("obtuse6-has-centres-outside-their-triangles", test_obtuse6);
  return g_test_run ();
}
