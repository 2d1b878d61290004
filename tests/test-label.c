/* Names: beside what they name, and on nothing else. */
#include "drawing.h"
#include "fixture.h"
#include "label.h"
#include "picture.h"

#include <glib.h>
#include <math.h>

static gboolean
overlap (const Label *a, const Label *b)
{
  return a->low.x < b->low.x + b->width && b->low.x < a->low.x + a->width
         && a->low.y < b->low.y + b->height && b->low.y < a->low.y + a->height;
}

static gboolean
covers_mark (const Label *label, Pixel at, double reach)
{
  const double x = CLAMP (at.x, label->low.x, label->low.x + label->width);
  const double y = CLAMP (at.y, label->low.y, label->low.y + label->height);

  return hypot (at.x - x, at.y - y) < reach - 2;
}

static LabelSheet *
sheet_new (float width, float height)
{
  return label_sheet_new (&(PixelBox){ 0, 0, width, height });
}

/* Where there is room, names sit on no mark, on no other name, within the
 * view. */
static void
test_labels (void)
{
  enum { N = 30 };
  g_autoptr (GRand) rand = g_rand_new_with_seed (5);
  LabelSheet *sheet = sheet_new (600, 600);
  Label labels[N] = { 0 };
  int i, k;

  for (i = 0; i < N; i++) {
    labels[i] = (Label){ .need = LABEL_PLAIN,
                         .place = { .slot = LABEL_NOWHERE },
                         .at = { 10 + g_rand_double (rand) * 580,
                                 10 + g_rand_double (rand) * 580 },
                         .radius = 7,
                         .reach = 7,
                         .width = 24,
                         .height = 14 };
    label_sheet_mark (sheet, labels[i].at, 7, 7, TRUE);
  }
  label_sheet_place (sheet, labels, N);
  for (i = 0; i < N; i++) {
    g_assert_true (labels[i].is_settled);
    g_assert_true (labels[i].low.x >= 0 && labels[i].low.x + 24 <= 600
                   && labels[i].low.y >= 0 && labels[i].low.y + 14 <= 600);
    for (k = 0; k < N; k++) {
      g_assert_false (covers_mark (&labels[i], labels[k].at, 7));
      g_assert_false (i != k && overlap (&labels[i], &labels[k]));
    }
  }
  label_sheet_free (sheet);
}

/* A name keeps off a line that runs through its favourite place. */
static void
test_labels_avoid_lines (void)
{
  LabelSheet *sheet = sheet_new (200, 200);
  Label label = { .need = LABEL_PLAIN,
                  .place = { .slot = LABEL_NOWHERE },
                  .at = { 100, 100 },
                  .radius = 7,
                  .reach = 7,
                  .width = 24,
                  .height = 14 };
  const Pixel right_up[2] = { { 100, 100 }, { 200, 0 } };
  int i;

  label_sheet_line (sheet, right_up, 3, LABEL_LINE_HEAVY);
  label_sheet_place (sheet, &label, 1);
  g_assert_true (label.is_settled);
  for (i = 0; i <= 100; i++) {
    const double x = 100 + i, y = 100 - i;

    g_assert_false (x > label.low.x && x < label.low.x + 24 && y > label.low.y
                    && y < label.low.y + 14);
  }
  label_sheet_free (sheet);
}

/* A name in the middle of a heavy line lies beside all its width. */
static void
test_labels_avoid_heavy_lines (void)
{
  LabelSheet *sheet = sheet_new (200, 200);
  const Pixel upright[2] = { { 100, 0 }, { 100, 200 } };
  Label label = { .need = LABEL_PLAIN,
                  .place = { .slot = LABEL_NOWHERE },
                  .at = { 100, 100 },
                  .width = 20,
                  .height = 14,
                  .is_centred = true };

  label_sheet_line (sheet, upright, 9, LABEL_LINE_HEAVY);
  label_sheet_place (sheet, &label, 1);
  g_assert_true (label.is_settled);
  g_assert_true (label.low.x + label.width <= 100 - 4.5
                 || label.low.x >= 100 + 4.5);
  label_sheet_free (sheet);
}

static double
gap_to (const Label *label, Pixel at)
{
  const double x = CLAMP (at.x, label->low.x, label->low.x + label->width);
  const double y = CLAMP (at.y, label->low.y, label->low.y + label->height);

  return hypot (at.x - x, at.y - y);
}

/* Places the names of two marks with thin lines all round them. */
static void
place_pair (GRand *rand, Label labels[2])
{
  LabelSheet *sheet = sheet_new (200, 200);
  int i;

  for (i = 0; i < 2; i++) {
    labels[i]
        = (Label){ .need = LABEL_PLAIN,
                   .place = { .slot = LABEL_NOWHERE },
                   .at = { g_rand_double_range (rand, 95, 105), 90 + 20 * i },
                   .radius = 7,
                   .reach = 7,
                   .width = 24,
                   .height = 14 };
    label_sheet_mark (sheet, labels[i].at, 7, 7, TRUE);
  }
  for (i = 0; i < 6; i++) {
    const Pixel line[2] = { { 0, g_rand_double_range (rand, 0, 200) },
                            { 200, g_rand_double_range (rand, 0, 200) } };

    label_sheet_line (sheet, line, 1.3, LABEL_LINE_LIGHT);
  }
  label_sheet_place (sheet, labels, 2);
  label_sheet_free (sheet);
}

/* A name crosses a thin line rather than to stand beside the mark of another,
 * whose it would seem to be. */
static void
test_names_are_nearest_to_their_own (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (7);
  Label labels[2];
  int i, k;

  for (i = 0; i < 100; i++) {
    place_pair (rand, labels);
    for (k = 0; k < 2; k++)
      g_assert_cmpfloat (gap_to (&labels[k], labels[k].at), <,
                         gap_to (&labels[k], labels[1 - k].at));
  }
}

/* A line that is hardly seen does not drive a name away. */
static void
test_names_lie_over_pale_lines (void)
{
  LabelSheet *sheet = sheet_new (200, 200);
  Label label = { .need = LABEL_PLAIN,
                  .place = { .slot = LABEL_NOWHERE },
                  .at = { 100, 100 },
                  .radius = 7,
                  .reach = 7,
                  .width = 24,
                  .height = 14 };
  int i;

  for (i = 0; i < 200; i += 14) {
    const Pixel level[2] = { { 0, i }, { 200, i } };

    label_sheet_line (sheet, level, 0.4, LABEL_LINE_LIGHT);
  }
  label_sheet_place (sheet, &label, 1);
  g_assert_cmpfloat (gap_to (&label, label.at), <, 7 + 5);
  label_sheet_free (sheet);
}

/* A plane of so many sites, of which the first are selected, drawn. */
typedef struct Crowd {
  Family family;
  guint n_sites, n_selected;
  ThemeKind theme;
  double width, height, zoom;
} Crowd;

typedef struct Drawn {
  guint n_names;
  double size; /* of marks */
} Drawn;

static void
draw_frame (const Crowd *crowd, const Frame *frame, Drawing *drawing)
{
  g_autofree uint32_t *selected = g_new (uint32_t, crowd->n_selected + 1);
  Picture picture;
  Projection projection;
  Scene scene = { .items = NULL };

  picture_init (&picture, PICTURE_PLANE, frame);
  picture.plane_camera.zoom = crowd->zoom;
  projection = plane_camera_projection (&picture.plane_camera, crowd->width,
                                        crowd->height);
  scene_look_fit (&picture.look, &projection, 0);
  for (guint i = 0; i < crowd->n_selected; i++)
    selected[i] = i;
  picture.look.selected = selected;
  picture.look.n_selected = crowd->n_selected;
  scene_plane (&scene, frame, &picture.look);
  drawing_set (drawing, &scene, &projection, theme_get (crowd->theme));
  scene_clear (&scene);
}

static Drawn
draw_crowd (const Crowd *crowd)
{
  g_autoptr (Fixture) fixture
      = fixture_new (crowd->family, 1, crowd->n_sites, ORDER_FURTHEST);
  Names *names = names_new ();
  Drawing *drawing = drawing_new (names);
  Frame frame;
  Drawn drawn;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  draw_frame (crowd, &frame, drawing);
  drawn = (Drawn){ drawing->n_placed, drawing->size };
  drawing_free (drawing);
  names_free (names);
  frame_clear (&frame);
  return drawn;
}

/* Returns: how many names a plane with a side of 300 px has. */
static guint
count_names (Family family, guint n_sites, guint n_selected)
{
  return draw_crowd (
             &(Crowd){ family, n_sites, n_selected, THEME_DARK, 300, 300, 1 })
      .n_names;
}

/* Returns: how large marks are of sixty sites in a plane of this height and a
 *          width of 350 px. */
static double
size_of_marks (ThemeKind theme, double height, double zoom)
{
  return draw_crowd (&(Crowd){ FAMILY_RANDOM, 60, 0, theme, 350, height, zoom })
      .size;
}

/* What counts is how near sites are: not the shape of the view, and less where
 * one looks closely. The larger marks of the last row need more room. */
static void
test_marks_shrink (void)
{
  const double light = size_of_marks (THEME_LIGHT, 350, 1);
  const double projector = size_of_marks (THEME_PROJECTOR, 350, 1);
  const double higher = size_of_marks (THEME_PROJECTOR, 600, 1);
  const double nearer = size_of_marks (THEME_PROJECTOR, 350, 3);

  g_assert_cmpfloat (projector, <, light);
  g_assert_cmpfloat (projector, <, 0.8);
  g_assert_cmpfloat (higher, ==, projector);
  g_assert_cmpfloat (nearer, ==, 1);
}

/* Names do not hide what they name. */
static void
test_names_need_room (void)
{
  const guint few = count_names (FAMILY_RANDOM, 12, 0);
  const guint crowd = count_names (FAMILY_RANDOM, 150, 0);

  g_assert_cmpuint (few, ==, 12);
  g_assert_cmpuint (crowd, ==, 0);
}

/* The important are never left out, the others are where there is no room. */
static void
test_labels_are_left_out (void)
{
  enum { N = 60 };
  LabelSheet *sheet = sheet_new (80, 80);
  Label labels[N];
  int i, n_placed = 0;

  for (i = 0; i < N; i++) {
    const int row = i / 8;

    labels[i] = (Label){ .place = { .slot = LABEL_NOWHERE },
                         .at = { 40 + i % 8, 40 + row },
                         .radius = 5,
                         .reach = 5,
                         .width = 24,
                         .height = 14,
                         .need = i == N - 1 ? LABEL_MUST : LABEL_PLAIN };
    label_sheet_mark (sheet, labels[i].at, 5, 5, TRUE);
  }
  label_sheet_place (sheet, labels, N);
  for (i = 0; i < N; i++)
    n_placed += labels[i].is_settled;
  g_assert_true (labels[N - 1].is_settled);
  g_assert_cmpint (n_placed, <, N);
  label_sheet_free (sheet);
}

/* They would be all that is seen, and each is placed against all others. */
static void
test_many_that_are_selected_have_no_names (void)
{
  const guint few = count_names (FAMILY_RANDOM, 300, 20);
  const guint all = count_names (FAMILY_RANDOM, 300, 300);

  g_assert_cmpuint (few, >=, 20);
  g_assert_cmpuint (all, ==, 0);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/label/names-sit-on-no-mark-and-no-name", test_labels);
  g_test_add_func ("/label/names-keep-off-lines", test_labels_avoid_lines);
  g_test_add_func ("/label/names-keep-off-the-width-of-heavy-lines",
                   test_labels_avoid_heavy_lines);
  g_test_add_func ("/label/names-are-nearest-to-their-own-marks",
                   test_names_are_nearest_to_their_own);
  g_test_add_func ("/label/names-stay-near-over-pale-lines",
                   test_names_lie_over_pale_lines);
  g_test_add_func ("/label/a-crowd-has-no-names", test_names_need_room);
  g_test_add_func ("/label/many-that-are-selected-have-no-names",
                   test_many_that_are_selected_have_no_names);
  g_test_add_func ("/label/marks-are-small-where-sites-are-near",
                   test_marks_shrink);
  g_test_add_func ("/label/only-the-unimportant-are-left-out",
                   test_labels_are_left_out);
  return g_test_run ();
}
