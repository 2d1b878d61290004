/* Quantities: numbers that a frame shows, by the names that lessons use in
 * expect, in questions and in conditions. */
#ifndef QUANTITY_H
#define QUANTITY_H

#include "frame.h"

#include <glib.h>

G_BEGIN_DECLS

typedef enum Quantity {
  QUANTITY_SITES,
  QUANTITY_DUPLICATES,
  QUANTITY_INSERTED,
  QUANTITY_WAITING,
  QUANTITY_OUTSIDE_SETS,
  QUANTITY_ROUND,
  QUANTITY_STEP,
  QUANTITY_FACETS,
  QUANTITY_LOWER,
  QUANTITY_UPPER,
  QUANTITY_VERTICAL,
  QUANTITY_HULL_CORNERS,   /* corners of the hull in the plane */
  QUANTITY_BOUNDARY_SITES, /* all sites on its boundary */
  QUANTITY_VISIBLE,        /* of the current round, as far as found: */
  QUANTITY_DYING_TRIANGLES,
  QUANTITY_VISIBLE_UPPER,
  QUANTITY_VISIBLE_VERTICAL,
  QUANTITY_HORIZON,
  QUANTITY_CONE,
  QUANTITY_NEW_TRIANGLES,
  QUANTITY_RETIRED,
  QUANTITY_TRIANGLES,
  QUANTITY_DELAUNAY_EDGES,
  QUANTITY_FREE_EDGES,
  QUANTITY_VORONOI_VERTICES,
  QUANTITY_VORONOI_EDGES, /* with two ends */
  QUANTITY_RAYS,          /* with one end */
  QUANTITY_VORONOI_LINES, /* with none */
} Quantity;

#define N_QUANTITIES (QUANTITY_VORONOI_LINES + 1)

/* Where a quantity says something. */
typedef enum QuantityScope {
  SCOPE_ALWAYS,
  SCOPE_HULL,  /* sites with a first simplex */
  SCOPE_ROUND, /* and a current round */
} QuantityScope;

const char *quantity_name (Quantity quantity);

/* Returns: the names, ending with NULL. */
const char *const *quantity_names (void);
gboolean quantity_parse (const char *name, Quantity *quantity);
QuantityScope quantity_scope (Quantity quantity);

/* Returns: what it counts, translated: "ridges of the horizon". */
const char *quantity_label (Quantity quantity);

guint quantity_value (const Frame *frame, Quantity quantity);

G_END_DECLS

#endif
