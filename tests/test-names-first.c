/* Names of what is spoken of: corners, facets, answers; and of more sets. */
#include "names-judge.h"

#include <math.h>

/* Windows of 1024 × 768, also at twice the dots, and 1920 × 1080 share their
 * width with panels; a view can have it all. */
static const double sizes[][2] = { { 345, 560 }, { 560, 860 }, { 1000, 700 } };

/* Shows a moment in some themes and sizes, both views. */
typedef void (*Judge) (const Shown *shown, const Moment *moment, gpointer user);

static void
for_each_picture (const Moment *what, Judge judge, gpointer user)
{
  static const ThemeKind themes[]
      = { THEME_LIGHT, THEME_PROJECTOR, THEME_CONTRAST };
  Camera camera;

  camera_init (&camera, CAMERA_HOME);
  for (guint i = 0; i < G_N_ELEMENTS (themes) * G_N_ELEMENTS (sizes) * 2; i++) {
    Moment moment = *what;
    Shown shown;

    moment.is_space = i % 2 == 1;
    moment.width = sizes[i / 2 % G_N_ELEMENTS (sizes)][0];
    moment.height = sizes[i / 2 % G_N_ELEMENTS (sizes)][1];
    moment.theme = themes[i / 6];
    shown_init (&shown);
    show (&shown, &moment, &camera);
    judge (&shown, &moment, user);
    shown_clear (&shown);
  }
}

static char *
describe (const Fixture *fixture, const Moment *moment)
{
  return g_strdup_printf ("%s, step %u, f%u, %s, %g × %g px, %s", fixture->name,
                          moment->frame->step, moment->selection.number,
                          theme_get (moment->theme)->name, moment->width,
                          moment->height, moment->is_space ? "space" : "plane");
}

static void
judge_all (const Shown *shown, const Moment *moment, gpointer user)
{
  g_autofree char *what = describe (user, moment);

  names_judge (shown, what);
  names_judge_leaders (shown, what);
  names_check_none_is_missing (shown, what);
}

/* More sets, at more steps, in some themes; a site is selected at half of
 * them. */
static void
test_more_sets (void)
{
  for (guint seed = 40; seed < 40 + 6; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 12, ORDER_FURTHEST);

    for (uint32_t step = 0; step < fixture->trace->n_events; step += 12) {
      const Object selection
          = { step % 24 == 0 ? OBJECT_SITE : OBJECT_NONE, 5 };
      Frame frame;

      frame_init (&frame, fixture->trace, step);
      for_each_picture (&(Moment){ .frame = &frame, .selection = selection },
                        judge_all, fixture);
      frame_clear (&frame);
    }
  }
}

/* How many corners there are to name, and how many are not. */
typedef struct Corners {
  const Fixture *fixture;
  guint n, n_nameless;
} Corners;

static void
count_corners (const Shown *shown, uint32_t facet, Corners *corners)
{
  corners->n += 3;
  corners->n_nameless += names_count_nameless (
      shown, corners->fixture->trace->facets[facet].site);
}

/* Among lines and dots on all sides there may be no place. */
static void
check_corners (const Corners *corners)
{
  g_test_message ("%u of %u corners have no name", corners->n_nameless,
                  corners->n);
  g_assert_cmpuint (corners->n, >, 500);
  g_assert_cmpuint (200 * corners->n_nameless, <, corners->n);
}

static void
judge_selected (const Shown *shown, const Moment *moment, gpointer corners)
{
  count_corners (shown, moment->selection.number, corners);
}

/* Whatever is selected, a person is told of its corners. */
static void
test_corners_have_names (void)
{
  Corners corners = { .n = 0 };

  for (guint seed = 7; seed < 7 + 3; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 12, ORDER_FURTHEST);
    Frame frame;

    corners.fixture = fixture;
    frame_init (&frame, fixture->trace, fixture->trace->n_events);
    for (uint32_t i = 0; i < frame.n_facets; i += 4)
      for_each_picture (
          &(Moment){ .frame = &frame,
                     .selection = { OBJECT_FACET, frame.facets[i].facet } },
          judge_selected, &corners);
    frame_clear (&frame);
  }
  check_corners (&corners);
}

static void
judge_cone (const Shown *shown, const Moment *moment, gpointer corners)
{
  const Frame *frame = moment->frame;

  for (uint32_t i = 0; i < frame->n_facets; i++)
    if (frame->facets[i].roles & FACET_CONE)
      count_corners (shown, frame->facets[i].facet, corners);
}

/* While the cone grows, its corners are what is spoken of. */
static void
test_cones_have_names (void)
{
  Corners corners = { .n = 0 };

  for (guint seed = 7; seed < 7 + 3; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 12, ORDER_FURTHEST);

    corners.fixture = fixture;
    for (guint round = 1; round <= 5; round += 2) {
      Frame frame;
      uint32_t step;

      g_assert_true (timeline_find (
          fixture->trace, (Place){ round, PHASE_CONE }, FALSE, &step));
      frame_init (&frame, fixture->trace, step);
      for_each_picture (&(Moment){ .frame = &frame }, judge_cone, &corners);
      frame_clear (&frame);
    }
  }
  check_corners (&corners);
}

static void
judge_answers (const Shown *shown, const Moment *moment, gpointer user)
{
  g_autofree char *what = describe (user, moment);

  names_judge_leaders (shown, what);
  if (!moment->is_space)
    g_assert_cmpuint (names_judge_answers (shown, user, what), <=, 1);
}

/* The largest triangle of the first rounds, answered while sites wait in it. */
static uint32_t
largest (const Frame *frame)
{
  double most = 0;
  uint32_t largest = 0;

  for (uint32_t i = 0; i < frame->delaunay.n_triangles; i++) {
    const uint32_t *site = frame->delaunay.triangles[i].site;
    const Site *sites = frame->trace->set->sites;
    const Site a = sites[site[0]], b = sites[site[1]], c = sites[site[2]];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

    if (area > most) {
      most = area;
      largest = frame->delaunay.triangles[i].facet;
    }
  }
  return largest;
}

static void
test_answers_stand_alone (void)
{
  for (guint seed = 1; seed < 1 + 8; seed++) {
    g_autoptr (Fixture) fixture
        = fixture_new (FAMILY_RANDOM, seed, 8, ORDER_FURTHEST);
    Frame frame;
    uint32_t step;

    g_assert_true (
        timeline_find (fixture->trace, (Place){ 1, PHASE_SEE }, FALSE, &step));
    frame_init (&frame, fixture->trace, step);
    for_each_picture (
        &(Moment){ .frame = &frame,
                   .answers
                   = &(SceneAnswer){ { OBJECT_FACET, largest (&frame) },
                                     ANSWER_RIGHT,
                                     0 },
                   .n_answers = 1 },
        judge_answers, fixture);
    frame_clear (&frame);
  }
}

/* A long triangle with a corner close to its middle: its name begins away from
 * there, inside it. */
static void
test_blunt_triangle (void)
{
  const Site sites[] = {
    { -0.5, -0.4 }, { 0.06, -0.13 }, { 0.5, 0.25 }, { 0.9, -0.9 }, { 0.7, 0.9 }
  };
  const Order order = { ORDER_INPUT, 0 };
  SiteSet *set = site_set_new (sites, G_N_ELEMENTS (sites));
  Trace *trace = trace_record (set, &order);
  Camera camera;
  Frame frame;
  Shown shown;
  guint n_names = 0;

  camera_init (&camera, CAMERA_HOME);
  frame_init (&frame, trace, trace->n_events);
  for (uint32_t i = 0; i < frame.delaunay.n_triangles; i++) {
    const Triangle *triangle = &frame.delaunay.triangles[i];

    shown_init (&shown);
    show (&shown,
          &(Moment){ .frame = &frame,
                     .width = 345,
                     .height = 560,
                     .selection = { OBJECT_FACET, triangle->facet } },
          &camera);
    n_names += names_judge_middles (&shown);
    shown_clear (&shown);
  }
  g_assert_cmpuint (n_names, >=, 3);
  frame_clear (&frame);
  trace_free (trace);
  site_set_free (set);
}

static gboolean
is_named (const Scene *scene, uint32_t facet)
{
  for (uint32_t i = 0; i < scene->n_items; i++)
    if (scene->items[i].role == ROLE_FACET_NAME
        && scene->items[i].object.number == facet)
      return TRUE;
  return FALSE;
}

static void
judge_beyond (const Shown *shown, const Moment *moment, gpointer fixture)
{
  const Trace *trace = ((const Fixture *)fixture)->trace;
  const uint32_t facet = trace_event (trace, moment->frame->step - 1).facet;
  const gboolean is_lower = trace->facets[facet].facing == FACING_LOWER;

  g_assert_true (is_named (&shown->scene, facet)
                 == (moment->is_space ? !is_lower : is_lower));
  judge_all (shown, moment, fixture);
}

/* A sentence tells which facet is beyond the horizon: it has its name where it
 * is not seen through others. */
static void
test_beyond_has_name (void)
{
  g_autoptr (Fixture) fixture
      = fixture_new (FAMILY_RANDOM, 7, 8, ORDER_FURTHEST);
  guint n_judged = 0;

  for (uint32_t step = 1; step <= fixture->trace->n_events; step++) {
    Frame frame;

    if (trace_event (fixture->trace, step - 1).kind != EVENT_HORIZON)
      continue;
    frame_init (&frame, fixture->trace, step);
    for_each_picture (&(Moment){ .frame = &frame }, judge_beyond, fixture);
    frame_clear (&frame);
    n_judged++;
  }
  g_assert_cmpuint (n_judged, >, 10);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/names/each-stands-well-at-any-step", test_more_sets);
  g_test_add_func ("/names/corners-of-what-is-selected-have-names",
                   test_corners_have_names);
  g_test_add_func ("/names/corners-of-a-cone-have-names",
                   test_cones_have_names);
  g_test_add_func ("/names/that-of-an-answer-stands-alone",
                   test_answers_stand_alone);
  g_test_add_func ("/names/no-facet-is-named-where-a-corner-is",
                   test_blunt_triangle);
  g_test_add_func ("/names/what-is-beyond-the-horizon-has-its-name",
                   test_beyond_has_name);
  return g_test_run ();
}
