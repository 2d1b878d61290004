#include "moment.h"

#include <stdlib.h>

static void
find_facets (Moment *moment, const Trace *trace)
{
  moment->facets = g_new (uint32_t, trace->n_facets + 1);
  for (uint32_t i = 0; i < trace->n_facets; i++)
    if (span_has (trace->facets[i].span, moment->step))
      moment->facets[moment->n_facets++] = i;
}

static void
find_active (Moment *moment, const Trace *trace)
{
  const uint32_t n_sites = moment->fixture->set->n_sites;

  moment->active = g_new (uint32_t, n_sites + 1);
  for (uint32_t i = 0; i < n_sites; i++)
    if (trace->inserted[i] <= moment->step)
      moment->active[moment->n_active++] = i;
}

Moment *
moment_new (const Fixture *fixture, const Judge *judge, uint32_t step)
{
  Moment *moment = g_new0 (Moment, 1);

  moment->fixture = fixture;
  moment->judge = judge;
  moment->step = step;
  find_facets (moment, fixture->trace);
  find_active (moment, fixture->trace);
  moment->corners = g_new (uint32_t, moment->n_active + 2);
  moment->n_corners
      = judge_hull (judge, moment->active, moment->n_active, moment->corners);
  for (uint32_t i = 0; i < moment->n_active; i++)
    if (judge_inside (judge, moment->corners, moment->n_corners,
                      moment->active[i])
        == 0)
      moment->n_boundary += 1;
  return moment;
}

void
moment_free (Moment *moment)
{
  g_free (moment->facets);
  g_free (moment->active);
  g_free (moment->corners);
  g_free (moment);
}

Facing
moment_facing (const Moment *moment, uint32_t facet)
{
  const uint32_t *site = moment->fixture->trace->facets[facet].site;
  const int turn = judge_orient (moment->judge, site[0], site[1], site[2]);

  return turn < 0 ? FACING_LOWER : turn > 0 ? FACING_UPPER : FACING_VERTICAL;
}

/* The hull edge that @site, three sites on a line, stands over has all
 * active sites on one side. */
static bool
lies_beyond (const Moment *moment, const uint32_t *line, uint32_t site)
{
  const int turn = judge_orient (moment->judge, line[0], line[1], site);

  for (uint32_t i = 0; i < moment->n_active; i++) {
    const int inner
        = judge_orient (moment->judge, line[0], line[1], moment->active[i]);

    if (inner != 0)
      return turn == -inner;
  }
  g_assert_not_reached ();
}

bool
moment_sees (const Moment *moment, uint32_t facet, uint32_t site)
{
  const uint32_t *corner = moment->fixture->trace->facets[facet].site;

  switch (moment_facing (moment, facet)) {
  case FACING_LOWER:
    return judge_circle (moment->judge, corner, site) < 0;
  case FACING_UPPER:
    return judge_circle (moment->judge, corner, site) > 0;
  case FACING_VERTICAL:
    return lies_beyond (moment, corner, site);
  }
  g_assert_not_reached ();
}

uint32_t
moment_count (const Moment *moment, Facing facing)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < moment->n_facets; i++)
    if (moment_facing (moment, moment->facets[i]) == facing)
      n += 1;
  return n;
}

char *
moment_seen (const Moment *moment, uint32_t site)
{
  GString *text = g_string_new (NULL);

  for (uint32_t i = 0; i < moment->n_facets; i++)
    if (moment_sees (moment, moment->facets[i], site))
      g_string_append_printf (text, "%s%u", text->len > 0 ? " " : "",
                              moment->facets[i]);
  return g_string_free (text, FALSE);
}
