#include "action.h"
#include "object-name.h"

#include <gio/gio.h>
#include <string.h>

static const Site lecture8[] = {
  { -1, -0.5 },         { 1, -0.8125 },      { 0.75, 0.8125 },
  { -0.9375, 0.5625 },  { 0.1875, -0.1875 }, { 0.5, -0.1875 },
  { -0.0625, -0.4375 }, { 0, 0.25 },
};

static Session *
new_lecture8 (void)
{
  Session *session = session_new ();

  g_assert_true (
      session_set_sites (session, lecture8, G_N_ELEMENTS (lecture8), NULL));
  return session;
}

static void
run (Session *session, const char *name, GVariant *parameter)
{
  g_autoptr (GError) error = NULL;

  g_assert_true (action_run (session, name, parameter, &error));
  g_assert_no_error (error);
}

static void
refuse (Session *session, const char *name, GVariant *parameter, int code)
{
  g_autoptr (GError) error = NULL;

  g_assert_false (action_run (session, name, parameter, &error));
  g_assert_error (error, ACTION_ERROR, code);
}

static void
test_names_are_good_for_gactions_and_unique (void)
{
  guint n;
  const Action *table = action_table (&n);

  for (guint i = 0; i < n; i++) {
    g_assert_true (g_action_name_is_valid (table[i].name));
    g_assert_true (action_find (table[i].name) == &table[i]);
    g_assert_cmpuint (strlen (table[i].sentence), >, 3);
    g_assert_cmpuint (table[i].where, !=, 0);
  }
}

static void
test_types_are_variant_types (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  guint n;
  const Action *table = action_table (&n);

  for (guint i = 0; i < n; i++) {
    GVariant *state = action_get_state (&table[i], session);

    g_assert_true (table[i].parameter == NULL
                   || g_variant_type_string_is_valid (table[i].parameter));
    g_assert_true (state == NULL || table[i].state != NULL);
    if (state != NULL) {
      g_assert_true (g_variant_is_of_type (g_variant_ref_sink (state),
                                           G_VARIANT_TYPE (table[i].state)));
      g_variant_unref (state);
    }
  }
}

static void
test_no_key_has_two_meanings (void)
{
  g_autoptr (GHashTable) keys
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  guint n;
  const Action *table = action_table (&n);

  for (guint i = 0; i < n; i++) {
    g_auto (GStrv) parts
        = g_strsplit (table[i].keys == NULL ? "" : table[i].keys, " ", -1);

    for (guint j = 0; parts[j] != NULL; j++)
      g_assert_true (g_hash_table_add (keys, g_strdup (parts[j])));
  }
}

/* What remote controls of lecturers send, and what they must never do. */
static void
test_clickers_step_and_escape_never_quits (void)
{
  g_assert_true (g_str_has_prefix (action_find ("next")->keys, "Page_Down"));
  g_assert_true (g_str_has_prefix (action_find ("back")->keys, "Page_Up"));
  g_assert_null (strstr (action_find ("quit")->keys, "Escape"));
  g_assert_null (strstr (action_find ("close")->keys, "Escape"));
}

static void
test_lesson_verbs_need_no_window (void)
{
  g_autoptr (GString) verbs = g_string_new (NULL);
  guint n;
  const Action *table = action_table (&n);

  for (guint i = 0; i < n; i++)
    if (table[i].where & ACTION_IN_LESSON) {
      g_assert_nonnull (table[i].run);
      g_string_append_printf (verbs, "%s ", table[i].name);
    }
  /* A closed list: whoever adds to it writes its reference too. */
  g_assert_cmpstr (verbs->str, ==,
                   "next-event back-event next-phase back-phase next-round "
                   "back-round goto show hide lift raise opacity reset-look "
                   "measure view views listing compare compare-view rounding "
                   "turn node order focus "
                   "select camera theme "
                   "add-site move-site remove-site sites ");
}

static void
test_what_the_window_does_is_refused_here (void)
{
  g_autoptr (Session) session = session_new ();

  refuse (session, "open", NULL, ACTION_ERROR_UNKNOWN);
  refuse (session, "quit", NULL, ACTION_ERROR_UNKNOWN);
  refuse (session, "step", NULL, ACTION_ERROR_UNKNOWN);
  refuse (session, "no-such-action", NULL, ACTION_ERROR_UNKNOWN);
}

/* Another order is another way to the same hull, and edits keep to it. */
static void
test_order_changes_the_way_not_the_hull (void)
{
  g_autoptr (Session) session = session_new ();
  const Trace *trace;

  run (session, "sites",
       g_variant_new_string ("0 0; 8 1; 3 9; 4 4; 7 6; 2 5; 5 2"));
  run (session, "order", g_variant_new_string ("input"));
  trace = session_get_trace (session);
  for (guint i = 0; i < trace->n_rounds; i++)
    g_assert_cmpuint (trace->rounds[i].site, ==, 4 + i);
  run (session, "add-site", g_variant_new ("(dd)", 6.0, 5.0));
  g_assert_cmpint (session_get_order (session).kind, ==, ORDER_INPUT);
  run (session, "order", g_variant_new_string ("random 7"));
  g_assert_cmpuint (session_get_order (session).seed, ==, 7);
  g_assert_cmpuint (session_get_frame (session)->counts.facets, ==, 12);
  refuse (session, "order", g_variant_new_string ("random"),
          ACTION_ERROR_PARAMETER);
  refuse (session, "order", g_variant_new_string ("nearest"),
          ACTION_ERROR_PARAMETER);
}

static void
test_parameters_of_other_types_are_refused (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  guint n;
  const Action *table = action_table (&n);

  for (guint i = 0; i < n; i++)
    if (table[i].run != NULL) {
      refuse (session, table[i].name, g_variant_new_byte (1),
              ACTION_ERROR_PARAMETER);
      if (table[i].parameter != NULL)
        refuse (session, table[i].name, NULL, ACTION_ERROR_PARAMETER);
    }
}

static void
test_every_layer_and_camera_has_its_row (void)
{
  g_autoptr (Session) session = session_new ();

  for (guint i = 0; i < N_LAYERS; i++) {
    const Layer layer = (Layer)(1u << i);
    g_autofree char *name = g_strdup_printf ("layer-%s", layer_name (layer));
    const guint before = session_get_look (session)->layers;

    run (session, name, NULL);
    g_assert_cmphex (session_get_look (session)->layers, ==, before ^ layer);
  }
  for (guint i = 0; i < N_CAMERA_PRESETS; i++) {
    const char *preset = camera_preset_name ((CameraPreset)i);
    g_autofree char *name = g_strdup_printf ("camera-%s", preset);

    run (session, name, NULL);
    run (session, "camera", g_variant_new_string (preset));
  }
}

static void
test_goto_lands_where_it_says (void)
{
  static const struct {
    const char *text;
    guint step;
  } rows[] = {
    /* As trace files list the events of this set. */
    { "start", 0 },
    { "simplex", 8 },
    { "before round 1", 8 },
    { "before round 1 choose", 8 },
    { "round 1 choose", 9 },
    { "before round 1 see", 9 },
    { "round 1 see", 11 },
    { "round 1 horizon", 15 },
    { "round 1 cone", 19 },
    { "before round 1 hand-over", 19 },
    { "round 1 hand-over", 24 },
    { "round 1", 24 },
    { "  round   2\tchoose ", 25 },
    { "complete", 73 },
  };
  g_autoptr (Session) session = new_lecture8 ();

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    run (session, "goto", g_variant_new_string (rows[i].text));
    g_assert_cmpuint (session_get_step (session), ==, rows[i].step);
  }
}

static void
test_goto_refuses_what_is_no_position (void)
{
  static const char *const rows[] = { "",
                                      "round",
                                      "round 0",
                                      "round -1",
                                      "round x",
                                      "round 1 simplex",
                                      "round 1 see now",
                                      "see",
                                      "before",
                                      "before start",
                                      "round 1e3",
                                      "round 99999999999",
                                      "after round 1" };
  g_autoptr (Session) session = new_lecture8 ();

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    refuse (session, "goto", g_variant_new_string (rows[i]),
            ACTION_ERROR_PARAMETER);
  refuse (session, "goto", g_variant_new_string ("round 5"),
          ACTION_ERROR_POSITION);
  refuse (session, "goto-step", g_variant_new_uint32 (74),
          ACTION_ERROR_POSITION);
  g_assert_cmpuint (session_get_step (session), ==, 73);
}

static void
test_steps_beyond_the_ends_are_refused (void)
{
  static const char *const forwards[]
      = { "next", "next-event", "next-phase", "next-round", "next-stop" };
  static const char *const backwards[]
      = { "back", "back-event", "back-phase", "back-round", "previous-stop" };
  g_autoptr (Session) session = new_lecture8 ();

  for (guint i = 0; i < G_N_ELEMENTS (forwards); i++) {
    refuse (session, forwards[i], NULL, ACTION_ERROR_POSITION);
    g_assert_false (action_is_enabled (action_find (forwards[i]), session));
  }
  run (session, "first", NULL);
  for (guint i = 0; i < G_N_ELEMENTS (backwards); i++) {
    refuse (session, backwards[i], NULL, ACTION_ERROR_POSITION);
    g_assert_false (action_is_enabled (action_find (backwards[i]), session));
  }
  g_assert_cmpuint (session_get_step (session), ==, 0);
}

static void
test_rounds_and_phases_step_to_their_ends (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  run (session, "first", NULL);
  run (session, "next-round", NULL);
  g_assert_cmpuint (session_get_step (session), ==, 8);
  run (session, "next-round", NULL);
  g_assert_cmpuint (session_get_step (session), ==, 24);
  run (session, "next-phase", NULL);
  run (session, "next-phase", NULL);
  g_assert_cmpuint (session_get_step (session), ==, 26);
  run (session, "back-event", NULL);
  run (session, "back-round", NULL);
  g_assert_cmpuint (session_get_step (session), ==, 24);
}

static void
test_only_what_exists_is_selected (void)
{
  static const char *const good[] = { "s0", "s7", "f0", "f21", "v20", "none" };
  static const char *const bad[]
      = { "s8", "f22", "v22", "r999", "s", "3", "s-1", "s07x", "", "S1" };
  g_autoptr (Session) session = new_lecture8 ();
  char name[OBJECT_NAME_ROOM];

  for (guint i = 0; i < G_N_ELEMENTS (good); i++) {
    run (session, "select", g_variant_new_string (good[i]));
    object_name_write (session_get_look (session)->selection, name);
    g_assert_cmpstr (name, ==, good[i]);
  }
  for (guint i = 0; i < G_N_ELEMENTS (bad); i++)
    refuse (session, "select", g_variant_new_string (bad[i]),
            ACTION_ERROR_PARAMETER);
  /* At the start no facet is born. */
  run (session, "first", NULL);
  refuse (session, "select", g_variant_new_string ("f0"),
          ACTION_ERROR_PARAMETER);
}

static void
assert_site (Session *session, guint site, double x, double y)
{
  const Site found = site_set_given (session_get_set (session), site);

  g_assert_cmpfloat (found.x, ==, x);
  g_assert_cmpfloat (found.y, ==, y);
}

static void
test_nudging_moves_by_one_grid_step (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  refuse (session, "nudge", g_variant_new_string ("left"),
          ACTION_ERROR_DISABLED);
  run (session, "select", g_variant_new_string ("s7"));
  refuse (session, "nudge", g_variant_new_string ("away"),
          ACTION_ERROR_PARAMETER);
  run (session, "nudge", g_variant_new_string ("right"));
  run (session, "nudge", g_variant_new_string ("up"));
  run (session, "nudge", g_variant_new_string ("up"));
  assert_site (session, 7, 1 / 64.0, 0.25 + 2 / 64.0);
  run (session, "nudge", g_variant_new_string ("left"));
  run (session, "nudge", g_variant_new_string ("down"));
  assert_site (session, 7, 0, 0.25 + 1 / 64.0);
}

static void
test_sites_are_edited_by_number (void)
{
  g_autoptr (Session) session = session_new ();

  for (int i = 0; i < 3; i++)
    run (session, "add-site", g_variant_new ("(dd)", i * 1.0, i * 0.5));
  run (session, "move-site", g_variant_new ("(udd)", 1u, 7.0, -7.0));
  assert_site (session, 1, 7, -7);
  run (session, "remove-site", g_variant_new_uint32 (0));
  assert_site (session, 0, 7, -7);
  run (session, "undo", NULL);
  run (session, "undo", NULL);
  assert_site (session, 1, 1, 0.5);
  run (session, "redo", NULL);
  assert_site (session, 1, 7, -7);
  refuse (session, "add-site", g_variant_new ("(dd)", 1.0, G_MAXDOUBLE * 2),
          ACTION_ERROR_PARAMETER);
}

static void
test_sites_come_from_words (void)
{
  static const struct {
    const char *text;
    guint n_sites;
  } rows[] = {
    { "0 0; 1 0; 0.5 1e0", 3 },
    { "random 12 seed 7", 12 },
    { "grid 3 4", 12 },
    { "circle 9", 9 },
    { "clusters 40 seed 2", 40 },
    { "near-circle 12 seed 5", 12 },
    { "spiral 30", 30 },
    { "kuzmin 50 seed 1", 50 },
    { "line 5", 5 },
  };
  static const char *const bad[] = { "",
                                     "0",
                                     "0 0;",
                                     "0 0; ; 1 1",
                                     "0 0 0",
                                     "nan 0",
                                     "inf inf",
                                     "0x1 0",
                                     "1e400 0",
                                     "random 5",
                                     "random 5 seed",
                                     "random -5 seed 1",
                                     "random 5 seed 1 2",
                                     "grid 3",
                                     "grid 0 3",
                                     "grid 200 200",
                                     "circle 0",
                                     "circle 8193",
                                     "line 1.5",
                                     "clusters 5",
                                     "spiral 5 seed 1",
                                     "near-circle 0 seed 1",
                                     "kuzmin 20001 seed 1",
                                     "file points.txt",
                                     "gird 3 3",
                                     "1e145 0; 1e-145 0" };
  g_autoptr (Session) session = session_new ();

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    run (session, "sites", g_variant_new_string (rows[i].text));
    g_assert_cmpuint (session_get_set (session)->n_sites, ==, rows[i].n_sites);
  }
  for (guint i = 0; i < G_N_ELEMENTS (bad); i++)
    refuse (session, "sites", g_variant_new_string (bad[i]),
            ACTION_ERROR_PARAMETER);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 5);
}

static void
test_fitting_keeps_the_turn (void)
{
  g_autoptr (Session) session = new_lecture8 ();
  const double from[2] = { 100, 100 }, to[2] = { 180, 120 };
  const double size[2] = { 400, 400 };
  Camera camera = *session_get_camera (session);
  Quaternion turn;

  camera_roll (&camera, from, to, size);
  turn = camera.turn;
  session_set_camera (session, &camera);
  run (session, "zoom-in", NULL);
  g_assert_cmpfloat (session_get_camera (session)->zoom, >, 1);
  g_assert_cmpfloat (session_get_plane_camera (session)->zoom, >, 1);
  run (session, "fit", NULL);
  g_assert_cmpfloat (session_get_camera (session)->zoom, ==, 1);
  g_assert_cmpfloat (session_get_plane_camera (session)->zoom, ==, 1);
  g_assert_cmpmem (&turn, sizeof turn, &session_get_camera (session)->turn,
                   sizeof turn);
}

static void
test_zooming_of_one_view_leaves_the_other (void)
{
  g_autoptr (Session) session = new_lecture8 ();

  run (session, "zoom-in-plane", NULL);
  g_assert_cmpfloat (session_get_camera (session)->zoom, ==, 1);
  run (session, "zoom-out-space", NULL);
  g_assert_cmpfloat (session_get_camera (session)->zoom, <, 1);
  g_assert_cmpfloat (session_get_plane_camera (session)->zoom, >, 1);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/action/names-are-good-for-gactions-and-unique",
    test_names_are_good_for_gactions_and_unique },
  { "/action/types-are-variant-types", test_types_are_variant_types },
  { "/action/no-key-has-two-meanings", test_no_key_has_two_meanings },
  { "/action/clickers-step-and-escape-never-quits",
    test_clickers_step_and_escape_never_quits },
  { "/action/lesson-verbs-need-no-window", test_lesson_verbs_need_no_window },
  { "/action/what-the-window-does-is-refused-here",
    test_what_the_window_does_is_refused_here },
  { "/action/parameters-of-other-types-are-refused",
    test_parameters_of_other_types_are_refused },
  { "/action/an-order-changes-the-way-not-the-hull",
    test_order_changes_the_way_not_the_hull },
  { "/action/every-layer-and-camera-has-its-row",
    test_every_layer_and_camera_has_its_row },
  { "/action/goto-lands-where-it-says", test_goto_lands_where_it_says },
  { "/action/goto-refuses-what-is-no-position",
    test_goto_refuses_what_is_no_position },
  { "/action/steps-beyond-the-ends-are-refused",
    test_steps_beyond_the_ends_are_refused },
  { "/action/rounds-and-phases-step-to-their-ends",
    test_rounds_and_phases_step_to_their_ends },
  { "/action/only-what-exists-is-selected", test_only_what_exists_is_selected },
  { "/action/nudging-moves-by-one-grid-step",
    test_nudging_moves_by_one_grid_step },
  { "/action/sites-are-edited-by-number", test_sites_are_edited_by_number },
  { "/action/sites-come-from-words", test_sites_come_from_words },
  { "/action/fitting-keeps-the-turn", test_fitting_keeps_the_turn },
  { "/action/zooming-of-one-view-leaves-the-other",
    test_zooming_of_one_view_leaves_the_other },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
