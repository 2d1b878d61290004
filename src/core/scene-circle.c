/* Circumcircles, drawn where they cross a rectangle, however large they are.
 */
#include "clip.h"
#include "scene-builder.h"

#include <math.h>

#define N_CORDS 144   /* of a whole circle */
#define STRAIGHT 1e12 /* radius beyond which a circle looks straight */
#define N_CONTOURS 5
#define CONTOUR_HEIGHT 0.4
#define HALF_TURN 3.14159265358979323846

/* A circle seen from one of its points: there it is exact, even where its
 * centre is too far away for doubles. */
typedef struct Circle {
  Point3 on;     /* a point of it */
  Pixel inwards; /* direction to the centre, length 1 */
  double radius;
} Circle;

static Circle
circle_through (Point3 a, Point3 b, Point3 c)
{
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double ex = c.x - a.x, ey = c.y - a.y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double area = dx * ey - dy * ex;
  const double sign = area < 0 ? -1 : 1;
  const Pixel to = { sign * (d * ey - e * dy), sign * (e * dx - d * ex) };
  const double length = hypot (to.x, to.y);
  const double radius = length / (2 * fabs (area));

  return (Circle){ a,
                   { to.x / length, to.y / length },
                   radius < STRAIGHT ? radius : STRAIGHT };
}

/* The point by @angle further round than circle->on. */
static Point3
circle_at (const Circle *circle, double angle)
{
  const double half = sin (angle / 2);
  const double in = 2 * circle->radius * half * half;
  const double on = circle->radius * sin (angle);

  return (Point3){
    circle->on.x + in * circle->inwards.x + on * circle->inwards.y,
    circle->on.y + in * circle->inwards.y - on * circle->inwards.x, 0
  };
}

/* The angle beyond which no point of the circle lies in the box. */
static double
angle_of_box (const Circle *circle, const Point3 box[2])
{
  const double x
      = fmax (fabs (box[0].x - circle->on.x), fabs (box[1].x - circle->on.x));
  const double y
      = fmax (fabs (box[0].y - circle->on.y), fabs (box[1].y - circle->on.y));
  const double part = hypot (x, y) / (2 * circle->radius);

  return part < 1 ? 2 * asin (part) : HALF_TURN;
}

typedef struct Pen {
  SceneBuilder *builder;
  Role role;
  Object object;
  double rim; /* of the paraboloid that it is lifted onto; 0: of none */
  Pixel at;   /* the end of the current item */
  bool is_down;
} Pen;

static void
pen_point (Pen *pen, Pixel at)
{
  const SceneLook *look = pen->builder->look;
  const double z = look->lift * (look->raise + at.x * at.x + at.y * at.y);

  scene_add_point (pen->builder, (Point3){ at.x, at.y, pen->rim > 0 ? z : 0 });
}

/* Cuts a segment off where it leaves the disc round 0.
 *
 * Returns: whether a part of it is left. */
static bool
clip_to_disc (double radius, Pixel ends[2])
{
  const Pixel from = ends[0];
  const Pixel by = { ends[1].x - from.x, ends[1].y - from.y };
  const double a = by.x * by.x + by.y * by.y;
  const double b = from.x * by.x + from.y * by.y;
  const double c = from.x * from.x + from.y * from.y - radius * radius;
  const double root = sqrt (fmax (b * b - a * c, 0));
  const double first = fmax ((-b - root) / a, 0);
  const double last = fmin ((-b + root) / a, 1);

  if (!(first < last))
    return false;
  if (last < 1)
    ends[1] = (Pixel){ from.x + last * by.x, from.y + last * by.y };
  if (first > 0)
    ends[0] = (Pixel){ from.x + first * by.x, from.y + first * by.y };
  return true;
}

static void
pen_draw (Pen *pen, const Point3 box[2], Point3 from, Point3 to)
{
  Pixel ends[2] = { { from.x, from.y }, { to.x, to.y } };

  if (!clip_to_rectangle ((Pixel){ box[0].x, box[0].y },
                          (Pixel){ box[1].x, box[1].y }, ends)
      || (pen->rim > 0 && !clip_to_disc (pen->rim, ends))) {
    pen->is_down = false;
    return;
  }
  if (!pen->is_down || pen->at.x != ends[0].x || pen->at.y != ends[0].y) {
    scene_add (pen->builder, SHAPE_PATH, pen->role, pen->object);
    pen_point (pen, ends[0]);
  }
  pen_point (pen, ends[1]);
  pen->at = ends[1];
  pen->is_down = true;
}

static void
draw_circle (Pen *pen, const Circle *circle, const Point3 box[2])
{
  const double end = angle_of_box (circle, box);
  Point3 last = circle_at (circle, -end);
  int i;

  for (i = 1; i <= N_CORDS; i++) {
    const bool is_closed = i == N_CORDS && end == HALF_TURN;
    const Point3 next
        = circle_at (circle, is_closed ? -end : -end + 2 * end * i / N_CORDS);

    pen_draw (pen, box, last, next);
    last = next;
  }
}

static void
add_circle (Pen *pen, const uint32_t site[3], const Point3 box[2])
{
  const SceneBuilder *builder = pen->builder;
  const Circle circle = circle_through (scene_at (builder, site[0], false),
                                        scene_at (builder, site[1], false),
                                        scene_at (builder, site[2], false));

  /* Sites that share their doubles in the scene have no circle to show. */
  if (isfinite (circle.inwards.x))
    draw_circle (pen, &circle, box);
}

void
scene_add_circle (SceneBuilder *builder,
                  Role role,
                  Object object,
                  const uint32_t site[3],
                  const Point3 box[2])
{
  Pen pen = { .builder = builder, .role = role, .object = object };

  add_circle (&pen, site, box);
}

void
scene_add_ellipse (SceneBuilder *builder, const uint32_t site[3])
{
  const double rim = scene_rim (builder);
  const Point3 box[2] = { { -rim, -rim, 0 }, { rim, rim, 0 } };
  Pen pen = { .builder = builder, .role = ROLE_ELLIPSE, .rim = rim };

  add_circle (&pen, site, box);
}

void
scene_add_contours (SceneBuilder *builder, const Point3 box[2])
{
  const double lift = builder->look->lift;
  int i;

  if (!(lift < 1) || !scene_has_layer (builder, LAYER_PARABOLOID))
    return;
  for (i = 1; i <= N_CONTOURS; i++) {
    const double radius = sqrt (i * CONTOUR_HEIGHT / lift);
    const Circle circle = { { radius, 0, 0 }, { -1, 0 }, radius };
    Pen pen = { .builder = builder, .role = ROLE_CONTOUR };

    if (radius < STRAIGHT)
      draw_circle (&pen, &circle, box);
  }
}

/* A facet that is not lower has a circle too, of which the reverse holds. */
static void
add_upper_circles (SceneBuilder *builder, const Point3 box[2])
{
  const Frame *frame = builder->frame;
  uint32_t i;

  for (i = 0; i < frame->n_facets; i++) {
    const uint32_t facet = frame->facets[i].facet;
    const FacetRow *row = &frame->trace->facets[facet];

    if (row->facing == FACING_UPPER && (frame->facets[i].roles & FACET_VISIBLE)
        && !(frame->facets[i].roles & FACET_RETIRED))
      scene_add_circle (builder, ROLE_CIRCLE_UPPER,
                        (Object){ OBJECT_FACET, facet }, row->site, box);
  }
}

/* Dots have little ink: what is pale would be lost on a cone's shadow. */
static void
keep_ink (Scene *scene, uint32_t first)
{
  uint32_t i;

  for (i = first; i < scene->n_items; i++)
    if (scene->items[i].role == ROLE_CIRCLE_UPPER
        && scene->items[i].emphasis == EMPHASIS_PALE)
      scene->items[i].emphasis = EMPHASIS_NORMAL;
}

static void
add_circles (SceneBuilder *builder, const Point3 box[2])
{
  const Frame *frame = builder->frame;
  const bool has_layer = scene_has_layer (builder, LAYER_CIRCLES);
  uint32_t group;

  for (group = 0; group < frame->voronoi.n_vertices; group++) {
    const uint32_t triangle = frame->voronoi.vertices[group].triangle;
    const bool is_dying = frame->is_dying[group];

    if (is_dying || has_layer)
      scene_add_circle (builder, is_dying ? ROLE_CIRCLE_VISIBLE : ROLE_CIRCLE,
                        scene_vertex_object (builder, group),
                        frame->delaunay.triangles[triangle].site, box);
  }
  add_upper_circles (builder, box);
}

void
scene_add_circles (SceneBuilder *builder, const Point3 box[2], bool over_cone)
{
  const uint32_t first = builder->scene->n_items;

  if ((builder->look->mask & MASK_FACING)
      || over_cone != scene_has_cone_shadow (builder))
    return;
  add_circles (builder, box);
  if (over_cone)
    keep_ink (builder->scene, first);
}
