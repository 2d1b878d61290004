/* The GL painter without a screen: its pictures of both views against those
 * of cairo and against the references. Where there is no EGL it fails and says
 * why. */
#include "egl-context.h"
#include "gl-painter.h"
#include "look-case.h"

#include <math.h>

#define SQUARE 20 /* px: pictures are compared in such squares from afar */

/* A scene on its way through GL. */
typedef struct Gl {
  GlPainter *painter;
  Names *names;
  Drawing *drawing;
} Gl;

static void
gl_init (Gl *gl, gboolean is_es)
{
  g_autoptr (GError) error = NULL;
  const char *why = NULL;

  if (!egl_context_make (is_es, &why))
    g_error ("GL cannot be tested: %s", why);
  gl->painter = gl_painter_new (&error);
  g_assert_no_error (error);
  gl->names = names_new ();
  gl->drawing = drawing_new (gl->names);
}

static void
gl_clear (Gl *gl)
{
  drawing_free (gl->drawing);
  names_free (gl->names);
  gl_painter_free (gl->painter);
  egl_context_drop ();
}

/* Returns: (transfer full): the picture of a scene. */
static cairo_surface_t *
gl_paint (Gl *gl, const LookScene *look, const Theme *theme, GlTarget target)
{
  const int side = (int)(LOOK_SIDE * target.scale);
  g_autoptr (GError) error = NULL;
  cairo_surface_t *surface;

  target.framebuffer = egl_framebuffer_new (side, side);
  name_places_forget (names_places (gl->names));
  drawing_set (gl->drawing, &look->scene, &look->projection, theme);
  gl_painter_paint (gl->painter, gl->drawing, &target, &error);
  g_assert_no_error (error);
  surface = egl_read (target.framebuffer, side, side);
  egl_framebuffer_free (target.framebuffer);
  return surface;
}

static const GlTarget fine = { .scale = 1 };

static void
check_case (Gl *gl, const LookCase *what, PictureView view, const char *by)
{
  const char *end = view == PICTURE_PLANE ? "plane" : "space";
  g_autofree char *name
      = g_strdup_printf ("%s-%s%s-cairo", what->name, end, by);
  cairo_surface_t *cairo = look_paint (what, view), *out;
  LookScene look;

  look_scene_init (&look, what, view);
  out = gl_paint (gl, &look, look.theme, fine);
  look_check_case (what, view, by, out, LOOK_ALIKE);
  look_check (name, out, cairo, LOOK_ALIKE);
  look_scene_clear (&look);
  cairo_surface_destroy (cairo);
  cairo_surface_destroy (out);
}

static void
check_cases (gboolean is_es, guint every, const char *by)
{
  Gl gl;

  gl_init (&gl, is_es);
  for (guint i = 0; i < look_n_cases; i += every) {
    check_case (&gl, &look_cases[i], PICTURE_PLANE, by);
    check_case (&gl, &look_cases[i], PICTURE_SPACE, by);
  }
  gl_clear (&gl);
}

static void
test_pictures (void)
{
  check_cases (FALSE, 1, "-gl");
}

static void
test_es (void)
{
  check_cases (TRUE, 4, "-gles");
}

/* Print has every hatch, the others every colour. */
static void
test_themes (void)
{
  Gl gl;

  gl_init (&gl, FALSE);
  for (int kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);
    g_autofree char *name = g_strconcat (theme->name, "-gl", NULL);
    cairo_surface_t *ref
        = cairo_image_surface_create (CAIRO_FORMAT_RGB24, LOOK_SIDE, LOOK_SIDE);
    cairo_t *cr = cairo_create (ref);
    cairo_surface_t *out;
    LookScene look;

    look_scene_init (&look, &look_cases[8], PICTURE_SPACE);
    painter_paint (cr, &look.scene, &look.projection, theme, 0);
    cairo_destroy (cr);
    cairo_surface_flush (ref);
    out = gl_paint (&gl, &look, theme, fine);
    look_check (name, out, ref, LOOK_ALIKE);
    look_scene_clear (&look);
    cairo_surface_destroy (out);
    cairo_surface_destroy (ref);
  }
  gl_clear (&gl);
}

/* While something moves only the edges of areas are rougher. */
static void
test_rough (void)
{
  const GlTarget rough = { .scale = 1, .is_rough = TRUE };
  Gl gl;

  gl_init (&gl, FALSE);
  for (guint i = 0; i < look_n_cases; i += 3) {
    g_autofree char *name
        = g_strconcat (look_cases[i].name, "-space-rough", NULL);
    cairo_surface_t *cairo = look_paint (&look_cases[i], PICTURE_SPACE), *out;
    LookScene look;

    look_scene_init (&look, &look_cases[i], PICTURE_SPACE);
    out = gl_paint (&gl, &look, look.theme, rough);
    look_check (name, out, cairo, LOOK_ALIKE);
    look_scene_clear (&look);
    cairo_surface_destroy (cairo);
    cairo_surface_destroy (out);
  }
  gl_clear (&gl);
}

static void
test_scale (void)
{
  const GlTarget twice = { .scale = 2 };
  cairo_surface_t *ref = cairo_image_surface_create (
      CAIRO_FORMAT_RGB24, 2 * LOOK_SIDE, 2 * LOOK_SIDE);
  cairo_t *cr = cairo_create (ref);
  cairo_surface_t *out;
  LookScene look;
  Gl gl;

  gl_init (&gl, FALSE);
  look_scene_init (&look, &look_cases[6], PICTURE_SPACE);
  cairo_scale (cr, 2, 2);
  painter_paint (cr, &look.scene, &look.projection, look.theme, 0);
  cairo_destroy (cr);
  cairo_surface_flush (ref);
  out = gl_paint (&gl, &look, look.theme, twice);
  look_check ("scale-2-gl", out, ref, LOOK_ALIKE);
  look_scene_clear (&look);
  cairo_surface_destroy (out);
  cairo_surface_destroy (ref);
  gl_clear (&gl);
}

/* Mean of a channel in one square of a picture. */
static double
mean_in_square (cairo_surface_t *surface, const int square[2], int k)
{
  const unsigned char *data = cairo_image_surface_get_data (surface);
  const int stride = cairo_image_surface_get_stride (surface);
  double sum = 0;

  for (int y = SQUARE * square[1]; y < SQUARE * (square[1] + 1); y++)
    for (int x = SQUARE * square[0]; x < SQUARE * (square[0] + 1); x++)
      sum += data[y * stride + 4 * x + k];
  return sum / (SQUARE * SQUARE);
}

/* How far two pictures are apart in the worst of all squares, and on the
 * average. */
static void
compare_squares (cairo_surface_t *a,
                 cairo_surface_t *b,
                 double *worst,
                 double *mean)
{
  const int n = LOOK_SIDE / SQUARE;

  *worst = *mean = 0;
  for (int i = 0; i < n * n; i++)
    for (int k = 0; k < 3; k++) {
      const int square[2] = { i % n, i / n };
      const double off = fabs (mean_in_square (a, square, k)
                               - mean_in_square (b, square, k));

      *worst = MAX (*worst, off);
      *mean += off / (3 * n * n);
    }
}

/* Many sites in space, one of them selected. */
static void
crowd_init (LookScene *look, guint n_sites, ThemeKind theme)
{
  SceneLook all;
  Camera camera;

  *look = (LookScene){ .theme = theme_get (theme) };
  look->fixture = fixture_new (FAMILY_RANDOM, 5, n_sites, ORDER_FURTHEST);
  frame_init (&look->frame, look->fixture->trace,
              look->fixture->trace->n_events);
  scene_look_init (&all, &look->frame);
  all.selection = (Object){ OBJECT_SITE, 3 };
  camera_init (&camera, CAMERA_HOME);
  look->projection = camera_projection (&camera, LOOK_SIDE, LOOK_SIDE);
  scene_space (&look->scene, &look->frame, &all);
}

static cairo_surface_t *
paint_sketch (Gl *gl, const LookScene *look)
{
  const GlTarget target
      = { .framebuffer = egl_framebuffer_new (LOOK_SIDE, LOOK_SIDE),
          .scale = 1,
          .is_rough = TRUE };
  g_autoptr (GError) error = NULL;
  cairo_surface_t *surface;

  name_places_forget (names_places (gl->names));
  drawing_set_sketch (gl->drawing, &look->scene, &look->projection, look->theme,
                      target.scale);
  gl_painter_paint (gl->painter, gl->drawing, &target, &error);
  g_assert_no_error (error);
  surface = egl_read (target.framebuffer, LOOK_SIDE, LOOK_SIDE);
  egl_framebuffer_free (target.framebuffer);
  return surface;
}

static void
check_sketch (Gl *gl, ThemeKind theme)
{
  cairo_surface_t *out, *ref;
  double worst, mean;
  guint n_strokes;
  LookScene look;

  crowd_init (&look, 1200, theme);
  ref = gl_paint (gl, &look, look.theme, fine);
  n_strokes = gl->drawing->n_strokes;
  out = paint_sketch (gl, &look);
  g_assert_true (gl->drawing->is_sketch);
  g_assert_cmpuint (gl->drawing->n_strokes, <, n_strokes);
  compare_squares (out, ref, &worst, &mean);
  g_test_message ("%s: off by %.2f, in a square by %.2f", look.theme->name,
                  mean, worst);
  g_assert_cmpfloat (mean, <, 4);
  g_assert_cmpfloat (worst, <, 26);
  cairo_surface_destroy (out);
  cairo_surface_destroy (ref);
  look_scene_clear (&look);
}

/* A sketch has other edges, and lacks the lines behind the hull: seen from
 * afar it is the same picture. */
static void
test_sketch (void)
{
  Gl gl;

  gl_init (&gl, FALSE);
  for (int kind = 0; kind < N_THEMES; kind++)
    check_sketch (&gl, (ThemeKind)kind);
  gl_clear (&gl);
}

/* A name stands in the same place while the view is turned, and after it. */
static void
check_names_of_sketch (Gl *gl, ThemeKind theme, guint n_sites)
{
  LookScene look;
  Pixel at;

  crowd_init (&look, n_sites, theme);
  name_places_forget (names_places (gl->names));
  drawing_set (gl->drawing, &look.scene, &look.projection, look.theme);
  g_assert_cmpuint (gl->drawing->n_placed, ==, 1);
  at = gl->drawing->placed[0].at;
  name_places_forget (names_places (gl->names));
  drawing_set_sketch (gl->drawing, &look.scene, &look.projection, look.theme,
                      1);
  g_assert_true (gl->drawing->is_sketch);
  g_assert_cmpuint (gl->drawing->n_placed, ==, 1);
  g_assert_cmpfloat (gl->drawing->placed[0].at.x, ==, at.x);
  g_assert_cmpfloat (gl->drawing->placed[0].at.y, ==, at.y);
  look_scene_clear (&look);
}

static void
test_names_of_sketch (void)
{
  Gl gl;

  gl_init (&gl, FALSE);
  for (int kind = 0; kind < N_THEMES; kind++)
    for (guint n_sites = 1200; n_sites < 1210; n_sites++)
      check_names_of_sketch (&gl, (ThemeKind)kind, n_sites);
  gl_clear (&gl);
}

/* With few sites each line is looked at. */
static void
test_small_sketch (void)
{
  LookScene look;
  guint n_strokes;
  Gl gl;

  gl_init (&gl, FALSE);
  crowd_init (&look, 40, THEME_LIGHT);
  drawing_set (gl.drawing, &look.scene, &look.projection, look.theme);
  n_strokes = gl.drawing->n_strokes;
  drawing_set_sketch (gl.drawing, &look.scene, &look.projection, look.theme, 1);
  g_assert_false (gl.drawing->is_sketch);
  g_assert_cmpuint (gl.drawing->n_strokes, ==, n_strokes);
  look_scene_clear (&look);
  gl_clear (&gl);
}

/* A framebuffer that does not exist is an error, not a blank picture. */
static void
test_failure (void)
{
  g_autoptr (GError) error = NULL;
  const GlTarget nowhere = { .framebuffer = 4711, .scale = 1 };
  LookScene look;
  Gl gl;

  gl_init (&gl, FALSE);
  look_scene_init (&look, &look_cases[0], PICTURE_SPACE);
  drawing_set (gl.drawing, &look.scene, &look.projection, look.theme);
  g_assert_false (gl_painter_paint (gl.painter, gl.drawing, &nowhere, &error));
  g_assert_error (error, GL_PAINTER_ERROR, GL_PAINTER_ERROR_FRAME);
  look_scene_clear (&look);
  gl_clear (&gl);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/gl/its-pictures-are-those-of-cairo", test_pictures);
  g_test_add_func ("/gl/the-same-with-opengl-es", test_es);
  g_test_add_func ("/gl/every-theme-looks-as-in-cairo", test_themes);
  g_test_add_func ("/gl/what-moves-is-the-same-picture", test_rough);
  g_test_add_func ("/gl/a-sketch-is-the-same-from-afar", test_sketch);
  g_test_add_func ("/gl/a-sketch-has-its-names-where-they-stay",
                   test_names_of_sketch);
  g_test_add_func ("/gl/little-is-never-sketched", test_small_sketch);
  g_test_add_func ("/gl/fine-screens-show-the-same-picture", test_scale);
  g_test_add_func ("/gl/a-picture-that-fails-is-an-error", test_failure);
  return g_test_run ();
}
