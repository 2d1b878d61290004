#include "session.h"

#include <math.h>

static const Site lecture8[] = {
  { -1, -0.5 },         { 1, -0.8125 },      { 0.75, 0.8125 },
  { -0.9375, 0.5625 },  { 0.1875, -0.1875 }, { 0.5, -0.1875 },
  { -0.0625, -0.4375 }, { 0, 0.25 },
};

static const Site square[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };

static Session *
new_lecture8 (void)
{
  Session *session = session_new ();

  g_assert_true (
      session_set_sites (session, lecture8, G_N_ELEMENTS (lecture8), NULL));
  return session;
}

static void
goto_place (Session *session, guint round, Phase phase)
{
  guint step;

  g_assert_true (timeline_find (session_get_trace (session),
                                (Place){ round, phase }, false, &step));
  session_set_step (session, step);
}

static void
assert_place (Session *session, guint round, Phase phase)
{
  const Place place = session_get_place (session);

  g_assert_cmpuint (place.round, ==, round);
  g_assert_cmpstr (phase_name (place.phase), ==, phase_name (phase));
}

static void
test_new_sites_stand_at_the_last_step (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
  assert_place (session, 4, PHASE_COMPLETE);
}

static void
test_an_edit_keeps_round_and_phase (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  goto_place (session, 3, PHASE_SEE);
  g_assert_true (session_move_site (session, 0, (Site){ -1, -0.625 }, NULL));
  assert_place (session, 3, PHASE_SEE);
  g_assert_true (session_add_site (session, (Site){ -0.5, 0 }, NULL));
  assert_place (session, 3, PHASE_SEE);
}

static void
test_an_edit_keeps_the_event_within_its_phase (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  goto_place (session, 4, PHASE_CHOOSE);
  session_set_step (session, session_get_step (session) + 2);
  g_assert_cmpuint (session_get_frame (session)->counts.visible, ==, 2);
  g_assert_true (session_move_site (session, 1, (Site){ 1, -0.75 }, NULL));
  assert_place (session, 4, PHASE_SEE);
  g_assert_cmpuint (session_get_frame (session)->counts.visible, ==, 2);
}

static void
test_a_place_that_is_gone_becomes_the_end (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  goto_place (session, 4, PHASE_CONE);
  g_assert_true (session_remove_site (session, 7, NULL));
  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
}

static void
test_a_drag_through_a_tie_finds_its_place_again (void)
{
  static const Site five[]
      = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.25, 0.5 } };
  g_autoptr (Session) session = session_new ();

  session_set_sites (session, five, G_N_ELEMENTS (five), NULL);
  goto_place (session, 1, PHASE_HORIZON);
  session_begin_edit (session);
  /* All five on one circle: there is no round on the way. */
  session_move_site (session, 4, (Site){ 0, 0 }, NULL);
  g_assert_cmpuint (session_get_place (session).round, ==, 0);
  session_move_site (session, 4, (Site){ 0.5, 0.25 }, NULL);
  session_end_edit (session);
  assert_place (session, 1, PHASE_HORIZON);
}

static void
test_a_drag_is_one_edit (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  Site back;

  session_begin_edit (session);
  for (int i = 1; i <= 10; i++)
    session_move_site (session, 3, (Site){ -0.9375, 0.5625 + i / 64.0 }, NULL);
  session_end_edit (session);
  g_assert_cmpstr (session_get_undo_label (session), ==, "Undo moving s3");

  g_assert_true (session_undo (session));
  back = site_set_given (session_get_set (session), 3);
  g_assert_cmpfloat (back.y, ==, 0.5625);
  g_assert_cmpstr (session_get_redo_label (session), ==, "Redo moving s3");
  g_assert_true (session_redo (session));
  back = site_set_given (session_get_set (session), 3);
  g_assert_cmpfloat (back.y, ==, 0.5625 + 10 / 64.0);
}

static void
test_two_drags_are_two_edits (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  for (int i = 1; i <= 2; i++) {
    session_begin_edit (session);
    session_move_site (session, 3, (Site){ -0.9375, 0.5 + i / 8.0 }, NULL);
    session_end_edit (session);
  }
  g_assert_true (session_undo (session));
  g_assert_cmpfloat (site_set_given (session_get_set (session), 3).y, ==,
                     0.625);
}

static void
test_every_edit_can_be_undone (void)
{
  g_autoptr (Session) session = session_new ();

  g_assert_null (session_get_undo_label (session));
  session_set_sites (session, square, 4, NULL);
  session_add_site (session, (Site){ 0.5, 0.5 }, NULL);
  session_move_site (session, 4, (Site){ 0.25, 0.5 }, NULL);
  session_remove_site (session, 0, NULL);
  session_set_sites (session, NULL, 0, NULL);
  g_assert_cmpstr (session_get_undo_label (session), ==,
                   "Undo deleting all sites");

  for (guint i = 0; i < 5; i++)
    g_assert_true (session_undo (session));
  g_assert_false (session_undo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 0);
  for (guint i = 0; i < 4; i++)
    g_assert_true (session_redo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 4);
  g_assert_cmpfloat (site_set_given (session_get_set (session), 3).x, ==, 0.25);
}

/* What is cancelled leaves no trace: not in the sites, not in the step, not in
 * what can be undone or redone. */
static void
test_a_cancelled_edit_has_not_been (void)
{
  g_autoptr (Session) session = session_new ();
  g_autofree char *label = NULL;

  session_add_site (session, (Site){ 0, 0 }, NULL);
  session_add_site (session, (Site){ 1, 0 }, NULL);
  label = g_strdup (session_get_undo_label (session));
  session_begin_edit (session);
  session_add_site (session, (Site){ 0, 1 }, NULL);
  session_move_site (session, 2, (Site){ 0, 2 }, NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 3);
  session_cancel_edit (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  g_assert_cmpstr (session_get_undo_label (session), ==, label);
  g_assert_null (session_get_redo_label (session));
  session_cancel_edit (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  g_assert_true (session_undo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 1);
}

static void
test_an_edit_forgets_what_was_undone (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  session_move_site (session, 0, (Site){ 0, 0 }, NULL);
  session_undo (session);
  session_add_site (session, (Site){ 0.25, 0.5 }, NULL);
  g_assert_null (session_get_redo_label (session));
  g_assert_false (session_redo (session));
}

static void
test_sites_that_do_not_exist_are_refused (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  g_autoptr (GError) error = NULL;

  g_assert_false (session_move_site (session, 8, (Site){ 0, 0 }, &error));
  g_assert_error (error, SESSION_ERROR, SESSION_ERROR_SITE);
  g_clear_error (&error);
  g_assert_false (session_remove_site (session, 8, &error));
  g_assert_error (error, SESSION_ERROR, SESSION_ERROR_SITE);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
}

static void
test_coordinates_out_of_range_change_nothing (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  g_autoptr (GError) error = NULL;

  g_assert_false (
      session_add_site (session, (Site){ 0x1p400, 0x1p-400 }, &error));
  g_assert_error (error, SESSION_ERROR, SESSION_ERROR_RANGE);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
  g_assert_cmpstr (session_get_undo_label (session), ==,
                   "Undo replacing all sites");
  session_set_preview (session, &(const Site){ 0x1p400, 1 });
  g_assert_false (session_get_look (session)->has_preview);
}

static void
test_moving_fits_the_extent_only_at_rest (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  const Extent before = session_get_look (session)->extent;
  const Extent *now = &session_get_look (session)->extent;

  session_begin_edit (session);
  session_move_site (session, 0, (Site){ -9, 4 }, NULL);
  g_assert_cmpmem (&before, sizeof before, now, sizeof before);
  session_end_edit (session);
  g_assert_cmpmem (&before, sizeof before, now, sizeof before);
  session_move_site (session, 0, (Site){ -11, 4 }, NULL);
  g_assert_cmpfloat (now->centre.x - now->radius, <=, -11);
  g_assert_cmpfloat (now->centre.x + now->radius, >=, 1);
}

static void
test_adding_fits_the_extent_only_when_outside (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  const Extent before = session_get_look (session)->extent;

  session_add_site (session, (Site){ 0.5, 0.5 }, NULL);
  g_assert_cmpfloat (session_get_look (session)->extent.radius, ==,
                     before.radius);
  session_add_site (session, (Site){ 7, 0.5 }, NULL);
  g_assert_cmpfloat (session_get_look (session)->extent.radius, ==, 4);
}

/* Beyond the range coordinates are scaled; the picture must not jump. */
static void
test_the_extent_stays_where_it_is_when_the_scale_changes (void)
{
  static const Site huge[] = { { 0, 0 }, { 0x1p200, 0 }, { 0, 0x1p200 } };
  g_autoptr (Session) session = session_new ();
  const Extent *extent = &session_get_look (session)->extent;
  double radius;

  session_set_sites (session, huge, 3, NULL);
  radius = ldexp (extent->radius, session_get_set (session)->exponent);
  g_assert_cmpint (session_get_set (session)->exponent, >, 0);
  session_move_site (session, 1, (Site){ 1, 0 }, NULL);
  session_move_site (session, 2, (Site){ 0, 1 }, NULL);
  g_assert_cmpint (session_get_set (session)->exponent, ==, 0);
  g_assert_cmpfloat (extent->radius, ==, radius);
}

static void
test_snapped_sites_have_few_digits (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  const Site snapped = session_snap (session, (Site){ 0.1234567, -0.7654321 });

  g_assert_cmpfloat (snapped.x * 64, ==, 8);
  g_assert_cmpfloat (snapped.y * 64, ==, -49);
  g_assert_cmpfloat (session_get_grid (session), ==, 1 / 64.0);
}

static void
test_the_snap_grid_follows_extent_and_zoom (void)
{
  static const Site far[] = { { 1000000, 5 }, { 1000800, 5 }, { 1000400, 9 } };
  g_autoptr (Session) session = session_new ();
  PlaneCamera camera;

  session_set_sites (session, far, 3, NULL);
  g_assert_cmpfloat (session_get_grid (session), ==, 4);
  camera = *session_get_plane_camera (session);
  camera.zoom = 8;
  session_set_plane_camera (session, &camera);
  g_assert_cmpfloat (session_get_grid (session), ==, 0.5);
  g_assert_cmpfloat (session_snap (session, (Site){ 1000000.3, 0 }).x, ==,
                     1000000.5);
}

static void
count_change (Session *session G_GNUC_UNUSED, guint changes, gpointer user)
{
  guint *told = user;

  told[0] += 1;
  told[1] = changes;
}

static void
test_one_edit_is_told_once (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  guint told[2] = { 0 };

  g_signal_connect (session, "changed", G_CALLBACK (count_change), told);
  session_add_site (session, (Site){ 0.5, 0.5 }, NULL);
  g_assert_cmpuint (told[0], ==, 1);
  g_assert_cmphex (told[1], ==, CHANGED_SITES | CHANGED_STEP | CHANGED_HISTORY);
}

static void
test_no_change_is_not_told (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  guint told[2] = { 0 };

  g_signal_connect (session, "changed", G_CALLBACK (count_change), told);
  session_set_step (session, session_get_step (session));
  session_set_layers (session, session_get_look (session)->layers);
  session_set_focus (session, session_get_look (session)->focus);
  session_set_playing (session, FALSE);
  session_set_speed (session, 1);
  session_move_site (session, 0, (Site){ -1, -0.5 }, NULL);
  g_assert_cmpuint (told[0], ==, 0);
}

static guint
count_steps (Session *session, StepSize size)
{
  guint n = 0;

  session_set_step (session, 0);
  session_set_step_size (session, size);
  while (session_next (session))
    n += 1;
  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
  return n;
}

static void
test_next_goes_by_the_step_size (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  g_assert_cmpuint (count_steps (session, STEP_EVENT), ==,
                    session_get_n_steps (session));
  /* The simplex, five phases in each of four rounds, completion. */
  g_assert_cmpuint (count_steps (session, STEP_PHASE), ==, 1 + 4 * 5 + 1);
  g_assert_cmpuint (count_steps (session, STEP_BEAT), ==, 1 + 4 + 1);
}

static void
test_frames_are_equal_forwards_and_backwards (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  g_autoptr (GArray) hashes = g_array_new (FALSE, FALSE, sizeof (guint64));
  guint64 hash;

  session_set_step_size (session, STEP_EVENT);
  session_set_step (session, 0);
  do {
    hash = frame_hash (session_get_frame (session));
    g_array_append_val (hashes, hash);
  } while (session_next (session));
  do {
    hash = frame_hash (session_get_frame (session));
    g_assert_cmphex (
        hash, ==, g_array_index (hashes, guint64, session_get_step (session)));
  } while (session_back (session));
  g_assert_cmpuint (session_get_step (session), ==, 0);
}

static void
test_playing_stops_at_the_end (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  guint n = 0;

  session_set_step_size (session, STEP_PHASE);
  session_set_playing (session, TRUE);
  g_assert_cmpuint (session_get_step (session), ==, 0);
  while (session_get_playing (session) && n < 1000) {
    session_tick (session);
    n += 1;
  }
  g_assert_cmpuint (n, ==, 22);
  g_assert_cmpuint (session_get_step (session), ==,
                    session_get_n_steps (session));
}

static void
test_speed_divides_the_tick (void)
{
  g_autoptr (Session) session = session_new ();

  session_set_step_size (session, STEP_PHASE);
  g_assert_cmpuint (session_get_tick_ms (session), ==, 1500);
  session_set_speed (session, 2);
  g_assert_cmpuint (session_get_tick_ms (session), ==, 750);
  session_set_speed (session, NAN);
  g_assert_cmpfloat (session_get_speed (session), ==, 2);
  session_set_speed (session, 1e9);
  g_assert_cmpfloat (session_get_speed (session), ==, SPEED_MOST);
}

/* Whatever a person does with few sites, nothing breaks. */
static void
test_few_sites_can_be_edited_at_every_step (void)
{
  g_autoptr (Session) session = session_new ();

  for (guint n = 0; n < 7; n++) {
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      session_set_step (session, step);
      g_assert_nonnull (session_get_frame (session));
      g_assert_true (
          session_add_site (session, (Site){ (double)(n * n % 5), n }, NULL));
      g_assert_true (session_undo (session));
    }
    session_add_site (session, (Site){ (double)(n * n % 5), n }, NULL);
  }
  while (session_get_set (session)->n_sites > 0)
    g_assert_true (session_remove_site (session, 0, NULL));
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/session/new-sites-stand-at-the-last-step",
    test_new_sites_stand_at_the_last_step },
  { "/session/an-edit-keeps-round-and-phase",
    test_an_edit_keeps_round_and_phase },
  { "/session/an-edit-keeps-the-event-within-its-phase",
    test_an_edit_keeps_the_event_within_its_phase },
  { "/session/a-place-that-is-gone-becomes-the-end",
    test_a_place_that_is_gone_becomes_the_end },
  { "/session/a-drag-through-a-tie-finds-its-place-again",
    test_a_drag_through_a_tie_finds_its_place_again },
  { "/session/a-drag-is-one-edit", test_a_drag_is_one_edit },
  { "/session/two-drags-are-two-edits", test_two_drags_are_two_edits },
  { "/session/every-edit-can-be-undone", test_every_edit_can_be_undone },
  { "/session/a-cancelled-edit-has-not-been",
    test_a_cancelled_edit_has_not_been },
  { "/session/an-edit-forgets-what-was-undone",
    test_an_edit_forgets_what_was_undone },
  { "/session/sites-that-do-not-exist-are-refused",
    test_sites_that_do_not_exist_are_refused },
  { "/session/coordinates-out-of-range-change-nothing",
    test_coordinates_out_of_range_change_nothing },
  { "/session/moving-fits-the-extent-only-at-rest",
    test_moving_fits_the_extent_only_at_rest },
  { "/session/adding-fits-the-extent-only-when-outside",
    test_adding_fits_the_extent_only_when_outside },
  { "/session/the-extent-stays-where-it-is-when-the-scale-changes",
    test_the_extent_stays_where_it_is_when_the_scale_changes },
  { "/session/snapped-sites-have-few-digits",
    test_snapped_sites_have_few_digits },
  { "/session/the-snap-grid-follows-extent-and-zoom",
    test_the_snap_grid_follows_extent_and_zoom },
  { "/session/one-edit-is-told-once", test_one_edit_is_told_once },
  { "/session/no-change-is-not-told", test_no_change_is_not_told },
  { "/session/next-goes-by-the-step-size", test_next_goes_by_the_step_size },
  { "/session/frames-are-equal-forwards-and-backwards",
    test_frames_are_equal_forwards_and_backwards },
  { "/session/playing-stops-at-the-end", test_playing_stops_at_the_end },
  { "/session/speed-divides-the-tick", test_speed_divides_the_tick },
  { "/session/few-sites-can-be-edited-at-every-step",
    test_few_sites_can_be_edited_at_every_step },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
