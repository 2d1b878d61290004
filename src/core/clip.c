#include "clip.h"

#include <math.h>

/* Nearer to the eye than this part of its distance nothing is shown. */
#define NEAR 0.05

static bool
is_finite_pixel (Pixel pixel)
{
  return isfinite (pixel.x) && isfinite (pixel.y);
}

static Pixel
pixel_of (const Projection *projection, const double clip[4])
{
  return (Pixel){ (1 + clip[0] / clip[3]) * projection->width / 2,
                  (1 - clip[1] / clip[3]) * projection->height / 2 };
}

bool
clip_point (const Projection *projection, Point3 point, Pixel *pixel)
{
  double clip[4];

  projection_clip_coordinates (projection, point, clip);
  *pixel = pixel_of (projection, clip);
  return clip[3] >= NEAR && is_finite_pixel (*pixel);
}

/* Where the way from @a, which is before the near plane, to @b meets it. */
static void
meet_near (const double a[4], const double b[4], double meet[4])
{
  const double t = (a[3] - NEAR) / (a[3] - b[3]);
  int i;

  for (i = 0; i < 3; i++)
    meet[i] = a[i] + t * (b[i] - a[i]);
  meet[3] = NEAR;
}

static bool
segment_before_eye (const Projection *projection,
                    const Point3 segment[2],
                    Pixel ends[2])
{
  double clip[2][4], meet[4];
  int i;

  for (i = 0; i < 2; i++)
    projection_clip_coordinates (projection, segment[i], clip[i]);
  for (i = 0; i < 2; i++) {
    const bool is_before = clip[i][3] >= NEAR;

    if (!is_before && !(clip[1 - i][3] >= NEAR))
      return false;
    if (!is_before)
      meet_near (clip[1 - i], clip[i], meet);
    ends[i] = pixel_of (projection, is_before ? clip[i] : meet);
  }
  return is_finite_pixel (ends[0]) && is_finite_pixel (ends[1]);
}

/* Narrows t[0] … t[1] to where from + t · along <= limit. */
static bool
narrow (double t[2], double from, double along, double limit)
{
  const double meet = (limit - from) / along;

  if (along == 0)
    return from <= limit;
  if (along > 0)
    t[1] = fmin (t[1], meet);
  else
    t[0] = fmax (t[0], meet);
  return t[0] <= t[1];
}

static bool
is_within (Pixel low, Pixel high, Pixel pixel)
{
  return pixel.x >= low.x && pixel.x <= high.x && pixel.y >= low.y
         && pixel.y <= high.y;
}

bool
clip_to_rectangle (Pixel low, Pixel high, Pixel ends[2])
{
  const Pixel from = ends[0];
  const Pixel along = { ends[1].x - from.x, ends[1].y - from.y };
  double t[2] = { 0, 1 };

  /* Most of what is drawn is in the view. */
  if (is_within (low, high, ends[0]) && is_within (low, high, ends[1]))
    return true;
  if (!narrow (t, from.x, along.x, high.x)
      || !narrow (t, -from.x, -along.x, -low.x)
      || !narrow (t, from.y, along.y, high.y)
      || !narrow (t, -from.y, -along.y, -low.y))
    return false;
  if (t[1] < 1)
    ends[1] = (Pixel){ from.x + t[1] * along.x, from.y + t[1] * along.y };
  if (t[0] > 0)
    ends[0] = (Pixel){ from.x + t[0] * along.x, from.y + t[0] * along.y };
  return true;
}

bool
clip_segment (const Projection *projection,
              const Point3 segment[2],
              double margin,
              Pixel ends[2])
{
  const Pixel low = { -margin, -margin };
  const Pixel high
      = { projection->width + margin, projection->height + margin };

  return segment_before_eye (projection, segment, ends)
         && clip_to_rectangle (low, high, ends);
}

/* Cuts off what lies before the eye's near plane while projecting. */
static uint32_t
polygon_before_eye (const Projection *projection,
                    const Point3 *points,
                    uint32_t n,
                    Pixel *corners)
{
  double last[4], here[4], meet[4];
  uint32_t i, n_corners = 0;

  projection_clip_coordinates (projection, points[n - 1], last);
  for (i = 0; i < n; i++) {
    const bool was_before = last[3] >= NEAR;
    int k;

    projection_clip_coordinates (projection, points[i], here);
    if (was_before != (here[3] >= NEAR)) {
      meet_near (was_before ? last : here, was_before ? here : last, meet);
      corners[n_corners++] = pixel_of (projection, meet);
    }
    if (here[3] >= NEAR)
      corners[n_corners++] = pixel_of (projection, here);
    for (k = 0; k < 4; k++)
      last[k] = here[k];
  }
  return n_corners;
}

/* A side of the rectangle: inside is where x · normal <= limit. */
typedef struct Side {
  Pixel normal;
  double limit;
} Side;

static double
beyond (const Side *side, Pixel pixel)
{
  return side->normal.x * pixel.x + side->normal.y * pixel.y - side->limit;
}

/* Works in place: a convex polygon gains at most one corner at a side, and it
 * is written after one corner more has been read.
 *
 * Source: Sutherland, Hodgman 1974. */
static uint32_t
cut (const Side *side, Pixel *corners, uint32_t n)
{
  const Pixel first = corners[0];
  Pixel last = corners[n - 1], here = first;
  uint32_t i, n_kept = 0;

  for (i = 0; i < n; i++) {
    const Pixel next = i + 1 < n ? corners[i + 1] : first;
    const double a = beyond (side, last), b = beyond (side, here);

    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const double t = a / (a - b);

      corners[n_kept++] = (Pixel){ last.x + t * (here.x - last.x),
                                   last.y + t * (here.y - last.y) };
    }
    if (b <= 0)
      corners[n_kept++] = here;
    last = here;
    here = next;
  }
  return n_kept;
}

static bool
are_within (Pixel low, Pixel high, const Pixel *corners, uint32_t n)
{
  uint32_t i;

  for (i = 0; i < n; i++)
    if (!is_within (low, high, corners[i]))
      return false;
  return true;
}

uint32_t
clip_polygon_to_rectangle (Pixel low, Pixel high, Pixel *corners, uint32_t n)
{
  const Side sides[4] = {
    { { 1, 0 }, high.x },
    { { -1, 0 }, -low.x },
    { { 0, 1 }, high.y },
    { { 0, -1 }, -low.y },
  };
  int i;

  for (i = 0; i < 4 && n > 0 && !are_within (low, high, corners, n); i++)
    n = cut (&sides[i], corners, n);
  return n < 3 ? 0 : n;
}

uint32_t
clip_polygon (const Projection *projection,
              const Point3 *points,
              uint32_t n,
              double margin,
              Pixel *corners)
{
  const Pixel low = { -margin, -margin };
  const Pixel high
      = { projection->width + margin, projection->height + margin };
  uint32_t i, n_corners;

  n_corners = polygon_before_eye (projection, points, n, corners);
  for (i = 0; i < n_corners; i++)
    if (!is_finite_pixel (corners[i]))
      return 0;
  return clip_polygon_to_rectangle (low, high, corners, n_corners);
}
