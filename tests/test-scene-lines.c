/* Lines of the scene of space that say something by their ends. */
#include "stage.h"

#include <math.h>

/* Returns: px from one end of a segment to the other. */
static double
length_of (const Stage *stage, const SceneItem *item)
{
  const Point3 *points = &stage->space.points[item->first];
  const Pixel a = stage_pixel (&stage->on_space, points[0]);
  const Pixel b = stage_pixel (&stage->on_space, points[1]);

  return hypot (a.x - b.x, a.y - b.y);
}

/* From home each height is a line between two ticks, of the same length
 * however short it is. */
static void
test_heights (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 2, PHASE_CHOOSE);
  guint n = 0;

  for (guint i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];

    if (item->role != ROLE_DROP)
      continue;
    g_assert_cmpuint (item->n, ==, 2);
    if (n++ % 3 != 0) {
      g_assert_cmpfloat (length_of (stage, item), >, 5);
      g_assert_cmpfloat (length_of (stage, item), <, 20);
    }
  }
  g_assert_cmpuint (n, >=, 3);
  g_assert_cmpuint (n % 3, ==, 0);
}

#define MARK_REACH 10 /* px; the largest mark but the current site's has it */

/* Returns: px from a place to the lift of a site. */
static double
to_lift (const Stage *stage, guint site, Point3 at)
{
  const Pixel from = stage_pixel (&stage->on_space, at);

  for (guint i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];
    const Pixel lift
        = stage_pixel (&stage->on_space, stage->space.points[item->first]);

    if (item->pass == PASS_MARKS && item->object.kind == OBJECT_SITE
        && item->object.number == site)
      return hypot (lift.x - from.x, lift.y - from.y);
  }
  g_assert_not_reached ();
}

/* Returns: whether the only height of a step is so short that a mark is larger;
 *          then none of its ends is under that. */
static gboolean
check_short (const Stage *stage, guint site)
{
  guint i = 0;

  while (i < stage->space.n_items && stage->space.items[i].role != ROLE_DROP)
    i++;
  if (i == stage->space.n_items
      || length_of (stage, &stage->space.items[i]) > 2 * MARK_REACH)
    return FALSE;
  for (guint k = 0; k < 2; k++) {
    const Point3 end = stage->space.points[stage->space.items[i].first + k];

    g_assert_cmpfloat (to_lift (stage, site, end), >, MARK_REACH);
  }
  return TRUE;
}

static void
test_short_heights (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  guint n = 0;

  for (guint step = 1; step <= fixture->trace->n_events; step++) {
    const Event event = trace_event (fixture->trace, step - 1);
    g_autoptr (Stage) stage = NULL;

    if (event.kind != EVENT_CLAIM)
      continue;
    stage = stage_take (fixture_load ("lecture8", ORDER_FURTHEST), step);
    n += check_short (stage, event.site);
  }
  g_assert_cmpuint (n, >, 0);
}

static guint
count_outlines (const Scene *scene)
{
  guint n = 0;

  for (guint i = 0; i < scene->n_items; i++)
    n += scene->items[i].role == ROLE_SELECTED_FACET
         && scene->items[i].pass == PASS_GROUND;
  return n;
}

static void
test_current_facet (void)
{
  g_autoptr (Stage) stage = stage_new ("lecture8", 2, PHASE_CHOOSE);

  g_assert_cmpuint (count_outlines (&stage->plane), ==, 1);
  g_assert_cmpuint (count_outlines (&stage->space), ==, 1);
}

/* Many lines through one point would be a mark that nothing explains. */
static void
test_bottom (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  guint n = 0;

  for (guint i = 0; i < stage->space.n_items; i++) {
    const SceneItem *item = &stage->space.items[i];

    const Point3 start = stage->space.points[item->first];

    n += item->role == ROLE_SHEET && hypot (start.x, start.y) < 0.01;
  }
  g_assert_cmpuint (n, >=, 2);
  g_assert_cmpuint (n, <=, 4);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/scene-lines/a-short-height-has-ticks", test_heights);
  g_test_add_func ("/scene-lines/no-mark-hides-an-end-of-a-short-height",
                   test_short_heights);
  g_test_add_func ("/scene-lines/both-views-outline-the-current-facet",
                   test_current_facet);
  g_test_add_func ("/scene-lines/few-wires-meet-at-the-bottom", test_bottom);
  return g_test_run ();
}
