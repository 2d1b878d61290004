#include "certify.h"

#include "fixture.h"

static void
assert_rounds (const Fixture *fixture)
{
  for (uint32_t step = 0; step <= fixture->trace->n_events;
       step = timeline_next (fixture->trace, step, GRAIN_ROUND)) {
    char why[CERTIFY_ROOM] = "";
    Frame frame;

    frame_init (&frame, fixture->trace, step);
    if (!certify_frame (&frame, why))
      g_error ("%s, step %u: %s", fixture->name, step, why);
    frame_clear (&frame);
    if (step == fixture->trace->n_events)
      break;
  }
}

static void
test_every_round_of_every_family_holds (void)
{
  fixture_for_each (12, 24, ORDER_FURTHEST, assert_rounds);
  fixture_for_each (12, 24, ORDER_RANDOM, assert_rounds);
}

static void
test_every_round_of_the_curated_sets_holds (void)
{
  for (const char *const *name = fixture_names (); *name != NULL; name += 1) {
    g_autoptr (Fixture) fixture = fixture_load (*name, ORDER_FURTHEST);

    assert_rounds (fixture);
  }
}

static void
test_every_single_step_holds (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("mixed8", ORDER_FURTHEST);

  for (uint32_t step = 0; step <= fixture->trace->n_events; step += 1) {
    char why[CERTIFY_ROOM] = "";
    Frame frame;

    frame_init (&frame, fixture->trace, step);
    g_assert_true (certify_frame (&frame, why));
    frame_clear (&frame);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/certify/every-round-of-the-curated-sets-holds",
                   test_every_round_of_the_curated_sets_holds);
  g_test_add_func ("/certify/every-round-of-every-family-holds",
                   test_every_round_of_every_family_holds);
  g_test_add_func ("/certify/every-single-step-holds",
                   test_every_single_step_holds);
  return g_test_run ();
}
