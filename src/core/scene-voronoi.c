/* The Voronoi diagram of a frame in scene coordinates. */
#include "memory.h"
#include "scene-builder.h"

#include <math.h>
#include <stdlib.h>

/* Where the sites use fewer bits than this below their first, a Voronoi
 * vertex as doubles of their units is too coarse to draw. */
#define COARSE 0x1p-26

struct SceneDiagram {
  SceneBuilder *builder;
  const Voronoi *voronoi; /* that of the frame, or one in scene units */
  Point3 low, high;
  Box box;           /* in the units of voronoi */
  Site *corners;     /* room for any cell */
  bool is_rescaled;  /* then all below is its own */
  SiteSet set;       /* scene units */
  Delaunay delaunay; /* borrows all but set */
  Voronoi own;       /* borrows all but delaunay, vertices and edges */
};

static bool
is_coarse (const Extent *extent)
{
  const double offset = fmax (fabs (extent->centre.x), fabs (extent->centre.y));

  return extent->radius < COARSE * offset;
}

/* Differences of the sites are exact here, so this is right in spite of its
 * simplicity. */
static Site
circumcentre (const Site *a, const Site *b, const Site *c)
{
  const double dx = b->x - a->x, dy = b->y - a->y;
  const double ex = c->x - a->x, ey = c->y - a->y;
  const double d = dx * dx + dy * dy, e = ex * ex + ey * ey;
  const double area = dx * ey - dy * ex;

  return (Site){ a->x + (d * ey - e * dy) / (2 * area),
                 a->y + (e * dx - d * ex) / (2 * area) };
}

/* Makes a copy of the diagram whose units are those of the scene. */
static void
rescale (SceneDiagram *diagram)
{
  const Voronoi *from = &diagram->builder->frame->voronoi;
  const SiteSet *set = from->delaunay->set;
  Site *sites = memory_new (set->n_sites, sizeof *sites);
  uint32_t i;

  diagram->set = *set;
  diagram->set.sites = sites;
  for (i = 0; i < set->n_sites; i++) {
    const Point3 at = scene_at (diagram->builder, i, false);

    sites[i] = (Site){ at.x, at.y };
  }
  diagram->delaunay = *from->delaunay;
  diagram->delaunay.set = &diagram->set;
  diagram->own = *from;
  diagram->own.delaunay = &diagram->delaunay;
  diagram->own.vertices
      = memory_new (from->n_vertices, sizeof *diagram->own.vertices);
  for (i = 0; i < from->n_vertices; i++) {
    const uint32_t triangle = from->vertices[i].triangle;
    const uint32_t *site = from->delaunay->triangles[triangle].site;

    diagram->own.vertices[i] = (VoronoiVertex){
      circumcentre (&sites[site[0]], &sites[site[1]], &sites[site[2]]), triangle
    };
  }
  diagram->voronoi = &diagram->own;
}

SceneDiagram *
scene_diagram_new (SceneBuilder *builder, const Point3 box[2])
{
  SceneDiagram *diagram = memory_new (1, sizeof *diagram);

  diagram->builder = builder;
  diagram->voronoi = &builder->frame->voronoi;
  diagram->low = box[0];
  diagram->high = box[1];
  diagram->box.low = scene_site (builder->look, box[0]);
  diagram->box.high = scene_site (builder->look, box[1]);
  diagram->is_rescaled = is_coarse (&builder->look->extent);
  if (diagram->is_rescaled) {
    rescale (diagram);
    diagram->box.low = (Site){ box[0].x, box[0].y };
    diagram->box.high = (Site){ box[1].x, box[1].y };
  }
  diagram->corners
      = memory_new (scene_diagram_room (diagram), sizeof *diagram->corners);
  return diagram;
}

void
scene_diagram_free (SceneDiagram *diagram)
{
  if (diagram->is_rescaled) {
    free (diagram->set.sites);
    free (diagram->own.vertices);
  }
  free (diagram->corners);
  free (diagram);
}

static Point3
to_scene (const SceneDiagram *diagram, Site at)
{
  if (diagram->is_rescaled)
    return (Point3){ at.x, at.y, 0 };
  return scene_point (diagram->builder->look, &at, false);
}

Point3
scene_diagram_point (const SceneDiagram *diagram, Site at)
{
  return to_scene (diagram, at);
}

void
scene_diagram_preview (const SceneDiagram *diagram, Site at, Preview *preview)
{
  const SceneBuilder *builder = diagram->builder;
  const Point3 point = scene_point (builder->look, &at, false);

  preview_init (preview, builder->frame->trace->set, at, diagram->voronoi,
                diagram->is_rescaled ? (Site){ point.x, point.y } : at,
                &diagram->box);
}

static void
add_cell (SceneDiagram *diagram, uint32_t site)
{
  SceneBuilder *builder = diagram->builder;
  const uint32_t n = voronoi_clip_cell (diagram->voronoi, site, &diagram->box,
                                        diagram->corners);
  const RoundRow *round = NULL;
  SceneItem *item;
  uint32_t i;

  if (n == 0)
    return;
  if (builder->is_round)
    round = &builder->frame->trace->rounds[builder->frame->round];
  item = scene_add (builder, SHAPE_POLYGON, ROLE_CELL,
                    (Object){ OBJECT_SITE, site });
  item->hue = scene_hue (builder, site);
  if (round != NULL && site == round->site)
    item->emphasis = EMPHASIS_LOUD;
  for (i = 0; i < n; i++)
    scene_add_point (builder, to_scene (diagram, diagram->corners[i]));
}

/* The largest number of corners that a cell of the diagram can have. */
uint32_t
scene_diagram_room (const SceneDiagram *diagram)
{
  const Delaunay *delaunay = diagram->voronoi->delaunay;
  uint32_t i, room = 0;

  for (i = 0; i < delaunay->n_active; i++) {
    const uint32_t n
        = voronoi_cell_room (diagram->voronoi, delaunay->active[i]);

    room = n > room ? n : room;
  }
  return room;
}

uint32_t
scene_diagram_cell (const SceneDiagram *diagram, uint32_t site, Point3 *corners)
{
  const uint32_t n = voronoi_clip_cell (diagram->voronoi, site, &diagram->box,
                                        diagram->corners);
  uint32_t i;

  for (i = 0; i < n; i++)
    corners[i] = to_scene (diagram, diagram->corners[i]);
  return n;
}

uint32_t
scene_diagram_n_edges (const SceneDiagram *diagram)
{
  return diagram->voronoi->n_edges;
}

bool
scene_diagram_edge (const SceneDiagram *diagram,
                    uint32_t edge,
                    uint32_t site[2],
                    Point3 ends[2])
{
  Site at[2];

  if (!voronoi_clip_edge (diagram->voronoi, edge, &diagram->box, at))
    return false;
  site[0] = diagram->voronoi->edges[edge].site[0];
  site[1] = diagram->voronoi->edges[edge].site[1];
  ends[0] = to_scene (diagram, at[0]);
  ends[1] = to_scene (diagram, at[1]);
  return true;
}

void
scene_add_cells (SceneDiagram *diagram)
{
  const Delaunay *delaunay = diagram->voronoi->delaunay;
  uint32_t i;

  for (i = 0; i < delaunay->n_active; i++)
    add_cell (diagram, delaunay->active[i]);
}

static const uint32_t *
edge_corners (const SceneBuilder *builder, uint32_t edge)
{
  return builder->frame->voronoi.edges[edge].site;
}

void
scene_add_voronoi_edges (SceneDiagram *diagram)
{
  SceneBuilder *builder = diagram->builder;
  const uint32_t n_edges = diagram->voronoi->n_edges;
  uint32_t *order = scene_order (builder, n_edges, 2, edge_corners);
  uint32_t i;

  for (i = 0; i < n_edges; i++) {
    const VoronoiEdge *edge = &diagram->voronoi->edges[order[i]];
    const int first = edge->site[1] < edge->site[0];
    Site ends[2];

    if (voronoi_clip_edge (diagram->voronoi, order[i], &diagram->box, ends))
      scene_add_segment (
          builder, ROLE_VORONOI_EDGE,
          (Object){ OBJECT_RIDGE, builder->ridge_of[edge->edge] },
          (Point3[2]){ to_scene (diagram, ends[first]),
                       to_scene (diagram, ends[!first]) });
  }
  free (order);
}

static bool
is_inside (const SceneDiagram *diagram, Point3 at)
{
  return diagram->low.x <= at.x && at.x <= diagram->high.x
         && diagram->low.y <= at.y && at.y <= diagram->high.y;
}

/* Returns: per vertex, whether more than one triangle has its circle; free
 *          with free(). */
static bool *
find_tied (const Voronoi *voronoi)
{
  const Delaunay *delaunay = voronoi->delaunay;
  bool *is_tied = memory_new (voronoi->n_vertices, sizeof *is_tied);
  uint32_t i;

  for (i = 0; i < delaunay->n_triangles; i++) {
    const uint32_t group = delaunay->triangles[i].group;

    if (voronoi->vertices[group].triangle != i)
      is_tied[group] = true;
  }
  return is_tied;
}

static void
add_vertex (SceneDiagram *diagram, Role role, uint32_t group)
{
  SceneBuilder *builder = diagram->builder;
  const Point3 at = to_scene (diagram, diagram->voronoi->vertices[group].at);

  if (is_inside (diagram, at))
    scene_add_mark (builder, role, scene_vertex_object (builder, group), at,
                    NULL);
}

/* In the order of the triangles that stand for them. */
static void
add_vertices (SceneDiagram *diagram, bool is_dying)
{
  const Voronoi *voronoi = diagram->voronoi;
  const uint32_t *order = scene_order_triangles (diagram->builder);
  bool *is_tied = find_tied (voronoi);
  uint32_t i;

  for (i = 0; i < voronoi->delaunay->n_triangles; i++) {
    const uint32_t group = voronoi->delaunay->triangles[order[i]].group;

    if (group < voronoi->n_vertices
        && voronoi->vertices[group].triangle == order[i]
        && diagram->builder->frame->is_dying[group] == is_dying)
      add_vertex (diagram,
                  is_dying         ? ROLE_VORONOI_VERTEX_DYING
                  : is_tied[group] ? ROLE_VORONOI_VERTEX_TIED
                                   : ROLE_VORONOI_VERTEX,
                  group);
  }
  free (is_tied);
}

void
scene_add_voronoi_vertices (SceneDiagram *diagram)
{
  if (scene_has_layer (diagram->builder, LAYER_VORONOI))
    add_vertices (diagram, false);
}

void
scene_add_dying_vertices (SceneDiagram *diagram)
{
  const Frame *frame = diagram->builder->frame;
  uint32_t group = 0;

  while (group < frame->voronoi.n_vertices && !frame->is_dying[group])
    group++;
  if (group < frame->voronoi.n_vertices)
    add_vertices (diagram, true);
}
