/* Exhibits in numbers: laws for people, counts for lessons. */
#include "exhibit.h"
#include "laws.h"

#include <glib/gi18n.h>

/* Whether the hull shown is that of all sites decided so far. */
static gboolean
is_whole (const PlanarFrame *frame)
{
  return frame->base == frame->step && frame->step >= frame->trace->start_end;
}

static void
add_planar_round (GPtrArray *laws, const PlanarCounts *counts)
{
  if (counts->visible > 0)
    laws_add (laws, "visible", _ ("visible edges"), "%u", counts->visible);
  if (counts->horizon > 0)
    laws_add (laws, "horizon", _ ("horizon corners"), "%u", counts->horizon);
  if (counts->cone > 0)
    laws_add (laws, "cone", _ ("new edges"), "%u", counts->cone);
  if (counts->retired > 0)
    laws_add (laws, "retired", _ ("retired"), "%u", counts->retired);
}

static void
add_planar (GPtrArray *laws, const PlanarFrame *frame)
{
  const PlanarCounts *counts = &frame->counts;
  const guint n_distinct = frame->trace->set->n_distinct;

  laws_add (laws, "sites", _ ("sites"), "%u", n_distinct);
  if (frame->n_sites > n_distinct)
    laws_add (laws, "duplicates", _ ("duplicates"), "%u",
              frame->n_sites - n_distinct);
  laws_add (laws, "hull-vertices", _ ("corners of the hull"), "%u",
            counts->corners);
  laws_add (laws, "ignored", _ ("inside, ignored"), "%u", counts->inside);
  if (counts->waiting > 0 && is_whole (frame))
    laws_add (laws, "waiting", _ ("still to decide"), "%u = %u − %u − %u",
              counts->waiting, n_distinct, counts->corners, counts->inside);
  else if (counts->waiting > 0)
    laws_add (laws, "waiting", _ ("still to decide"), "%u", counts->waiting);
  if (frame->is_in_round)
    add_planar_round (laws, counts);
  if (counts->outside_sets > 0)
    laws_add (laws, "outside-sets", _ ("outside sets"), "%u",
              counts->outside_sets);
}

static void
add_rounded (GPtrArray *laws, const RoundedHull *hull)
{
  laws_add (laws, "rounded-corners", _ ("corners by rounded signs"), "%u",
            hull->n_corners);
  laws_add (laws, "true-corners", _ ("corners in truth"), "%u", hull->n_true);
  laws_add (laws, "lost-sites", _ ("corners lost"), "%u", hull->n_lost);
}

static void
add_map (GPtrArray *laws, const SignMap *map)
{
  char step[G_ASCII_DTOSTR_BUF_SIZE];

  laws_add (laws, "nodes", _ ("nodes"), "%d = %d²",
            SIGN_MAP_SIDE * SIGN_MAP_SIDE, SIGN_MAP_SIDE);
  laws_add (laws, "wrong-signs", _ ("wrong signs"), "%u", map->n_wrong);
  laws_add (laws, "grid", _ ("from node to node"), "%s",
            g_ascii_formatd (step, sizeof step, "%.3g", map->step));
}

GPtrArray *
exhibit_laws (Exhibit *exhibit, guint step)
{
  const SignMap *map = exhibit_map (exhibit);
  GPtrArray *laws = laws_new ();

  if (exhibit_kind (exhibit) == EXHIBIT_PLANAR)
    add_planar (laws, exhibit_planar_frame (exhibit, step));
  else if (map != NULL)
    add_map (laws, map);
  else
    add_rounded (laws, exhibit_rounded_hull (exhibit, step));
  return laws;
}

typedef struct Count {
  const char *key;
  guint count;
} Count;

static gboolean
look_up (const Count *rows, guint n_rows, const char *key, guint *count)
{
  for (guint i = 0; i < n_rows; i++)
    if (g_str_equal (key, rows[i].key)) {
      *count = rows[i].count;
      return TRUE;
    }
  return FALSE;
}

static gboolean
count_planar (const PlanarCounts *counts, const char *key, guint *count)
{
  const Count rows[] = {
    { "hull-vertices", counts->corners },
    { "ignored", counts->inside },
    { "waiting", counts->waiting },
    { "outside-sets", counts->outside_sets },
    { "visible", counts->visible },
    { "horizon", counts->horizon },
    { "cone", counts->cone },
    { "retired", counts->retired },
  };

  return look_up (rows, G_N_ELEMENTS (rows), key, count);
}

static gboolean
count_rounded (const RoundedHull *hull, const char *key, guint *count)
{
  const Count rows[] = {
    { "rounded-corners", hull->n_corners },
    { "true-corners", hull->n_true },
    { "lost-sites", hull->n_lost },
  };

  return look_up (rows, G_N_ELEMENTS (rows), key, count);
}

gboolean
exhibit_count (Exhibit *exhibit, guint step, const char *key, guint *count)
{
  const SignMap *map = exhibit_map (exhibit);

  if (exhibit_kind (exhibit) == EXHIBIT_PLANAR)
    return count_planar (&exhibit_planar_frame (exhibit, step)->counts, key,
                         count);
  if (exhibit_kind (exhibit) == EXHIBIT_ROUNDED)
    return count_rounded (exhibit_rounded_hull (exhibit, step), key, count);
  if (map == NULL || !g_str_equal (key, "wrong-signs"))
    return FALSE;
  *count = map->n_wrong;
  return TRUE;
}

const char *const *
exhibit_count_names (void)
{
  static const char *const names[]
      = { "hull-vertices",        "ignored",           "facets-created",
          "facets-seen",          "redistributions",   "cone-facets",
          "other-round",          "other-visible",     "other-facets",
          "other-facets-created", "other-facets-seen", "other-redistributions",
          "other-cone-facets",    "wrong-signs",       "rounded-corners",
          "true-corners",         "lost-sites",        NULL };

  return names;
}
