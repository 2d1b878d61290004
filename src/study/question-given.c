/* What the pictures show where a question is asked, in words. */
#include "number.h"
#include "object-name.h"
#include "question-bank.h"
#include "question-click.h"
#include "scene.h"

#include <glib/gi18n.h>

static void
append_site (GString *text, const SiteSet *set, guint site)
{
  const Site given = site_set_given (set, site);
  char x[NUMBER_ROOM], y[NUMBER_ROOM];

  number_write (given.x, x);
  number_write (given.y, y);
  g_string_append_printf (text, "%ss%u (%s, %s)", site == 0 ? "" : ", ", site,
                          x, y);
}

static char *
tell_sites (const SiteSet *set)
{
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < set->n_sites; i++)
    append_site (text, set, i);
  return g_strdup_printf (_ ("Sites: %s."), text->str);
}

/* Which sites are on the hull, unless all of them are. */
static char *
tell_hull (const Frame *frame)
{
  g_autoptr (GString) text = g_string_new (NULL);

  if (frame->trace->is_flat || frame->delaunay.n_active == 0)
    return NULL;
  if (frame->delaunay.n_active == frame->trace->set->n_distinct)
    return g_strdup (_ ("All sites are on the hull."));
  for (guint i = 0; i < frame->delaunay.n_active; i++)
    g_string_append_printf (text, "%ss%u", i == 0 ? "" : ", ",
                            frame->delaunay.active[i]);
  return g_strdup_printf (_ ("On the hull so far: %s."), text->str);
}

/* The current site, once it has been chosen. */
static char *
tell_apex (const Occasion *occasion)
{
  const RoundRow *round = occasion_round (occasion);

  if (round == NULL || occasion->step < round->select
      || occasion->step >= round->end)
    return NULL;
  return g_strdup_printf (_ ("s%u comes next."), round->site);
}

static char *
tell_order (const Trace *trace)
{
  if (trace->order.kind == ORDER_FURTHEST)
    return NULL;
  return g_strdup_printf (_ ("Order of insertion: %s."),
                          order_kind_name (trace->order.kind));
}

static char *
facet_text (const Question *question, const Trace *trace, guint facet)
{
  const FacetRow *row = &trace->facets[facet];

  if (question_mask (question) & MASK_FACING)
    return g_strdup_printf ("f%u (s%u s%u s%u)", facet, row->site[0],
                            row->site[1], row->site[2]);
  return g_strdup_printf ("f%u (s%u s%u s%u, %s)", facet, row->site[0],
                          row->site[1], row->site[2],
                          facing_name (row->facing));
}

/* The sites of the circle of a vertex, by number. */
static char *
vertex_text (const Frame *frame, guint facet)
{
  const Delaunay *delaunay = &frame->delaunay;
  guint group = INDEX_NONE;
  g_autoptr (GString) text = g_string_new (NULL);
  g_autofree gboolean *is_on = g_new0 (gboolean, frame->n_sites);

  for (guint i = 0; i < delaunay->n_triangles; i++)
    if (delaunay->triangles[i].facet == facet)
      group = delaunay->triangles[i].group;
  for (guint i = 0; i < delaunay->n_triangles; i++)
    for (guint k = 0; delaunay->triangles[i].group == group && k < 3; k++)
      is_on[delaunay->triangles[i].site[k]] = TRUE;
  for (guint i = 0; i < frame->n_sites; i++)
    if (is_on[i])
      g_string_append_printf (text, " s%u", i);
  return g_strdup_printf ("f%u (%s)", facet, text->str + 1);
}

char *
question_object_text (const Question *question,
                      const Frame *frame,
                      Object object)
{
  char name[OBJECT_NAME_ROOM];

  switch (object.kind) {
  case OBJECT_FACET:
    return facet_text (question, frame->trace, object.number);
  case OBJECT_VERTEX:
    return vertex_text (frame, object.number);
  case OBJECT_RIDGE: {
    const RidgeRow row = trace_ridge (frame->trace, object.number);

    return g_strdup_printf ("s%u–s%u", MIN (row.site[0], row.site[1]),
                            MAX (row.site[0], row.site[1]));
  }
  case OBJECT_SITE:
  case OBJECT_NONE:
    break;
  }
  object_name_write (object, name);
  return g_strdup (name);
}

/* The facets that prompt and options name, by their corners. */

static void
tell_facets_in (GPtrArray *lines,
                const char *text,
                const Question *question,
                const Frame *frame)
{
  g_autoptr (GRegex) regex = g_regex_new ("\\bf([0-9]{1,9})\\b", 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;

  for (g_regex_match (regex, text, 0, &match); g_match_info_matches (match);
       g_match_info_next (match, NULL)) {
    g_autofree char *digits = g_match_info_fetch (match, 1);
    const guint facet = (guint)g_ascii_strtoull (digits, NULL, 10);
    g_autofree char *line = NULL;

    if (facet >= frame->trace->n_facets
        || !span_has (frame->trace->facets[facet].span, frame->step))
      continue;
    line = facet_text (question, frame->trace, facet);
    if (!g_ptr_array_find_with_equal_func (lines, line, g_str_equal, NULL))
      g_ptr_array_add (lines, g_steal_pointer (&line));
  }
}

static void
tell_facets (GPtrArray *lines,
             const Question *question,
             const Occasion *occasion,
             const Frame *frame)
{
  g_autofree char *prompt = question_prompt (question, occasion);

  tell_facets_in (lines, prompt, question, frame);
  for (guint i = 0; i < question->options->len; i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    tell_facets_in (lines, option->text, question, frame);
    tell_facets_in (lines, condition_text (option->condition), question, frame);
  }
}

/* The outside set from which the furthest is to be taken. */
static char *
tell_outside_set (const Question *question, const Occasion *occasion)
{
  const RoundRow *round = occasion_round (occasion);
  const Trace *trace = occasion->trace;
  g_autoptr (GString) text = g_string_new (NULL);

  if (round == NULL || question->kind != QUESTION_CLICK
      || !g_str_equal (question->click->name, "furthest-site"))
    return NULL;
  for (guint i = 0; i < trace->n_claims; i++)
    if (trace_claim (trace, i).facet == round->facet
        && span_has (trace_claim (trace, i).span, occasion->step))
      g_string_append_printf (text, "%ss%u", text->len == 0 ? "" : ", ",
                              trace_claim (trace, i).site);
  return g_strdup_printf (_ ("Outside set of f%u: %s."), round->facet,
                          text->str);
}

static void
tell (GPtrArray *lines, char *line)
{
  if (line != NULL)
    g_ptr_array_add (lines, line);
}

GPtrArray *
question_given (const Question *question, const Occasion *occasion)
{
  GPtrArray *lines = g_ptr_array_new_with_free_func (g_free);
  Frame frame;

  /* What holds for all sites, or for none, needs no sites. */
  if (question->kind == QUESTION_ALWAYS
      || (question->kind == QUESTION_ORDER
          && question->order == ORDER_OF_PHASES))
    return lines;
  frame_init (&frame, occasion->trace, occasion->step);
  tell (lines, tell_sites (occasion->trace->set));
  tell (lines, tell_order (occasion->trace));
  tell (lines, tell_hull (&frame));
  tell (lines, tell_apex (occasion));
  tell_facets (lines, question, occasion, &frame);
  tell (lines, tell_outside_set (question, occasion));
  frame_clear (&frame);
  return lines;
}
