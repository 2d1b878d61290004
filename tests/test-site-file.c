#include "site-file.h"

#include <glib.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

static SiteSet *
parse (const char *text, SiteFileError *error)
{
  return site_file_parse (text, strlen (text), error);
}

static void
assert_sites (const char *text, const Site *expected, uint32_t n_sites)
{
  SiteFileError error;
  SiteSet *set = parse (text, &error);

  g_assert_nonnull (set);
  g_assert_cmpuint (set->n_sites, ==, n_sites);
  for (uint32_t i = 0; i < n_sites; i += 1) {
    g_assert_cmpfloat (set->sites[i].x, ==, expected[i].x);
    g_assert_cmpfloat (set->sites[i].y, ==, expected[i].y);
  }
  site_set_free (set);
}

static void
assert_refused_bytes (const char *text, size_t length, uint32_t line)
{
  SiteFileError error = { 0, "" };

  g_assert_null (site_file_parse (text, length, &error));
  g_assert_cmpuint (error.line, ==, line);
  g_assert_cmpuint (strlen (error.reason), >, 5);
  for (const char *p = error.reason; *p != '\0'; p += 1)
    g_assert_true (g_ascii_isprint (*p));
}

static void
assert_refused (const char *text, uint32_t line)
{
  assert_refused_bytes (text, strlen (text), line);
}

static const Site half_and_two[] = { { 0.5, 2 } };

static void
test_every_dress_of_a_line_is_read (void)
{
  static const char *const dresses[] = {
    "0.5 2",
    "0.5\t2\n",
    "0.5,2\n",
    "0.5;2\n",
    "0.5 , 2\n",
    "0.5\t;\t2\n",
    "  +.5 2.  \n",
    "5e-1,0.2E+1\r\n",
    "\357\273\2770.5 2", /* after a byte order mark */
    "\n\n0.5 2\n\n",
    "# a\n  # b\n0.5 2",
    "#\xc3\xa9\n0.5 2",
    " \t\n0.5  2",
    "#\r\n\r\n0.5;2\r\n",
  };

  for (size_t i = 0; i < G_N_ELEMENTS (dresses); i += 1)
    assert_sites (dresses[i], half_and_two, 1);
}

static void
test_empty_files_have_no_sites (void)
{
  assert_sites ("", NULL, 0);
  assert_sites ("\n", NULL, 0);
  assert_sites ("\xef\xbb\xbf# nothing", NULL, 0);
}

static void
test_bad_lines_are_refused_with_their_number (void)
{
  static const char *const bad[] = {
    "1",        "1,",         "1 2 3",      "1,2,3",
    "1,,2",     "1;,2",       "1, ,2",      ",1 2",
    "1 2,",     "1 2;",       "0x1 2",      "1 0x2",
    "inf 1",    "1 -inf",     "nan 1",      "1 NaN",
    "1,5 2,5",  "1,5;2,5",    "one two",    "1 two",
    "1e 2",     "1 2e",       "1e400 1",    "1 -1e400",
    "1e-400 1", "1-2",        "1 2 # two",  "1 2//",
    "(1 2)",    "1.2.3 4",    "1_000 2",    "'1' 2",
    "1d5 2",    "1\302\2402", "\xd9\xa1 2", "1 \357\273\2772",
    "; 1 2",    "1 + 2",
  };

  for (size_t i = 0; i < G_N_ELEMENTS (bad); i += 1) {
    g_autofree char *text
        = g_strdup_printf ("# head\r\n0 0\n\n%s\n9 9 9\n", bad[i]);
    Site site;

    assert_refused (text, 4);
    g_assert_nonnull (site_file_parse_line (bad[i], strlen (bad[i]), &site));
  }
}

static void
test_bytes_that_are_no_text_are_refused (void)
{
  assert_refused_bytes ("1 2\n3 \0 4\n", 10, 2);
  assert_refused_bytes ("1 2\n#\0\n", 7, 2);
  assert_refused ("1 2\n1 \x01 2\n", 2);
  assert_refused ("1 2\n# \x1b[31m\n", 2);
  assert_refused ("1\v2\n", 1);
  assert_refused ("1 2\n# \x7f\n", 2);
  assert_refused ("1 2\r3 4\r", 1);
  assert_refused ("1 2\n3 4\r", 2);
  assert_refused ("1 2\r\r\n", 1);
}

static void
test_text_that_is_not_utf_8_is_refused (void)
{
  static const char *const bad[] = {
    "\xe9",
    "\xc0\xaf",
    "\xe0\x80\xaf",
    "\xed\xa0\x80",
    "\xf5\x80\x80",
    "\xf4\x90\x80\x80",
    "\xf0\x8f\xbf\xbf",
    "\xc3",
    "\xe2\x82",
    "\x80",
    "\xff\xfe",
    "\xe2\x28\xa1",
  };

  for (size_t i = 0; i < G_N_ELEMENTS (bad); i += 1) {
    g_autofree char *text = g_strdup_printf ("0 0\n# %s", bad[i]);

    assert_refused (text, 2);
  }
}

static void
test_utf_8_agrees_with_glib (void)
{
  GRand *random = g_rand_new_with_seed (8);

  for (int i = 0; i < 20000; i += 1) {
    char text[6] = "#";
    SiteFileError error;
    SiteSet *set;

    for (int j = 1; j < 5; j += 1)
      text[j] = (char)(g_rand_boolean (random)
                           ? g_rand_int_range (random, 0x80, 0xc0)
                           : g_rand_int_range (random, 0xc0, 0x100));
    set = parse (text, &error);
    g_assert_cmpint (set != NULL, ==, g_utf8_validate (text, -1, NULL));
    site_set_free (set);
  }
  g_rand_free (random);
}

static void
test_line_that_leaves_the_range_is_named (void)
{
  assert_refused ("1e60 0\n# small\n1 1e-60\n2 2\n", 3);
}

static void
test_locale_does_not_matter (void)
{
  g_assert_nonnull (setlocale (LC_ALL, "de_DE.UTF-8"));
  assert_sites ("0.5 2", half_and_two, 1);
  assert_refused ("0,5 2,5", 1);
  setlocale (LC_ALL, "C");
}

static GString *
repeated (const char *head, const char *part, int n, const char *tail)
{
  GString *text = g_string_new (head);

  for (int i = 0; i < n; i += 1)
    g_string_append (text, part);
  return g_string_append (text, tail);
}

static void
read_long (GString *text)
{
  SiteFileError error;

  site_set_free (site_file_parse (text->str, text->len, &error));
  g_string_free (text, TRUE);
}

/* The time limit of the tests is the judge: these take a second, and
 * days if anything took time that grows with the square of the length. */
static void
test_reading_takes_linear_time (void)
{
  read_long (repeated ("#", "x", 16 << 20, "\n1 2\n"));
  read_long (repeated ("1.", "7", 4 << 20, " 2\n"));
  read_long (repeated ("1e", "9", 4 << 20, " 2\n"));
  read_long (repeated ("", "0", 4 << 20, "1 2\n"));
  read_long (repeated ("1", " ", 16 << 20, "2\n"));
  read_long (repeated ("", "1 2\n", 1 << 19, ""));
  read_long (repeated ("", "# c\n", 2 << 20, ""));
}

static void
test_long_numbers_are_read_exactly (void)
{
  GString *text = repeated ("0.5", "0", 1 << 20, " 2");

  assert_sites (text->str, half_and_two, 1);
  g_string_free (text, TRUE);
}

static void
test_more_than_ten_million_sites_are_refused (void)
{
  GString *text = repeated ("", "1 2\n", 10000001, "");

  assert_refused_bytes (text->str, text->len, 10000001);
  g_string_free (text, TRUE);
}

static void
test_written_files_read_back_the_same (void)
{
  const Site sites[] = { { -5e-324, 0 }, { 1e-310, 1. / 3 * 1e-290 } };
  SiteSet *set = site_set_new (sites, 2), *again;
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);
  SiteFileError error;

  g_assert_true (site_file_write (set, file));
  g_assert_cmpint (fclose (file), ==, 0);
  again = site_file_parse (text, length, &error);
  g_assert_cmpuint (again->n_sites, ==, 2);
  for (uint32_t i = 0; i < 2; i += 1) {
    g_assert_cmpfloat (site_set_given (again, i).x, ==, sites[i].x);
    g_assert_cmpfloat (site_set_given (again, i).y, ==, sites[i].y);
  }
  site_set_free (set);
  site_set_free (again);
  free (text);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/site-file/every-dress-of-a-line-is-read",
                   test_every_dress_of_a_line_is_read);
  g_test_add_func ("/site-file/empty-files-have-no-sites",
                   test_empty_files_have_no_sites);
  g_test_add_func ("/site-file/bad-lines-are-refused-with-their-number",
                   test_bad_lines_are_refused_with_their_number);
  g_test_add_func ("/site-file/bytes-that-are-no-text-are-refused",
                   test_bytes_that_are_no_text_are_refused);
  g_test_add_func ("/site-file/text-that-is-not-utf-8-is-refused",
                   test_text_that_is_not_utf_8_is_refused);
  g_test_add_func ("/site-file/utf-8-agrees-with-glib",
                   test_utf_8_agrees_with_glib);
  g_test_add_func ("/site-file/line-that-leaves-the-range-is-named",
                   test_line_that_leaves_the_range_is_named);
  g_test_add_func ("/site-file/locale-does-not-matter",
                   test_locale_does_not_matter);
  g_test_add_func ("/site-file/reading-takes-linear-time",
                   test_reading_takes_linear_time);
  g_test_add_func ("/site-file/long-numbers-are-read-exactly",
                   test_long_numbers_are_read_exactly);
  g_test_add_func ("/site-file/more-than-ten-million-sites-are-refused",
                   test_more_than_ten_million_sites_are_refused);
  g_test_add_func ("/site-file/written-files-read-back-the-same",
                   test_written_files_read_back_the_same);
  return g_test_run ();
}
