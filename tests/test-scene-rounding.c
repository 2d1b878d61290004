/* The pictures of the demonstration of rounding against the judge and against
 * the signs themselves. */
#include "fixture.h"
#include "judge.h"
#include "scene-rounding.h"

#include <math.h>

static const SceneLook plain = { .layers = LAYERS_DEFAULT,
                                 .extent = { { 0, 0 }, 32 },
                                 .low = { -1, -1, 0 },
                                 .high = { 1, 1, 0 } };

/* Hulls */

typedef struct Picture {
  const RoundedHull *hull;
  Judge *judge;
  uint32_t *corners; /* of the sites tried, by the judge */
  guint n_corners;
} Picture;

static gboolean
has (const uint32_t *sites, guint n, guint site)
{
  for (guint i = 0; i < n; i++)
    if (sites[i] == site)
      return TRUE;
  return FALSE;
}

/* The first triangle is made of three sites, each step is of one more. */
static Role
expected_role (const Picture *picture, gboolean is_exact, guint site)
{
  const RoundedHull *hull = picture->hull;
  const gboolean is_true = has (picture->corners, picture->n_corners, site);
  const gboolean is_drawn
      = is_exact ? is_true : has (hull->corners, hull->n_corners, site);

  if (site == hull->steps[hull->n_steps - 1].site)
    return ROLE_SITE_APEX;
  if (!has (hull->order, hull->n_steps + 2, site))
    return ROLE_SITE_WAITING;
  if (is_drawn)
    return ROLE_SITE;
  return is_true ? ROLE_SITE_LOST : ROLE_SITE_IGNORED;
}

/* Returns: how many sites are told to be lost. */
static guint
check_picture (const Picture *picture, gboolean is_exact)
{
  Scene scene = { 0 };
  guint n_sites = 0, n_edges = 0, n_lost = 0;

  scene_rounded (&scene, picture->hull, is_exact, &plain);
  for (guint i = 0; i < scene.n_items; i++) {
    const SceneItem *item = &scene.items[i];

    n_edges += item->role == ROLE_HULL_EDGE;
    n_lost += item->role == ROLE_SITE_LOST;
    if (item->shape != SHAPE_MARK)
      continue;
    n_sites += 1;
    g_assert_cmpstr (
        role_name (item->role), ==,
        role_name (expected_role (picture, is_exact, item->object.number)));
  }
  g_assert_cmpuint (n_sites, ==, picture->hull->set->n_sites);
  if (is_exact)
    g_assert_cmpuint (n_edges, ==, picture->n_corners);
  scene_clear (&scene);
  return n_lost;
}

/* Returns: how many sites are lost after the last step. */
static guint
check_steps (const char *name)
{
  SiteSet *set = fixture_corpus_set (name);
  Picture picture = { .judge = judge_new (set),
                      .corners = g_new (uint32_t, set->n_sites + 1) };
  guint n_lost = 0, n_done = 0;

  for (guint step = 1; step == n_done + 1; step++) {
    RoundedHull hull;

    rounded_hull_init (&hull, set, step);
    n_done = hull.n_steps;
    picture.hull = &hull;
    picture.n_corners
        = judge_hull (picture.judge, hull.order, n_done + 2, picture.corners);
    n_lost = check_picture (&picture, TRUE);
    g_assert_cmpuint (n_lost, ==, 0);
    n_lost = check_picture (&picture, FALSE);
    rounded_hull_clear (&hull);
  }
  g_free (picture.corners);
  judge_free (picture.judge);
  site_set_free (set);
  return n_lost;
}

static void
test_each_site_is_drawn_as_what_became_of_it (void)
{
  const guint n_lost = check_steps ("kettner-a1");

  g_assert_cmpuint (n_lost, ==, 1);
  check_steps ("kettner-a1-global");
  check_steps ("kettner-a2");
  check_steps ("kettner-b1");
}

/* Sign maps */

static guint
node_of (double border)
{
  return (guint)lrint ((border + 1) / 2 * SIGN_MAP_SIDE);
}

/* Paints as a painter does: what comes later lies over what came before. */
static void
paint (const Scene *scene, Role nodes[SIGN_MAP_SIDE][SIGN_MAP_SIDE])
{
  for (guint i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];
    const Point3 *corner = scene->points + item->first;

    if (item->shape != SHAPE_POLYGON)
      continue;
    g_assert_cmpuint (item->n, ==, 4);
    for (guint row = node_of (corner[0].y); row < node_of (corner[2].y); row++)
      for (guint column = node_of (corner[0].x); column < node_of (corner[2].x);
           column++)
        nodes[row][column] = item->role;
  }
}

static void
check_map (const SignMap *map, gboolean is_exact)
{
  static const Role roles[]
      = { ROLE_SIGN_RIGHT, ROLE_SIGN_ZERO, ROLE_SIGN_LEFT };
  static Role nodes[SIGN_MAP_SIDE][SIGN_MAP_SIDE];
  Scene scene = { 0 };

  scene_sign_map (&scene, map, is_exact, (const uint32_t[2]){ 7, 99 }, &plain);
  paint (&scene, nodes);
  for (guint row = 0; row < SIGN_MAP_SIDE; row++)
    for (guint column = 0; column < SIGN_MAP_SIDE; column++) {
      const int sign
          = is_exact ? map->exact[row][column] : map->rounded[row][column];

      if (nodes[row][column] != roles[sign + 1])
        g_error ("column %u, row %u", column, row);
    }
  scene_clear (&scene);
}

static void
test_every_node_has_the_colour_of_its_sign (void)
{
  g_autofree SignMap *map = g_new (SignMap, 1);

  g_assert_true (sign_map_init (map, &(Site){ 0.5 + 0x1p-46, 0.5 + 0x1p-46 },
                                &(Site){ 12, 12 }, &(Site){ 24, 24 }));
  check_map (map, FALSE);
  check_map (map, TRUE);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/scene-rounding/each-site-is-drawn-as-what-became-of-it",
                   test_each_site_is_drawn_as_what_became_of_it);
  g_test_add_func ("/scene-rounding/every-node-has-the-colour-of-its-sign",
                   test_every_node_has_the_colour_of_its_sign);
  return g_test_run ();
}
