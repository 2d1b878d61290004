#include "action.h"

#include <string.h>

static const Site five[]
    = { { 0, 0 }, { 1, 0 }, { 0.1, 1 }, { 0.25, 0.3 }, { 0.75, 0.5 } };

static Session *
new_session (void)
{
  Session *session = session_new ();

  g_assert_true (session_set_sites (session, five, 5, NULL));
  return session;
}

static void
assert_selected (Session *session, const char *expected)
{
  guint n;
  const guint32 *sites = session_get_selected_sites (session, &n);
  g_autoptr (GString) found = g_string_new (NULL);

  for (guint i = 0; i < n; i++)
    g_string_append_printf (found, "%ss%u", i > 0 ? " " : "", sites[i]);
  g_assert_cmpstr (found->str, ==, expected);
}

static void
assert_sites (Session *session, const Site *sites, guint n)
{
  const SiteSet *set = session_get_set (session);

  g_assert_cmpuint (set->n_sites, ==, n);
  for (guint i = 0; i < n; i++) {
    g_assert_cmpfloat (site_set_given (set, i).x, ==, sites[i].x);
    g_assert_cmpfloat (site_set_given (set, i).y, ==, sites[i].y);
  }
}

static void
test_sites_join_the_selection_and_leave_it (void)
{
  g_autoptr (Session) session = new_session ();
  const guint32 some[] = { 4, 1, 4 };

  session_toggle_site (session, 3);
  session_toggle_site (session, 1);
  assert_selected (session, "s1 s3");
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 1);
  session_toggle_site (session, 3);
  assert_selected (session, "s1");
  session_select_sites (session, some, 3);
  assert_selected (session, "s1 s4");
  session_set_selection (session, (Object){ OBJECT_SITE, 4 });
  assert_selected (session, "s4");
  session_set_selection (session, (Object){ OBJECT_FACET, 0 });
  assert_selected (session, "");
}

static void
test_several_move_as_one_edit (void)
{
  g_autoptr (Session) session = new_session ();
  const guint32 some[] = { 1, 3 };
  const Site moved[]
      = { { 0, 0 }, { 1.5, 0.25 }, { 0.1, 1 }, { 0.75, 0.55 }, { 0.75, 0.5 } };

  session_select_sites (session, some, 2);
  session_begin_edit (session);
  session_move_selected (session, 1, (Site){ 1.25, 0 }, NULL);
  session_move_selected (session, 1, (Site){ 1.5, 0.25 }, NULL);
  session_end_edit (session);
  assert_sites (session, moved, 5);
  assert_selected (session, "s1 s3");
  g_assert_cmpstr (session_get_undo_label (session), ==, "Undo moving 2 sites");
  session_undo (session);
  assert_sites (session, five, 5);
}

static void
test_several_go_as_one_edit (void)
{
  g_autoptr (Session) session = new_session ();
  const guint32 some[] = { 0, 3 };
  const Site left[] = { { 1, 0 }, { 0.1, 1 }, { 0.75, 0.5 } };

  session_select_sites (session, some, 2);
  g_assert_true (session_remove_selected (session, NULL));
  assert_sites (session, left, 3);
  assert_selected (session, "");
  g_assert_cmpstr (session_get_undo_label (session), ==,
                   "Undo deleting 2 sites");
  session_undo (session);
  assert_sites (session, five, 5);
  session_redo (session);
  assert_sites (session, left, 3);
}

static void
test_what_moves_up_stays_selected (void)
{
  g_autoptr (Session) session = new_session ();
  const guint32 some[] = { 1, 2, 4 };

  session_select_sites (session, some, 3);
  session_remove_site (session, 2, NULL);
  assert_selected (session, "s1 s3");
  session_undo (session);
  session_set_sites (session, five, 2, NULL);
  assert_selected (session, "");
}

/* Coordinates that no exact scaling fits leave all as it was. */
static void
test_a_move_out_of_range_is_refused (void)
{
  g_autoptr (Session) session = new_session ();
  g_autoptr (GError) error = NULL;

  session_toggle_site (session, 2);
  g_assert_false (
      session_move_selected (session, 2, (Site){ 1e200, 1e-200 }, &error));
  g_assert_error (error, SESSION_ERROR, SESSION_ERROR_RANGE);
  assert_sites (session, five, 5);
}

static void
test_without_the_grid_points_stay_where_they_are (void)
{
  g_autoptr (Session) session = new_session ();
  const Site point = { 0.123456, 0.654321 };
  Site at = session_snap (session, point);

  g_assert_true (session_get_snaps (session));
  g_assert_cmpfloat (ABS (at.x - point.x), >, 1e-4);
  session_set_snaps (session, FALSE);
  at = session_snap (session, point);
  g_assert_cmpfloat (ABS (at.x - point.x), <, 1e-4);
  g_assert_cmpfloat (ABS (at.y - point.y), <, 1e-4);
}

/* The views fit what was there before, however far away the others were. */
static void
test_undoing_a_replacement_fits_the_views (void)
{
  static const Site far[] = { { 1e4, 1e4 }, { 2e4, 1e4 }, { 1e4, 3e4 } };
  g_autoptr (Session) session = new_session ();
  const Extent before = session_get_look (session)->extent;

  g_assert_true (session_replace_sites (session, far, 3, "paste", NULL));
  g_assert_cmpfloat (session_get_look (session)->extent.radius, >, 1e3);
  session_undo (session);
  g_assert_cmpfloat (session_get_look (session)->extent.radius, ==,
                     before.radius);
  g_assert_cmpfloat (session_get_plane_camera (session)->zoom, ==, 1);
  session_redo (session);
  g_assert_cmpfloat (session_get_look (session)->extent.radius, >, 1e3);
}

static void
test_removing_a_site_renames_the_selection (void)
{
  g_autoptr (Session) session = new_session ();

  session_set_selection (session, (Object){ OBJECT_SITE, 4 });
  session_remove_site (session, 2, NULL);
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 3);
  session_remove_site (session, 3, NULL);
  g_assert_cmpuint (session_get_look (session)->selection.kind, ==,
                    OBJECT_NONE);
}

static void
test_facets_are_not_selected_through_an_edit (void)
{
  g_autoptr (Session) session = new_session ();
  const Frame *frame = session_get_frame (session);
  const guint32 facet = frame->delaunay.triangles[0].facet;

  session_set_selection (session, (Object){ OBJECT_FACET, facet });
  session_move_site (session, 2, (Site){ 0.125, 0.875 }, NULL);
  g_assert_cmpuint (session_get_look (session)->selection.kind, ==,
                    OBJECT_NONE);
}

static void
run (Session *session, const char *name)
{
  g_autoptr (GError) error = NULL;

  g_assert_true (action_run (session, name, NULL, &error));
  g_assert_no_error (error);
}

static void
test_the_selection_walks_round_the_sites (void)
{
  g_autoptr (Session) session = new_session ();
  g_autoptr (GError) error = NULL;

  run (session, "select-previous");
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 4);
  run (session, "select-next");
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 0);
  run (session, "select-none");
  run (session, "select-next");
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 0);
  run (session, "new");
  g_assert_false (action_run (session, "select-next", NULL, &error));
  g_assert_error (error, ACTION_ERROR, ACTION_ERROR_DISABLED);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/selection/sites-join-the-selection-and-leave-it",
    test_sites_join_the_selection_and_leave_it },
  { "/selection/several-move-as-one-edit", test_several_move_as_one_edit },
  { "/selection/several-go-as-one-edit", test_several_go_as_one_edit },
  { "/selection/what-moves-up-stays-selected",
    test_what_moves_up_stays_selected },
  { "/selection/a-move-out-of-range-is-refused",
    test_a_move_out_of_range_is_refused },
  { "/selection/undoing-a-replacement-fits-the-views",
    test_undoing_a_replacement_fits_the_views },
  { "/selection/without-the-grid-points-stay-where-they-are",
    test_without_the_grid_points_stay_where_they_are },
  { "/selection/removing-a-site-renames-the-selection",
    test_removing_a_site_renames_the_selection },
  { "/selection/facets-are-not-selected-through-an-edit",
    test_facets_are_not_selected_through_an_edit },
  { "/selection/the-selection-walks-round-the-sites",
    test_the_selection_walks_round_the_sites },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
