/* Looks at space in words. */
#include "action.h"
#include "camera-text.h"
#include "same-session.h"

static void
test_cameras_survive_their_words (void)
{
  GRand *random = g_rand_new_with_seed (7);
  const double size[2] = { 800, 600 };

  for (guint i = 0; i < 500; i++) {
    Camera camera, again;
    g_autofree char *text = NULL, *twice = NULL;
    const double from[2] = { g_rand_double_range (random, 0, 800),
                             g_rand_double_range (random, 0, 600) };
    const double to[2] = { g_rand_double_range (random, 0, 800),
                           g_rand_double_range (random, 0, 600) };

    camera_init (&camera, (CameraPreset)(i % N_CAMERA_PRESETS));
    camera_roll (&camera, from, to, size);
    camera.zoom = g_rand_double_range (random, 0.2, 4);
    camera.pan_x = i % 3 == 0 ? 0 : g_rand_double_range (random, -1, 1);
    text = camera_text_write (&camera);
    g_assert_true (camera_text_read (text, &again));
    assert_same_camera (&camera, &again);
    twice = camera_text_write (&again);
    g_assert_cmpstr (text, ==, twice);
  }
  g_rand_free (random);
}

static void
test_words_that_are_no_camera_are_refused (void)
{
  static const char *const words[]
      = { "",       "20",         "20 91",          "20 18 0 0",
          "a b",    "20 18 nan",  "20 18 0 1 2",    "20 18 0 1 2 3 4",
          "inf 18", "20 18 flat", "parallel 20 18", "20 18 centre 1" };
  g_autoptr (Session) session = session_new ();
  g_autofree char *home = NULL;

  for (guint i = 0; i < G_N_ELEMENTS (words); i++) {
    Camera camera;

    g_assert_false (camera_text_read (words[i], &camera));
    g_assert_false (
        action_run (session, "camera", g_variant_new_string (words[i]), NULL));
  }
  g_assert_true (
      action_run (session, "camera", g_variant_new_string ("20 18"), NULL));
  home = camera_text_write (session_get_camera (session));
  g_assert_cmpstr (home, ==, "home");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/camera-text/cameras-survive-their-words",
                   test_cameras_survive_their_words);
  g_test_add_func ("/camera-text/words-that-are-no-camera-are-refused",
                   test_words_that_are_no_camera_are_refused);
  return g_test_run ();
}
