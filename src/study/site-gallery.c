#include "site-gallery.h"

#include "document.h"
#include "locate.h"

#include <glib/gi18n.h>

/* The facts are those of tests/test-site-set-facts.c. */
static const GalleryEntry entries[] = {
  { "near-far6", N_ ("The site furthest from its facet is not the furthest "
                     "from the hull") },
  { "gap6", N_ ("The site with the larger vertical gap is the nearer one") },
  { "tie6", N_ ("Two sites are equally far; the lower number comes first") },
  { "wheel8", N_ ("One site in the middle can end every triangle, or hardly "
                  "any: the order decides") },
  { "cross5", N_ ("The shadow of the horizon crosses itself") },
  { "mixed8", N_ ("New sites inside and outside, seen from below, from above "
                  "and both") },
  { "lecture8", N_ ("One insertion in both worlds: every site lies inside") },
  { "lecture8b", N_ ("The same for self-study, with clearer margins") },
  { "obtuse6", N_ ("Voronoi vertices outside their triangles and outside the "
                   "hull") },
  { "mwt4", N_ ("The Delaunay diagonal is not the shorter one") },
  { "square5", N_ ("Four corners on one circle make no simplex; the fifth "
                   "site does") },
  { "flip5-in", N_ ("One grid step before an edge flips") },
  { "flip5-tie", N_ ("Four sites on one circle: either diagonal will do") },
  { "flip5-out", N_ ("One grid step after the edge has flipped") },
  { "vertical5", N_ ("A vertical facet is born and goes again") },
  { "grid9", N_ ("Vertical facets and circle groups come and go") },
  { "furthest8", N_ ("What the upper hull knows: the furthest-site diagram") },
};

const GalleryEntry *
site_gallery (guint *n_entries)
{
  *n_entries = G_N_ELEMENTS (entries);
  return entries;
}

SiteSet *
site_gallery_load (const char *name, GError **error)
{
  g_autofree char *folder = locate_lessons ();
  g_autofree char *file = g_strconcat (name, ".txt", NULL);
  g_autofree char *path = g_build_filename (folder, "sites", file, NULL);

  return document_read_points (path, error);
}
