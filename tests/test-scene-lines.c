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
  g_test_add_func ("/scene-lines/few-wires-meet-at-the-bottom", test_bottom);
  return g_test_run ();
}
