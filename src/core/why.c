#include "why.h"

#include "number.h"
#include "predicate.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The marker of strings to translate. */
#define N_(text) text

#define MINUS "\xe2\x88\x92"

static bool
has_facet (const Frame *frame, uint32_t facet)
{
  if (frame->trace->is_flat)
    return facet < frame->delaunay.n_triangles;
  return facet < frame->trace->n_facets
         && frame_facet_roles (frame, facet) != 0;
}

/* A Voronoi vertex is called by the first facet of its circle. */
static uint32_t
facet_of (const Frame *frame, Object object)
{
  if ((object.kind == OBJECT_FACET || object.kind == OBJECT_VERTEX)
      && has_facet (frame, object.number))
    return object.number;
  return INDEX_NONE;
}

static uint32_t
site_of (const Frame *frame, Object object)
{
  return object.kind == OBJECT_SITE && object.number < frame->n_sites
             ? object.number
             : INDEX_NONE;
}

static uint32_t
current_site (const Frame *frame)
{
  const Trace *trace = frame->trace;

  if (frame->round == INDEX_NONE
      || frame->step > trace->rounds[frame->round].end)
    return INDEX_NONE;
  return trace->rounds[frame->round].site;
}

Why
why_find (const Frame *frame, Object selection, Object hover, Object measured)
{
  Why why = { facet_of (frame, selection), site_of (frame, hover) };

  if (why.facet == INDEX_NONE) {
    why.facet = facet_of (frame, hover);
    why.site = site_of (frame, selection);
  }
  if (why.site == INDEX_NONE)
    why.site = site_of (frame, measured);
  if (why.site == INDEX_NONE)
    why.site = current_site (frame);
  return why;
}

/* Returns: the sites of the facet; its shadow's corners. */
static const uint32_t *
corners_of (const Frame *frame, uint32_t facet)
{
  return frame->trace->is_flat ? frame->delaunay.triangles[facet].site
                               : frame->trace->facets[facet].site;
}

Facing
why_facing (const Frame *frame, uint32_t facet)
{
  return frame->trace->is_flat ? FACING_LOWER
                               : frame->trace->facets[facet].facing;
}

/* From the site in question all differences are short, so that little cancels
 * where the power is small. */
static double
rounded_power (const Site *a, const Site *b, const Site *c, const Site *p)
{
  const double ax = a->x - p->x, ay = a->y - p->y;
  const double bx = b->x - p->x, by = b->y - p->y;
  const double cx = c->x - p->x, cy = c->y - p->y;
  const double area
      = (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
  const double determinant = (ax * ax + ay * ay) * (bx * cy - by * cx)
                             + (bx * bx + by * by) * (cx * ay - cy * ax)
                             + (cx * cx + cy * cy) * (ax * by - ay * bx);

  return -determinant / area;
}

/* The sign is that of the incircle test; rounding may only shrink the number
 * to the least that there is. */
Power
why_power (const SiteSet *set, const uint32_t circle[3], uint32_t site)
{
  const Site *a = &set->sites[circle[0]], *b = &set->sites[circle[1]];
  const Site *c = &set->sites[circle[2]], *p = &set->sites[site];
  const int turn = orient (a, b, c);
  Power power = { .sign = turn * lift_orient (a, b, c, p) };

  power.value = rounded_power (a, b, c, p);
  if (power.sign == 0)
    power.value = 0;
  else if (!(power.value * power.sign > 0))
    power.value = power.sign * DBL_MIN;
  power.value = ldexp (power.value, 2 * set->exponent);
  /* Nor may it lose a number that is as large as there are any. */
  if (!(fabs (power.value) <= DBL_MAX))
    power.value = power.sign * DBL_MAX;
  return power;
}

/* Three significant digits, the same in every locale: as a whole number and
 * a power of ten, which is read as the nearest double. */
void
why_write_number (Power power, char text[WHY_NUMBER_ROOM])
{
  const double size = fabs (power.value);
  const double exponent = floor (log10 (size)) - 2;
  char rounded[NUMBER_ROOM], digits[NUMBER_ROOM] = "0";
  double number;

  if (power.sign != 0) {
    snprintf (rounded, sizeof rounded, "%.0fe%d",
              round (size * pow (10, -exponent)), (int)exponent);
    number_write (number_parse (rounded, &number) == NULL ? size : number,
                  digits);
  }
  snprintf (text, WHY_NUMBER_ROOM, "%s%.20s", power.sign < 0 ? MINUS : "",
            digits);
}

static bool
is_corner (const uint32_t corner[3], uint32_t site)
{
  return corner[0] == site || corner[1] == site || corner[2] == site;
}

/* A vertical facet has no circle: its plane stands on a line. */
static const char *
vertical_template (const Frame *frame, const Why *why)
{
  const uint32_t *corner = corners_of (frame, why->facet);
  const Site *sites = frame->trace->set->sites;
  const int side = lift_orient (&sites[corner[0]], &sites[corner[1]],
                                &sites[corner[2]], &sites[why->site]);

  if (side > 0)
    return N_ ("{f} is vertical and has no circle: {p} lies beyond its hull "
               "edge, so {p} sees it.");
  if (side < 0)
    return N_ ("{f} is vertical and has no circle: {p} lies on the inner side "
               "of its hull edge, so {p} does not see it.");
  return N_ ("{f} is vertical and has no circle: {p} lies on the line of its "
             "hull edge.");
}

static const char *
circle_template (Facing facing, int sign)
{
  const bool is_upper = facing == FACING_UPPER;

  if (sign == 0)
    return N_ ("{p} lies on {f}’s circle: its power is 0, its lift lies in "
               "the plane of {f}.");
  if (sign > 0)
    return is_upper ? N_ ("{p} lies outside {f}’s circle, by a power of {n}: "
                          "its lift is that far above {f}’s plane, so {p} "
                          "sees {f}.")
                    : N_ ("{p} lies outside {f}’s circle, by a power of {n}: "
                          "its lift is that far above {f}’s plane.");
  return is_upper ? N_ ("{p} lies inside {f}’s circle, by a power of {n}: its "
                        "lift is that far below {f}’s plane.")
                  : N_ ("{p} lies inside {f}’s circle, by a power of {n}: its "
                        "lift is that far below {f}’s plane, so {p} sees {f}.");
}

/* Replaces {p}, {f} and {n}. */
static void
fill (const char *template,
      Why why,
      const char *number,
      char text[NARRATION_ROOM])
{
  size_t n = 0;

  for (; *template != '\0' && n + 32 < NARRATION_ROOM; template ++) {
    char *to = text + n;

    if (strncmp (template, "{p}", 3) == 0)
      n += (size_t)snprintf (to, 32, "s%u", why.site);
    else if (strncmp (template, "{f}", 3) == 0)
      n += (size_t)snprintf (to, 32, "f%u", why.facet);
    else if (strncmp (template, "{n}", 3) == 0)
      n += (size_t)snprintf (to, 32, "%s", number);
    else {
      text[n++] = *template;
      continue;
    }
    template += 2;
  }
  text[n] = '\0';
}

void
why_write (const Frame *frame,
           Why why,
           NarrationTranslate translate,
           char text[NARRATION_ROOM])
{
  const char *template;
  char number[WHY_NUMBER_ROOM] = "";
  const uint32_t *corner;

  text[0] = '\0';
  if (why.facet == INDEX_NONE || why.site == INDEX_NONE)
    return;
  corner = corners_of (frame, why.facet);
  if (is_corner (corner, why.site)) {
    template = N_ ("{p} is a corner of {f}: its lift lies in {f}’s plane.");
  } else if (why_facing (frame, why.facet) == FACING_VERTICAL) {
    template = vertical_template (frame, &why);
  } else {
    const Power power = why_power (frame->trace->set, corner, why.site);

    why_write_number (power, number);
    template = circle_template (why_facing (frame, why.facet), power.sign);
  }
  fill (translate == NULL ? template : translate (template), why, number, text);
}
