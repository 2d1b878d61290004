/* Scenes in which only what a person points at has changed, against scenes
 * filled anew and against definitions; lists by place against a look at all. */
#include "box-index.h"
#include "stage.h"

#include <string.h>

#define N_LOOKS 24

/* An object of any kind, which the step may or may not show. */
static Object
any_object (GRand *rand, const Trace *trace)
{
  const uint32_t n_rows[] = { [OBJECT_NONE] = 1,
                              [OBJECT_SITE] = trace->set->n_sites,
                              [OBJECT_FACET] = trace->n_facets,
                              [OBJECT_VERTEX] = trace->n_facets,
                              [OBJECT_RIDGE] = trace->n_ridges };
  const int kind = g_rand_int_range (rand, 0, G_N_ELEMENTS (n_rows));

  if (kind == OBJECT_NONE || n_rows[kind] == 0)
    return (Object){ OBJECT_NONE, 0 };
  return (Object){ (ObjectKind)kind,
                   (uint32_t)g_rand_int_range (rand, 0, (int)n_rows[kind]) };
}

/* Selects a few sites; @room keeps them. */
static void
select_some (GRand *rand, SceneLook *look, uint32_t n_sites, uint32_t room[3])
{
  const uint32_t first
      = (uint32_t)g_rand_int_range (rand, 0, (int)MAX (n_sites, 1));

  look->n_selected = 0;
  for (uint32_t i = first; i < n_sites && look->n_selected < 3; i += 2)
    room[look->n_selected++] = i;
  look->selected = room;
}

static void
point_at_something (GRand *rand, Stage *stage, uint32_t room[3])
{
  const SiteSet *set = stage->fixture->set;
  SceneLook *look = &stage->look;
  const Point3 at = { g_rand_double_range (rand, -1, 1),
                      g_rand_double_range (rand, -1, 1), 0 };

  look->hover = any_object (rand, stage->fixture->trace);
  look->selection = any_object (rand, stage->fixture->trace);
  look->measured = any_object (rand, stage->fixture->trace);
  look->has_preview = g_rand_int_range (rand, 0, 3) == 0;
  look->preview = scene_site (look, at);
  look->n_selected = 0;
  if (g_rand_boolean (rand))
    select_some (rand, look, set->n_sites, room);
}

static void
assert_same_item (const SceneItem *a, const SceneItem *b)
{
  g_assert_cmpint (a->shape, ==, b->shape);
  g_assert_cmpint (a->role, ==, b->role);
  g_assert_cmpint (a->emphasis, ==, b->emphasis);
  g_assert_cmpint (a->lit, ==, b->lit);
  g_assert_cmpint (a->pass, ==, b->pass);
  g_assert_true (object_equal (a->object, b->object));
  g_assert_cmpuint (a->first, ==, b->first);
  g_assert_cmpuint (a->n, ==, b->n);
  g_assert_cmpuint (a->hue, ==, b->hue);
  g_assert_true (a->fade == b->fade);
  g_assert_cmpstr (a->label, ==, b->label);
}

static void
assert_same_scene (const Scene *a, const Scene *b)
{
  g_assert_cmpuint (a->n_items, ==, b->n_items);
  g_assert_cmpuint (a->n_points, ==, b->n_points);
  g_assert_cmpuint (a->stock.n_items, ==, b->stock.n_items);
  g_assert_cmpuint (a->n_lit, ==, b->n_lit);
  for (uint32_t i = 0; i < a->n_items; i++)
    assert_same_item (&a->items[i], &b->items[i]);
  for (uint32_t i = 0; i < a->n_lit; i++)
    g_assert_cmpuint (a->lit[i], ==, b->lit[i]);
  g_assert_cmpint (
      memcmp (a->points, b->points, a->n_points * sizeof *a->points), ==, 0);
}

static void
check_relit (Stage *stage)
{
  Scene fresh = { 0 };

  g_assert_true (scene_relight (&stage->plane, &stage->frame, &stage->look));
  scene_plane (&fresh, &stage->frame, &stage->look);
  assert_same_scene (&stage->plane, &fresh);
  g_assert_true (scene_relight (&stage->space, &stage->frame, &stage->look));
  scene_space (&fresh, &stage->frame, &stage->look);
  assert_same_scene (&stage->space, &fresh);
  scene_clear (&fresh);
}

/* Calls @check for looks at some steps of a fixture, with all layers. */
static void
for_looks (const Fixture *fixture, void (*check) (Stage *stage))
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (5);
  const uint32_t n = fixture->trace->n_events;

  for (uint32_t step = 0; step <= n; step += MAX (n / 5, 1)) {
    Stage stage = { .fixture = (Fixture *)fixture };
    uint32_t room[3];

    frame_init (&stage.frame, fixture->trace, step);
    scene_look_init (&stage.look, &stage.frame);
    stage.look.layers = (1U << N_LAYERS) - 1;
    stage.look.mask = step % 3 == 1 ? MASK_ROUND : 0;
    stage_project (&stage, 300, 300);
    stage_draw (&stage);
    for (guint i = 0; i < N_LOOKS; i++) {
      point_at_something (rand, &stage, room);
      check (&stage);
    }
    scene_clear (&stage.plane);
    scene_clear (&stage.space);
    frame_clear (&stage.frame);
  }
}

static void
check_fixture (const Fixture *fixture)
{
  for_looks (fixture, check_relit);
}

static void
test_relit (void)
{
  fixture_for_each (1, 20, ORDER_FURTHEST, check_fixture);
}

static void
test_refused (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  const uint32_t n_items = stage->plane.n_items;
  Scene never = { 0 };

  stage->look.layers ^= LAYER_CIRCLES;
  g_assert_false (scene_relight (&stage->plane, &stage->frame, &stage->look));
  g_assert_cmpuint (stage->plane.n_items, ==, n_items);
  stage->look.layers ^= LAYER_CIRCLES;
  stage->look.low.x -= 0.5;
  g_assert_false (scene_relight (&stage->plane, &stage->frame, &stage->look));
  g_assert_false (scene_relight (&never, &stage->frame, &stage->look));
}

/* Lit are what is pointed at and what has the same circle, by definition. */

static uint32_t
group_of (const Frame *frame, uint32_t facet)
{
  for (uint32_t i = 0; i < frame->delaunay.n_triangles; i++)
    if (frame->delaunay.triangles[i].facet == facet)
      return frame->delaunay.triangles[i].group;
  return INDEX_NONE;
}

static gboolean
means (const Frame *frame, Object a, Object b)
{
  const gboolean is_dual
      = (a.kind == OBJECT_FACET && b.kind == OBJECT_VERTEX)
        || (a.kind == OBJECT_VERTEX && b.kind == OBJECT_FACET);

  if (is_dual)
    return group_of (frame, a.number) != INDEX_NONE
           && group_of (frame, a.number) == group_of (frame, b.number);
  return a.kind != OBJECT_NONE && object_equal (a, b);
}

static gboolean
is_meant (const Stage *stage, Object object)
{
  const SceneLook *look = &stage->look;

  for (uint32_t i = 0; i < look->n_selected; i++)
    if (object.kind == OBJECT_SITE && object.number == look->selected[i])
      return TRUE;
  return means (&stage->frame, object, look->selection)
         || means (&stage->frame, object, look->hover);
}

static void
check_lit (Stage *stage)
{
  const Scene *scenes[2] = { &stage->plane, &stage->space };

  /* Previews take the light from cells and triangles; circles of what is lit
   * are items of their own. */
  stage->look.has_preview = FALSE;
  stage_draw (stage);
  for (int k = 0; k < 2; k++)
    for (uint32_t i = 0; i < scenes[k]->stock.n_items; i++) {
      const SceneItem *item = &scenes[k]->items[i];

      if (item->role != ROLE_CIRCLE)
        g_assert_cmpint (item->lit != LIT_NONE, ==,
                         is_meant (stage, item->object));
    }
}

static void
check_lit_fixture (const Fixture *fixture)
{
  for_looks (fixture, check_lit);
}

static void
test_lit (void)
{
  fixture_for_each (1, 12, ORDER_FURTHEST, check_lit_fixture);
}

/* Pickers */

static void
check_picks (Stage *stage, GRand *rand)
{
  ScenePicker *pickers[2] = { scene_picker_new (), scene_picker_new () };

  for (guint i = 0; i < 300; i++) {
    const gboolean is_space = i % 2 == 1;
    const Scene *scene = is_space ? &stage->space : &stage->plane;
    const Projection *projection
        = is_space ? &stage->on_space : &stage->on_plane;
    const double at[2] = { g_rand_double_range (rand, -20, 520),
                           g_rand_double_range (rand, -20, 520) };
    const double reach = i % 3 == 0 ? 0 : 4.0 * (i % 12);
    const Object all = scene_pick (scene, projection, at, reach);
    const Object near
        = scene_picker_pick (pickers[is_space], scene, projection, at, reach);

    g_assert_true (object_equal (all, near));
  }
  scene_picker_free (pickers[0]);
  scene_picker_free (pickers[1]);
}

static void
test_picker (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (3);

  for (guint seed = 1; seed <= fixture_n_seeds (4); seed++) {
    g_autoptr (Stage) stage = stage_take (
        fixture_new (FAMILY_RANDOM, seed, 60, ORDER_FURTHEST), seed * 40);

    check_picks (stage, rand);
    stage->look.hover = any_object (rand, stage->fixture->trace);
    g_assert_true (scene_relight (&stage->plane, &stage->frame, &stage->look));
    check_picks (stage, rand);
  }
}

/* A picker follows camera and scene. */
static void
test_picker_follows (void)
{
  g_autoptr (Stage) stage = stage_at_end ("lecture8");
  g_autoptr (Stage) other = stage_at_end ("mixed8");
  ScenePicker *picker = scene_picker_new ();
  const double at[2] = { 100, 120 };

  for (guint i = 0; i < 4; i++) {
    const Stage *now = i % 2 == 0 ? stage : other;

    stage_project (stage, 400 + 30 * i, 500);
    g_assert_true (object_equal (
        scene_pick (&now->plane, &now->on_plane, at, 9),
        scene_picker_pick (picker, &now->plane, &now->on_plane, at, 9)));
  }
  scene_picker_free (picker);
}

/* Boxes */

#define N_BOXES 400

static PixelBox
any_box (GRand *rand, double largest)
{
  const double x = g_rand_double_range (rand, -60, 260);
  const double y = g_rand_double_range (rand, -60, 160);

  return (PixelBox){ (float)x, (float)y,
                     (float)(x + g_rand_double_range (rand, 0, largest)),
                     (float)(y + g_rand_double_range (rand, 0, largest)) };
}

static void
test_boxes (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (9);
  const PixelBox view = { -20, -10, 211, 107 };
  BoxIndex *index = box_index_new ();
  PixelBox boxes[N_BOXES];

  for (guint i = 0; i < N_BOXES; i++)
    boxes[i] = any_box (rand, i % 10 == 0 ? 200 : 20);
  box_index_set (index, &view, boxes, sizeof boxes[0], N_BOXES);
  for (guint turn = 0; turn < 200; turn++) {
    const PixelBox place = any_box (rand, 30);
    guint n = 0;

    box_index_forget (index);
    box_index_find (index, &place);
    for (uint32_t i = 0; i < N_BOXES; i++) {
      const gboolean is_found = box_index_next (index, i) == i;

      n += is_found;
      if (boxes_meet (&boxes[i], &place) && boxes_meet (&boxes[i], &view)
          && boxes_meet (&place, &view))
        g_assert_true (is_found);
    }
    /* And not just all of them. */
    g_assert_cmpuint (n, <, N_BOXES / 2);
  }
  box_index_free (index);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/relight/a-scene-relit-is-that-filled-anew", test_relit);
  g_test_add_func ("/relight/another-stock-is-refused", test_refused);
  g_test_add_func ("/relight/what-is-meant-is-lit-and-nothing-else", test_lit);
  g_test_add_func ("/picker/near-the-pixel-is-all-that-matters", test_picker);
  g_test_add_func ("/picker/it-follows-camera-and-scene", test_picker_follows);
  g_test_add_func ("/box-index/it-finds-all-that-meet-the-place", test_boxes);
  return g_test_run ();
}
