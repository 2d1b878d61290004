#include "number.h"

#include <float.h>
#include <glib.h>
#include <locale.h>
#include <math.h>
#include <string.h>

static void
assert_reads (const char *text, double expected, const char *rest)
{
  double number = -1;
  const char *end = number_parse (text, &number);

  g_assert_nonnull (end);
  g_assert_cmpstr (end, ==, rest);
  g_assert_cmpfloat (number, ==, expected);
}

static void
test_decimal_numbers_are_read (void)
{
  assert_reads ("1", 1, "");
  assert_reads ("+1 2", 1, " 2");
  assert_reads ("-.5;", -0.5, ";");
  assert_reads ("5.e1", 50, "");
  assert_reads ("1e2e", 100, "e");
  assert_reads ("1e", 1, "e");
  assert_reads ("1e+", 1, "e+");
  assert_reads ("1,5", 1, ",5");
  assert_reads ("0e999", 0, "");
  assert_reads ("1.7976931348623157e308", DBL_MAX, "");
  assert_reads ("4.9406564584124654e-324", DBL_TRUE_MIN, "");
}

static void
test_all_else_is_refused (void)
{
  static const char *const refused[]
      = { "",    " 1",   ".",   "-",        "+-1",     "e5",    ".e5",
          "inf", "-inf", "nan", "NAN",      "0x10",    "0X1p3", "-0x1",
          "one", ",5",   "--1", "\xd9\xa1", "infinity" };

  for (size_t i = 0; i < G_N_ELEMENTS (refused); i += 1) {
    double number = 0;

    g_assert_null (number_parse (refused[i], &number));
    g_assert_true (isnan (number));
  }
}

static void
test_refusal_tells_too_large_from_too_small (void)
{
  double number;

  g_assert_null (number_parse ("1e400", &number));
  g_assert_true (isinf (number));
  g_assert_null (number_parse ("-0.001e-400", &number));
  g_assert_cmpfloat (number, ==, 0);
}

static void
assert_writes (double number, const char *expected)
{
  char text[NUMBER_ROOM];

  number_write (number, text);
  g_assert_cmpstr (text, ==, expected);
}

static void
test_few_digits_are_written (void)
{
  assert_writes (0, "0");
  assert_writes (0.1, "0.1");
  assert_writes (-0.6, "-0.6");
  assert_writes (0.1 + 0.2, "0.30000000000000004");
  assert_writes (1e22, "1e+22");
  assert_writes (DBL_TRUE_MIN, "5e-324");
  assert_writes (DBL_MAX, "1.7976931348623157e+308");
}

static void
test_written_numbers_read_back_the_same (void)
{
  GRand *random = g_rand_new_with_seed (17);

  for (int i = 0; i < 100000; i += 1) {
    const guint64 high = g_rand_int (random), low = g_rand_int (random);
    const guint64 bits = high << 32 | low;
    char text[NUMBER_ROOM];
    double number;

    memcpy (&number, &bits, sizeof number);
    if (!isfinite (number))
      continue;
    number_write (number, text);
    assert_reads (text, number, "");
    g_assert_cmpfloat (g_ascii_strtod (text, NULL), ==, number);
  }
  g_rand_free (random);
}

static void
test_locale_does_not_matter (void)
{
  double number;

  g_assert_nonnull (setlocale (LC_ALL, "de_DE.UTF-8"));
  g_assert_cmpstr (localeconv ()->decimal_point, ==, ",");
  assert_writes (0.5, "0.5");
  assert_reads ("0.5", 0.5, "");
  assert_reads ("0,5", 0, ",5");
  g_assert_null (number_parse (",5", &number));
  g_assert_cmpstr (localeconv ()->decimal_point, ==, ",");
  setlocale (LC_ALL, "C");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/number/decimal-numbers-are-read",
                   test_decimal_numbers_are_read);
  g_test_add_func ("/number/all-else-is-refused", test_all_else_is_refused);
  g_test_add_func ("/number/refusal-tells-too-large-from-too-small",
                   test_refusal_tells_too_large_from_too_small);
  g_test_add_func ("/number/few-digits-are-written",
                   test_few_digits_are_written);
  g_test_add_func ("/number/written-numbers-read-back-the-same",
                   test_written_numbers_read_back_the_same);
  g_test_add_func ("/number/locale-does-not-matter",
                   test_locale_does_not_matter);
  return g_test_run ();
}
