/* Where the objects of a canvas are drawn. */
#include "canvas.h"

#include <string.h>

static Point3
locate_site (Canvas *canvas, guint site)
{
  Session *session = canvas_get_session (canvas);
  const SiteSet *set = session_get_set (session);
  const Point3 point
      = scene_point (session_get_look (session), &set->sites[site],
                     HULL2VD_CANVAS_GET_CLASS (canvas)->is_space);
  const Projection projection = canvas_get_projection (canvas);

  return projection_apply (&projection, point);
}

static GdkRectangle
rectangle_around (const Point3 *points, guint n_points)
{
  double low[2] = { points[0].x, points[0].y };
  double high[2] = { points[0].x, points[0].y };

  for (guint i = 1; i < n_points; i++) {
    low[0] = MIN (low[0], points[i].x);
    low[1] = MIN (low[1], points[i].y);
    high[0] = MAX (high[0], points[i].x);
    high[1] = MAX (high[1], points[i].y);
  }
  /* Far points would not fit into integers. */
  for (int axis = 0; axis < 2; axis++) {
    low[axis] = CLAMP (low[axis], -1e6, 1e6);
    high[axis] = CLAMP (high[axis], -1e6, 1e6);
  }
  return (GdkRectangle){ (int)low[0] - LOCATE_MARGIN_PX,
                         (int)low[1] - LOCATE_MARGIN_PX,
                         (int)(high[0] - low[0]) + 2 * LOCATE_MARGIN_PX,
                         (int)(high[1] - low[1]) + 2 * LOCATE_MARGIN_PX };
}

/* The sites at the corners of an object; returns their number. */
static guint
list_corners (Session *session, Object object, uint32_t corners[3])
{
  const Frame *frame = session_get_frame (session);
  const Trace *trace = frame->trace;

  if (object.kind == OBJECT_SITE && object.number < trace->set->n_sites) {
    corners[0] = object.number;
    return 1;
  }
  if (object.kind == OBJECT_RIDGE && object.number < trace->n_ridges) {
    memcpy (corners, trace_ridge (trace, object.number).site,
            2 * sizeof corners[0]);
    return 2;
  }
  if (object.kind != OBJECT_FACET && object.kind != OBJECT_VERTEX)
    return 0;
  if (trace->is_flat && object.number < frame->delaunay.n_triangles)
    memcpy (corners, frame->delaunay.triangles[object.number].site,
            3 * sizeof corners[0]);
  else if (!trace->is_flat && object.number < trace->n_facets)
    memcpy (corners, trace->facets[object.number].site, 3 * sizeof corners[0]);
  else
    return 0;
  return 3;
}

guint
canvas_outline (Canvas *canvas, Object object, Point3 points[3])
{
  uint32_t corners[3];
  const guint n = list_corners (canvas_get_session (canvas), object, corners);

  for (guint i = 0; i < n; i++)
    points[i] = locate_site (canvas, corners[i]);
  return n;
}

gboolean
canvas_locate (Canvas *canvas, Object object, GdkRectangle *rectangle)
{
  Point3 points[3];
  const guint n = canvas_outline (canvas, object, points);

  if (n == 0)
    return FALSE;
  *rectangle = rectangle_around (points, n);
  return TRUE;
}
