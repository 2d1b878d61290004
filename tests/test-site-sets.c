/* The facts of the curated site sets, worked out in rational arithmetic
 * before the engine was written. Lessons are built on them. */
#include "fixture.h"

typedef struct Kinds {
  guint lower, upper, vertical;
} Kinds;

static void
add_kind (Kinds *kinds, Facing facing)
{
  kinds->lower += facing == FACING_LOWER;
  kinds->upper += facing == FACING_UPPER;
  kinds->vertical += facing == FACING_VERTICAL;
}

/* Appends "2L1U"; "0" for none. */
static void
write_kinds (GString *text, Kinds kinds)
{
  if (kinds.lower + kinds.upper + kinds.vertical == 0)
    g_string_append_c (text, '0');
  if (kinds.lower > 0)
    g_string_append_printf (text, "%uL", kinds.lower);
  if (kinds.upper > 0)
    g_string_append_printf (text, "%uU", kinds.upper);
  if (kinds.vertical > 0)
    g_string_append_printf (text, "%uV", kinds.vertical);
}

static Kinds
standing_kinds (const Trace *trace, uint32_t step)
{
  Kinds kinds = { 0, 0, 0 };

  for (uint32_t i = 0; i < trace->n_facets; i++)
    if (span_has (trace->facets[i].span, step))
      add_kind (&kinds, trace->facets[i].facing);
  return kinds;
}

/* Appends the kinds of the facets of the events from one step to another. */
static void
write_events (GString *text, const Trace *trace, uint32_t first, uint32_t last)
{
  Kinds kinds = { 0, 0, 0 };

  for (uint32_t step = first; step <= last; step++)
    add_kind (&kinds,
              trace->facets[trace_event (trace, step - 1).facet].facing);
  write_kinds (text, kinds);
}

/* "2L2U: s4 2L>4L, s5 1L1U>3L1U: 6L2U" — the simplex; each round's site, the
 * facets it sees and its cone; the end. */
static char *
describe (const Trace *trace)
{
  GString *text = g_string_new (NULL);

  write_kinds (text, standing_kinds (trace, trace->simplex_end));
  for (uint32_t i = 0; i < trace->n_rounds; i++) {
    const RoundRow *row = &trace->rounds[i];

    g_string_append_printf (text, "%s s%u ", i == 0 ? ":" : ",", row->site);
    write_events (text, trace, row->first_visible, row->last_visible);
    g_string_append_c (text, '>');
    write_events (text, trace, row->first_cone, row->last_cone);
  }
  g_string_append (text, ": ");
  write_kinds (text, standing_kinds (trace, trace->n_events));
  return g_string_free (text, FALSE);
}

typedef struct Story {
  const char *name;
  bool is_any_order; /* --order input gives the same rounds */
  const char *rounds;
} Story;

static const Story stories[] = {
  { "lecture8", true, "2L2U: s4 2L>4L, s5 1L>3L, s6 3L>5L, s7 4L>6L: 10L2U" },
  { "lecture8b", true, "2L2U: s4 2L>4L, s5 1L>3L, s6 3L>5L, s7 2L>4L: 10L2U" },
  { "mixed8", true,
    "2L2U: s4 2L>3L1U, s5 3U>3L2U, s6 3L>5L, s7 1L1U>3L1U: 10L2U" },
  { "base4-in", true, "2L2U: s4 2L>4L: 4L2U" },
  { "base4-outl", true, "2L2U: s4 1L>2L1U: 3L3U" },
  { "base4-outlu", true, "2L2U: s4 1L1U>2L2U: 3L3U" },
  { "base4-outu", true, "2L2U: s4 1U>1L2U: 3L3U" },
  { "cross5", true, "2L2U: s4 1L1U>3L1U: 4L2U" },
  { "convex4", true, "2L2U: 2L2U" },
  { "inner4", true, "3L1U: 3L1U" },
  { "line3-1", true, "2L1U1V: 2L1U1V" },
  { "square5", true, "2L1U1V: s3 1V>2L1U: 4L2U" },
  { "tie6", true, "3L1U: s4 2L>4L, s5 2L>4L: 7L1U" },
  { "wheel8", false,
    "2L2U: s7 2L>3L1U, s5 2U>2L2U, s6 1L2U>2L3U, s4 1L>2L1U: 7L5U" },
  { "grid9", false,
    "2L1U1V: s4 1L>2L1U, s6 2U>1L1U2V, s8 1V>2L1U, s5 1L>2L1V, s7 1L>2L1V: "
    "8L2U4V" },
  { "vertical5", true, "2L1U1V: s4 1V>2L1U: 4L2U" },
  { "near-far6", true, "2L2U: s4 1L>3L, s5 1L>2L1U: 5L3U" },
  { "gap6", true, "3L1U: s4 1L>2L1U, s5 1L>2L1U: 5L3U" },
  { "furthest8", false,
    "2L2U: s5 2L>4L, s4 1L1U>2L2U, s6 2L>4L, s7 2L>4L: 9L3U" },
  { "obtuse6", true, "2L2U: s4 2L>4L, s5 2L>3L1U: 5L3U" },
  { "flip5-in", true, "2L2U: s4 2U>1L3U: 3L3U" },
  { "flip5-tie", true, "2L2U: s3 1U>1L2U: 3L3U" },
  { "flip5-out", true, "2L2U: s4 2U>1L3U: 3L3U" },
  { "mwt4", true, "2L2U: 2L2U" },
};

static void
test_story (gconstpointer data)
{
  const Story *story = data;
  g_autoptr (Fixture) fixture = fixture_load (story->name, ORDER_FURTHEST);
  g_autoptr (Fixture) by_input = fixture_load (story->name, ORDER_INPUT);
  g_autofree char *rounds = describe (fixture->trace);
  g_autofree char *input_rounds = describe (by_input->trace);

  g_assert_cmpstr (rounds, ==, story->rounds);
  if (story->is_any_order)
    g_assert_cmpstr (input_rounds, ==, story->rounds);
  else
    g_assert_cmpstr (input_rounds, !=, story->rounds);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (stories); i++) {
    g_autofree char *path = g_strdup_printf (
        "/site-sets/the-rounds-of-%s-are-known", stories[i].name);

    g_test_add_data_func (path, &stories[i], test_story);
  }
  return g_test_run ();
}
