/* QuickHull in the plane, where facets are edges and ridges are corners: the
 * same words and phases as in space, but here a site may lie inside, and is
 * then ignored. It says nothing but these events, in this order:
 *
 *   DUPLICATE…                  sites that equal an earlier one
 *   FLAT                        all sites lie on one line, or:
 *   SIMPLEX×3 (CLAIM|IGNORE)…   the first triangle, and who sees which edge
 *   then for each round         the insertion of one site
 *     SELECT VISIBLE… HORIZON×2 CONE×2 RETIRE (IGNORE RETIRE)… (CLAIM|IGNORE)…
 *   COMPLETE
 *
 * The first triangle is made of the first two distinct sites and the first
 * one off their line. A site sees an edge when it lies strictly to the right
 * of it, and also when it lies on its line beyond it: so all corners of the
 * hull are strict. A site on an edge is inside.
 *
 * Edges are numbered in the order of their birth, from 0; no number is used
 * again.
 */
#ifndef PLANAR_H
#define PLANAR_H

#include "site.h"

typedef enum PlanarKind {
  PLANAR_DUPLICATE, /* site equals an earlier one and is done */
  PLANAR_FLAT,      /* all sites lie on one line */
  PLANAR_SIMPLEX,   /* edge of the first triangle */
  PLANAR_CLAIM,     /* site joins the outside set of edge, which it sees */
  PLANAR_IGNORE,    /* site lies inside: it is ignored from now on */
  PLANAR_SELECT,    /* site, furthest in edge's outside set, is next */
  PLANAR_VISIBLE,   /* site sees edge */
  PLANAR_HORIZON,   /* corner[0] bounds the visible edges; edge lies beyond */
  PLANAR_CONE,      /* edge is born between the horizon and site */
  PLANAR_RETIRE,    /* edge dies */
  PLANAR_COMPLETE,  /* no outside set is left */
} PlanarKind;

typedef struct PlanarEvent {
  PlanarKind kind;
  uint32_t edge;      /* or INDEX_NONE */
  uint32_t site;      /* of the round, or the one that is told of */
  uint32_t corner[2]; /* tail and head of a new edge, the hull on its left;
                         of the horizon, the corner; else INDEX_NONE */
} PlanarEvent;

typedef struct PlanarHook {
  void (*on_event) (const PlanarEvent *event, void *user);
  void *user;
} PlanarHook;

/* Builds the hull of @set, always furthest first.
 *
 * Cost: O(n log n) expected for sites spread at random. */
void planar_build (const SiteSet *set, const PlanarHook *hook);

#endif
