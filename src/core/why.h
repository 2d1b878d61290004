/* Why a circle holds a site: the plane of a facet cuts the paraboloid in an
 * ellipse whose shadow is the facet's circle, and the vertical gap from a
 * site's lift to that plane is the power of the site for the circle.
 */
#ifndef WHY_H
#define WHY_H

#include "frame.h"
#include "narration.h"

/* Which facet and which site a person asks about. */
typedef struct Why {
  uint32_t facet; /* of Trace.facets, or a triangle of flat input; INDEX_NONE:
                     none is chosen */
  uint32_t site;  /* INDEX_NONE: none */
} Why;

/* The facet is what is selected, or under the pointer, or its Voronoi vertex;
 * the site is the other one of the two, else @measured, else the
 * current site. */
Why
why_find (const Frame *frame, Object selection, Object hover, Object measured);

Facing why_facing (const Frame *frame, uint32_t facet);

/* The power of a site for the circle through three others, in coordinates as
 * given: the square of its distance to the centre less that of the radius. */
typedef struct Power {
  int sign;     /* exact: -1 inside, 0 on the circle, +1 outside */
  double value; /* has this sign */
} Power;

Power why_power (const SiteSet *set, const uint32_t circle[3], uint32_t site);

/* Writes a power for a label: few digits, a true minus. */
#define WHY_NUMBER_ROOM 24
void why_write_number (Power power, char text[WHY_NUMBER_ROOM]);

/* The sentence, as narration_write() makes them; empty when there is no facet
 * or no site. */
void why_write (const Frame *frame,
                Why why,
                NarrationTranslate translate,
                char text[NARRATION_ROOM]);

#endif
