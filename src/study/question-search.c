#include "question-search.h"

#include "generator.h"
#include "question-reason.h"

#include <math.h>

/* Drags */

gboolean
question_drag_holds (const Question *question,
                     const Trace *before,
                     const Trace *now)
{
  Situation situation = { NULL, before, question->site };
  gboolean holds;
  Frame frame;

  frame_init (&frame, now, now->n_events);
  situation.frame = &frame;
  holds = condition_fault (question->condition, &situation) == NULL
          && condition_holds (question->condition, &situation);
  frame_clear (&frame);
  return holds;
}

/* The search for a place. */
typedef struct Search {
  const Question *question;
  const Trace *trace;
  Site *sites; /* as given; that which is dragged changes */
  Site start;  /* on the grid */
  double step;
  int reach;  /* steps on each side */
  int n_left; /* sets that may be tried yet */
} Search;

static gboolean
try_site (Search *search, Site to)
{
  gboolean holds;
  Run *run;

  if (search->n_left-- <= 0)
    return FALSE;
  search->sites[search->question->site] = to;
  run = run_new (search->sites, search->trace->set->n_sites,
                 &search->trace->order);
  if (run == NULL)
    return FALSE;
  holds = run->set->n_distinct == search->trace->set->n_distinct
          && question_drag_holds (search->question, search->trace, run->trace);
  run_unref (run);
  return holds;
}

static gboolean
try_at (Search *search, int x, int y)
{
  return try_site (search, (Site){ search->start.x + x * search->step,
                                   search->start.y + y * search->step });
}

/* Places at the distance of @ring steps, then of more. */
static gboolean
try_rings (Search *search)
{
  for (int ring = 1; ring <= search->reach; ring++)
    for (int i = -ring; i <= ring; i++)
      if (try_at (search, i, -ring) || try_at (search, i, ring)
          || try_at (search, -ring, i) || try_at (search, ring, i))
        return TRUE;
  return FALSE;
}

/* As session-edit.c: 64 steps from the centre of the view to its border. */
#define GRID_BITS 6

/* What holds nowhere is found out in about a second. */
#define MOST_REACH 24
#define MOST_SITES 80000 /* of all sets that are tried, together */

static double
snap (double coordinate, double grid)
{
  return nearbyint (coordinate / grid) * grid;
}

static gboolean
is_on_grid (Site site, double grid)
{
  return snap (site.x, grid) == site.x && snap (site.y, grid) == site.y;
}

/* Of every three other sites: half way between two, and the fourth corner of
 * their parallelogram. Lines and circles pass there exactly. */
static gboolean
try_exact (Search *search, double grid)
{
  const guint n = search->trace->set->n_sites;
  const guint dragged = search->question->site;

  for (guint i = 0; i < n; i++)
    for (guint k = 0; k < n; k++)
      for (guint l = 0; l <= i && i != dragged && k != dragged && i != k; l++) {
        const Site *a = &search->sites[i], *b = &search->sites[k];
        const Site *c = &search->sites[l];
        const Site to = l == i
                            ? (Site){ (a->x + b->x) / 2, (a->y + b->y) / 2 }
                            : (Site){ a->x + b->x - c->x, a->y + b->y - c->y };

        if (l != dragged && is_on_grid (to, grid) && try_site (search, to))
          return TRUE;
      }
  return FALSE;
}

/* Coarse grids first, then exact places, then fine grids near the site. */
static gboolean
search_all (Search *search, double grid, double radius)
{
  for (int factor = 16; factor >= 1; factor /= 2) {
    if (factor == 2 && try_exact (search, grid))
      return TRUE;
    search->step = factor * grid;
    search->reach = MIN ((int)(2 * radius / search->step), MOST_REACH);
    if (try_rings (search))
      return TRUE;
  }
  return FALSE;
}

gboolean
question_find_drag (const Question *question, const Trace *trace, Site *to)
{
  const SiteSet *set = trace->set;
  const Extent extent = site_set_extent (set);
  const double radius = ldexp (extent.radius, set->exponent);
  const double grid = ldexp (1, ilogb (radius) - GRID_BITS);
  g_autofree Site *sites = g_new0 (Site, set->n_sites);
  Search search = { .question = question, .trace = trace, .sites = sites };

  for (guint i = 0; i < set->n_sites; i++)
    sites[i] = site_set_given (set, i);
  search.start.x = snap (sites[question->site].x, grid);
  search.start.y = snap (sites[question->site].y, grid);
  search.n_left = MOST_SITES / (int)MAX (set->n_sites, 1);
  if (!search_all (&search, grid, radius))
    return FALSE;
  *to = sites[question->site];
  return TRUE;
}

/* Every set of sites */

static gboolean
fails_at (const Condition *condition, const Trace *trace, guint step)
{
  Situation situation = { NULL, NULL, INDEX_NONE };
  gboolean fails;
  Frame frame;

  frame_init (&frame, trace, step);
  situation.frame = &frame;
  fails = condition_fault (condition, &situation) == NULL
          && !condition_holds (condition, &situation);
  frame_clear (&frame);
  return fails;
}

gboolean
question_fails (const Condition *condition, const Trace *trace)
{
  const QuantityScope scope = condition_scope (condition);

  if (trace->set->n_distinct == 0)
    return FALSE;
  if (trace->is_flat)
    return scope == SCOPE_ALWAYS
           && fails_at (condition, trace, trace->n_events);
  if (scope != SCOPE_ROUND && fails_at (condition, trace, trace->start_end))
    return TRUE;
  for (guint i = 0; i < trace->n_rounds; i++)
    if (fails_at (condition, trace, trace->rounds[i].end))
      return TRUE;
  return FALSE;
}

/* The families of sets, one after the other; NULL at the end. */
static Site *
make_set (guint number, guint *n_sites)
{
  static const guint grids[][2] = { { 2, 2 }, { 3, 2 }, { 3, 3 }, { 4, 3 } };
  const guint n_random = 120;

  if (number < G_N_ELEMENTS (grids)) {
    *n_sites = grids[number][0] * grids[number][1];
    return generator_grid (grids[number][0], grids[number][1], NULL);
  }
  number -= G_N_ELEMENTS (grids);
  if (number < 5) {
    *n_sites = 4 + number;
    return generator_circle (*n_sites, NULL);
  }
  number -= 5;
  if (number < 4) {
    *n_sites = 2 + number;
    return generator_line (*n_sites, NULL);
  }
  number -= 4;
  *n_sites = 4 + number % 6;
  return number < 2 * n_random
             ? generator_random (*n_sites, number % n_random, NULL)
             : NULL;
}

/* The second half of the random sets is coarse: full of ties. */
#define FIRST_COARSE 133

static void
make_coarse (Site *sites, guint n_sites)
{
  for (guint i = 0; i < n_sites; i++) {
    sites[i].x = nearbyint (3 * sites[i].x) / 4;
    sites[i].y = nearbyint (3 * sites[i].y) / 4;
  }
}

static gboolean
fails_for (const Condition *condition, const Site *sites, guint n_sites)
{
  Run *run = run_new (sites, n_sites, &(Order){ ORDER_FURTHEST, 0 });
  const gboolean fails = run != NULL && question_fails (condition, run->trace);

  g_clear_pointer (&run, run_unref);
  return fails;
}

Site *
question_find_failure (const Condition *condition,
                       const Trace *trace,
                       guint *n_sites)
{
  Site *sites;

  if (question_fails (condition, trace)) {
    *n_sites = trace->set->n_sites;
    sites = g_new0 (Site, *n_sites);
    for (guint i = 0; i < *n_sites; i++)
      sites[i] = site_set_given (trace->set, i);
    return sites;
  }
  for (guint i = 0; (sites = make_set (i, n_sites)) != NULL; i++) {
    if (i >= FIRST_COARSE)
      make_coarse (sites, *n_sites);
    if (fails_for (condition, sites, *n_sites))
      return sites;
    g_free (sites);
  }
  return NULL;
}

/* Orders of insertion */

/* A set whose order of input is the order to be judged. */
typedef struct Permuted {
  Site *sites;
  guint *names; /* of the sites in the run */
  guint n;
} Permuted;

static void
permuted_add (Permuted *permuted, const Trace *trace, guint site)
{
  for (guint i = 0; i < permuted->n; i++)
    if (permuted->names[i] == site)
      return;
  permuted->sites[permuted->n] = site_set_given (trace->set, site);
  permuted->names[permuted->n++] = site;
}

/* The first simplex, the rounds so far, the sites in @order, the others. */
static void
permute (Permuted *permuted, const Occasion *occasion, const GArray *order)
{
  const Trace *trace = occasion->trace;
  const guint n = trace->set->n_sites;

  permuted->sites = g_new0 (Site, n);
  permuted->names = g_new0 (guint, n);
  permuted->n = 0;
  for (guint i = 0; i < n; i++)
    if (trace->inserted[i] <= trace->simplex_end)
      permuted_add (permuted, trace, i);
  for (guint i = 0; i + 1 < occasion->round; i++)
    permuted_add (permuted, trace, trace->rounds[i].site);
  for (guint i = 0; i < order->len; i++)
    permuted_add (permuted, trace, g_array_index (order, Object, i).number);
  for (guint i = 0; i < n; i++)
    if (trace->set->first[i] == i)
      permuted_add (permuted, trace, i);
}

/* The site of the outside set that lies further than the current one, or
 * INDEX_NONE. */
static guint
find_further (const Trace *trace, const RoundRow *round)
{
  for (guint i = 0; i < trace->n_claims; i++) {
    const ClaimRow claim = trace_claim (trace, i);

    if (claim.facet == round->facet && span_has (claim.span, round->select - 1)
        && question_further (trace, round->facet, claim.site, round->site) > 0)
      return claim.site;
  }
  return INDEX_NONE;
}

guint
question_legal_order (const Occasion *occasion,
                      const GArray *order,
                      guint *better)
{
  Permuted permuted;
  guint n_legal = 0;
  Run *run;

  permute (&permuted, occasion, order);
  run = run_new (permuted.sites, permuted.n, &(Order){ ORDER_INPUT, 0 });
  *better = INDEX_NONE;
  for (; run != NULL && n_legal < order->len; n_legal++) {
    const guint round = occasion->round - 1 + n_legal;
    const guint further
        = round < run->trace->n_rounds
              ? find_further (run->trace, &run->trace->rounds[round])
              : INDEX_NONE;

    if (round >= run->trace->n_rounds)
      break;
    if (further != INDEX_NONE) {
      *better = permuted.names[further];
      break;
    }
  }
  g_clear_pointer (&run, run_unref);
  g_free (permuted.sites);
  g_free (permuted.names);
  return n_legal;
}
