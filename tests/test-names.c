/* Names in whole pictures: each stands well, and stays where it does while
 * something moves. */
#include "names-judge.h"

#include <math.h>

/* Windows of 1024 × 768, also at twice the dots, and 1920 × 1080 share their
 * width with panels; a view can have it all. */
static const double sizes[][2] = { { 345, 560 }, { 560, 860 }, { 1000, 700 } };

/* Of more sites some have to have a name where no leader passes clear. */
#define FEW_SITES 25

/* Returns: how many names there are in all themes, sizes and both views. */
static guint
judge_frame (const Fixture *fixture, const Frame *frame, Object selection)
{
  guint n_names = 0;
  Camera camera;

  camera_init (&camera, CAMERA_HOME);
  for (guint i = 0; i < N_THEMES * G_N_ELEMENTS (sizes) * 2; i++) {
    const double *size = sizes[i / 2 % G_N_ELEMENTS (sizes)];
    const Moment moment = { .frame = frame,
                            .is_space = i % 2 == 1,
                            .theme = (ThemeKind)(i / 6),
                            .width = size[0],
                            .height = size[1],
                            .selection = selection };
    g_autofree char *what = g_strdup_printf (
        "%s, step %u, %s, %g × %g px, %s", fixture->name, frame->step,
        theme_get (moment.theme)->name, moment.width, moment.height,
        moment.is_space ? "space" : "plane");
    Shown shown;

    shown_init (&shown);
    show (&shown, &moment, &camera);
    n_names += names_judge (&shown, what);
    if (frame->n_sites <= FEW_SITES)
      names_judge_leaders (&shown, what);
    names_check_none_is_missing (&shown, what);
    shown_clear (&shown);
  }
  return n_names;
}

/* Returns: how many names there are at four steps. */
static guint
judge_steps (guint32 seed, guint n_sites)
{
  g_autoptr (Fixture) fixture
      = fixture_new (FAMILY_RANDOM, seed, n_sites, ORDER_FURTHEST);
  const uint32_t n_events = fixture->trace->n_events;
  guint n_names = 0;

  for (uint32_t i = 0; i < 4; i++) {
    const Object selection = { i == 1 ? OBJECT_SITE : OBJECT_NONE, 5 };
    Frame frame;

    frame_init (&frame, fixture->trace, n_events - i * n_events / 5);
    n_names += judge_frame (fixture, &frame, selection);
    frame_clear (&frame);
  }
  return n_names;
}

/* Of few sites nearly all have names, of many those for whom there is room. */
static void
test_names_stand_well (void)
{
  const guint n_pictures = 4 * N_THEMES * G_N_ELEMENTS (sizes) * 2;

  g_assert_cmpuint (judge_steps (7, 12), >, n_pictures * 11);
  g_assert_cmpuint (judge_steps (7, 25), >, n_pictures * 18);
  g_assert_cmpuint (judge_steps (7, 60), >, n_pictures * 12);
  g_assert_cmpuint (judge_steps (7, 100), >, n_pictures * 8);
}

/* Sets where a heavy line all but ends between a name and its dot. */
static void
test_names_are_not_cut_off (void)
{
  static const guint32 seeds[] = { 31, 32, 38 };

  for (guint i = 0; i < G_N_ELEMENTS (seeds); i++)
    judge_steps (seeds[i], 12);
}

/* What moves */

/* Where a name stood in the picture before, and what it covered when it came
 * there. */
typedef struct Stand {
  gboolean is_there;
  Pixel off; /* from its dot */
  double covered;
} Stand;

#define N_MOVING 25

typedef struct Stands {
  Stand names[N_MOVING];
  guint n_hops;
} Stands;

/* Between names, side by side, px. */
#define APART 10.0

/* A name has left its place: there it would have stood no more, or would cover
 * more than it did. */
static void
judge_hop (const Shown *shown, uint32_t name, const Stand *stand, Pixel at)
{
  const SceneItem *item
      = &shown->scene.items[shown->drawing->placed[name].item];
  const PixelBox now = names_letters_of (&shown->drawing->placed[name]);
  const PixelBox then
      = { (float)(at.x + stand->off.x), (float)(at.y + stand->off.y),
          (float)(at.x + stand->off.x) + now.right - now.left,
          (float)(at.y + stand->off.y) + now.bottom - now.top };
  const float aside = (float)APART, above = (float)(APART / 2);
  const PixelBox wide = { then.left - aside, then.top - above,
                          then.right + aside, then.bottom + above };

  if (names_fault_of (shown, name, &then, MUCH_NEARER) == NULL
      && names_is_apart (shown->drawing, name, &wide)
      && names_ink_under (shown, &then) < stand->covered + 20)
    g_error ("%s has left a place where it stood well; covers %g, %g then",
             item->label, names_ink_under (shown, &then), stand->covered);
}

/* Compares where names stand with the picture before. */
static void
follow (const Shown *shown, Stands *stands, gboolean is_judged)
{
  const Stands before = *stands;

  for (guint i = 0; i < N_MOVING; i++)
    stands->names[i].is_there = FALSE;
  for (uint32_t i = 0; i < shown->drawing->n_placed; i++) {
    const PlacedName *placed = &shown->drawing->placed[i];
    const SceneItem *item = &shown->scene.items[placed->item];
    const PixelBox box = names_letters_of (placed);
    const Pixel at = names_pixel_of (shown, item);
    const Pixel off = { box.left - at.x, box.top - at.y };
    const Stand *last = &before.names[item->object.number];
    Stand *stand = &stands->names[item->object.number];
    const gboolean stays
        = last->is_there
          && hypot (off.x - last->off.x, off.y - last->off.y) < 3;

    *stand = (Stand){ TRUE, off, last->covered };
    if (!stays)
      stand->covered = names_ink_under (shown, &box);
    stands->n_hops += last->is_there && !stays;
    if (last->is_there && !stays && is_judged)
      judge_hop (shown, i, last, at);
  }
}

/* A moment of a site that goes along a circle, while space is turned. */
static void
show_moving (Shown *shown, gboolean is_space, guint i)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (3);
  const Order order = { ORDER_FURTHEST, 0 };
  Site sites[N_MOVING];
  SiteSet *set;
  Trace *trace;
  Frame frame;
  Camera camera;

  for (guint k = 0; k < N_MOVING; k++)
    sites[k] = (Site){ g_rand_double_range (rand, -1, 1),
                       g_rand_double_range (rand, -1, 1) };
  sites[3] = (Site){ 0.3 * cos (0.02 * i), 0.3 * sin (0.02 * i) };
  camera_init (&camera, CAMERA_HOME);
  camera_stand (&camera, 0.4 * i, 25);
  set = site_set_new (sites, N_MOVING);
  trace = trace_record (set, &order);
  frame_init (&frame, trace, trace->n_events);
  show (
      shown,
      &(Moment){
          .frame = &frame, .is_space = is_space, .width = 560, .height = 560 },
      &camera);
  frame_clear (&frame);
  trace_free (trace);
  site_set_free (set);
}

/* Returns: how often names hop from one picture to the next; each of a new view
 *          or all of one. */
static guint
count_hops (gboolean is_space, gboolean is_one_view)
{
  Stands stands = { .n_hops = 0 };
  Shown shown;

  shown_init (&shown);
  for (guint i = 0; i < 90; i++) {
    if (!is_one_view) {
      shown_clear (&shown);
      shown_init (&shown);
    }
    show_moving (&shown, is_space, i);
    names_judge (&shown, "moving");
    follow (&shown, &stands, is_one_view);
  }
  shown_clear (&shown);
  return stands.n_hops;
}

/* While something moves, a name leaves its place only when it does not stand
 * well there any more. */
static void
test_names_stay (void)
{
  for (int is_space = 0; is_space < 2; is_space++) {
    const guint n_anew = count_hops (is_space, FALSE);
    const guint n_hops = count_hops (is_space, TRUE);

    g_test_message ("%u hops; %u if each picture were the first", n_hops,
                    n_anew);
    g_assert_cmpuint (2 * n_hops, <, n_anew);
  }
}

/* The same step is the same picture, whichever way one came. */
static void
test_same_step (void)
{
  g_autoptr (Fixture) fixture
      = fixture_new (FAMILY_RANDOM, 7, 12, ORDER_FURTHEST);
  const uint32_t n_events = fixture->trace->n_events;
  Shown there, back;
  Camera camera;

  camera_init (&camera, CAMERA_HOME);
  shown_init (&there);
  shown_init (&back);
  for (uint32_t i = 0; i < 2 * n_events; i += 3) {
    Frame frame;

    frame_init (&frame, fixture->trace, i < n_events ? i : 2 * n_events - i);
    show (&back,
          &(Moment){
              .frame = &frame, .is_space = TRUE, .width = 345, .height = 560 },
          &camera);
    shown_clear (&there);
    shown_init (&there);
    show (&there,
          &(Moment){
              .frame = &frame, .is_space = TRUE, .width = 345, .height = 560 },
          &camera);
    g_assert_cmpuint (there.drawing->n_placed, ==, back.drawing->n_placed);
    for (uint32_t k = 0; k < there.drawing->n_placed; k++)
      g_assert_cmpmem (&there.drawing->placed[k].at, sizeof (Pixel),
                       &back.drawing->placed[k].at, sizeof (Pixel));
    frame_clear (&frame);
  }
  shown_clear (&there);
  shown_clear (&back);
}

/* Returns: how many lines of a gap there are. */
static guint
check_gaps (const Shown *shown)
{
  const Drawing *drawing = shown->drawing;
  guint n_gaps = 0;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const uint32_t item = stroke->place.item;

    if (stroke->kind != STROKE_LINE || item == INDEX_NONE
        || shown->scene.items[item].role != ROLE_GAP)
      continue;
    n_gaps++;
    for (uint32_t k = 0; k < drawing->n_placed; k++) {
      const PixelBox box = names_letters_of (&drawing->placed[k]);
      Pixel ends[2] = { drawing->pixels[stroke->first],
                        drawing->pixels[stroke->first + stroke->n - 1] };

      if (names_is_of_site (&shown->scene.items[drawing->placed[k].item]))
        g_assert_false (clip_to_rectangle ((Pixel){ box.left, box.top },
                                           (Pixel){ box.right, box.bottom },
                                           ends));
    }
  }
  return n_gaps;
}

/* A gap that is measured is not covered by a name: those that lie there get out
 * of the way. */
static void
test_gap_is_free (void)
{
  g_autoptr (Fixture) fixture
      = fixture_new (FAMILY_RANDOM, 7, 12, ORDER_FURTHEST);
  guint n_gaps = 0, n_names = 0, n_before = 0;
  Frame frame;
  Camera camera;

  camera_init (&camera, CAMERA_HOME);
  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  for (uint32_t i = 0; i < 12 * 2; i++) {
    Moment moment = {
      .frame = &frame, .is_space = i % 2 == 1, .width = 345, .height = 560
    };
    Shown shown;

    moment.selection
        = (Object){ OBJECT_FACET, fixture->trace->n_facets - 1 - i % 3 };
    shown_init (&shown);
    show (&shown, &moment, &camera);
    n_before += names_judge (&shown, "selected");
    moment.measured = (Object){ OBJECT_SITE, i / 2 };
    show (&shown, &moment, &camera);
    n_names += names_judge (&shown, "measured");
    n_gaps += check_gaps (&shown);
    shown_clear (&shown);
  }
  g_assert_cmpuint (n_gaps, >, 12);
  g_assert_cmpuint (n_names + 2, >=, n_before);
  g_test_message ("%u names, %u before", n_names, n_before);
  frame_clear (&frame);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/names/each-stands-well", test_names_stand_well);
  g_test_add_func ("/names/none-is-cut-off", test_names_are_not_cut_off);
  g_test_add_func ("/names/one-stays-where-it-stands-well-while-things-move",
                   test_names_stay);
  g_test_add_func ("/names/a-step-is-the-same-whichever-way-one-came",
                   test_same_step);
  g_test_add_func ("/names/none-covers-a-gap-that-is-measured",
                   test_gap_is_free);
  return g_test_run ();
}
