#include "laws.h"

#include <glib/gi18n.h>

static void
law_free (gpointer data)
{
  Law *law = data;

  g_free (law->key);
  g_free (law->name);
  g_free (law->value);
  g_free (law);
}

static void
add (GPtrArray *laws, const char *key, const char *name, char *value)
{
  Law *law = g_new0 (Law, 1);

  law->key = g_strdup (key);
  law->name = g_strdup (name);
  law->value = value;
  g_ptr_array_add (laws, law);
}

static char *
number (guint n)
{
  return g_strdup_printf ("%u", n);
}

static void
add_sites (GPtrArray *laws, const Frame *frame)
{
  const guint n_distinct = frame->trace->set->n_distinct;
  const guint n_duplicates = frame->n_sites - n_distinct;

  add (laws, "inserted", _ ("sites inserted"),
       /* Translators: as in "7 of 8". */
       g_strdup_printf (_ ("%u of %u"), frame->counts.n_inserted, n_distinct));
  if (n_duplicates > 0)
    add (laws, "duplicates", _ ("duplicates"), number (n_duplicates));
}

/* The facets by kind: d sites, b of them on the boundary of their hull in
 * the plane, h its corners. */
static void
add_facets (GPtrArray *laws, const Frame *frame)
{
  const FrameCounts *counts = &frame->counts;
  const guint d = counts->n_inserted;
  const guint b = frame->delaunay.n_boundary;
  const guint h = frame->delaunay.n_extreme;

  /* The laws hold for whole hulls: the first simplex is not yet one. */
  if (d == 0) {
    add (laws, "facets", _ ("facets"), number (counts->facets));
    return;
  }
  add (laws, "facets", _ ("facets"),
       g_strdup_printf ("%u = 2·%u − 4", counts->facets, d));
  add (laws, "lower", C_ ("counter", "lower"),
       g_strdup_printf ("%u = 2·%u − 2 − %u", counts->lower, d, b));
  add (laws, "upper", C_ ("counter", "upper"),
       g_strdup_printf ("%u = %u − 2", counts->upper, h));
  if (counts->vertical > 0)
    add (laws, "vertical", C_ ("counter", "vertical"),
         g_strdup_printf ("%u = %u − %u", counts->vertical, b, h));
}

/* Without a simplex there are triangles, or segments, alone. */
static void
add_flat (GPtrArray *laws, const Frame *frame)
{
  const FrameCounts *counts = &frame->counts;
  const guint d = counts->n_inserted;

  if (frame->delaunay.dimension == 2) {
    add (laws, "triangles", _ ("triangles"),
         g_strdup_printf ("%u = %u − 2", counts->triangles, d));
    add (laws, "voronoi-vertices", _ ("Voronoi vertices"),
         number (counts->voronoi_vertices));
    add (laws, "rays", _ ("Voronoi rays"),
         g_strdup_printf ("%u = %u", counts->rays, d));
  } else if (frame->delaunay.dimension == 1) {
    add (laws, "delaunay-edges", _ ("segments"),
         g_strdup_printf ("%u = %u − 1", counts->delaunay_edges, d));
    add (laws, "voronoi-lines", _ ("Voronoi lines"),
         g_strdup_printf ("%u = %u − 1", counts->voronoi_edges, d));
  }
}

/* Of the horizon and the cone, so many have been found; once all are, their
 * number follows from that of the visible facets. */
static void
add_found (GPtrArray *laws,
           const char *key,
           const char *name,
           guint n,
           guint n_visible)
{
  if (n > 0)
    add (laws, key, name,
         n == n_visible + 2 ? g_strdup_printf ("%u = %u + 2", n, n_visible)
                            : number (n));
}

static void
add_round (GPtrArray *laws, const Frame *frame)
{
  const FrameCounts *counts = &frame->counts;

  /* Until the first is found there is nothing to count. */
  if (counts->visible > 0)
    add (laws, "visible", C_ ("counter", "visible"), number (counts->visible));
  if (frame->place.phase < PHASE_HORIZON)
    return;
  add_found (laws, "horizon", _ ("horizon"), counts->horizon, counts->visible);
  add_found (laws, "cone", _ ("cone"), counts->cone, counts->visible);
  if (counts->retired > 0)
    add (laws, "retired", C_ ("counter", "retired"), number (counts->retired));
}

static void
add_waiting (GPtrArray *laws, const Frame *frame)
{
  const FrameCounts *counts = &frame->counts;

  if (counts->outside_sets > 0)
    add (laws, "outside-sets", _ ("outside sets"),
         /* Translators: sites in outside sets. */
         g_strdup_printf (g_dngettext (NULL, "%u site in %u", "%u sites in %u",
                                       counts->waiting),
                          counts->waiting, counts->outside_sets));
}

GPtrArray *
laws_new (void)
{
  return g_ptr_array_new_with_free_func (law_free);
}

void
laws_add (
    GPtrArray *laws, const char *key, const char *name, const char *format, ...)
{
  va_list values;

  va_start (values, format);
  add (laws, key, name, g_strdup_vprintf (format, values));
  va_end (values);
}

GPtrArray *
laws_of (const Frame *frame)
{
  GPtrArray *laws = laws_new ();

  add_sites (laws, frame);
  if (frame->counts.facets > 0)
    add_facets (laws, frame);
  else
    add_flat (laws, frame);
  if (frame->round != INDEX_NONE && frame->place.phase != PHASE_COMPLETE)
    add_round (laws, frame);
  add_waiting (laws, frame);
  return laws;
}

void
laws_hide (GPtrArray *laws)
{
  for (guint i = 0; i < laws->len; i++) {
    Law *law = g_ptr_array_index (laws, i);

    if (g_str_equal (law->key, "inserted"))
      continue;
    g_free (law->value);
    law->value = g_strdup ("?");
  }
}
