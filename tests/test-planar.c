#include "fixture.h"
#include "judge.h"
#include "planar-frame.h"

#include <stdlib.h>
#include <string.h>

#define N_SEEDS 12
#define N_SITES 24

/* A trace with its judge. */
typedef struct Planar {
  const SiteSet *set;
  PlanarTrace *trace;
  Judge *judge;
} Planar;

static Planar
planar_new (const SiteSet *set)
{
  return (Planar){ set, planar_trace_record (set), judge_new (set) };
}

static void
planar_clear (Planar *planar)
{
  planar_trace_free (planar->trace);
  judge_free (planar->judge);
}

/* The sites that are on the hull or ignored as inside at @step. */
static uint32_t
list_decided (const PlanarFrame *frame, uint32_t *sites)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < frame->n_sites; i++)
    if (frame->sites[i].state == SITE_INSERTED
        || frame->sites[i].state == SITE_IGNORED
        || (frame->sites[i].state == SITE_APEX && frame->step == frame->base))
      sites[n++] = i;
  return n;
}

static bool
has_site (const uint32_t *sites, uint32_t n, uint32_t site)
{
  for (uint32_t i = 0; i < n; i++)
    if (sites[i] == site)
      return true;
  return false;
}

/* The hull shown is that of the sites decided so far. */
static void
check_hull (const Planar *planar, const PlanarFrame *frame)
{
  g_autofree uint32_t *decided = g_new (uint32_t, frame->n_sites + 1);
  g_autofree uint32_t *corners = g_new (uint32_t, frame->n_sites + 2);
  const uint32_t n_decided = list_decided (frame, decided);
  const uint32_t n = judge_hull (planar->judge, decided, n_decided, corners);

  g_assert_cmpuint (frame->n_corners, ==, n);
  g_assert_cmpuint (frame->counts.corners, ==, n);
  for (uint32_t i = 0; i < n; i++)
    g_assert_true (has_site (corners, n, frame->corners[i]));
  for (uint32_t i = 0; n >= 3 && i < n; i++)
    g_assert_cmpint (judge_orient (planar->judge, frame->corners[i],
                                   frame->corners[(i + 1) % n],
                                   frame->corners[(i + 2) % n]),
                     ==, 1);
}

/* A site is ignored only when it is no corner of the hull of all sites. */
static void
check_end (const Planar *planar)
{
  const PlanarTrace *trace = planar->trace;
  PlanarFrame frame;

  planar_frame_init (&frame, trace, trace->n_events);
  check_hull (planar, &frame);
  g_assert_cmpuint (frame.counts.waiting, ==, 0);
  g_assert_cmpuint (frame.counts.corners + frame.counts.inside, ==,
                    planar->set->n_distinct);
  planar_frame_clear (&frame);
}

static void
check_every_hull (const Fixture *fixture)
{
  Planar planar = planar_new (fixture->set);
  PlanarFrame frame;
  uint32_t step = planar.trace->start_end;

  for (; !planar.trace->is_flat;) {
    planar_frame_init (&frame, planar.trace, step);
    check_hull (&planar, &frame);
    planar_frame_clear (&frame);
    if (step == planar.trace->n_events)
      break;
    step = course_next (&planar.trace->course, step, GRAIN_ROUND);
  }
  check_end (&planar);
  planar_clear (&planar);
}

static void
test_every_round_ends_in_the_hull_of_the_sites_so_far (void)
{
  fixture_for_each (N_SEEDS, N_SITES, ORDER_FURTHEST, check_every_hull);
}

static bool
is_beyond (const Judge *judge, const uint32_t corner[2], uint32_t site)
{
  /* On the line: both ends lie on one side of the site. */
  return mpz_cmp (judge->x[site], judge->x[corner[0]])
                 * mpz_cmp (judge->x[site], judge->x[corner[1]])
             > 0
         || mpz_cmp (judge->y[site], judge->y[corner[0]])
                    * mpz_cmp (judge->y[site], judge->y[corner[1]])
                > 0;
}

static bool
judge_sees (const Judge *judge, const uint32_t corner[2], uint32_t site)
{
  const int turn = judge_orient (judge, corner[0], corner[1], site);

  return turn < 0 || (turn == 0 && is_beyond (judge, corner, site));
}

/* In every round the visible edges are exactly those that the definition says
 * the site sees, and the site is the furthest of its outside set. */
static void
check_round (const Planar *planar, uint32_t index)
{
  const PlanarTrace *trace = planar->trace;
  const PlanarRound *round = &trace->rounds[index];
  const uint32_t before = round->select - 1;

  for (uint32_t i = 0; i < trace->n_edges; i++) {
    const PlanarEdge *row = &trace->edges[i];

    if (span_has (row->span, before))
      g_assert_cmpint (row->seen <= round->end, ==,
                       judge_sees (planar->judge, row->corner, round->site));
  }
  for (uint32_t i = 0; i < trace->n_claims; i++) {
    const PlanarClaim *row = &trace->claims[i];
    int order;

    if (!span_has (row->span, before) || row->edge != round->edge
        || row->site == round->site)
      continue;
    /* To the right of an edge areas are negative. */
    order
        = judge_compare_areas (planar->judge, trace->edges[round->edge].corner,
                               round->site, row->site);
    g_assert_true (order < 0 || (order == 0 && round->site < row->site));
  }
}

static void
check_rounds (const Fixture *fixture)
{
  Planar planar = planar_new (fixture->set);

  for (uint32_t i = 0; i < planar.trace->n_rounds; i++)
    check_round (&planar, i);
  planar_clear (&planar);
}

static void
test_a_site_sees_what_the_definition_says_and_is_the_furthest (void)
{
  fixture_for_each (N_SEEDS, N_SITES, ORDER_FURTHEST, check_rounds);
}

/* At every step each distinct site is on the hull, inside, or waiting, and
 * what waits in an outside set sees its edge. */
static void
check_sites (const Fixture *fixture)
{
  Planar planar = planar_new (fixture->set);
  const PlanarTrace *trace = planar.trace;

  for (uint32_t i = 0; i < trace->n_claims; i++)
    g_assert_cmpint (
        judge_orient (planar.judge,
                      trace->edges[trace->claims[i].edge].corner[0],
                      trace->edges[trace->claims[i].edge].corner[1],
                      trace->claims[i].site),
        ==, -1);
  for (uint32_t step = trace->start_end; step <= trace->n_events; step++) {
    PlanarFrame frame;

    planar_frame_init (&frame, trace, step);
    if (frame.base == frame.step)
      g_assert_cmpuint (frame.counts.corners + frame.counts.inside
                            + frame.counts.waiting,
                        ==, fixture->set->n_distinct);
    planar_frame_clear (&frame);
  }
  planar_clear (&planar);
}

static void
test_every_site_is_a_corner_or_inside_or_waits (void)
{
  fixture_for_each (3, N_SITES, ORDER_FURTHEST, check_sites);
}

static SiteSet *
set_of (const double *coordinates, uint32_t n_sites)
{
  return site_set_new ((const Site *)coordinates, n_sites);
}

/* A triangle, one site inside, one on an edge, two beyond the lower edge, of
 * which the further buries a corner: worked out by hand. */
static void
test_small_set_goes_as_by_hand (void)
{
  const double coordinates[]
      = { 0, 0, 4, 0, 0, 4, 1, 1, 2, 2, 8, -2, 5, -1, 3, -0.5 };
  SiteSet *set = set_of (coordinates, 8);
  PlanarTrace *trace = planar_trace_record (set);
  char text[NARRATION_ROOM];

  /* e0 s0s1, e1 s1s2, e2 s2s0; s3 and s4 are inside. */
  g_assert_cmpuint (trace->start_end, ==, 8);
  g_assert_cmpuint (trace->inside_from[3], ==, 4);
  g_assert_cmpuint (trace->inside_from[4], ==, 5);
  /* s5 is the furthest from e0 and sees e0 and e1; s1 is buried. */
  g_assert_cmpuint (trace->n_rounds, ==, 1);
  g_assert_cmpuint (trace->rounds[0].site, ==, 5);
  g_assert_cmpuint (trace->edges[1].seen, ==, 11);
  g_assert_cmpuint (trace->inside_from[1], !=, STEP_NEVER);
  planar_narration_write (trace, trace->inside_from[1], NULL, text);
  g_assert_cmpstr (text, ==,
                   "s1 was a corner and lies inside now: it is ignored.");
  planar_narration_write (trace, trace->n_events, NULL, text);
  g_assert_cmpstr (text, ==,
                   "No outside set is left: the hull is complete, and it has "
                   "3 corners.");
  planar_trace_free (trace);
  site_set_free (set);
}

/* A site on the line of an edge beyond it takes the place of its corner. */
static void
test_collinear_corners_do_not_stay (void)
{
  const double coordinates[] = { 0, 0, 1, 0, 0, 1, 2, 0, 3, 0 };
  SiteSet *set = set_of (coordinates, 5);
  PlanarTrace *trace = planar_trace_record (set);
  PlanarFrame frame;

  planar_frame_init (&frame, trace, trace->n_events);
  g_assert_cmpuint (frame.n_corners, ==, 3);
  g_assert_true (has_site (frame.corners, 3, 4));
  g_assert_false (has_site (frame.corners, 3, 1));
  planar_frame_clear (&frame);
  planar_trace_free (trace);
  site_set_free (set);
}

static void
assert_flat (const double *coordinates,
             uint32_t n_sites,
             uint32_t n_corners,
             uint32_t n_inside)
{
  SiteSet *set = set_of (coordinates, n_sites);
  PlanarTrace *trace = planar_trace_record (set);
  PlanarFrame frame;

  g_assert_true (trace->is_flat);
  g_assert_cmpuint (trace->n_rounds, ==, 0);
  planar_frame_init (&frame, trace, trace->n_events);
  g_assert_cmpuint (frame.n_corners, ==, n_corners);
  g_assert_cmpuint (frame.counts.inside, ==, n_inside);
  planar_frame_clear (&frame);
  planar_trace_free (trace);
  site_set_free (set);
}

static void
test_few_and_collinear_sites_have_a_hull (void)
{
  const double line[] = { 1, 1, 3, 3, 0, 0, 2, 2, 3, 3 };

  assert_flat (line, 0, 0, 0);
  assert_flat (line, 1, 1, 0);
  assert_flat (line, 2, 2, 0);
  assert_flat (line, 5, 2, 2);
}

/* The course of the trace is one of rounds and phases in their order. */
static void
check_course (const Fixture *fixture)
{
  PlanarTrace *trace = planar_trace_record (fixture->set);
  const Course *course = &trace->course;
  uint32_t step = 0, n_rounds = 0;

  while (step < course->n_steps) {
    const uint32_t next = course_next (course, step, GRAIN_PHASE);

    g_assert_cmpuint (course_back (course, next, GRAIN_PHASE), ==, step);
    if (course_place (course, next).phase == PHASE_CHOOSE)
      n_rounds++;
    if (step > 0 && course_place (course, next).phase != PHASE_COMPLETE)
      g_assert_true (course_place (course, step).round
                         < course_place (course, next).round
                     || course_place (course, step).phase
                            < course_place (course, next).phase);
    step = next;
  }
  g_assert_cmpuint (n_rounds, ==, trace->n_rounds);
  planar_trace_free (trace);
}

static void
test_course_goes_through_all_phases_of_all_rounds (void)
{
  fixture_for_each (3, N_SITES, ORDER_FURTHEST, check_course);
}

static void
test_course_finds_places (void)
{
  const double coordinates[] = { 0, 0, 4, 0, 0, 4, 5, 5 };
  SiteSet *set = set_of (coordinates, 4);
  PlanarTrace *trace = planar_trace_record (set);
  const Course *course = &trace->course;
  uint32_t step;

  /* SIMPLEX×3 CLAIM SELECT VISIBLE HORIZON×2 CONE×2 RETIRE COMPLETE */
  g_assert_cmpuint (course->n_steps, ==, 12);
  g_assert_true (
      course_find (course, (Place){ 0, PHASE_SIMPLEX }, false, &step));
  g_assert_cmpuint (step, ==, 4);
  g_assert_true (
      course_find (course, (Place){ 1, PHASE_HORIZON }, false, &step));
  g_assert_cmpuint (step, ==, 8);
  g_assert_true (
      course_find (course, (Place){ 1, PHASE_HORIZON }, true, &step));
  g_assert_cmpuint (step, ==, 6);
  g_assert_true (
      course_find (course, (Place){ 0, PHASE_COMPLETE }, false, &step));
  g_assert_cmpuint (step, ==, 12);
  g_assert_false (course_find (course, (Place){ 2, PHASE_SEE }, false, &step));
  planar_trace_free (trace);
  site_set_free (set);
}

typedef void (*CheckScene) (const Scene *scene, const PlanarFrame *frame);

/* The scenes of all steps. */
static void
check_scenes (const Fixture *fixture, CheckScene check)
{
  PlanarTrace *trace = planar_trace_record (fixture->set);
  const SceneLook look = { .layers = LAYERS_DEFAULT,
                           .extent = site_set_extent (fixture->set),
                           .low = { -1, -1, 0 },
                           .high = { 1, 1, 0 } };
  Scene scene = { 0 };

  for (uint32_t step = 0; step <= trace->n_events; step++) {
    PlanarFrame frame;

    planar_frame_init (&frame, trace, step);
    scene_planar (&scene, &frame, &look);
    check (&scene, &frame);
    planar_frame_clear (&frame);
  }
  scene_clear (&scene);
  planar_trace_free (trace);
}

/* Every site has one mark, and every edge of the frame is drawn. */
static void
check_marks (const Scene *scene, const PlanarFrame *frame)
{
  uint32_t n_marks = 0, n_edges = 0;

  for (uint32_t i = 0; i < scene->n_items; i++) {
    const Role role = scene->items[i].role;

    n_marks += role >= ROLE_SITE && role <= ROLE_SITE_IGNORED;
    n_edges += role == ROLE_HULL_EDGE || role == ROLE_VISIBLE_EDGE
               || role == ROLE_CONE_EDGE || role == ROLE_RETIRED;
  }
  g_assert_cmpuint (n_marks, ==, frame->trace->set->n_sites);
  if (!frame->trace->is_flat)
    g_assert_cmpuint (n_edges, ==, frame->n_edges);
}

static void
check_scene (const Fixture *fixture)
{
  check_scenes (fixture, check_marks);
}

/* What is gained is one area, without seams: the hull lies over the part of it
 * that it has already. */
static void
check_one_gain (const Scene *scene, const PlanarFrame *frame)
{
  uint32_t n_gains = 0, n_hulls = 0;

  for (uint32_t i = 0; i < scene->n_items; i++) {
    n_hulls += scene->items[i].role == ROLE_HULL_AREA;
    if (scene->items[i].role != ROLE_CONE)
      continue;
    g_assert_cmpuint (n_hulls, ==, 0);
    n_gains++;
  }
  g_assert_cmpuint (n_gains, ==,
                    frame->counts.cone >= 2 && frame->base != frame->step);
}

static void
check_gain (const Fixture *fixture)
{
  check_scenes (fixture, check_one_gain);
}

static void
test_gain_is_one_area (void)
{
  fixture_for_each (2, 12, ORDER_FURTHEST, check_gain);
}

static void
test_scene_shows_every_site_and_edge (void)
{
  fixture_for_each (2, 12, ORDER_FURTHEST, check_scene);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/planar/every-round-ends-in-the-hull-of-the-sites-so-far",
                   test_every_round_ends_in_the_hull_of_the_sites_so_far);
  g_test_add_func (
      "/planar/a-site-sees-what-the-definition-says-and-is-the-furthest",
      test_a_site_sees_what_the_definition_says_and_is_the_furthest);
  g_test_add_func ("/planar/every-site-is-a-corner-or-inside-or-waits",
                   test_every_site_is_a_corner_or_inside_or_waits);
  g_test_add_func ("/planar/small-set-goes-as-by-hand",
                   test_small_set_goes_as_by_hand);
  g_test_add_func ("/planar/collinear-corners-do-not-stay",
                   test_collinear_corners_do_not_stay);
  g_test_add_func ("/planar/few-and-collinear-sites-have-a-hull",
                   test_few_and_collinear_sites_have_a_hull);
  g_test_add_func ("/planar/course-goes-through-all-phases-of-all-rounds",
                   test_course_goes_through_all_phases_of_all_rounds);
  g_test_add_func ("/planar/course-finds-places", test_course_finds_places);
  g_test_add_func ("/planar/what-is-gained-is-one-area", test_gain_is_one_area);
  g_test_add_func ("/planar/scene-shows-every-site-and-edge",
                   test_scene_shows_every_site_and_edge);
  return g_test_run ();
}
