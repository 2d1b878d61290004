#include "document.h"
#include "point-import.h"

#include <glib/gstdio.h>
#include <string.h>

static SiteSet *
parse (const char *text, gboolean *is_foreign, GError **error)
{
  return point_import_parse (text, strlen (text), "p", is_foreign, error);
}

static void
test_tables_and_rbox_text_are_read (void)
{
  static const struct {
    const char *text;
    guint n_sites;
    gboolean is_foreign;
  } rows[] = {
    { "0.5 0.25\n1 2\n", 2, FALSE },
    { "", 0, FALSE },
    { "x,y\n0.5,0.25\n1,2\n", 2, TRUE },
    { "\xef\xbb\xbf\"lon\";\"lat\"\r\n0.5;0.25\r\n", 1, TRUE },
    { "# made by hand\n\neast\tnorth\n0.5\t0.25\n", 1, TRUE },
    { "2 rbox 3 D2\n3\n0.5 0.25\n1 1\n2 0\n", 3, TRUE },
    { "2\n2\n0.5 0.25\n1 1", 2, TRUE },
    { "2\n0\n", 0, TRUE },
    { "0,5;0,25\n-0,125;3\n", 2, TRUE },
    { "x;y\r\n0,5;0,25\r\n# a,b\r\n1;2\r\n", 2, TRUE },
    /* Two numbers are a site, whatever they might mean elsewhere. */
    { "2 3\n0.5 0.25\n", 2, FALSE },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autoptr (GError) error = NULL;
    gboolean is_foreign;
    SiteSet *set = parse (rows[i].text, &is_foreign, &error);

    g_assert_no_error (error);
    g_assert_cmpuint (set->n_sites, ==, rows[i].n_sites);
    g_assert_cmpint (is_foreign, ==, rows[i].is_foreign);
    if (set->n_sites > 0 && i + 1 < G_N_ELEMENTS (rows))
      g_assert_cmpfloat (site_set_given (set, 0).x, ==, 0.5);
    site_set_free (set);
  }
}

#define DECIMALS "a comma stands between numbers: write decimals with a point"

/* All else is refused as in point files, by its line in the whole text. */
static void
test_all_else_is_refused_by_its_line (void)
{
  static const char *const rows[][2] = {
    { "x,y\n", "p:1: " },
    { "x,y\na,b\n", "p:2: " },
    { "x,y\n1,2\n3;z\n", "p:3: " },
    { "x,y,z\n1,2,3\n", "p:1: " },
    { "x\n1 2\n", "p:1: " },
    { "nan,inf\n1,2\n", "p:1: " },
    { "x;y\n1,500;2\n12,250;-3,125\n", "p:2: " DECIMALS },
    { "1,5;2,5\n1.5;2\n", "p:1: " DECIMALS },
    { "1 1\n-1,5\t2\n", "p:2: " DECIMALS },
    { "1,5,2,5\n", "p:1: expected exactly two numbers, found more" },
    { "1, 2, 3\n", "p:1: expected exactly two numbers, found more" },
    { "1.234,5;2,5\n", "p:1: " },
    { "x,1\n1,2\n", "p:1: " },
    { "0x1,y\n1,2\n", "p:1: " },
    { "2\n3\n1 1\n2 2\n",
      "p:2: the number of points is given as 3, but 2 follow" },
    { "2\n1\n1 1\n2 2\n",
      "p:2: the number of points is given as 1, but 2 follow" },
    { "#\n3 rbox 1 D3\n1\n1 1 1\n",
      "p:2: expected exactly two columns, x and y, found 3" },
    { "\nx,y,z\n1,2,3\n",
      "p:2: expected exactly two columns, x and y, found 3" },
    { "1,2\n1,2,3\n", "p:2: expected exactly two numbers, found more" },
    { "x y\n1 2\n1 2 3 4\n", "p:3: expected exactly two numbers, found more" },
    { "Dear reader,\nsee below\n", "p:1: expected two decimal numbers" },
    { "Dear kind reader\nsee below\n", "p:1: expected two decimal numbers" },
    { "x y\n1 2 z\n", "p:2: expected nothing after the second number" },
    { "2\n1.5\n1 1\n", "p:1: " },
    { "2\n2\n1 1\n\n# …\n1 x\n", "p:6: " },
    { "x,\x01\n1,2\n", "p:1: " },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autoptr (GError) error = NULL;

    g_assert_null (parse (rows[i][0], NULL, &error));
    g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_REFUSED);
    if (!g_str_has_prefix (error->message, rows[i][1]))
      g_error ("%u: %s", i, error->message);
  }
}

/* hull2vd-cli and lessons read point files alone. */
static void
test_point_files_stay_strict (void)
{
  static const char table[] = "x,y\n1,2\n", rbox[] = "2\n1\n1 2\n";
  static const char decimals[] = "0 0\n1,5;2,5\n";
  g_autoptr (GError) error = NULL;

  g_assert_null (document_parse_points (table, strlen (table), "p", NULL));
  g_assert_null (document_parse_points (rbox, strlen (rbox), "p", NULL));
  g_assert_null (
      document_parse_points (decimals, strlen (decimals), "p", &error));
  g_assert_true (g_str_has_prefix (error->message, "p:2: " DECIMALS));
}

static void
test_a_refused_text_changes_nothing (void)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;

  g_assert_true (
      point_import_text (session, "1 2\n3 4\n", "clipboard", "paste", NULL));
  g_assert_cmpstr (session_get_undo_label (session), ==, "Undo paste");
  g_assert_false (point_import_text (session, "x y\n1 2\n1 z\n", "clipboard",
                                     "paste", &error));
  g_assert_true (g_str_has_prefix (error->message, "clipboard:3: "));
  g_clear_error (&error);
  g_assert_false (
      point_import_text (session, " \n# -\n", "clipboard", "paste", &error));
  g_assert_cmpstr (error->message, ==, "clipboard: there are no points in it");
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  g_assert_true (session_undo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 0);
}

static void
test_a_table_opens_as_points (void)
{
  g_autofree char *folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "t.csv", NULL);
  g_autoptr (Session) session = session_new ();
  gboolean is_foreign = FALSE;

  g_file_set_contents (path, "x,y\n0.1,1e-9\n0.2,3\n", -1, NULL);
  g_assert_true (point_import_open (session, path, &is_foreign, NULL));
  g_assert_true (is_foreign);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 2);
  g_unlink (path);
  g_rmdir (folder);
}

static void
test_commas_of_spreadsheets_are_decimal (void)
{
  SiteSet *set = parse ("1,5;-0,125\n1e2;2,25\n", NULL, NULL);

  g_assert_nonnull (set);
  g_assert_true (site_set_given (set, 0).x == 1.5);
  g_assert_true (site_set_given (set, 0).y == -0.125);
  g_assert_true (site_set_given (set, 1).x == 100);
  g_assert_true (site_set_given (set, 1).y == 2.25);
  site_set_free (set);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/point-import/tables-and-rbox-text-are-read",
    test_tables_and_rbox_text_are_read },
  { "/point-import/all-else-is-refused-by-its-line",
    test_all_else_is_refused_by_its_line },
  { "/point-import/commas-of-spreadsheets-are-decimal",
    test_commas_of_spreadsheets_are_decimal },
  { "/point-import/point-files-stay-strict", test_point_files_stay_strict },
  { "/point-import/a-refused-text-changes-nothing",
    test_a_refused_text_changes_nothing },
  { "/point-import/a-table-opens-as-points", test_a_table_opens_as_points },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
