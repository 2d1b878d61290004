/* Listings: what was printed is word for word and not run; what is corrected
 * follows the events. */
#include "fixture.h"
#include "listing.h"

#include <glib.h>

static void
test_names_are_read_back (void)
{
  for (int i = 0; i < N_LISTINGS; i++) {
    Listing listing = N_LISTINGS;

    g_assert_true (listing_parse (listing_name ((Listing)i), &listing));
    g_assert_cmpint (listing, ==, i);
  }
}

/* Pseudo-code 1 and 2 of the paper have 13 and 20 numbered lines. */
static void
test_printed_lines_are_numbered (void)
{
  static const struct {
    Listing listing;
    uint32_t n_lines;
  } printed[] = { { LISTING_HULL_2004, 13 }, { LISTING_DIAGRAMS_2004, 20 } };

  for (guint k = 0; k < G_N_ELEMENTS (printed); k++) {
    uint32_t n_lines;
    const PseudocodeLine *lines = listing_lines (printed[k].listing, &n_lines);

    g_assert_cmpuint (n_lines, ==, printed[k].n_lines);
    for (uint32_t i = 0; i < n_lines; i++) {
      g_autofree char *number = g_strdup_printf ("%u: ", i + 1);

      g_assert_true (g_str_has_prefix (lines[i].text, number));
    }
  }
}

/* Returns: the text of the line at @step, or NULL. */
static const char *
text_at (Listing listing, const Trace *trace, uint32_t step)
{
  uint32_t n_lines;
  const PseudocodeLine *lines = listing_lines (listing, &n_lines);
  const uint32_t line = listing_line (listing, trace, step);

  if (line == INDEX_NONE)
    return NULL;
  g_assert_cmpuint (line, <, n_lines);
  return lines[line].text;
}

static void
test_only_what_runs_has_a_line (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  const Trace *trace = fixture->trace;

  for (uint32_t step = 1; step <= trace->n_events; step++) {
    const EventKind kind = trace_event (trace, step - 1).kind;
    const char *text = text_at (LISTING_HULL_CORRECTED, trace, step);

    g_assert_null (text_at (LISTING_HULL_2004, trace, step));
    g_assert_null (text_at (LISTING_DIAGRAMS_2004, trace, step));
    g_assert_nonnull (text_at (LISTING_QUICKHULL, trace, step));
    if (kind == EVENT_VISIBLE)
      g_assert_cmpstr (text, ==, "if p sees f, add f to F");
    if (kind == EVENT_CONE)
      g_assert_cmpstr (text, ==, "add the facet of the ridge and p to CH(P)");
    if (kind == EVENT_RETIRE)
      g_assert_cmpstr (text, ==, "remove the facets of F from CH(P)");
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/listing/names-are-read-back", test_names_are_read_back);
  g_test_add_func ("/listing/printed-lines-are-numbered-as-in-the-paper",
                   test_printed_lines_are_numbered);
  g_test_add_func ("/listing/only-what-runs-has-a-current-line",
                   test_only_what_runs_has_a_line);
  return g_test_run ();
}
