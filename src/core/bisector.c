#include "bisector.h"

#include "predicate.h"

#include <math.h>

Bisector
bisector_of (const Site *tail, const Site *head)
{
  return (Bisector){ { tail->x / 2 + head->x / 2, tail->y / 2 + head->y / 2 },
                     { tail->y - head->y, head->x - tail->x } };
}

Site
bisector_at (const Bisector *line, double t)
{
  return (Site){ line->middle.x + t * line->along.x,
                 line->middle.y + t * line->along.y };
}

double
bisector_parameter (const Bisector *line, const Site *at)
{
  const double length
      = line->along.x * line->along.x + line->along.y * line->along.y;

  return ((at->x - line->middle.x) * line->along.x
          + (at->y - line->middle.y) * line->along.y)
         / length;
}

/* The centre lies on the side of the third corner just when the angle there
 * is acute. */
int
bisector_side (const Site *tail, const Site *head, const Site *corner)
{
  const double dot = (tail->x - corner->x) * (head->x - corner->x)
                     + (tail->y - corner->y) * (head->y - corner->y);

  return dot * orient (tail, head, corner) > 0 ? 1 : -1;
}

/* Narrows t[0] … t[1] to where low <= from + t · along <= high.
 *
 * Returns: false when nothing is left. */
static bool
narrow (double t[2], double from, double along, const double range[2])
{
  double enter, leave;

  if (along == 0)
    return range[0] <= from && from <= range[1];
  enter = (range[0] - from) / along;
  leave = (range[1] - from) / along;
  t[0] = fmax (t[0], fmin (enter, leave));
  t[1] = fmin (t[1], fmax (enter, leave));
  return t[0] < t[1];
}

bool
bisector_clip (const Bisector *line, const Box *box, double t[2])
{
  const double x[2] = { box->low.x, box->high.x };
  const double y[2] = { box->low.y, box->high.y };

  return narrow (t, line->middle.x, line->along.x, x)
         && narrow (t, line->middle.y, line->along.y, y);
}

/* How far beyond the bisector a point lies, seen from its tail; only signs
 * and ratios count. */
static double
excess (const Site *point, const Bisector *line)
{
  return (point->x - line->middle.x) * line->along.y
         - (point->y - line->middle.y) * line->along.x;
}

/* Works in place: one corner is read ahead, and at most one more is written
 * than read. */
uint32_t
bisector_cut (Site *corners, uint32_t n, const Site *site, const Site *other)
{
  const Bisector line = bisector_of (site, other);
  const Site first = corners[0];
  Site last = corners[n - 1], here = first;
  uint32_t i, n_kept = 0;

  for (i = 0; i < n; i++) {
    const Site next = i + 1 < n ? corners[i + 1] : first;
    const double a = excess (&last, &line);
    const double b = excess (&here, &line);

    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const double t = a / (a - b);

      corners[n_kept++] = (Site){ last.x + t * (here.x - last.x),
                                  last.y + t * (here.y - last.y) };
    }
    if (b <= 0)
      corners[n_kept++] = here;
    last = here;
    here = next;
  }
  return n_kept;
}

void
box_corners (const Box *box, Site corners[4])
{
  corners[0] = box->low;
  corners[1] = (Site){ box->high.x, box->low.y };
  corners[2] = box->high;
  corners[3] = (Site){ box->low.x, box->high.y };
}
