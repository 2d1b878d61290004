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
paint (const Case *what)
{
  g_autoptr (Session) session = play (what);
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

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/exhibit-picture/pictures-look-like-the-references",
                   test_pictures_look_like_the_references);
  g_test_add_func ("/exhibit-picture/another-step-is-another-picture",
                   test_another_step_is_another_picture);
  return g_test_run ();
}
