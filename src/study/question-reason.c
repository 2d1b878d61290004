#include "question-reason.h"

#include "why.h"

#include <glib/gi18n.h>
#include <math.h>

/* Signs and numbers */

static int
side_of (const Trace *trace, guint site, guint facet)
{
  const Site *sites = trace->set->sites;
  const uint32_t *corner = trace->facets[facet].site;

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[site]);
}

gboolean
question_sees (const Trace *trace, guint site, guint facet)
{
  return side_of (trace, site, facet) > 0;
}

int
question_further (const Trace *trace, guint facet, guint p, guint q)
{
  const Site *sites = trace->set->sites;
  const uint32_t *corner = trace->facets[facet].site;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };

  return lift_further (plane, &sites[p], &sites[q]);
}

/* Returns: (transfer full): the power of a site with respect to the circle
 *          of a facet, in coordinates as given, without its sign, which the
 *          sentence tells: "0.03". */
static char *
power_text (const Trace *trace, guint site, guint facet)
{
  const double power
      = fabs (why_power (trace->set, trace->facets[facet].site, site).value);
  char text[G_ASCII_DTOSTR_BUF_SIZE];

  return g_strdup (g_ascii_formatd (text, sizeof text,
                                    power < 0.001 ? "%.1g" : "%.2g", power));
}

/* Who sees what */

static char *
lower_sentence (int side, guint site, guint facet, const char *power)
{
  if (side == 0)
    return g_strdup_printf (
        _ ("s%u does not see f%u: it lies exactly on f%u’s circle."), site,
        facet, facet);
  return g_strdup_printf (
      side > 0 ? _ ("s%u sees f%u: it lies inside f%u’s circle, by a power of "
                    "−%s.")
               : _ ("s%u does not see f%u: it lies outside f%u’s circle, by a "
                    "power of %s."),
      site, facet, facet, power);
}

static char *
upper_sentence (int side, guint site, guint facet, const char *power)
{
  if (side == 0)
    return g_strdup_printf (
        _ ("s%u does not see f%u, an upper facet: it lies exactly on f%u’s "
           "circle."),
        site, facet, facet);
  return g_strdup_printf (
      side > 0 ? _ ("s%u sees f%u, an upper facet: it lies outside f%u’s "
                    "circle, by a power of %s.")
               : _ ("s%u does not see f%u, an upper facet: it lies inside "
                    "f%u’s circle, by a power of −%s."),
      site, facet, facet, power);
}

static char *
sees_sentence (const Trace *trace, guint site, guint facet)
{
  const int side = side_of (trace, site, facet);
  g_autofree char *power = NULL;

  if (trace->facets[facet].facing == FACING_VERTICAL)
    return g_strdup_printf (
        side > 0 ? _ ("s%u sees f%u, a vertical facet: it lies strictly beyond "
                      "this hull edge.")
                 : _ ("s%u does not see f%u, a vertical facet: it does not lie "
                      "strictly beyond this hull edge."),
        site, facet);
  power = power_text (trace, site, facet);
  return trace->facets[facet].facing == FACING_LOWER
             ? lower_sentence (side, site, facet, power)
             : upper_sentence (side, site, facet, power);
}

REASON (reason_visible)
{
  const guint site = occasion_round (occasion)->site;
  const gboolean sees = question_sees (occasion->trace, site, object.number);

  if (!sees || !g_str_equal (question->click->name, "dying-triangles")
      || occasion->trace->facets[object.number].facing == FACING_LOWER)
    return sees_sentence (occasion->trace, site, object.number);
  return g_strdup_printf (
      _ ("s%u sees f%u, but that is not a lower facet: it has no triangle."),
      site, object.number);
}

REASON (reason_sees_argument)
{
  if (occasion->trace->inserted[object.number] <= occasion->step)
    return g_strdup_printf (_ ("s%u does not wait: it is on the hull already."),
                            object.number);
  return sees_sentence (occasion->trace, object.number,
                        question->argument.number);
}

REASON (reason_argument_sees)
{
  return sees_sentence (occasion->trace, question->argument.number,
                        object.number);
}

/* Sites are handed over to facets that have just been born. */
REASON (reason_hand_over)
{
  const FacetRow *row = &occasion->trace->facets[object.number];
  const guint site = question->argument.number;

  if (row->round == occasion->round)
    return sees_sentence (occasion->trace, site, object.number);
  return g_strdup_printf (
      row->seen <= occasion->step
          ? _ ("s%u cannot be handed over to f%u: it is visible and will "
               "retire.")
          : _ ("s%u is not handed over to f%u: it is not a facet of the cone."),
      site, object.number);
}

REASON (reason_circle)
{
  const guint site = occasion_round (occasion)->site;
  const int side = side_of (occasion->trace, site, object.number);
  g_autofree char *power = power_text (occasion->trace, site, object.number);

  if (side == 0)
    return g_strdup_printf (
        _ ("The circle of f%u does not contain s%u: it lies exactly on it."),
        object.number, site);
  return g_strdup_printf (
      side > 0 ? _ ("The circle of f%u contains s%u: it lies inside, by a "
                    "power of −%s.")
               : _ ("The circle of f%u does not contain s%u: it lies outside, "
                    "by a power of %s."),
      object.number, site, power);
}

/* Ridges */

REASON (reason_horizon)
{
  const RidgeRow row = trace_ridge (occasion->trace, object.number);
  const guint site = occasion_round (occasion)->site;
  const gboolean left = question_sees (occasion->trace, site, row.facet[0]);
  const gboolean right = question_sees (occasion->trace, site, row.facet[1]);

  if (left != right)
    return g_strdup_printf (
        _ ("Ridge s%u s%u is on the horizon: s%u sees f%u on one side of it, "
           "but not f%u on the other."),
        row.site[0], row.site[1], site, row.facet[left ? 0 : 1],
        row.facet[left ? 1 : 0]);
  return g_strdup_printf (
      left ? _ ("Ridge s%u s%u is not on the horizon: s%u sees the facets on "
                "both sides of it, f%u and f%u.")
           : _ ("Ridge s%u s%u is not on the horizon: s%u sees neither of the "
                "facets beside it, f%u and f%u."),
      row.site[0], row.site[1], site, row.facet[0], row.facet[1]);
}

/* The cone facet over a ridge, or INDEX_NONE. */
static guint
cone_over (const Occasion *occasion, const RidgeRow *row)
{
  const RoundRow *round = occasion_round (occasion);

  for (guint i = round->first_cone - 1; i < round->last_cone; i++) {
    const Event event = trace_event (occasion->trace, i);

    if ((event.ridge[0] == row->site[0] && event.ridge[1] == row->site[1])
        || (event.ridge[0] == row->site[1] && event.ridge[1] == row->site[0]))
      return event.facet;
  }
  return INDEX_NONE;
}

REASON (reason_new_triangle)
{
  const RidgeRow row = trace_ridge (occasion->trace, object.number);
  const guint facet = cone_over (occasion, &row);
  const char *sentence;

  if (facet == INDEX_NONE)
    return g_strdup_printf (
        _ ("Ridge s%u s%u is not on the horizon: no facet will be born over "
           "it."),
        row.site[0], row.site[1]);
  switch (occasion->trace->facets[facet].facing) {
  case FACING_LOWER:
    sentence = _ ("Over ridge s%u s%u a lower facet is born: its shadow is a "
                  "new triangle.");
    break;
  case FACING_UPPER:
    sentence = _ ("Over ridge s%u s%u an upper facet is born: it has no "
                  "triangle in the plane.");
    break;
  case FACING_VERTICAL:
  default:
    sentence = _ ("Over ridge s%u s%u a vertical facet is born: its shadow is "
                  "only a segment.");
    break;
  }
  return g_strdup_printf (sentence, row.site[0], row.site[1]);
}

/* Facets */

REASON (reason_facing)
{
  switch (occasion->trace->facets[object.number].facing) {
  case FACING_LOWER:
    return g_strdup_printf (_ ("f%u is a lower facet: it faces down, and its "
                               "shadow is a triangle of the plane."),
                            object.number);
  case FACING_UPPER:
    return g_strdup_printf (
        _ ("f%u is an upper facet: it faces away from the plane."),
        object.number);
  case FACING_VERTICAL:
    break;
  }
  return g_strdup_printf (
      _ ("f%u is a vertical facet: it stands over a straight hull edge."),
      object.number);
}

/* Outside sets */

/* The facet whose outside set the site is in, or INDEX_NONE. */
static guint
claimed_by (const Occasion *occasion, guint site)
{
  for (guint i = 0; i < occasion->trace->n_claims; i++)
    if (trace_claim (occasion->trace, i).site == site
        && span_has (trace_claim (occasion->trace, i).span, occasion->step))
      return trace_claim (occasion->trace, i).facet;
  return INDEX_NONE;
}

static char *
member_sentence (const Occasion *occasion, guint site, guint facet)
{
  const guint by = claimed_by (occasion, site);

  if (by == facet)
    return g_strdup_printf (_ ("s%u is in the outside set of f%u."), site,
                            facet);
  if (by == INDEX_NONE)
    return g_strdup_printf (_ ("s%u does not wait: it is in no outside set."),
                            site);
  return g_strdup_printf (
      _ ("s%u is not in the outside set of f%u: it is in that of f%u, and each "
         "waiting site is in only one."),
      site, facet, by);
}

REASON (reason_member)
{
  return member_sentence (occasion, object.number, question->argument.number);
}

REASON (reason_outside_set)
{
  for (guint i = 0; i < occasion->trace->n_claims; i++)
    if (trace_claim (occasion->trace, i).facet == object.number
        && span_has (trace_claim (occasion->trace, i).span, occasion->step))
      return g_strdup_printf (
          _ ("The outside set of f%u is not empty: s%u is in it."),
          object.number, trace_claim (occasion->trace, i).site);
  return g_strdup_printf (_ ("The outside set of f%u is empty."),
                          object.number);
}

REASON (reason_furthest)
{
  const RoundRow *round = occasion_round (occasion);
  const guint facet = round->facet;
  g_autoptr (GArray) best = g_array_new (FALSE, FALSE, sizeof (Object));
  guint furthest;

  if (claimed_by (occasion, object.number) != facet)
    return member_sentence (occasion, object.number, facet);
  question->click->collect (question, occasion, frame, best);
  furthest = g_array_index (best, Object, 0).number;
  if (question_further (occasion->trace, facet, object.number, furthest) < 0)
    return g_strdup_printf (
        _ ("s%u is not the furthest from f%u: s%u lies further in front of "
           "it."),
        object.number, facet, furthest);
  return g_strdup_printf (
      _ ("No site of the outside set lies further in front of f%u than s%u."),
      facet, object.number);
}

/* Cells */

static gboolean
is_on_boundary (const Frame *frame, guint site, gboolean *is_corner)
{
  const Delaunay *delaunay = &frame->delaunay;

  for (guint i = 0; i < delaunay->n_boundary; i++)
    if (delaunay->boundary[i] == site) {
      *is_corner = delaunay_is_extreme (delaunay, i);
      return TRUE;
    }
  return FALSE;
}

static gboolean
has_cell (const Frame *frame, guint site)
{
  return frame->sites[site].state == SITE_INSERTED;
}

static char *
no_cell_sentence (guint site)
{
  return g_strdup_printf (_ ("s%u is not on the hull yet: it has no cell."),
                          site);
}

REASON (reason_unbounded)
{
  gboolean is_corner;

  if (!has_cell (frame, object.number))
    return no_cell_sentence (object.number);
  return g_strdup_printf (
      is_on_boundary (frame, object.number, &is_corner)
          ? _ ("The cell of s%u is unbounded: s%u lies on the boundary of the "
               "hull in the plane.")
          : _ ("The cell of s%u is bounded: s%u lies inside the hull in the "
               "plane."),
      object.number, object.number);
}

REASON (reason_corner)
{
  gboolean is_corner = FALSE;

  if (!has_cell (frame, object.number))
    return no_cell_sentence (object.number);
  if (!is_on_boundary (frame, object.number, &is_corner))
    return g_strdup_printf (
        _ ("s%u is not a corner: it lies inside the hull in the plane."),
        object.number);
  return g_strdup_printf (is_corner
                              ? _ ("s%u is a corner of the hull in the plane.")
                              : _ ("s%u is not a corner: it lies on an edge of "
                                   "the hull, between two corners."),
                          object.number);
}

static char *
neighbours_sentence (const Frame *frame, guint site, guint other)
{
  for (guint i = 0; i < frame->delaunay.n_edges; i++) {
    const DelaunayEdge *edge = &frame->delaunay.edges[i];

    if (edge->site[0] + edge->site[1] == site + other
        && (edge->site[0] == site || edge->site[1] == site))
      return g_strdup_printf (
          edge->is_free
              ? _ ("The cells of s%u and s%u have one point in common but no "
                   "side: the two lie on one empty circle with others.")
              : _ ("The cells of s%u and s%u have a side in common, and a "
                   "Delaunay edge joins the two."),
          site, other);
  }
  return g_strdup_printf (
      _ ("The cells of s%u and s%u have no side in common."), site, other);
}

REASON (reason_neighbour)
{
  const guint site = question->argument.number;

  if (object.number == site)
    return g_strdup_printf (_ ("s%u is the site itself."), site);
  if (!has_cell (frame, object.number))
    return no_cell_sentence (object.number);
  return neighbours_sentence (frame, site, object.number);
}

REASON (reason_duplicate)
{
  const guint first = occasion->trace->set->first[object.number];

  return first != object.number
             ? g_strdup_printf (_ ("s%u equals s%u."), object.number, first)
             : g_strdup_printf (_ ("s%u equals no earlier site."),
                                object.number);
}

/* Conditions */

char *
reason_condition (const Condition *condition,
                  const Occasion *occasion,
                  const Frame *frame)
{
  static const char *const facings[]
      = { "is-lower", "is-upper", "is-vertical", NULL };
  static const char *const cells[] = { "bounded", "unbounded", NULL };
  guint arguments[2];
  const char *word = condition_word (condition, arguments);

  if (word == NULL)
    return NULL;
  if (g_str_equal (word, "sees"))
    return sees_sentence (occasion->trace, arguments[0], arguments[1]);
  if (g_strv_contains (facings, word))
    return reason_facing (NULL, occasion, frame,
                          (Object){ OBJECT_FACET, arguments[0] });
  if (g_strv_contains (cells, word))
    return reason_unbounded (NULL, occasion, frame,
                             (Object){ OBJECT_SITE, arguments[0] });
  if (g_str_equal (word, "neighbours") && has_cell (frame, arguments[0])
      && has_cell (frame, arguments[1]))
    return neighbours_sentence (frame, arguments[0], arguments[1]);
  return NULL;
}
