/* Pictures of exhibits, as export and the window make them. */
#include "action.h"
#include "command.h"
#include "look-case.h"
#include "session-picture.h"

#include <string.h>

#define SIDE 420

typedef struct Case {
  const char *name;
  const char *sites;
  const char *commands[4]; /* of the lesson language */
} Case;

/* A first triangle, sites inside, and some beyond each of its edges. */
#define THIRTEEN                                                               \
  "-0.5 -0.4; 0.6 -0.5; 0.1 0.5; 0 0; 0.1 -0.2; 0.9 0.3; 0.5 0.6; "            \
  "-0.7 0.5; -0.9 -0.1; 0.2 -0.9; -0.3 0.75; 0.35 0.1; -0.25 0.2"

static const Case cases[] = {
  { "planar-choose", THIRTEEN, { "view planar", "goto round 2 choose" } },
  { "planar-see", THIRTEEN, { "view planar", "goto round 2 see" } },
  { "planar-cone", THIRTEEN, { "view planar", "goto round 2 cone" } },
  { "planar-end", THIRTEEN, { "view planar" } },
  { "compare-cone",
    THIRTEEN,
    { "compare furthest input", "goto round 3 cone" } },
  { "signs-fig2a", "", { "rounding fig2a" } },
  { "rounded-a1", "", { "rounding A1", "view rounded" } },
};

static void
run (Session *session, const char *text)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GVariant) parameter = NULL;
  g_autofree char *verb = NULL;

  command_parse (text, &verb, &parameter, &error);
  g_assert_no_error (error);
  action_run (session, verb, parameter, &error);
  g_assert_no_error (error);
}

static Session *
play (const Case *what)
{
  g_autofree char *sites = g_strconcat ("sites ", what->sites, NULL);
  Session *session = session_new ();

  if (what->sites[0] != '\0')
    run (session, sites);
  for (guint i = 0; i < G_N_ELEMENTS (what->commands); i++)
    if (what->commands[i] != NULL)
      run (session, what->commands[i]);
  return session;
}

static cairo_surface_t *
paint_session (Session *session)
{
  cairo_surface_t *surface;
  Picture picture;
  cairo_t *cr;

  session_picture (&picture, session, PICTURE_BOTH);
  picture.width = picture.view == PICTURE_BOTH ? 2 * SIDE : SIDE;
  picture.height = SIDE;
  surface = cairo_image_surface_create (CAIRO_FORMAT_RGB24, (int)picture.width,
                                        (int)picture.height);
  cr = cairo_create (surface);
  picture_paint (&picture, session_get_frame (session), cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

static cairo_surface_t *
paint (const Case *what)
{
  g_autoptr (Session) session = play (what);

  return paint_session (session);
}

static void
check_picture (const Case *what)
{
  g_autofree char *path = fixture_path ("images", what->name, "-ref.png");
  cairo_surface_t *out = paint (what);
  cairo_surface_t *ref;

  if (g_getenv ("HULL2VD_RENEW_IMAGES") != NULL) {
    g_assert_cmpint (cairo_surface_write_to_png (out, path), ==,
                     CAIRO_STATUS_SUCCESS);
    cairo_surface_destroy (out);
    return;
  }
  ref = cairo_image_surface_create_from_png (path);
  g_assert_cmpint (cairo_surface_status (ref), ==, CAIRO_STATUS_SUCCESS);
  look_check (what->name, out, ref, LOOK_SAME);
  cairo_surface_destroy (ref);
  cairo_surface_destroy (out);
}

static void
test_pictures_look_like_the_references (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (cases); i++)
    check_picture (&cases[i]);
}

/* A picture that stayed the same whatever is shown would prove nothing. */
static void
test_another_step_is_another_picture (void)
{
  cairo_surface_t *see = paint (&cases[1]);
  cairo_surface_t *cone = paint (&cases[2]);
  cairo_surface_t *diff
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, SIDE, SIDE);

  g_assert_cmpuint (look_compare (see, cone, 0, diff), >, SIDE);
  cairo_surface_destroy (see);
  cairo_surface_destroy (cone);
  cairo_surface_destroy (diff);
}

static guint
count_pixels (cairo_surface_t *a, cairo_surface_t *b)
{
  cairo_surface_t *diff = cairo_image_surface_create (
      CAIRO_FORMAT_RGB24, cairo_image_surface_get_width (a),
      cairo_image_surface_get_height (a));
  const guint n = look_compare (a, b, 0, diff);

  cairo_surface_destroy (diff);
  return n;
}

/* Some layers show something only of what a person points at; the Voronoi
 * diagram takes the place of what the tangent planes are from above. */
static void
check_layer (Session *session, Layer layer)
{
  const gboolean is_always = layer != LAYER_WHY && layer != LAYER_PREVIEW;
  g_autofree char *name = g_strconcat ("layer-", layer_name (layer), NULL);
  const gboolean is_enabled = action_is_enabled (action_find (name), session);
  const guint layers = session_get_look (session)->layers;
  const guint others
      = layer == LAYER_TANGENTS ? layers & ~(guint)LAYER_VORONOI : layers;
  cairo_surface_t *with, *without;
  guint n;

  session_set_layers (session, others | layer);
  with = paint_session (session);
  session_set_layers (session, others & ~(guint)layer);
  without = paint_session (session);
  session_set_layers (session, layers);
  n = count_pixels (with, without);
  if (is_enabled ? is_always && n == 0 : n > 0)
    g_error ("%s: %u pixels", name, n);
  cairo_surface_destroy (with);
  cairo_surface_destroy (without);
}

static void
test_layers_can_be_chosen_where_they_are_seen (void)
{
  static const guint which[] = { 3, 4, 5, 6 };

  for (guint i = 0; i < G_N_ELEMENTS (which); i++) {
    g_autoptr (Session) session = play (&cases[which[i]]);

    for (guint bit = 0; bit < N_LAYERS; bit++)
      check_layer (session, (Layer)(1u << bit));
    session_set_compares_space (session, TRUE);
    for (guint bit = 0; bit < N_LAYERS; bit++)
      check_layer (session, (Layer)(1u << bit));
  }
}

/* How dark the picture is from @first to before @end, down one column. */
static guint
darkness (cairo_surface_t *surface, guint column, guint first, guint end)
{
  const int stride = cairo_image_surface_get_stride (surface);
  const unsigned char *data = cairo_image_surface_get_data (surface);
  guint sum = 0;

  for (guint row = first; row < end; row++)
    sum += 255u - data[row * (guint)stride + 4 * column];
  return sum;
}

/* Black on white, what turns left is known by its hatch alone. */
static void
test_the_hatch_of_a_sign_map_is_whole (void)
{
  g_autoptr (Session) session = play (&cases[5]);
  const guint step = (guint)theme_get (THEME_PRINT)->hatch_px;
  const guint column = SIDE / 7, first = SIDE / 4 / step * step + step / 2;
  cairo_surface_t *surface;
  guint one;

  run (session, "theme print");
  surface = paint_session (session);
  one = darkness (surface, column, first, first + step);
  g_assert_cmpuint (one, >, 100);
  for (guint row = first; row < SIDE / 2; row += step)
    g_assert_cmpuint (darkness (surface, column, row, row + step), ==, one);
  cairo_surface_destroy (surface);
}

/* Many sites, and light */

static Session *
session_of (const char *sites)
{
  g_autofree char *command = g_strconcat ("sites ", sites, NULL);
  Session *session = session_new ();

  run (session, command);
  return session;
}

static void
wait (Session *session)
{
  while (session_is_working (session, NULL))
    g_main_context_iteration (NULL, TRUE);
}

static void
check_same_course (Session *session, Session *other)
{
  g_autofree char *sentence = NULL, *expected = NULL;

  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_PLANAR);
  g_assert_cmpuint (session_get_n_steps (session), ==,
                    session_get_n_steps (other));
  run (session, "goto round 5 see");
  run (other, "goto round 5 see");
  sentence = session_narrate (session);
  expected = session_narrate (other);
  g_assert_cmpstr (sentence, ==, expected);
}

static void
test_a_thread_makes_the_record_of_many_sites (void)
{
  g_autoptr (Session) session = session_of ("random 3000 seed 1");
  g_autoptr (Session) other = session_of ("random 3000 seed 1");

  session_set_patient (session, TRUE);
  run (session, "view planar");
  g_assert_true (session_is_working (session, NULL));
  session_cancel (session);
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
  run (session, "view planar");
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
  wait (session);
  run (other, "view planar");
  check_same_course (session, other);
  session_add_site (session, (Site){ 2, 3 }, NULL);
  wait (session);
  session_add_site (other, (Site){ 2, 3 }, NULL);
  check_same_course (session, other);
}

static void
check_same_scene (const Scene *scene, const Scene *expected)
{
  g_assert_cmpuint (scene->n_items, ==, expected->n_items);
  g_assert_cmpuint (scene->n_lit, ==, expected->n_lit);
  for (guint i = 0; i < scene->n_items; i++) {
    g_assert_true (
        object_equal (scene->items[i].object, expected->items[i].object));
    g_assert_cmpint (scene->items[i].lit, ==, expected->items[i].lit);
  }
}

/* What is kept for another thread stays what it was. */
static void
check_light (const char *view)
{
  g_autoptr (Session) session = session_of (THIRTEEN);
  g_autoptr (Showing) showing = NULL;
  g_autofree char *command = g_strconcat ("view ", view, NULL);
  Scene scene = { 0 }, anew = { 0 }, later = { 0 };
  SceneLook look;

  run (session, command);
  look = *session_get_look (session);
  session_fill_scene (session, 0, &scene, &look);
  look.selection = (Object){ OBJECT_SITE, 3 };
  look.hover = (Object){ OBJECT_SITE, 1 };
  g_assert_true (session_relight_scene (session, 0, &scene, &look));
  session_fill_scene (session, 0, &anew, &look);
  check_same_scene (&scene, &anew);
  g_assert_cmpuint (scene.n_lit, ==, g_str_equal (view, "signs") ? 0 : 2);
  showing = session_keep_showing (session, 0, &look);
  run (session, "view lifts");
  showing_fill (showing, &later);
  check_same_scene (&later, &anew);
  scene_clear (&scene);
  scene_clear (&anew);
  scene_clear (&later);
}

static void
test_another_light_is_that_of_a_scene_made_anew (void)
{
  check_light ("planar");
  check_light ("rounded");
  check_light ("signs");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/exhibit-picture/pictures-look-like-the-references",
                   test_pictures_look_like_the_references);
  g_test_add_func ("/exhibit-picture/another-step-is-another-picture",
                   test_another_step_is_another_picture);
  g_test_add_func ("/exhibit-picture/layers-can-be-chosen-where-they-are-seen",
                   test_layers_can_be_chosen_where_they_are_seen);
  g_test_add_func ("/exhibit-picture/a-thread-makes-the-record-of-many-sites",
                   test_a_thread_makes_the_record_of_many_sites);
  g_test_add_func (
      "/exhibit-picture/another-light-is-that-of-a-scene-made-anew",
      test_another_light_is_that_of_a_scene_made_anew);
  g_test_add_func ("/exhibit-picture/the-hatch-of-a-sign-map-is-whole",
                   test_the_hatch_of_a_sign_map_is_whole);
  return g_test_run ();
}
