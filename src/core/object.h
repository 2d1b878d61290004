/* Things that a person can point at, by the same name in every view, panel,
 * lesson and test. */
#ifndef OBJECT_H
#define OBJECT_H

#include "site.h"

typedef enum ObjectKind {
  OBJECT_NONE,
  OBJECT_SITE,   /* and its lift, its cell */
  OBJECT_FACET,  /* and its shadow, the shadow's circumcircle; a triangle of
                    flat input goes by its own number */
  OBJECT_VERTEX, /* the Voronoi vertex whose circle group has this facet as
                    its lowest-numbered */
  OBJECT_RIDGE,  /* a row of Trace.ridges: Delaunay edge and Voronoi edge */
} ObjectKind;

typedef struct Object {
  ObjectKind kind;
  uint32_t number; /* 0 for OBJECT_NONE */
} Object;

static inline bool
object_equal (Object a, Object b)
{
  return a.kind == b.kind && a.number == b.number;
}

#endif
