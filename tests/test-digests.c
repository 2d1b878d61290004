/* Digests of many traces, the same whatever the compiler, the optimization,
 * the locale and the time of day: the sets of rbox.c in every order. The
 * program is built with and without optimization. tests/README.md tells how
 * to renew them. */
#include "fixture.h"
#include "rbox.h"
#include "trace-file.h"

#include <locale.h>
#include <stdlib.h>

enum { N_SEEDS = 1, N_SITES = 80 };

/* Returns: (transfer full): the digest of the text of a trace file. */
static char *
digest_of (const SiteSet *set, const Order *order)
{
  Trace *trace = trace_record (set, order);
  char *text = NULL, *digest;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);

  g_assert_true (trace_file_write (trace, GRAIN_EVENT, file));
  g_assert_cmpint (fclose (file), ==, 0);
  digest = g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *)text,
                                        length);
  trace_free (trace);
  free (text);
  return digest;
}

/* Returns: (transfer full): a line for every set and order. */
static char *
all_digests (void)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < N_SEEDS * N_RBOXES; i++) {
    SiteSet *set = rbox_new (i % N_RBOXES, i / N_RBOXES, N_SITES);

    for (OrderKind kind = ORDER_FURTHEST; kind < N_ORDERS; kind++) {
      g_autofree char *digest = digest_of (set, &(Order){ kind, 3 });

      g_string_append_printf (text, "%s %u %s %s\n", rbox_name (i % N_RBOXES),
                              i / N_RBOXES, order_kind_name (kind), digest);
    }
    site_set_free (set);
  }
  return g_string_free (text, FALSE);
}

static char *
golden_path (void)
{
  return fixture_path ("golden", "digests", ".txt");
}

/* Names the first set and order that differ. */
static void
assert_golden (void)
{
  g_autofree char *text = all_digests ();
  g_autofree char *path = golden_path ();
  g_autofree char *expected = NULL;
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_auto (GStrv) golden = NULL;

  g_assert_true (g_file_get_contents (path, &expected, NULL, NULL));
  golden = g_strsplit (expected, "\n", -1);
  g_assert_cmpuint (g_strv_length (lines), ==, g_strv_length (golden));
  for (guint i = 0; lines[i] != NULL; i++)
    g_assert_cmpstr (lines[i], ==, golden[i]);
}

static void
test_traces_are_the_same_twice (void)
{
  assert_golden ();
  assert_golden ();
}

static void
test_traces_are_the_same_in (gconstpointer locale)
{
  g_assert_nonnull (setlocale (LC_ALL, locale));
  assert_golden ();
  setlocale (LC_ALL, "C");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  if (g_getenv ("HULL2VD_RENEW_DIGESTS") != NULL) {
    g_autofree char *text = all_digests ();
    g_autofree char *path = golden_path ();

    return g_file_set_contents (path, text, -1, NULL) ? 0 : 1;
  }
  g_test_add_func ("/digests/traces-are-the-same-twice-in-a-row",
                   test_traces_are_the_same_twice);
  g_test_add_data_func ("/digests/traces-are-the-same-in-de_DE.UTF-8",
                        "de_DE.UTF-8", test_traces_are_the_same_in);
  g_test_add_data_func ("/digests/traces-are-the-same-in-ar_EG.UTF-8",
                        "ar_EG.UTF-8", test_traces_are_the_same_in);
  return g_test_run ();
}
