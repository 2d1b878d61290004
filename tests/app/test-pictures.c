/* Pictures of large sets, which another thread makes: both views in a window,
 * as the session changes. Needs a display: run by tests/headless.sh. */
#include "document.h"
#include "plane-view.h"
#include "session-chore.h"
#include "space-view.h"

#include <string.h>

#define N_LARGE (SESSION_AT_ONCE + 400)
#define N_CANVASES 2

typedef struct Stage {
  GtkWidget *window, *views[N_CANVASES];
  Session *session;
} Stage;

static Site *
random_sites (guint n, guint32 seed)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);
  Site *sites = g_new (Site, n);

  for (guint i = 0; i < n; i++)
    sites[i] = (Site){ g_rand_double_range (rand, -1, 1),
                       g_rand_double_range (rand, -1, 1) };
  return sites;
}

static gboolean
is_busy (const Stage *stage)
{
  return session_is_working (stage->session, NULL)
         || canvas_is_busy (HULL2VD_CANVAS (stage->views[0]))
         || canvas_is_busy (HULL2VD_CANVAS (stage->views[1]));
}

/* The picture of a view as it is drawn now. */
static cairo_surface_t *
draw (GtkWidget *view)
{
  cairo_surface_t *surface = cairo_image_surface_create (
      CAIRO_FORMAT_RGB24, gtk_widget_get_allocated_width (view),
      gtk_widget_get_allocated_height (view));
  cairo_t *cr = cairo_create (surface);

  gtk_widget_draw (view, cr);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

/* Lets the main loop run until both pictures show what they should. */
static void
settle (Stage *stage)
{
  do {
    for (guint i = 0; i < N_CANVASES; i++)
      cairo_surface_destroy (draw (stage->views[i]));
    while (is_busy (stage))
      gtk_main_iteration ();
    for (guint i = 0; i < N_CANVASES; i++)
      cairo_surface_destroy (draw (stage->views[i]));
  } while (is_busy (stage));
}

static void
stage_init (Stage *stage, guint n)
{
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 0);
  g_autofree Site *sites = random_sites (n, 5);

  stage->window = gtk_window_new (GTK_WINDOW_TOPLEVEL);
  stage->session = session_new ();
  session_set_sites (stage->session, sites, n, NULL);
  session_set_patient (stage->session, TRUE);
  stage->views[0] = g_object_new (PLANE_VIEW_TYPE, NULL);
  stage->views[1] = g_object_new (SPACE_VIEW_TYPE, NULL);
  for (guint i = 0; i < N_CANVASES; i++) {
    gtk_widget_set_size_request (stage->views[i], 300, 300);
    canvas_set_session (HULL2VD_CANVAS (stage->views[i]), stage->session);
    gtk_container_add (GTK_CONTAINER (box), stage->views[i]);
  }
  gtk_container_add (GTK_CONTAINER (stage->window), box);
  gtk_widget_show_all (stage->window);
  while (!gtk_widget_get_mapped (stage->views[1]))
    gtk_main_iteration ();
  settle (stage);
}

static void
stage_clear (Stage *stage)
{
  gtk_widget_destroy (stage->window);
  g_object_unref (stage->session);
}

static void
check_same (cairo_surface_t *a, cairo_surface_t *b)
{
  const gsize n = (gsize)cairo_image_surface_get_stride (a)
                  * (gsize)cairo_image_surface_get_height (a);

  g_assert_cmpmem (cairo_image_surface_get_data (a), n,
                   cairo_image_surface_get_data (b), n);
}

/* Both pictures, once as they are and once made anew on the main loop. */
static void
check_pictures (Stage *stage)
{
  for (guint i = 0; i < N_CANVASES; i++) {
    cairo_surface_t *later, *at_once;

    settle (stage);
    later = draw (stage->views[i]);
    session_set_patient (stage->session, FALSE);
    canvas_invalidate (HULL2VD_CANVAS (stage->views[i]));
    at_once = draw (stage->views[i]);
    g_assert_false (canvas_is_busy (HULL2VD_CANVAS (stage->views[i])));
    session_set_patient (stage->session, TRUE);
    check_same (later, at_once);
    cairo_surface_destroy (later);
    cairo_surface_destroy (at_once);
  }
}

static void
test_same (void)
{
  Camera camera;
  Stage stage;

  stage_init (&stage, N_LARGE);
  check_pictures (&stage);
  session_set_step (stage.session, session_get_n_steps (stage.session) / 2);
  check_pictures (&stage);
  session_move_site (stage.session, 7, (Site){ 0.25, 0.5 }, NULL);
  check_pictures (&stage);
  camera_init (&camera, CAMERA_LOOK_DOWN);
  session_set_camera (stage.session, &camera);
  check_pictures (&stage);
  session_set_layers (stage.session, LAYER_HULL | LAYER_CIRCLES);
  session_set_selection (stage.session, (Object){ OBJECT_SITE, 7 });
  check_pictures (&stage);
  stage_clear (&stage);
}

/* Until then the one before is shown, and the main loop does not wait. */
static void
test_stays (void)
{
  Stage stage;

  stage_init (&stage, N_LARGE);
  for (guint i = 0; i < N_CANVASES; i++) {
    Canvas *canvas = HULL2VD_CANVAS (stage.views[i]);
    cairo_surface_t *before = draw (stage.views[i]), *now;

    session_set_step (stage.session,
                      session_get_n_steps (stage.session) / (i + 2));
    now = draw (stage.views[i]);
    g_assert_true (canvas_is_busy (canvas));
    check_same (before, now);
    cairo_surface_destroy (now);
    settle (&stage);
    now = draw (stage.views[i]);
    g_assert_cmpint (memcmp (cairo_image_surface_get_data (before),
                             cairo_image_surface_get_data (now), 300 * 300 * 4),
                     !=, 0);
    cairo_surface_destroy (now);
    cairo_surface_destroy (before);
  }
  stage_clear (&stage);
}

/* What is only lit is there at once. */
static void
test_lit (void)
{
  Stage stage;

  stage_init (&stage, N_LARGE);
  session_set_hover (stage.session, (Object){ OBJECT_SITE, 7 });
  for (guint i = 0; i < N_CANVASES; i++) {
    cairo_surface_destroy (draw (stage.views[i]));
    g_assert_false (canvas_is_busy (HULL2VD_CANVAS (stage.views[i])));
  }
  check_pictures (&stage);
  stage_clear (&stage);
}

/* A drag that is given up leaves the document as it was, and the pictures. */
static void
test_cancelled (void)
{
  g_autofree char *before = NULL, *after = NULL;
  cairo_surface_t *pictures[2];
  Stage stage;

  stage_init (&stage, 10000);
  before = document_copy (stage.session);
  pictures[0] = draw (stage.views[0]);
  session_begin_edit (stage.session);
  for (guint i = 0; i < 8; i++) {
    session_move_site (stage.session, 7, (Site){ i / 16.0, 0.25 }, NULL);
    cairo_surface_destroy (draw (stage.views[0]));
    g_main_context_iteration (NULL, FALSE);
  }
  session_cancel (stage.session);
  session_cancel_edit (stage.session);
  settle (&stage);
  after = document_copy (stage.session);
  g_assert_cmpstr (after, ==, before);
  pictures[1] = draw (stage.views[0]);
  check_same (pictures[0], pictures[1]);
  cairo_surface_destroy (pictures[0]);
  cairo_surface_destroy (pictures[1]);
  stage_clear (&stage);
}

/* Who does not wait for a picture keeps the one before, until something else
 * changes; who steps fast sees the last step. */
static void
test_refused (void)
{
  cairo_surface_t *before, *after;
  Stage stage;

  stage_init (&stage, N_LARGE);
  before = draw (stage.views[0]);
  session_set_step (stage.session, session_get_n_steps (stage.session) / 2);
  cairo_surface_destroy (draw (stage.views[0]));
  g_assert_nonnull (session_get_chore (stage.session));
  g_assert_true (session_give_up (stage.session));
  g_assert_null (session_get_chore (stage.session));
  /* The picture of space is another one. */
  for (guint i = 0; i < 100 || session_get_chore (stage.session) != NULL; i++) {
    g_main_context_iteration (NULL, FALSE);
    g_usleep (1000);
  }
  after = draw (stage.views[0]);
  g_assert_null (session_get_chore (stage.session));
  check_same (before, after);
  cairo_surface_destroy (before);
  cairo_surface_destroy (after);
  for (guint i = 9; i > 3; i--) {
    session_set_step (stage.session, session_get_n_steps (stage.session) / i);
    cairo_surface_destroy (draw (stage.views[0]));
    g_main_context_iteration (NULL, FALSE);
  }
  check_pictures (&stage);
  g_assert_null (session_get_chore (stage.session));
  stage_clear (&stage);
}

/* Few sites are shown at once, whatever is still in the making. */
static void
test_few (void)
{
  g_autofree Site *sites = random_sites (9, 6);
  Stage stage;

  stage_init (&stage, N_LARGE);
  session_set_step (stage.session, session_get_n_steps (stage.session) / 2);
  cairo_surface_destroy (draw (stage.views[0]));
  g_assert_true (canvas_is_busy (HULL2VD_CANVAS (stage.views[0])));
  session_set_sites (stage.session, sites, 9, NULL);
  cairo_surface_destroy (draw (stage.views[0]));
  g_assert_false (canvas_is_busy (HULL2VD_CANVAS (stage.views[0])));
  check_pictures (&stage);
  stage_clear (&stage);
}

/* While GTK dresses all widgets, a few hundred sites are enough to wait for. */
static void
test_dressed (void)
{
  Appearance dark;
  Stage stage;

  stage_init (&stage, 300);
  dark = *session_get_own_appearance (stage.session);
  dark.theme = THEME_DARK;
  session_set_own_appearance (stage.session, &dark);
  cairo_surface_destroy (draw (stage.views[0]));
  g_assert_true (canvas_is_busy (HULL2VD_CANVAS (stage.views[0])));
  check_pictures (&stage);
  session_set_step (stage.session, session_get_n_steps (stage.session) / 2);
  cairo_surface_destroy (draw (stage.views[0]));
  g_assert_false (canvas_is_busy (HULL2VD_CANVAS (stage.views[0])));
  stage_clear (&stage);
}

/* A window that goes while its pictures are in the making. */
static void
test_left (void)
{
  Stage stage;

  stage_init (&stage, N_LARGE);
  session_set_step (stage.session, 9);
  cairo_surface_destroy (draw (stage.views[0]));
  cairo_surface_destroy (draw (stage.views[1]));
  stage_clear (&stage);
  for (guint i = 0; i < 50; i++) {
    g_main_context_iteration (NULL, FALSE);
    g_usleep (2000);
  }
}

int
main (int argc, char **argv)
{
  gtk_test_init (&argc, &argv, NULL);
  g_test_add_func ("/pictures/they-are-those-made-at-once", test_same);
  g_test_add_func ("/pictures/the-one-before-is-shown-until-then", test_stays);
  g_test_add_func ("/pictures/what-is-lit-is-there-at-once", test_lit);
  g_test_add_func ("/pictures/a-drag-given-up-leaves-all-as-it-was",
                   test_cancelled);
  g_test_add_func ("/pictures/one-given-up-leaves-the-one-before",
                   test_refused);
  g_test_add_func ("/pictures/few-sites-are-shown-at-once", test_few);
  g_test_add_func ("/pictures/another-theme-comes-later", test_dressed);
  g_test_add_func ("/pictures/a-window-may-go-away", test_left);
  return g_test_run ();
}
