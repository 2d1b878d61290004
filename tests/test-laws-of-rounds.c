/* The laws of one insertion, at every round of many sets. */
#include "standing.h"

/* One round with what stands before and after it. */
typedef struct Round {
  const Fixture *fixture;
  const RoundRow *row;
  Standing *before, *after;
} Round;

/* How often each case of a round came; a law that is never put to the test
 * proves nothing. */
static struct {
  guint inside, border, lower, upper, both, vertical, tied, ties_of_furthest;
} cases;

typedef void (*CheckRound) (const Round *round);
static CheckRound check_round;

static void
visit_rounds (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  const Trace *trace = fixture->trace;

  for (uint32_t i = 0; i < trace->n_rounds; i++) {
    const RoundRow *row = &trace->rounds[i];
    g_autoptr (Standing) before
        = standing_new (fixture, judge, row->select - 1);
    g_autoptr (Standing) after = standing_new (fixture, judge, row->end);

    check_round (&(Round){ fixture, row, before, after });
  }
}

static void
at_every_round (gconstpointer check)
{
  check_round = *(const CheckRound *)check;
  fixture_for_each (20, 16, ORDER_FURTHEST, visit_rounds);
  fixture_for_each (4, 40, ORDER_RANDOM, visit_rounds);
}

static bool
is_seen (const Round *round, uint32_t facet)
{
  const uint32_t seen = round->fixture->trace->facets[facet].seen;

  return round->row->first_visible <= seen && seen <= round->row->last_visible;
}

static uint32_t
count_seen (const Round *round, Facing facing)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < round->before->n_facets; i++) {
    const uint32_t facet = round->before->facets[i];

    n += is_seen (round, facet)
         && standing_facing (round->before, facet) == facing;
  }
  return n;
}

static int
place_of_apex (const Round *round)
{
  return judge_inside (round->before->judge, round->before->corners,
                       round->before->n_corners, round->row->site);
}

static void
check_seen_facets (const Round *round)
{
  for (uint32_t i = 0; i < round->before->n_facets; i++) {
    const uint32_t facet = round->before->facets[i];

    standing_assert (round->before, is_seen (round, facet)
                                        == standing_sees (round->before, facet,
                                                          round->row->site));
    standing_assert (round->before,
                     standing_facing (round->before, facet)
                         == round->fixture->trace->facets[facet].facing);
  }
}

static void
check_inside_sees_lower_only (const Round *round)
{
  const uint32_t upper = count_seen (round, FACING_UPPER);
  const uint32_t vertical = count_seen (round, FACING_VERTICAL);
  const uint32_t lower = count_seen (round, FACING_LOWER);
  const int place = place_of_apex (round);

  if (place >= 0)
    standing_assert (round->before, lower > 0 && upper == 0 && vertical == 0);
  cases.inside += place > 0;
  cases.border += place == 0;
  cases.vertical += vertical > 0;
  if (place < 0 && vertical == 0) {
    cases.lower += upper == 0;
    cases.upper += lower == 0;
    cases.both += lower > 0 && upper > 0;
  }
}

static void
check_counts (const Round *round)
{
  const RoundRow *row = round->row;
  const Standing *after = round->after;
  const uint32_t visible = row->last_visible - row->first_visible + 1;
  const uint32_t horizon = row->last_horizon - row->first_horizon + 1;
  const uint32_t cone = row->last_cone - row->first_cone + 1;
  const uint32_t retired = row->last_retire - row->first_retire + 1;

  standing_assert (after, cone == horizon);
  standing_assert (after, cone == visible + 2);
  standing_assert (after, retired == visible);
  standing_assert (after, after->n_active == round->before->n_active + 1);
  standing_assert (after, after->n_facets == 2 * after->n_active - 4);
}

/* Between the rounds, with b sites on the border and h corners. */
static void
check_kinds (const Standing *standing)
{
  const uint32_t d = standing->n_active;
  const uint32_t b = standing->n_boundary, h = standing->n_corners;

  standing_assert (standing,
                   standing_count (standing, FACING_LOWER) == 2 * d - 2 - b);
  standing_assert (standing, standing_count (standing, FACING_UPPER) == h - 2);
  standing_assert (standing,
                   standing_count (standing, FACING_VERTICAL) == b - h);
}

static void
check_kinds_of_round (const Round *round)
{
  check_kinds (round->before);
  check_kinds (round->after);
}

/* New lower = visible lower + 2 - Δh, new upper = visible upper + Δh, in
 * general position: no vertical facet before or after. */
static void
check_changes (const Round *round)
{
  const uint32_t h = round->before->n_corners;
  const uint32_t h_after = round->after->n_corners;
  uint32_t lower = 0, upper = 0;

  if (standing_count (round->before, FACING_VERTICAL) > 0
      || standing_count (round->after, FACING_VERTICAL) > 0)
    return;
  for (uint32_t i = 0; i < round->after->n_facets; i++) {
    const uint32_t facet = round->after->facets[i];

    if (round->fixture->trace->facets[facet].span.birth < round->row->select)
      continue;
    lower += standing_facing (round->after, facet) == FACING_LOWER;
    upper += standing_facing (round->after, facet) == FACING_UPPER;
  }
  standing_assert (round->after,
                   lower + h_after == count_seen (round, FACING_LOWER) + 2 + h);
  standing_assert (round->after,
                   upper + h == count_seen (round, FACING_UPPER) + h_after);
}

static Event
horizon_event (const Round *round, uint32_t i)
{
  const uint32_t first = round->row->first_horizon;
  const uint32_t n = round->row->last_horizon - first + 1;

  return trace_event (round->fixture->trace, first - 1 + i % n);
}

static void
check_loop (const Round *round)
{
  const uint32_t n = round->row->last_horizon - round->row->first_horizon + 1;
  g_autofree bool *is_met = g_new0 (bool, round->fixture->set->n_sites);

  for (uint32_t i = 0; i < n; i++) {
    const Event ridge = horizon_event (round, i);
    const Event next = horizon_event (round, i + 1);

    standing_assert (round->before, ridge.ridge[1] == next.ridge[0]);
    standing_assert (round->before, !is_met[ridge.ridge[0]]);
    standing_assert (round->before, !is_seen (round, ridge.facet));
    is_met[ridge.ridge[0]] = true;
  }
}

/* From a site inside the hull the horizon is the border of a star: clockwise
 * in the plane, as visible lower facets are. */
static void
check_star (const Round *round)
{
  const uint32_t n = round->row->last_horizon - round->row->first_horizon + 1;

  if (place_of_apex (round) <= 0)
    return;
  for (uint32_t i = 0; i < n; i++) {
    const Event event = horizon_event (round, i);

    standing_assert (round->before,
                     judge_orient (round->before->judge, event.ridge[0],
                                   event.ridge[1], round->row->site)
                         < 0);
  }
}

static guint
count_crossings (const Round *round)
{
  const uint32_t n = round->row->last_horizon - round->row->first_horizon + 1;
  guint n_crossings = 0;

  for (uint32_t i = 0; i < n; i++)
    for (uint32_t j = i + 1; j < n; j++)
      n_crossings
          += judge_cross (round->before->judge, horizon_event (round, i).ridge,
                          horizon_event (round, j).ridge);
  return n_crossings;
}

static void
check_shadow (const Round *round)
{
  const bool is_mixed = count_seen (round, FACING_LOWER) > 0
                        && count_seen (round, FACING_UPPER) > 0;

  if (!is_mixed)
    standing_assert (round->before, count_crossings (round) == 0);
}

/* Every circle is empty and the triangles fill the hull. */
static void
check_delaunay (const Round *round)
{
  const Standing *standing = round->after;
  const Judge *judge = standing->judge;
  mpz_t area, whole;

  mpz_inits (area, whole, NULL);
  judge_add_area (judge, standing->corners, standing->n_corners, whole);
  for (uint32_t i = 0; i < standing->n_facets; i++) {
    const uint32_t *site
        = round->fixture->trace->facets[standing->facets[i]].site;

    if (standing_facing (standing, standing->facets[i]) != FACING_LOWER)
      continue;
    for (uint32_t k = 0; k < standing->n_active; k++)
      standing_assert (standing,
                       judge_circle (judge, site, standing->active[k]) >= 0);
    judge_add_area (judge, site, 3, area);
  }
  mpz_neg (area, area); /* their shadows are clockwise */
  standing_assert (standing, mpz_cmp (area, whole) == 0);
  mpz_clears (area, whole, NULL);
}

/* The circle of an upper facet holds every site: furthest-site Delaunay. */
static void
check_upper (const Round *round)
{
  const Standing *standing = round->after;

  for (uint32_t i = 0; i < standing->n_facets; i++) {
    const uint32_t *site
        = round->fixture->trace->facets[standing->facets[i]].site;

    if (standing_facing (standing, standing->facets[i]) != FACING_UPPER)
      continue;
    for (uint32_t k = 0; k < standing->n_active; k++)
      standing_assert (standing,
                       judge_circle (standing->judge, site, standing->active[k])
                           <= 0);
  }
}

/* Compares how far in front of the facet two sites lie: by their powers, or
 * beyond a hull edge by the areas. */
static int
compare_further (const Standing *standing,
                 uint32_t facet,
                 uint32_t p,
                 uint32_t q)
{
  const uint32_t *site = standing->fixture->trace->facets[facet].site;
  const Facing facing = standing_facing (standing, facet);
  mpz_t left, right;
  int sign;

  if (facing == FACING_VERTICAL)
    return judge_compare_areas (standing->judge, site, p, q)
           * judge_orient (standing->judge, site[0], site[1], p);
  mpz_inits (left, right, NULL);
  judge_power (standing->judge, site, p, left);
  judge_power (standing->judge, site, q, right);
  sign = mpz_cmp (left, right);
  mpz_clears (left, right, NULL);
  return facing == FACING_LOWER ? -sign : sign;
}

/* The site of a round is the furthest of its outside set, the lowest of
 * those that tie, and the facet is the oldest with an outside set. */
static void
check_furthest (const Round *round)
{
  const Trace *trace = round->fixture->trace;
  const uint32_t facet = round->row->facet, apex = round->row->site;

  if (trace->order.kind != ORDER_FURTHEST)
    return;
  for (uint32_t i = 0; i < trace->n_claims; i++) {
    const ClaimRow claim = trace_claim (trace, i);
    int further;

    if (!span_has (claim.span, round->before->step))
      continue;
    standing_assert (round->before, claim.facet >= facet);
    if (claim.facet != facet || claim.site == apex)
      continue;
    further = compare_further (round->before, facet, apex, claim.site);
    cases.ties_of_furthest += further == 0;
    standing_assert (round->before,
                     further > 0 || (further == 0 && apex < claim.site));
  }
}

/* Every waiting site is in exactly one outside set, of a facet it sees. */
static void
check_partition (const Round *round)
{
  const Trace *trace = round->fixture->trace;
  g_autofree guint *n_claims = g_new0 (guint, trace->set->n_sites);

  for (uint32_t i = 0; i < trace->n_claims; i++) {
    const ClaimRow claim = trace_claim (trace, i);

    if (!span_has (claim.span, round->after->step))
      continue;
    n_claims[claim.site] += 1;
    standing_assert (round->after,
                     standing_sees (round->after, claim.facet, claim.site));
  }
  for (uint32_t i = 0; i < trace->set->n_sites; i++) {
    const bool is_waiting
        = trace->set->first[i] == i && trace->inserted[i] > round->after->step;

    standing_assert (round->after, n_claims[i] == (is_waiting ? 1 : 0));
  }
}

static void
test_cases_all_occur (void)
{
  static const CheckRound checks[]
      = { check_inside_sees_lower_only, check_furthest };

  for (guint i = 0; i < G_N_ELEMENTS (checks); i++)
    at_every_round (&checks[i]);
  g_assert_cmpuint (cases.inside, >, 100);
  g_assert_cmpuint (cases.border, >, 20);
  g_assert_cmpuint (cases.lower, >, 20);
  g_assert_cmpuint (cases.upper, >, 20);
  g_assert_cmpuint (cases.both, >, 20);
  g_assert_cmpuint (cases.vertical, >, 20);
  g_assert_cmpuint (cases.ties_of_furthest, >, 20);
}

/* The first simplex has one of three forms. */
static void
check_first_simplex (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  g_autoptr (Standing) standing = NULL;
  uint32_t lower, upper;

  if (fixture->trace->is_flat)
    return;
  standing = standing_new (fixture, judge, fixture->trace->simplex_end);
  lower = standing_count (standing, FACING_LOWER);
  upper = standing_count (standing, FACING_UPPER);
  standing_assert (standing, standing->n_facets == 4);
  standing_assert (standing, (lower == 2 && upper == 2)
                                 || (lower == 3 && upper == 1)
                                 || (lower == 2 && upper == 1));
  check_kinds (standing);
}

static void
test_first_simplex (void)
{
  fixture_for_each (60, 8, ORDER_FURTHEST, check_first_simplex);
}

int
main (int argc, char **argv)
{
  static const struct {
    const char *name;
    CheckRound check;
  } laws[] = {
    { "a-site-sees-a-facet-as-the-circles-say", check_seen_facets },
    { "a-site-in-the-hull-sees-only-lower-facets",
      check_inside_sees_lower_only },
    { "cone-equals-horizon-equals-visible-plus-2", check_counts },
    { "kinds-of-facets-follow-from-the-border-of-the-hull",
      check_kinds_of_round },
    { "new-facets-follow-from-visible-ones-and-corners", check_changes },
    { "the-horizon-is-one-loop-between-seen-and-unseen", check_loop },
    { "the-horizon-of-a-site-in-the-hull-is-the-border-of-a-star", check_star },
    { "the-shadow-of-the-horizon-crosses-itself-only-with-both-kinds-visible",
      check_shadow },
    { "lower-facets-are-the-delaunay-triangulation-at-the-end-of-a-round",
      check_delaunay },
    { "circles-of-upper-facets-hold-every-site", check_upper },
    { "the-furthest-site-of-the-oldest-outside-set-comes-next",
      check_furthest },
    { "every-waiting-site-is-claimed-once-by-a-facet-it-sees",
      check_partition },
  };

  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (laws); i++) {
    g_autofree char *path = g_strconcat ("/laws/", laws[i].name, NULL);

    g_test_add_data_func (path, &laws[i].check, at_every_round);
  }
  g_test_add_func ("/laws/every-case-of-a-round-occurs", test_cases_all_occur);
  g_test_add_func ("/laws/the-first-simplex-has-one-of-three-forms",
                   test_first_simplex);
  return g_test_run ();
}
