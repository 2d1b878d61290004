/* The words of conditions: what they mean, by exact signs. */
#include "condition-private.h"

#include <glib/gi18n.h>

static const Site *
site_at (const Situation *situation, guint site)
{
  return &situation->frame->trace->set->sites[site];
}

static gboolean
sees (const Trace *trace, guint facet, const Site *site)
{
  const Site *sites = trace->set->sites;
  const uint32_t *corner = trace->facets[facet].site;

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      site)
         > 0;
}

static gboolean
holds_sees (const Situation *situation, const guint arguments[2])
{
  return sees (situation->frame->trace, arguments[1],
               site_at (situation, arguments[0]));
}

static gboolean
is_facing (const Situation *situation, guint facet, Facing facing)
{
  return situation->frame->trace->facets[facet].facing == facing;
}

static gboolean
holds_lower (const Situation *situation, const guint arguments[2])
{
  return is_facing (situation, arguments[0], FACING_LOWER);
}

static gboolean
holds_upper (const Situation *situation, const guint arguments[2])
{
  return is_facing (situation, arguments[0], FACING_UPPER);
}

static gboolean
holds_vertical (const Situation *situation, const guint arguments[2])
{
  return is_facing (situation, arguments[0], FACING_VERTICAL);
}

/* The triangulation */

static gboolean
has_edge (const Delaunay *delaunay, guint a, guint b)
{
  for (guint i = 0; i < delaunay->n_edges; i++) {
    const uint32_t *site = delaunay->edges[i].site;

    if ((site[0] == a && site[1] == b) || (site[0] == b && site[1] == a))
      return TRUE;
  }
  return FALSE;
}

static gboolean
holds_neighbours (const Situation *situation, const guint arguments[2])
{
  return has_edge (&situation->frame->delaunay, arguments[0], arguments[1]);
}

static gboolean
holds_unbounded (const Situation *situation, const guint arguments[2])
{
  const Delaunay *delaunay = &situation->frame->delaunay;

  for (guint i = 0; i < delaunay->n_boundary; i++)
    if (delaunay->boundary[i] == arguments[0])
      return TRUE;
  return delaunay->n_active == 1 && delaunay->active[0] == arguments[0];
}

/* A site without a cell is neither. */
static gboolean
holds_bounded (const Situation *situation, const guint arguments[2])
{
  const FrameSite *row = &situation->frame->sites[arguments[0]];

  return row->state == SITE_INSERTED && !holds_unbounded (situation, arguments);
}

/* Returns: +1 when the site lies strictly inside the hull in the plane, 0 on
 *          its border, -1 outside. */
static int
side_of_hull (const Situation *situation, guint site)
{
  const Delaunay *delaunay = &situation->frame->delaunay;
  const Site *sites = situation->frame->trace->set->sites;
  int least = delaunay->dimension == 2 ? 1 : -1;

  for (guint i = 0; delaunay->dimension == 2 && i < delaunay->n_boundary; i++) {
    const uint32_t tail = delaunay->boundary[i];
    const uint32_t head = delaunay->boundary[(i + 1) % delaunay->n_boundary];
    const int side = orient (&sites[tail], &sites[head], &sites[site]);

    least = MIN (least, side);
  }
  return least;
}

static gboolean
holds_inside (const Situation *situation, const guint arguments[2])
{
  return side_of_hull (situation, arguments[0]) > 0;
}

static gboolean
holds_outside (const Situation *situation, const guint arguments[2])
{
  return side_of_hull (situation, arguments[0]) < 0;
}

static gboolean
holds_tie (const Situation *situation, const guint arguments[2])
{
  (void)arguments;
  return quantity_value (situation->frame, QUANTITY_FREE_EDGES) > 0;
}

static gboolean
holds_no_simplex (const Situation *situation, const guint arguments[2])
{
  (void)arguments;
  return situation->frame->trace->is_flat;
}

/* Whether the angle at @a is obtuse: then the centre lies beyond the side
 * across. On a grid that a hand can reach the products are exact. */
static gboolean
is_obtuse (const Site *a, const Site *b, const Site *c)
{
  return (b->x - a->x) * (c->x - a->x) + (b->y - a->y) * (c->y - a->y) < 0;
}

static gboolean
holds_vertex_outside (const Situation *situation, const guint arguments[2])
{
  const Delaunay *delaunay = &situation->frame->delaunay;
  const Site *sites = situation->frame->trace->set->sites;

  (void)arguments;
  for (guint i = 0; i < delaunay->n_triangles; i++) {
    const uint32_t *site = delaunay->triangles[i].site;

    for (guint k = 0; k < 3; k++)
      if (is_obtuse (&sites[site[k]], &sites[site[(k + 1) % 3]],
                     &sites[site[(k + 2) % 3]]))
        return TRUE;
  }
  return FALSE;
}

/* The drag */

static gboolean
has_same_boundary (const Delaunay *a, const Delaunay *b)
{
  if (a->n_boundary != b->n_boundary)
    return FALSE;
  for (guint i = 0; i < a->n_boundary; i++)
    if (!has_edge (b, a->boundary[i], a->boundary[(i + 1) % a->n_boundary]))
      return FALSE;
  return TRUE;
}

/* An edge has taken the place of another: of two diagonals that tie, neither
 * has won. */
static gboolean
holds_flip (const Situation *situation, const guint arguments[2])
{
  const Delaunay *now = &situation->frame->delaunay;
  Delaunay before;
  gboolean holds = FALSE;

  (void)arguments;
  delaunay_init (&before, situation->before, situation->before->n_events);
  if (has_same_boundary (&before, now))
    for (guint i = 0; i < now->n_edges; i++)
      if (!now->edges[i].is_free
          && !has_edge (&before, now->edges[i].site[0], now->edges[i].site[1]))
        holds = TRUE;
  delaunay_clear (&before);
  return holds;
}

/* What the dragged site sees of the hull of all the others. */
typedef struct Seen {
  guint n[FACING_VERTICAL + 1];
} Seen;

static Seen
what_it_sees (const Situation *situation)
{
  const SiteSet *all = situation->frame->trace->set;
  g_autofree Site *others = g_new0 (Site, all->n_sites);
  Seen seen = { { 0 } };
  guint n_others = 0;
  SiteSet *set;
  Trace *trace;

  for (guint i = 0; i < all->n_sites; i++)
    if (i != situation->site)
      others[n_others++] = all->sites[i];
  /* A part of a set that is in range is in range, at the same scale or not:
   * the sites are those of the whole set. */
  set = site_set_new (others, n_others);
  if (set == NULL || set->exponent != 0) {
    site_set_free (set);
    return seen;
  }
  trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });
  for (guint i = 0; i < trace->n_facets; i++)
    if (span_has (trace->facets[i].span, trace->n_events)
        && sees (trace, i, site_at (situation, situation->site)))
      seen.n[trace->facets[i].facing] += 1;
  trace_free (trace);
  site_set_free (set);
  return seen;
}

static gboolean
holds_only_lower (const Situation *situation, const guint arguments[2])
{
  const Seen seen = what_it_sees (situation);

  (void)arguments;
  return seen.n[FACING_LOWER] > 0 && seen.n[FACING_UPPER] == 0
         && seen.n[FACING_VERTICAL] == 0;
}

static gboolean
holds_only_upper (const Situation *situation, const guint arguments[2])
{
  const Seen seen = what_it_sees (situation);

  (void)arguments;
  return seen.n[FACING_UPPER] > 0 && seen.n[FACING_LOWER] == 0
         && seen.n[FACING_VERTICAL] == 0;
}

static gboolean
holds_lower_and_upper (const Situation *situation, const guint arguments[2])
{
  const Seen seen = what_it_sees (situation);

  (void)arguments;
  return seen.n[FACING_LOWER] > 0 && seen.n[FACING_UPPER] > 0;
}

static const ConditionWord words[] = {
  { "sees", "sf", FALSE, N_ ("{a} sees {b}"), holds_sees },
  { "is-lower", "f", FALSE, N_ ("{a} is a lower facet"), holds_lower },
  { "is-upper", "f", FALSE, N_ ("{a} is an upper facet"), holds_upper },
  { "is-vertical", "f", FALSE, N_ ("{a} is a vertical facet"), holds_vertical },
  { "neighbours", "ss", FALSE, N_ ("a Delaunay edge joins {a} and {b}"),
    holds_neighbours },
  { "unbounded", "s", FALSE, N_ ("the cell of {a} is unbounded"),
    holds_unbounded },
  { "bounded", "s", FALSE, N_ ("the cell of {a} is bounded"), holds_bounded },
  { "inside", "s", FALSE, N_ ("{a} lies inside the hull in the plane"),
    holds_inside },
  { "outside", "s", FALSE, N_ ("{a} lies outside the hull in the plane"),
    holds_outside },
  { "tie", "", FALSE, N_ ("a diagonal is free"), holds_tie },
  { "no-simplex", "", FALSE, N_ ("there is no simplex"), holds_no_simplex },
  { "vertex-outside", "", FALSE,
    N_ ("a Voronoi vertex lies outside its triangle"), holds_vertex_outside },
  { "flip", "", TRUE, N_ ("a diagonal flips"), holds_flip },
  { "only-lower", "", TRUE,
    N_ ("it sees only lower facets of the hull of the others"),
    holds_only_lower },
  { "only-upper", "", TRUE,
    N_ ("it sees only upper facets of the hull of the others"),
    holds_only_upper },
  { "lower-and-upper", "", TRUE,
    N_ ("it sees both lower and upper facets of the hull of the others"),
    holds_lower_and_upper },
};

const ConditionWord *
condition_word_find (const char *name)
{
  for (guint i = 0; i < G_N_ELEMENTS (words); i++)
    if (g_str_equal (name, words[i].name))
      return &words[i];
  return NULL;
}

const char *const *
condition_words (void)
{
  static const char *names[G_N_ELEMENTS (words) + 1];

  for (guint i = 0; i < G_N_ELEMENTS (words); i++)
    names[i] = words[i].name;
  return names;
}
