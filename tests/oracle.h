/* Judges a result file, format "lift-result" 1, by brute force and from the
 * definitions of its keys alone. Stops the test with a message on a fault. */
#ifndef ORACLE_H
#define ORACLE_H

#include "judge.h"

#include <json-glib/json-glib.h>

/* @name: of the site set, for the message.
 *
 * Cost: cubic in the number of sites. */
void oracle_judge (const char *json, const SiteSet *set, const char *name);

/* What the parts of the oracle share. */
typedef struct Oracle {
  const char *name;
  const SiteSet *set;
  Judge *judge;
  JsonObject *root;
  uint32_t *active; /* ascending */
  uint32_t n_active;
  uint32_t *corners; /* of the hull in the plane */
  uint32_t n_corners;
  uint32_t n_boundary; /* sites on its border */
  int dimension;       /* of the sites in the plane */
} Oracle;

/* Returns: item @i of list @key, itself a list. */
JsonArray *oracle_item (JsonArray *list, guint i);

/* Returns: number @k of a list, which must be an active site. */
uint32_t oracle_site (const Oracle *oracle, JsonArray *list, guint k);

void oracle_judge_voronoi (const Oracle *oracle);

#define oracle_assert(oracle, condition)                                       \
  G_STMT_START                                                                 \
  {                                                                            \
    if (!(condition))                                                          \
      g_error ("%s: not true: %s", (oracle)->name, #condition);                \
  }                                                                            \
  G_STMT_END

#endif
