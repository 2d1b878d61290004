/* The line of points equally far from two sites, in doubles: what nearest- and
 * furthest-site diagrams are clipped with. */
#ifndef BISECTOR_H
#define BISECTOR_H

#include "site.h"

/* middle + t · along, t growing to the left of tail → head. */
typedef struct Bisector {
  Site middle, along;
} Bisector;

/* A rectangle. */
typedef struct Box {
  Site low, high;
} Box;

Bisector bisector_of (const Site *tail, const Site *head);

/* Returns: the point of the line at @t. */
Site bisector_at (const Bisector *line, double t);

/* Returns: where on the line the point nearest to @at lies. */
double bisector_parameter (const Bisector *line, const Site *at);

/* Which end of the bisector of @tail and @head the centre of the circle
 * through them and @corner lies towards, for centres beyond the double range.
 *
 * Returns: 1 or -1. */
int bisector_side (const Site *tail, const Site *head, const Site *corner);

/* Narrows t[0] … t[1] to the part of the line in @box.
 *
 * Returns: false when nothing is left. */
bool bisector_clip (const Bisector *line, const Box *box, double t[2]);

/* Cuts away the part of a convex polygon that lies nearer to @other than to
 * @site, in place. @corners has room for one more.
 *
 * Returns: the number of corners left. */
uint32_t
bisector_cut (Site *corners, uint32_t n, const Site *site, const Site *other);

/* Writes the corners of @box, counter-clockwise. */
void box_corners (const Box *box, Site corners[4]);

#endif
