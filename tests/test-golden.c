/* Golden traces: what QuickHull says of a set, byte for byte, whatever the
 * compiler, the optimization and the locale. tests/README.md tells how to
 * renew them. */
#include "fixture.h"
#include "trace-file.h"

#include <locale.h>
#include <stdlib.h>

static const char *const golden[] = {
  "lecture8", "mixed8",  "grid9", "square5",    "tie6", "wheel8",
  "cross5",   "square4", "line4", "duplicates", "none", "point1",
};

/* Returns: (transfer full): the text of the trace file. */
static char *
write_trace (const Trace *trace)
{
  char *text = NULL;
  size_t length;
  FILE *file = open_memstream (&text, &length);

  g_assert_true (trace_file_write (trace, GRAIN_EVENT, file));
  g_assert_cmpint (fclose (file), ==, 0);
  return text;
}

/* Names the first line that differs. */
static void
assert_same_lines (const char *name, const char *text, const char *expected)
{
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_auto (GStrv) golden_lines = g_strsplit (expected, "\n", -1);
  guint i = 0;

  while (lines[i] != NULL && g_strcmp0 (lines[i], golden_lines[i]) == 0)
    i += 1;
  if (g_strcmp0 (lines[i], golden_lines[i]) != 0)
    g_error ("%s.trace:%u: \"%s\" was \"%s\"", name, i + 1,
             lines[i] == NULL ? "" : lines[i],
             golden_lines[i] == NULL ? "" : golden_lines[i]);
}

static void
assert_golden (const char *name)
{
  g_autoptr (Fixture) fixture = fixture_load (name, ORDER_FURTHEST);
  g_autofree char *path = fixture_path ("golden", name, ".trace");
  g_autofree char *expected = NULL;
  char *text = write_trace (fixture->trace);

  if (!g_file_get_contents (path, &expected, NULL, NULL))
    g_error ("%s cannot be read", path);
  assert_same_lines (name, text, expected);
  free (text);
}

static void
test_golden (gconstpointer name)
{
  assert_golden (name);
}

/* Locales with a decimal comma and with digits of their own. */
static void
test_locale (gconstpointer locale)
{
  g_assert_nonnull (setlocale (LC_ALL, locale));
  for (guint i = 0; i < G_N_ELEMENTS (golden); i++)
    assert_golden (golden[i]);
  setlocale (LC_ALL, "C");
}

int
main (int argc, char **argv)
{
  static const char *const locales[] = { "de_DE.UTF-8", "ar_EG.UTF-8" };

  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (golden); i++) {
    g_autofree char *path = g_strdup_printf (
        "/golden/the-trace-of-%s-is-the-same-byte-for-byte", golden[i]);

    g_test_add_data_func (path, golden[i], test_golden);
  }
  for (guint i = 0; i < G_N_ELEMENTS (locales); i++) {
    g_autofree char *path
        = g_strdup_printf ("/golden/traces-are-the-same-in-%s", locales[i]);

    g_test_add_data_func (path, locales[i], test_locale);
  }
  return g_test_run ();
}
