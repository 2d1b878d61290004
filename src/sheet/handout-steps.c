/* Four panels for each insertion: before, visible, cone, after; the plane
 * above space, a sentence below. */
#include "handout-private.h"

#include "stop-state.h"

#include <glib/gi18n.h>

#define N_PANELS 4
#define PANEL_GAP 9.0

/* Of many rounds so many are shown, evenly spread, the last among them. */
#define MOST_ROUNDS 24

/* Of many sites pictures are large, and nobody follows them on paper. */
#define MANY_SITES 200
#define MOST_ROUNDS_OF_MANY 4

/* Of many facets so many are named. */
#define MOST_NAMES 6

typedef struct Film {
  Handout *handout;
  Session *session; /* of these sites alone */
  const Trace *trace;
} Film;

/* Sentences */

static char *
facet_names (const Trace *trace, const RoundRow *round)
{
  GString *names = g_string_new (NULL);
  const guint n = round->last_visible - round->first_visible + 1;

  for (guint i = 0; i < MIN (n, MOST_NAMES); i++)
    g_string_append_printf (
        names, "%sf%u", i == 0 ? "" : ", ",
        trace_event (trace, round->first_visible - 1 + i).facet);
  if (n > MOST_NAMES)
    g_string_append (names, ", …");
  return g_string_free (names, FALSE);
}

static char *
visible_sentence (const Trace *trace, const RoundRow *round)
{
  const guint n = round->last_visible - round->first_visible + 1;
  g_autofree char *names = facet_names (trace, round);

  /* Translators: s4 sees 2 facets: f0, f1. */
  return g_strdup_printf (
      ngettext ("s%u sees %u facet: %s.", "s%u sees %u facets: %s.", n),
      round->site, n, names);
}

static char *
cone_sentence (const RoundRow *round)
{
  const guint n = round->last_cone - round->first_cone + 1;

  return g_strdup_printf (
      _ ("A cone of %u facets, one over each ridge of the horizon: %u = %u + "
         "2."),
      n, n, n - 2);
}

static char *
after_sentence (const Film *film, const RoundRow *round)
{
  const Frame *frame = session_get_frame (film->session);
  const guint n = round->last_retire - round->first_retire + 1;
  g_autofree char *retired = g_strdup_printf (
      ngettext ("%u facet retires.", "%u facets retire.", n), n);

  return g_strdup_printf (
      _ ("%s The hull has %u = 2·%u − 4 facets; the triangulation has %u "
         "triangles."),
      retired, frame->counts.facets, frame->counts.n_inserted,
      frame->counts.triangles);
}

/* Panels are narrow: no line ends within a formula. */
static char *
keep_formulas (const char *sentence)
{
  g_autoptr (GRegex) regex = g_regex_new (" ([=+−]) (?=[0-9])", 0, 0, NULL);

  return g_regex_replace (regex, sentence, -1, 0, "\302\240\\1\302\240", 0,
                          NULL);
}

/* Panels */

static const char *
panel_label (guint panel)
{
  static const char *const labels[N_PANELS]
      = { N_ ("Before"), N_ ("Visible"), N_ ("Cone"), N_ ("After") };

  return _ (labels[panel]);
}

static guint
panel_step (const RoundRow *round, guint panel)
{
  const guint steps[N_PANELS]
      = { round->select, round->last_visible, round->last_cone, round->end };

  return steps[panel];
}

static char *
panel_sentence (const Film *film, const RoundRow *round, guint panel)
{
  switch (panel) {
  case 0:
    return session_narrate (film->session);
  case 1:
    return visible_sentence (film->trace, round);
  case 2:
    return cone_sentence (round);
  default:
    return after_sentence (film, round);
  }
}

static Block *
panel_new (const Film *film, const RoundRow *round, guint panel, double width)
{
  Handout *handout = film->handout;
  const Appearance *appearance = &handout->options.appearance;
  const Moment moment
      = { film->session, MOMENT_NONE, MOMENT_SHOWN, panel_step (round, panel) };
  Block *stack = block_stack (width);
  g_autofree char *sentence = NULL, *kept = NULL;

  moment_enter (&moment);
  handout_tell_of (handout, film->session, MOMENT_SHOWN, MOMENT_PLANE);
  handout_tell_of (handout, film->session, MOMENT_SHOWN, MOMENT_SPACE);
  sentence = panel_sentence (film, round, panel);
  kept = keep_formulas (sentence);
  block_add (stack,
             handout_words (handout, TEXT_LABEL, width, panel_label (panel)));
  block_add_below (
      stack, moment_block (&moment, MOMENT_PLANE, appearance, width, width), 3);
  block_add_below (
      stack, moment_block (&moment, MOMENT_SPACE, appearance, width, width), 4);
  block_add_below (stack, handout_words (handout, TEXT_SMALL, width, kept), 4);
  return stack;
}

static void
add_round (const Film *film, guint round)
{
  Handout *handout = film->handout;
  const RoundRow *row = &film->trace->rounds[round - 1];
  const double width = (handout->width - (N_PANELS - 1) * PANEL_GAP) / N_PANELS;
  g_autofree char *title
      = g_strdup_printf (_ ("Round %u: s%u"), round, row->site);
  Block *stack = block_stack (handout->width);
  Block *columns = block_columns (PANEL_GAP);

  for (guint panel = 0; panel < N_PANELS; panel++)
    block_add (columns, panel_new (film, row, panel, width));
  stack->tag = "Sect";
  stack->title = g_strdup (title);
  stack->level = 2;
  block_add (stack,
             handout_words (handout, TEXT_HEADING, handout->width, title));
  block_add_below (stack, columns, PART_GAP);
  pages_add (handout->pages, stack, STOP_GAP);
}

static void
add_rounds (const Film *film)
{
  const guint n_rounds = film->trace->n_rounds;
  const gboolean is_many = film->trace->set->n_sites > MANY_SITES;
  const guint n_shown
      = MIN (n_rounds, is_many ? MOST_ROUNDS_OF_MANY : MOST_ROUNDS);

  for (guint i = 1; i <= n_shown; i++)
    add_round (film, (guint)((guint64)i * n_rounds / n_shown));
}

/* Runs */

static gboolean
is_run_before (const Lesson *lesson, guint stop)
{
  for (guint i = 0; i < stop; i++)
    if (lesson_stop (lesson, i)->state->run
        == lesson_stop (lesson, stop)->state->run)
      return TRUE;
  return FALSE;
}

/* A session without lesson shows every round in the same look. */
static Session *
session_of (const Run *run)
{
  Session *session = session_new ();
  g_autofree Site *sites = run_given (run);

  session_set_order (session, &run->trace->order);
  session_set_sites (session, sites, run->set->n_sites, NULL);
  session_set_focus (session, FOCUS_ACTIVE);
  return session;
}

static void
add_run (Handout *handout, guint stop)
{
  const LessonStop *row = lesson_stop (handout->lesson, stop);
  g_autoptr (Session) session = session_of (row->state->run);
  const Film film = { handout, session, session_get_trace (session) };
  /* Translators: a heading; the sites from this stop of a lesson on. */
  g_autofree char *title
      = g_strdup_printf (_ ("From stop %u on: %s"), stop + 1, row->title);
  Block *heading;

  if (film.trace->n_rounds == 0)
    return;
  heading = handout_words (handout, TEXT_LABEL, handout->width, title);
  heading->keeps = TRUE;
  pages_add (handout->pages, heading, STOP_GAP);
  add_rounds (&film);
}

static guint
count_rounds (const Lesson *lesson)
{
  guint n = 0;

  for (guint i = 0; i < lesson->stops->len; i++)
    n += lesson_stop (lesson, i)->state->run->trace->n_rounds;
  return n;
}

void
handout_add_steps (Handout *handout)
{
  handout_add_part (handout, _ ("Insertion by insertion"));
  if (count_rounds (handout->lesson) == 0)
    pages_add (handout->pages,
               handout_words (handout, TEXT_BODY, handout->width,
                              _ ("No site of this lesson is inserted: its "
                                 "lifts lie in one plane.")),
               PART_GAP);
  for (guint i = 0; i < handout->lesson->stops->len; i++)
    if (!is_run_before (handout->lesson, i))
      add_run (handout, i);
}
