/* view-bench [FRAMES [WORDS]]: what the two views cost, 1000 × 1000 px, beside
 * what they may cost: all rows, or those that have WORDS in their names. A row
 * is a frame as the window makes it, without the window: recompute, scene,
 * drawing, pixels. */
#include "easel.h"
#include "egl-context.h"
#include "gl-painter.h"
#include "memory.h"
#include "raster.h"
#include "trace.h"

#include <epoxy/gl.h>
#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SIDE 1000
#define INSET 6.0
#define HULL_AND_SHEET (LAYER_HULL | LAYER_PARABOLOID)

/* Sites, their hull, and both views of it. */
typedef struct Views {
  Site *sites;
  guint n_sites;
  SiteSet *set;
  Trace *trace;
  Frame frame;
  SceneLook look;
  Camera camera;
  PlaneCamera plane_camera;
  Scene scenes[2];
  Easel *easels[2];
  ScenePicker *picker;
} Views;

static const Order order = { ORDER_FURTHEST, 0 };

static void
compute (Views *views, guint step)
{
  views->set = site_set_new (views->sites, views->n_sites);
  views->trace = trace_record (views->set, &order);
  frame_init (&views->frame, views->trace, MIN (step, views->trace->n_events));
}

static void
forget (Views *views)
{
  frame_clear (&views->frame);
  trace_free (views->trace);
  site_set_free (views->set);
}

static void
views_init (Views *views, guint n_sites, double part)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (11);

  *views = (Views){ .n_sites = n_sites };
  views->sites = g_new (Site, n_sites);
  for (guint i = 0; i < n_sites; i++) {
    views->sites[i].x = g_rand_double_range (rand, -1, 1);
    views->sites[i].y = g_rand_double_range (rand, -1, 1);
  }
  compute (views, G_MAXUINT);
  if (part < 1) {
    const guint step = (guint)(part * views->trace->n_events);

    frame_clear (&views->frame);
    frame_init (&views->frame, views->trace, step);
  }
  scene_look_init (&views->look, &views->frame);
  camera_init (&views->camera, CAMERA_HOME);
  plane_camera_init (&views->plane_camera);
  for (int i = 0; i < 2; i++)
    views->easels[i] = easel_new ();
  views->picker = scene_picker_new ();
}

static void
views_clear (Views *views)
{
  forget (views);
  scene_picker_free (views->picker);
  for (int i = 0; i < 2; i++) {
    scene_clear (&views->scenes[i]);
    easel_free (views->easels[i]);
  }
  g_free (views->sites);
}

static Projection
project (const Views *views, gboolean is_space)
{
  return is_space ? camera_projection (&views->camera, SIDE, SIDE)
                  : plane_camera_projection (&views->plane_camera, SIDE, SIDE);
}

static void
build (Views *views, gboolean is_space)
{
  const Projection projection = project (views, is_space);

  if (is_space) {
    scene_space (&views->scenes[1], &views->frame, &views->look);
    return;
  }
  scene_look_fit (&views->look, &projection, INSET);
  scene_plane (&views->scenes[0], &views->frame, &views->look);
}

static void
show (Views *views, gboolean is_space)
{
  const Projection projection = project (views, is_space);

  cairo_region_destroy (easel_paint (views->easels[is_space],
                                     &views->scenes[is_space], &projection,
                                     theme_get (THEME_LIGHT), 1));
}

static void
show_both (Views *views)
{
  for (int i = 0; i < 2; i++) {
    build (views, i);
    show (views, i);
  }
}

/* Times */

static guint n_frames = 15;
static const char *words = "";
static gboolean is_late; /* a row has missed its target */

static int
compare_times (const void *a, const void *b)
{
  const gint64 *p = a, *q = b;

  return (*p > *q) - (*p < *q);
}

/* Prints one row: the median of all frames but the first two, and the
 * slowest. A target of 0: none. */
static void
measure (const char *what,
         double target_ms,
         void (*frame) (Views *views, guint i),
         Views *views)
{
  g_autofree gint64 *times = g_new (gint64, n_frames);
  const guint middle = n_frames / 2;
  double median, slowest;

  for (guint i = 0; i < n_frames + 2; i++) {
    const gint64 start = g_get_monotonic_time ();

    frame (views, i);
    if (i >= 2)
      times[i - 2] = g_get_monotonic_time () - start;
  }
  qsort (times, n_frames, sizeof *times, compare_times);
  median = (double)times[middle] / 1000;
  slowest = (double)times[n_frames - 1] / 1000;
  if (target_ms > 0) {
    printf ("%-58s %6.0f %8.2f %8.2f  %s\n", what, target_ms, median, slowest,
            median <= target_ms ? "" : "late");
    is_late = is_late || median > target_ms;
  } else {
    printf ("%-58s %6s %8.2f %8.2f\n", what, "–", median, slowest);
  }
  fflush (stdout);
}

/* Frames */

static void
drag (Views *views, guint i)
{
  const double angle = 0.05 * i;

  views->look.selection = (Object){ OBJECT_SITE, 3 };
  views->sites[3] = (Site){ 0.2 * cos (angle), 0.2 * sin (angle) };
  forget (views);
  compute (views, G_MAXUINT);
  show_both (views);
}

static void
next_step (Views *views, guint i)
{
  const guint step = views->frame.step + 1;

  (void)i;
  frame_clear (&views->frame);
  frame_init (&views->frame, views->trace, step);
  show_both (views);
}

/* The pointer goes over the plane; both views light what is under it. */
static void
hover (Views *views, guint i)
{
  const Projection projection = project (views, FALSE);
  const guint row = i / 60;
  const double at_px[2] = { 300 + 7.0 * (i % 60), 400 + row };

  views->look.hover = scene_picker_pick (views->picker, &views->scenes[0],
                                         &projection, at_px, 12);
  for (int k = 0; k < 2; k++) {
    if (!scene_relight (&views->scenes[k], &views->frame, &views->look))
      build (views, k);
    show (views, k);
  }
}

/* The same, and both show what a site there would change. */
static void
foresee (Views *views, guint i)
{
  const Projection projection = project (views, FALSE);

  views->look.has_preview = TRUE;
  views->look.preview = scene_site (
      &views->look,
      projection_unapply (&projection, 300 + 7.0 * (i % 60), 400));
  hover (views, i);
}

/* The first one after a step: it lists what there is. */
static void
hover_anew (Views *views, guint i)
{
  show_both (views);
  hover (views, i);
}

static void
paint_whole (Views *views, guint i)
{
  static Names *names;
  static Drawing *drawing;
  static Raster *raster;
  const Projection projection = project (views, FALSE);

  (void)i;
  if (names == NULL) {
    names = names_new ();
    drawing = drawing_new (names);
    raster = raster_new (SIDE, SIDE, 1);
  }
  build (views, FALSE);
  drawing_set (drawing, &views->scenes[0], &projection,
               theme_get (THEME_LIGHT));
  raster_paint (raster, drawing, NULL);
}

static void
draw_kept (Views *views, guint i)
{
  static cairo_surface_t *window;
  cairo_t *cr;

  (void)i;
  if (window == NULL) {
    window = cairo_image_surface_create (CAIRO_FORMAT_RGB24, SIDE, SIDE);
    build (views, FALSE);
    show (views, FALSE);
  }
  cr = cairo_create (window);
  cairo_set_source_surface (cr, easel_get_surface (views->easels[0]), 0, 0);
  cairo_paint (cr);
  cairo_destroy (cr);
}

static void
turn_camera (Views *views)
{
  const double size_px[2] = { SIDE, SIDE }, from_px[2] = { 500, 500 };
  const double to_px[2] = { 507, 502 };

  camera_roll (&views->camera, from_px, to_px, size_px);
}

static void
turn (Views *views, guint i)
{
  if (i == 0)
    build (views, TRUE);
  turn_camera (views);
  show (views, TRUE);
}

/* OpenGL */

typedef struct Gl {
  GlPainter *painter;
  Names *names;
  Drawing *drawing;
  GlTarget target;
} Gl;

static Gl gl;

static gboolean
gl_begin (void)
{
  g_autoptr (GError) error = NULL;
  const char *why = NULL;

  if (!egl_context_make (FALSE, &why)) {
    printf ("OpenGL is not measured: %s\n", why);
    return FALSE;
  }
  gl.painter = gl_painter_new (&error);
  if (gl.painter == NULL) {
    printf ("OpenGL is not measured: %s\n", error->message);
    return FALSE;
  }
  gl.names = names_new ();
  gl.drawing = drawing_new (gl.names);
  gl.target = (GlTarget){ .framebuffer = egl_framebuffer_new (SIDE, SIDE),
                          .scale = 1 };
  return TRUE;
}

static void
gl_frame (Views *views)
{
  const Projection projection = project (views, TRUE);

  if (gl.target.is_rough)
    drawing_set_sketch (gl.drawing, &views->scenes[1], &projection,
                        theme_get (THEME_LIGHT), gl.target.scale);
  else
    drawing_set (gl.drawing, &views->scenes[1], &projection,
                 theme_get (THEME_LIGHT));
  gl_painter_paint (gl.painter, gl.drawing, &gl.target, NULL);
  glFinish ();
}

static void
gl_turn (Views *views, guint i)
{
  if (i == 0)
    build (views, TRUE);
  turn_camera (views);
  gl.target.is_rough = TRUE;
  gl_frame (views);
}

static void
gl_settle (Views *views, guint i)
{
  if (i == 0)
    build (views, TRUE);
  gl.target.is_rough = FALSE;
  gl_frame (views);
}

/* The table */

static void
measure_sites (const char *what,
               guint n_sites,
               double part,
               double target_ms,
               void (*frame) (Views *views, guint i))
{
  Views views;

  if (strstr (what, words) == NULL)
    return;
  views_init (&views, n_sites, part);
  if (frame == hover || frame == foresee || frame == next_step)
    show_both (&views);
  measure (what, target_ms, frame, &views);
  views_clear (&views);
}

/* A hull of n sites has 2n − 4 facets. */
static void
measure_facets (const char *what,
                guint n_facets,
                guint layers,
                double target_ms,
                void (*frame) (Views *views, guint i))
{
  Views views;

  if (strstr (what, words) == NULL)
    return;
  views_init (&views, n_facets / 2 + 2, 1);
  views.look.layers = layers;
  measure (what, target_ms, frame, &views);
  views_clear (&views);
}

static void
measure_gl (void)
{
  if (!gl_begin ())
    return;
  printf ("\nOpenGL is %s\n", (const char *)glGetString (GL_RENDERER));
  measure_facets ("space, OpenGL, 10 000 facets and sheet, turning", 10000,
                  HULL_AND_SHEET, 20, gl_turn);
  measure_facets ("  at rest: 10 000 facets, four samples a pixel", 10000,
                  HULL_AND_SHEET, 160, gl_settle);
  measure_facets ("space, OpenGL, 1 000 facets and sheet, turning", 1000,
                  HULL_AND_SHEET, 20, gl_turn);
  measure_facets ("  at rest: 1 000 facets, four samples a pixel", 1000,
                  HULL_AND_SHEET, 160, gl_settle);
  measure_facets ("  12 facets, all layers, turning", 12, LAYERS_DEFAULT, 0,
                  gl_turn);
  measure_facets ("  12 facets, all layers, at rest", 12, LAYERS_DEFAULT, 0,
                  gl_settle);
  measure_facets ("  100 facets, all layers, turning", 100, LAYERS_DEFAULT, 0,
                  gl_turn);
}

static void
measure_raster (void)
{
  measure_sites ("drag a site: recompute, both views, 200 sites", 200, 1, 16,
                 drag);
  measure_sites ("drag a site: recompute, both views, 2 000 sites", 2000, 1, 50,
                 drag);
  measure_sites ("a step, both views, 2 000 sites", 2000, 0.5, 8, next_step);
  measure_sites ("hover: pick, both views, 10 000 sites", 10000, 1, 5, hover);
  measure_sites ("  the same, with the preview of a site", 10000, 1, 0,
                 foresee);
  measure_sites ("  both views, whole, and the first hover", 10000, 1, 0,
                 hover_anew);
  measure_sites ("plane, whole, 1 000 sites", 1000, 1, 20, paint_whole);
  measure_sites ("plane, whole, 10 000 sites", 10000, 1, 100, paint_whole);
  measure_sites ("plane, nothing has changed, 10 000 sites", 10000, 1, 1,
                 draw_kept);
  measure_facets ("space, 1 000 facets and sheet, turning", 1000,
                  HULL_AND_SHEET, 12, turn);
  measure_facets ("space, 10 000 facets and sheet, turning", 10000,
                  HULL_AND_SHEET, 30, turn);
  measure_facets ("  12 facets, all layers, turning", 12, LAYERS_DEFAULT, 0,
                  turn);
  measure_facets ("  100 facets, all layers, turning", 100, LAYERS_DEFAULT, 0,
                  turn);
  measure_facets ("  10 000 facets, all layers, turning", 10000, LAYERS_DEFAULT,
                  0, turn);
}

/* The processor, as the system names it. */
static void
print_machine (void)
{
  g_autofree char *text = NULL;
  const char *name = NULL;

  if (g_file_get_contents ("/proc/cpuinfo", &text, NULL, NULL))
    name = strstr (text, "model name");
  if (name != NULL) {
    name = strchr (name, ':') + 2;
    printf ("%.*s, ", (int)strcspn (name, "\n"), name);
  }
  printf ("%u processors; %d × %d px; ms a frame, %u frames\n",
          g_get_num_processors (), SIDE, SIDE, n_frames);
}

int
main (int argc, char **argv)
{
  memory_keep ();
  if (argc > 1)
    n_frames = (guint)MAX (atoi (argv[1]), 3);
  if (argc > 2)
    words = argv[2];
  print_machine ();
  printf ("%-58s %6s %8s %8s\n", "", "target", "median", "slowest");
  measure_raster ();
  measure_gl ();
  return is_late ? 1 : 0;
}
