/* A cell keeps its colour as long as there is its site. */
#include "session.h"

#include <math.h>

#define N_SITES 7

static const Site sites[N_SITES]
    = { { 0, 0 },        { 1, 0.125 },    { 0.25, 1 },     { -0.75, 0.5 },
        { -0.5, -0.75 }, { 0.625, -0.5 }, { 0.375, 0.375 } };

static Session *
new_session (void)
{
  Session *session = session_new ();

  g_assert_true (session_set_sites (session, sites, N_SITES, NULL));
  return session;
}

/* The hue of the cell around the site at @at, as the plane is painted. */
static guint32
hue_at (Session *session, Site at)
{
  const SiteSet *set = session_get_set (session);
  guint32 hue = G_MAXUINT32;
  SceneLook look = *session_get_look (session);
  Scene scene = { 0 };

  look.low = (Point3){ -4, -4, 0 };
  look.high = (Point3){ 4, 4, 0 };
  scene_plane (&scene, session_get_frame (session), &look);
  for (guint i = 0; i < scene.n_items; i++) {
    const SceneItem *item = &scene.items[i];

    if (item->role == ROLE_CELL
        && site_set_given (set, item->object.number).x == at.x
        && site_set_given (set, item->object.number).y == at.y)
      hue = item->hue;
  }
  scene_clear (&scene);
  g_assert_cmpuint (hue, !=, G_MAXUINT32);
  return hue;
}

static void
check_hue (Session *session, Site at, guint32 expected)
{
  const guint32 hue = hue_at (session, at);

  g_assert_cmpuint (hue, ==, expected);
}

static void
check_others (Session *session, guint but, const guint32 *hues)
{
  for (guint i = 0; i < N_SITES; i++)
    if (i != but)
      check_hue (session, sites[i], hues[i]);
}

static void
get_hues (Session *session, guint32 *hues)
{
  for (guint i = 0; i < N_SITES; i++) {
    hues[i] = hue_at (session, sites[i]);
    for (guint k = 0; k < i; k++)
      g_assert_cmpuint (hues[k], !=, hues[i]);
  }
}

static void
test_drag (void)
{
  g_autoptr (Session) session = new_session ();
  guint32 hues[N_SITES];

  get_hues (session, hues);
  session_begin_edit (session);
  for (int i = 1; i <= 40; i++) {
    const Site to = { -1 + i / 20.0, 0.8 * sin (i / 3.0) };

    g_assert_true (session_move_site (session, 2, to, NULL));
    check_hue (session, to, hues[2]);
    check_others (session, 2, hues);
  }
  session_end_edit (session);
}

static void
test_removal (void)
{
  guint32 hues[N_SITES];

  for (guint gone = 0; gone < N_SITES; gone++) {
    g_autoptr (Session) session = new_session ();

    get_hues (session, hues);
    g_assert_true (session_remove_site (session, gone, NULL));
    check_others (session, gone, hues);
    g_assert_true (session_undo (session));
    check_others (session, N_SITES, hues);
    g_assert_true (session_redo (session));
    check_others (session, gone, hues);
  }
}

/* Not the hue of another one, nor one that is still used after a removal. */
static void
test_addition (void)
{
  g_autoptr (Session) session = new_session ();
  const Site added = { -0.25, 0.3125 };
  guint32 hues[N_SITES], hue;

  get_hues (session, hues);
  g_assert_true (session_remove_site (session, 1, NULL));
  g_assert_true (session_add_site (session, added, NULL));
  hue = hue_at (session, added);
  for (guint i = 0; i < N_SITES; i++)
    g_assert_true (i == 1 || hue != hues[i]);
  check_others (session, 1, hues);
  g_assert_true (session_remove_site (session, 0, NULL));
  check_hue (session, added, hue);
}

static void
test_order (void)
{
  g_autoptr (Session) session = new_session ();
  const Order order = { ORDER_RANDOM, 5 };
  guint32 hues[N_SITES];

  get_hues (session, hues);
  g_assert_true (session_remove_site (session, 3, NULL));
  session_set_order (session, &order);
  check_others (session, 3, hues);
}

/* A drag that is undone after a removal elsewhere. */
static void
test_history (void)
{
  g_autoptr (Session) session = new_session ();
  guint32 hues[N_SITES];

  get_hues (session, hues);
  g_assert_true (session_remove_site (session, 4, NULL));
  g_assert_true (session_move_site (session, 4, (Site){ 0.5, -0.9 }, NULL));
  check_hue (session, (Site){ 0.5, -0.9 }, hues[5]);
  g_assert_true (session_undo (session));
  check_others (session, 4, hues);
  g_assert_true (session_undo (session));
  check_others (session, N_SITES, hues);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/hues/a-cell-keeps-its-colour-while-its-site-is-dragged",
                   test_drag);
  g_test_add_func ("/hues/cells-keep-their-colours-when-another-site-goes",
                   test_removal);
  g_test_add_func ("/hues/a-new-cell-has-a-colour-of-its-own", test_addition);
  g_test_add_func ("/hues/the-order-of-insertion-changes-no-colour",
                   test_order);
  g_test_add_func ("/hues/undo-brings-colours-back", test_history);
  return g_test_run ();
}
