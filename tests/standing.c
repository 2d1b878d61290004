#include "standing.h"

#include <stdlib.h>

static void
find_facets (Standing *standing, const Trace *trace)
{
  standing->facets = g_new (uint32_t, trace->n_facets + 1);
  for (uint32_t i = 0; i < trace->n_facets; i++)
    if (span_has (trace->facets[i].span, standing->step))
      standing->facets[standing->n_facets++] = i;
}

static void
find_active (Standing *standing, const Trace *trace)
{
  const uint32_t n_sites = standing->fixture->set->n_sites;

  standing->active = g_new (uint32_t, n_sites + 1);
  for (uint32_t i = 0; i < n_sites; i++)
    if (trace->inserted[i] <= standing->step)
      standing->active[standing->n_active++] = i;
}

Standing *
standing_new (const Fixture *fixture, const Judge *judge, uint32_t step)
{
  Standing *standing = g_new0 (Standing, 1);

  standing->fixture = fixture;
  standing->judge = judge;
  standing->step = step;
  find_facets (standing, fixture->trace);
  find_active (standing, fixture->trace);
  standing->corners = g_new (uint32_t, standing->n_active + 2);
  standing->n_corners = judge_hull (judge, standing->active, standing->n_active,
                                    standing->corners);
  for (uint32_t i = 0; i < standing->n_active; i++)
    if (judge_inside (judge, standing->corners, standing->n_corners,
                      standing->active[i])
        == 0)
      standing->n_boundary += 1;
  return standing;
}

void
standing_free (Standing *standing)
{
  g_free (standing->facets);
  g_free (standing->active);
  g_free (standing->corners);
  g_free (standing);
}

Facing
standing_facing (const Standing *standing, uint32_t facet)
{
  const uint32_t *site = standing->fixture->trace->facets[facet].site;
  const int turn = judge_orient (standing->judge, site[0], site[1], site[2]);

  return turn < 0 ? FACING_LOWER : turn > 0 ? FACING_UPPER : FACING_VERTICAL;
}

/* The hull edge that @site, three sites on a line, stands over has all
 * active sites on one side. */
static bool
lies_beyond (const Standing *standing, const uint32_t *line, uint32_t site)
{
  const int turn = judge_orient (standing->judge, line[0], line[1], site);

  for (uint32_t i = 0; i < standing->n_active; i++) {
    const int inner
        = judge_orient (standing->judge, line[0], line[1], standing->active[i]);

    if (inner != 0)
      return turn == -inner;
  }
  g_assert_not_reached ();
}

bool
standing_sees (const Standing *standing, uint32_t facet, uint32_t site)
{
  const uint32_t *corner = standing->fixture->trace->facets[facet].site;

  switch (standing_facing (standing, facet)) {
  case FACING_LOWER:
    return judge_circle (standing->judge, corner, site) < 0;
  case FACING_UPPER:
    return judge_circle (standing->judge, corner, site) > 0;
  case FACING_VERTICAL:
    return lies_beyond (standing, corner, site);
  }
  g_assert_not_reached ();
}

uint32_t
standing_count (const Standing *standing, Facing facing)
{
  uint32_t n = 0;

  for (uint32_t i = 0; i < standing->n_facets; i++)
    if (standing_facing (standing, standing->facets[i]) == facing)
      n += 1;
  return n;
}

char *
standing_seen (const Standing *standing, uint32_t site)
{
  GString *text = g_string_new (NULL);

  for (uint32_t i = 0; i < standing->n_facets; i++)
    if (standing_sees (standing, standing->facets[i], site))
      g_string_append_printf (text, "%s%u", text->len > 0 ? " " : "",
                              standing->facets[i]);
  return g_string_free (text, FALSE);
}
