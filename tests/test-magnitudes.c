/* Sets of all kinds and all magnitudes, their results judged from the JSON by
 * rational numbers: right, or refused. */
#include "fixture.h"
#include "oracle.h"
#include "rbox.h"
#include "result-json.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Returns: the result as JSON; free with free(). */
static char *
json_of (const SiteSet *set, OrderKind kind)
{
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);
  Result result;

  result_init_batch (&result, set, &(Order){ kind, 3 });
  g_assert_true (
      result_json_write (&result, (ResultForm){ true, false }, file));
  g_assert_cmpint (fclose (file), ==, 0);
  result_clear (&result);
  return text;
}

static void
judge (const SiteSet *set, const char *name)
{
  for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS;
       kind += ORDER_HILBERT) {
    char *json = json_of (set, kind);

    oracle_judge (json, set, name);
    free (json);
  }
}

static void
test_sets_of_every_kind_are_right (void)
{
  rbox_for_each (2, 24, judge);
}

/* Some double whose exponent is from @lowest to @highest, or zero. */
static double
some_double (GRand *random, int lowest, int highest)
{
  const int exponent = g_rand_int_range (random, lowest, highest + 1);
  const double mantissa = g_rand_double_range (random, 1, 2);

  switch (g_rand_int_range (random, 0, 6)) {
  case 0:
    return 0;
  case 1:
    return ldexp (1, exponent);
  case 2:
    return -ldexp (mantissa, exponent);
  default:
    return ldexp (mantissa, exponent);
  }
}

/* The widths go to twice what can be scaled, the lowest magnitude from the
 * smallest double on. */
static guint
judge_magnitudes (GRand *random)
{
  enum { N = 7, LEAST = DBL_MIN_EXP - DBL_MANT_DIG, MOST = DBL_MAX_EXP - 1 };
  const int width = g_rand_int_range (random, 0, 4 * SITE_RANGE);
  const int lowest = g_rand_int_range (random, LEAST, MOST - width + 1);
  g_autofree char *name
      = g_strdup_printf ("from 2^%d to 2^%d", lowest, lowest + width);
  SiteRange range = SITE_RANGE_INIT;
  bool is_fit = true;
  Site sites[N];
  SiteSet *set;

  for (guint i = 0; i < N; i++) {
    sites[i].x = some_double (random, lowest, lowest + width);
    sites[i].y = some_double (random, lowest, lowest + width);
    is_fit = site_range_add (&range, &sites[i]) && is_fit;
  }
  set = site_set_new (sites, N);
  g_assert_true ((set != NULL) == is_fit);
  g_assert_true (is_fit || width > 2 * SITE_RANGE);
  if (set != NULL)
    judge (set, name);
  site_set_free (set);
  return is_fit ? 1 : 0;
}

static void
test_sets_of_any_magnitude_are_right_or_refused (void)
{
  const guint n = fixture_n_seeds (150);
  GRand *random = g_rand_new_with_seed (290);
  guint n_fit = 0;

  for (guint i = 0; i < n; i++)
    n_fit += judge_magnitudes (random);
  /* Both happen. */
  g_assert_cmpuint (n_fit, >, n / 3);
  g_assert_cmpuint (n_fit, <, n - n / 10);
  g_rand_free (random);
}

/* The centre of (0, 2^a), (0, -2^a), (2^b · part, 0) is at
 * x = 2^b part / 2 - 2^(2a - b - 1) / part. */
static gboolean
is_null (double part)
{
  const double far = 0x1p800;
  const double near = ldexp (part, 575);
  SiteSet *set
      = site_set_new ((Site[]){ { 0, far }, { 0, -far }, { near, 0 } }, 3);
  char *json = json_of (set, ORDER_FURTHEST);
  const gboolean found = strstr (json, "\"vertices\": [null]") != NULL;

  oracle_judge (json, set, "at the edge of doubles");
  free (json);
  site_set_free (set);
  return found;
}

static void
test_centres_are_null_beyond_doubles_only (void)
{
  g_assert_true (is_null (1));
  g_assert_true (is_null (1 - 0x1p-40));
  g_assert_false (is_null (1 + 0x1p-40));
  g_assert_false (is_null (1 + 0x1p-50));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/magnitudes/sets-of-every-kind-are-right",
                   test_sets_of_every_kind_are_right);
  g_test_add_func ("/magnitudes/sets-of-any-magnitude-are-right-or-refused",
                   test_sets_of_any_magnitude_are_right_or_refused);
  g_test_add_func ("/magnitudes/centres-are-null-beyond-doubles-only",
                   test_centres_are_null_beyond_doubles_only);
  return g_test_run ();
}
