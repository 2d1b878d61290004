/* Site sets for tests: curated ones by name, and families by seed. */
#ifndef FIXTURE_H
#define FIXTURE_H

#include "trace.h"

#include <glib.h>

/* A set and what QuickHull does with it. */
typedef struct Fixture {
  char *name; /* "lecture8", "clusters 3": to name it in a failure */
  SiteSet *set;
  Trace *trace;
} Fixture;

/* Returns: (transfer full): tests/sites/NAME.txt. */
Fixture *fixture_load (const char *name, OrderKind order);

typedef enum Family {
  FAMILY_RANDOM,   /* general position */
  FAMILY_TIES,     /* small integers: duplicates, many on a line or circle */
  FAMILY_GRID,     /* every node of a grid, shuffled */
  FAMILY_CIRCLE,   /* integer points of one circle, and a few within */
  FAMILY_LINE,     /* most of them on one line */
  FAMILY_CLUSTERS, /* knots of sites 2^-40 across, far from each other */
  FAMILY_ULPS,     /* a line, each site off by the last bit */
} Family;

#define N_FAMILIES (FAMILY_ULPS + 1)

/* Returns: (transfer full): about @n sites; the same for the same seed. */
Fixture *fixture_new (Family family, guint32 seed, guint n, OrderKind order);

/* Returns: (transfer full): takes over @set. */
Fixture *fixture_take (char *name, SiteSet *set, const Order *order);
void fixture_free (Fixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Fixture, fixture_free)

/* Returns: how many times as many seeds to try: HULL2VD_SOAK, or 1. */
guint fixture_soak_factor (void);

/* Returns: how many seeds to try where @n are wanted: HULL2VD_SOAK times as
 * many; one in HULL2VD_SAMPLE, but at least one, where each takes long. */
guint fixture_n_seeds (guint n);

/* Calls @check for fixture_n_seeds (@n) seeds of every family. */
void fixture_for_each (guint n,
                       guint n_sites,
                       OrderKind order,
                       void (*check) (const Fixture *fixture));

/* Returns: the first facet with these three corners, or INDEX_NONE. */
uint32_t
fixture_facet (const Fixture *fixture, uint32_t a, uint32_t b, uint32_t c);

/* Returns: whether a facet with these corners stands at the end. */
bool
fixture_ends_with (const Fixture *fixture, uint32_t a, uint32_t b, uint32_t c);

/* Returns: the names of all curated sets, NULL at the end. */
const char *const *fixture_names (void);

/* Returns: (transfer full): the path of a curated set. */
char *fixture_set_path (const char *name);

/* Returns: (transfer full): the sites of tests/corpus/NAME.txt. */
SiteSet *fixture_corpus_set (const char *name);

/* Returns: (transfer full): the path of a file below tests/. */
char *fixture_path (const char *folder, const char *name, const char *end);

#endif
