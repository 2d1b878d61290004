/* Drawings that take strokes from the one before: they are those drawn anew,
 * and all that differs is marked. */
#include "drawing.h"
#include "fixture.h"
#include "squares.h"
#include "theme.h"

#include <string.h>

#define SIDE 300
#define SQUARE 16

/* One drawing after another, as an easel has them, and each drawn anew. */
typedef struct Sequence {
  Names *names;
  Drawing *now, *before, *anew;
  Scene scene;
  gboolean is_space;
  guint n_taken; /* drawings that could take something */
} Sequence;

static void
sequence_init (Sequence *sequence, gboolean is_space)
{
  *sequence = (Sequence){ .names = names_new (), .is_space = is_space };
  sequence->now = drawing_new (sequence->names);
  sequence->before = drawing_new (sequence->names);
  sequence->anew = drawing_new (sequence->names);
}

static void
sequence_clear (Sequence *sequence)
{
  drawing_free (sequence->now);
  drawing_free (sequence->before);
  drawing_free (sequence->anew);
  names_free (sequence->names);
  scene_clear (&sequence->scene);
}

static gboolean
is_same_style (const Style *a, const Style *b)
{
  return colour_equal (a->fill, b->fill) && colour_equal (a->line, b->line)
         && colour_equal (a->halo, b->halo) && a->hatch == b->hatch
         && a->mark == b->mark && a->width == b->width && a->dash == b->dash
         && a->gap == b->gap && a->casing == b->casing && a->radius == b->radius
         && a->ring_gap == b->ring_gap && a->halo_width == b->halo_width;
}

static void
check_stroke (const Drawing *a, const Stroke *p, const Drawing *b, guint i)
{
  const Stroke *q = &b->strokes[i];

  g_assert_cmpint (p->kind, ==, q->kind);
  g_assert_cmpuint (p->n_outer, ==, q->n_outer);
  g_assert_cmpmem (&p->fill, sizeof p->fill, &q->fill, sizeof q->fill);
  g_assert_cmpmem (&p->box, sizeof p->box, &q->box, sizeof q->box);
  g_assert_cmpmem (&p->place, sizeof p->place, &q->place, sizeof q->place);
  g_assert_true (is_same_style (&a->styles[p->style], &b->styles[q->style]));
  g_assert_cmpmem (a->pixels + p->first, p->n * sizeof *a->pixels,
                   b->pixels + q->first, q->n * sizeof *b->pixels);
}

static void
check_same (const Drawing *a, const Drawing *b)
{
  g_assert_cmpuint (a->n_strokes, ==, b->n_strokes);
  for (guint i = 0; i < a->n_strokes; i++)
    check_stroke (a, &a->strokes[i], b, i);
  g_assert_cmpuint (a->n_placed, ==, b->n_placed);
  for (guint i = 0; i < a->n_placed; i++)
    g_assert_cmpmem (&a->placed[i].at, sizeof (Pixel), &b->placed[i].at,
                     sizeof (Pixel));
}

/* Where sums over the strokes of both differ, they are told to differ. */
static void
check_marked (const Sequence *sequence, const Squares *changed)
{
  const SquareGrid *grid = &changed->grid;
  Squares differing;

  squares_init (&differing, grid);
  drawing_compare (sequence->before, sequence->now, &differing);
  for (int i = 0; i < grid->columns * grid->rows; i++)
    g_assert_true (changed->is_marked[i] || !differing.is_marked[i]);
  squares_clear (&differing);
}

static Projection
project (gboolean is_space)
{
  Camera camera;
  PlaneCamera plane_camera;

  camera_init (&camera, CAMERA_HOME);
  plane_camera_init (&plane_camera);
  return is_space ? camera_projection (&camera, SIDE, SIDE)
                  : plane_camera_projection (&plane_camera, SIDE, SIDE);
}

static void
go_on (Sequence *sequence, const Trace *trace, guint step, SceneLook *look)
{
  const Projection projection = project (sequence->is_space);
  const SquareGrid grid = square_grid_of (SIDE, SIDE, 1, SQUARE);
  const Theme *theme = theme_get (THEME_PAPER);
  Drawing *last = sequence->before;
  Squares changed;
  Frame frame;

  frame_init (&frame, trace, step);
  if (sequence->is_space)
    scene_space (&sequence->scene, &frame, look);
  else
    scene_plane (&sequence->scene, &frame, look);
  frame_clear (&frame);
  sequence->before = sequence->now;
  sequence->now = last;
  squares_init (&changed, &grid);
  if (drawing_set_stock_again (last, sequence->before, &sequence->scene,
                               &projection, theme, &changed)) {
    sequence->n_taken++;
    check_marked (sequence, &changed);
  }
  squares_clear (&changed);
  drawing_set_stock (sequence->anew, &sequence->scene, &projection, theme);
  check_same (sequence->now, sequence->anew);
}

static void
walk_through (const Fixture *fixture)
{
  const Trace *trace = fixture->trace;

  for (guint space = 0; space < 2; space++) {
    Sequence sequence;
    SceneLook look;
    Frame frame;

    frame_init (&frame, trace, 0);
    scene_look_init (&look, &frame);
    frame_clear (&frame);
    look.layers |= LAYER_CIRCLES | LAYER_FURTHEST | LAYER_TANGENTS;
    sequence_init (&sequence, space == 1);
    for (guint i = 0; i <= MIN (trace->n_events, 60); i++)
      go_on (&sequence, trace, i, &look);
    for (guint i = 0; i < 6; i++)
      go_on (&sequence, trace, i * 7919 % (trace->n_events + 1), &look);
    g_assert_cmpuint (sequence.n_taken, >, 0);
    sequence_clear (&sequence);
  }
}

static void
test_steps (void)
{
  fixture_for_each (0, 40, ORDER_FURTHEST, walk_through);
}

/* A site that is dragged numbers all facets anew; and opacity makes styles. */
static void
test_drag (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (3);
  const Order order = { ORDER_FURTHEST, 0 };
  Site sites[60];
  Sequence sequence;
  SceneLook look;
  Frame frame;

  for (guint i = 0; i < G_N_ELEMENTS (sites); i++)
    sites[i] = (Site){ g_rand_double (rand), g_rand_double (rand) };
  sequence_init (&sequence, TRUE);
  for (guint i = 0; i < 30; i++) {
    SiteSet *set;
    Trace *trace;

    sites[3].x = 0.3 + 0.01 * i;
    set = site_set_new (sites, G_N_ELEMENTS (sites));
    trace = trace_record (set, &order);
    frame_init (&frame, trace, trace->n_events);
    if (i == 0)
      scene_look_init (&look, &frame);
    frame_clear (&frame);
    look.role_fade[ROLE_LOWER] = i / 60.0;
    go_on (&sequence, trace, trace->n_events, &look);
    trace_free (trace);
    site_set_free (set);
  }
  g_assert_cmpuint (sequence.n_taken, ==, 29);
  sequence_clear (&sequence);
}

/* Items that look all the same and follow each other stay as many. */
static void
test_twins (void)
{
  Point3 points[] = { { -0.5, 0, 0 }, { 0.5, 0.5, 0 } };
  SceneItem items[3];
  const Scene scene = { .items = items,
                        .n_items = G_N_ELEMENTS (items),
                        .points = points,
                        .n_points = G_N_ELEMENTS (points),
                        .stock = { .edition = 1,
                                   .n_items = G_N_ELEMENTS (items),
                                   .n_points = G_N_ELEMENTS (points) } };
  const Projection projection = project (FALSE);
  const SquareGrid grid = square_grid_of (SIDE, SIDE, 1, SQUARE);
  const Theme *theme = theme_get (THEME_LIGHT);
  Sequence sequence;
  Squares changed;

  for (guint i = 0; i < G_N_ELEMENTS (items); i++)
    items[i] = (SceneItem){ .shape = SHAPE_PATH,
                            .role = ROLE_DELAUNAY_EDGE,
                            .emphasis = EMPHASIS_NORMAL,
                            .n = 2,
                            .beside = { INDEX_NONE, INDEX_NONE } };
  sequence_init (&sequence, FALSE);
  squares_init (&changed, &grid);
  drawing_set_stock (sequence.before, &scene, &projection, theme);
  g_assert_true (drawing_set_stock_again (sequence.now, sequence.before, &scene,
                                          &projection, theme, &changed));
  check_same (sequence.now, sequence.before);
  g_assert_cmpuint (sequence.now->n_strokes, ==, 3);
  for (int i = 0; i < grid.columns * grid.rows; i++)
    g_assert_false (changed.is_marked[i]);
  squares_clear (&changed);
  sequence_clear (&sequence);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/drawing-again/steps-are-those-drawn-anew", test_steps);
  g_test_add_func ("/drawing-again/so-is-a-site-that-is-dragged", test_drag);
  g_test_add_func ("/drawing-again/items-that-look-the-same-stay-as-many",
                   test_twins);
  return g_test_run ();
}
