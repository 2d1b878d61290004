#include "names-judge.h"

#include <math.h>

/* Names are painted on whole pixels. */
#define ROUNDING 1.0

/* Where all is drawn smaller than this there is a crowd. */
#define CROWDED 0.75

/* A line of so much ink across is heavy, px at the widths of a theme. */
#define HEAVY 2.2

void
shown_init (Shown *shown)
{
  *shown = (Shown){ .names = names_new () };
  shown->drawing = drawing_new (shown->names);
}

void
shown_clear (Shown *shown)
{
  drawing_free (shown->drawing);
  names_free (shown->names);
  scene_clear (&shown->scene);
}

void
show (Shown *shown, const Moment *moment, const Camera *camera)
{
  PlaneCamera plane_camera;
  SceneLook look;

  scene_look_init (&look, moment->frame);
  look.selection = moment->selection;
  look.measured = moment->measured;
  look.answers = moment->answers;
  look.n_answers = moment->n_answers;
  if (moment->measured.kind != OBJECT_NONE)
    look.layers |= LAYER_WHY;
  if (moment->is_space) {
    shown->projection
        = camera_projection (camera, moment->width, moment->height);
    scene_space (&shown->scene, moment->frame, &look);
  } else {
    plane_camera_init (&plane_camera);
    shown->projection = plane_camera_projection (&plane_camera, moment->width,
                                                 moment->height);
    scene_look_fit (&look, &shown->projection, 6);
    scene_plane (&shown->scene, moment->frame, &look);
  }
  drawing_set (shown->drawing, &shown->scene, &shown->projection,
               theme_get (moment->theme));
}

/* The judge */

Pixel
names_pixel_of (const Shown *shown, const SceneItem *item)
{
  const Point3 at
      = projection_apply (&shown->projection, shown->scene.points[item->first]);

  return (Pixel){ at.x, at.y };
}

PixelBox
names_letters_of (const PlacedName *placed)
{
  const float casing = (float)NAME_CASING;

  return (PixelBox){ placed->box.left + casing, placed->box.top + casing,
                     placed->box.right - casing, placed->box.bottom - casing };
}

double
names_distance_to (const PixelBox *box, Pixel at)
{
  const double x = MAX (MAX (box->left - at.x, at.x - box->right), 0);
  const double y = MAX (MAX (box->top - at.y, at.y - box->bottom), 0);

  return sqrt (x * x + y * y);
}

static gboolean
has_to_be_there (const SceneItem *item)
{
  return item->emphasis == EMPHASIS_LOUD || item->role == ROLE_SITE_APEX
         || item->lit != LIT_NONE;
}

bool
names_is_of_site (const SceneItem *item)
{
  return item->object.kind == OBJECT_SITE && item->role != ROLE_POWER;
}

/* A halo is part of its dot. */
static double
radius_of (const Style *style)
{
  const double ring = style->mark == MARK_RINGED ? style->ring_gap : 0;

  return style->halo.alpha > 0
             ? style->radius + ring + style->casing + style->halo_width
             : style->radius;
}

/* How large the site's own dot is. */
double
names_radius_at (const Drawing *drawing, Pixel at)
{
  double radius = 0;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel middle = drawing->pixels[stroke->first];

    if (stroke->kind == STROKE_MARK && fabs (middle.x - at.x) < 0.5
        && fabs (middle.y - at.y) < 0.5)
      radius = MAX (radius, radius_of (&drawing->styles[stroke->style]));
  }
  return radius;
}

static gboolean
is_within_frame (const Shown *shown, const PixelBox *box)
{
  const Drawing *drawing = shown->drawing;
  gboolean is_within = box->left >= -ROUNDING && box->top >= -ROUNDING
                       && box->right <= drawing->width + ROUNDING
                       && box->bottom <= drawing->height + ROUNDING;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const PixelBox *frame = &stroke->box;

    if (!shown->scene.is_space && stroke->place.item != INDEX_NONE
        && shown->scene.items[stroke->place.item].role == ROLE_GROUND)
      is_within = is_within && box->left > frame->left + 1
                  && box->top > frame->top + 1 && box->right < frame->right - 1
                  && box->bottom < frame->bottom - 1;
  }
  return is_within;
}

bool
names_is_apart (const Drawing *drawing, uint32_t name, const PixelBox *letters)
{
  for (uint32_t i = 0; i < drawing->n_placed; i++) {
    const PixelBox other = names_letters_of (&drawing->placed[i]);

    if (i != name && boxes_meet (letters, &other))
      return FALSE;
  }
  return TRUE;
}

/* On no mark, of sites or of Voronoi vertices. */
static gboolean
is_off_marks (const Shown *shown, const PixelBox *box)
{
  const Drawing *drawing = shown->drawing;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];

    if (stroke->kind == STROKE_MARK
        && names_distance_to (box, drawing->pixels[stroke->first]) + ROUNDING
               < drawing->styles[stroke->style].radius)
      return FALSE;
  }
  return TRUE;
}

static gboolean
is_nearest (const Shown *shown, const PixelBox *box, Pixel at, double nearer)
{
  const Drawing *drawing = shown->drawing;
  const double own
      = names_distance_to (box, at) - names_radius_at (drawing, at);

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel middle = drawing->pixels[stroke->first];
    const SceneItem *item = stroke->place.item == INDEX_NONE
                                ? NULL
                                : &shown->scene.items[stroke->place.item];

    if (stroke->kind != STROKE_MARK || item == NULL
        || item->object.kind != OBJECT_SITE
        || fabs (middle.x - at.x) + fabs (middle.y - at.y) <= 1)
      continue;
    if (names_distance_to (box, middle) - drawing->styles[stroke->style].radius
        < nearer * own)
      return FALSE;
  }
  return TRUE;
}

/* Where two lines a + t u and b + s v meet. */
bool
names_is_crossed (Pixel a, Pixel b, Pixel c, Pixel d)
{
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double by = ux * vy - uy * vx;
  const double t = ((c.x - a.x) * vy - (c.y - a.y) * vx) / by;
  const double s = ((c.x - a.x) * uy - (c.y - a.y) * ux) / by;

  return isfinite (t) && isfinite (s) && t > 0 && t < 1 && s > 0 && s < 1;
}

double
names_distance_from_line (Pixel at, Pixel a, Pixel b)
{
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = (at.x - a.x) * dx + (at.y - a.y) * dy;
  const double part = CLAMP (along / (dx * dx + dy * dy), 0, 1);

  return hypot (a.x + part * dx - at.x, a.y + part * dy - at.y);
}

/* A heavy line between a name and its dot, but for those that end there. */
static gboolean
is_cut_off (const Shown *shown, const PixelBox *box, Pixel at)
{
  const Drawing *drawing = shown->drawing;
  const Pixel middle
      = { (box->left + box->right) / 2, (box->top + box->bottom) / 2 };
  const double heavy = HEAVY * drawing->theme->line_factor * drawing->size;
  const double radius = names_radius_at (drawing, at);

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Style *style = &drawing->styles[stroke->style];
    const Pixel *pixels = &drawing->pixels[stroke->first];
    const uint32_t item = stroke->place.item;
    double own;

    if (stroke->kind != STROKE_LINE || item == INDEX_NONE
        || shown->scene.items[item].shape != SHAPE_PATH
        || style->width * style->line.alpha < heavy)
      continue;
    /* The middle of a facet has no dot, but may lie on the line. */
    own = (radius > 0 ? radius : style->width / 2) + ROUNDING;
    for (uint32_t k = 0; k + 1 < stroke->n; k++)
      if (names_is_crossed (at, middle, pixels[k], pixels[k + 1])
          && names_distance_from_line (at, pixels[k], pixels[k + 1]) > own)
        return TRUE;
  }
  return FALSE;
}

/* A thin line of the same item from dot to name. */
static gboolean
is_led (const Shown *shown, uint32_t item, const PixelBox *box, Pixel at)
{
  const Drawing *drawing = shown->drawing;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel *pixels = &drawing->pixels[stroke->first];

    if (stroke->kind == STROKE_LINE && stroke->place.item == item
        && stroke->n == 2
        && hypot (pixels[0].x - at.x, pixels[0].y - at.y)
               < names_radius_at (drawing, at) + LEADER_BEGINS
        && names_distance_to (box, pixels[1]) < 4)
      return TRUE;
  }
  return FALSE;
}

const char *
names_fault_of (const Shown *shown,
                uint32_t name,
                const PixelBox *box,
                double nearer)
{
  const PlacedName *placed = &shown->drawing->placed[name];
  const SceneItem *item = &shown->scene.items[placed->item];
  const Pixel at = names_pixel_of (shown, item);

  if (!is_within_frame (shown, box))
    return "lies beyond the frame";
  if (!names_is_apart (shown->drawing, name, box))
    return "lies on another name";
  if (!has_to_be_there (item) && !is_off_marks (shown, box))
    return "lies on a mark";
  if (is_led (shown, placed->item, box, at))
    return NULL;
  if (!is_off_marks (shown, box))
    return "lies on a mark";
  if (!is_nearest (shown, box, at, nearer))
    return "is nearer to another site";
  return is_cut_off (shown, box, at) ? "lies beyond a heavy line" : NULL;
}

/* Whether a place lies on the same side of all lines of a triangle. */
static gboolean
is_in_triangle (Pixel at, const Pixel corners[3])
{
  guint n_left = 0;

  for (guint i = 0; i < 3; i++) {
    const Pixel a = corners[i], b = corners[(i + 1) % 3];

    n_left += (b.x - a.x) * (at.y - a.y) > (b.y - a.y) * (at.x - a.x);
  }
  return n_left % 3 == 0;
}

/* Whether a place lies in a facet that is drawn, or in none that is. */
static gboolean
is_in_facet (const Shown *shown, Object facet, Pixel at)
{
  const Scene *scene = &shown->scene;

  for (uint32_t i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];
    Pixel corners[3];

    if (item->shape != SHAPE_POLYGON || item->n != 3
        || !object_equal (item->object, facet)
        || (scene->is_space && item->pass == PASS_GROUND))
      continue;
    for (guint k = 0; k < 3; k++)
      if (!clip_point (&shown->projection, scene->points[item->first + k],
                       &corners[k]))
        return TRUE;
    return is_in_triangle (at, corners);
  }
  return TRUE;
}

/* The name of a facet stands in it, or a line leads there; in a crowd, where
 * facets are smaller than names, it is near. */
static void
judge_facet (const Shown *shown, uint32_t name, const char *what)
{
  const PlacedName *placed = &shown->drawing->placed[name];
  const SceneItem *item = &shown->scene.items[placed->item];
  const Pixel at = names_pixel_of (shown, item);
  const PixelBox box = names_letters_of (placed);

  const Pixel middle
      = { (box.left + box.right) / 2, (box.top + box.bottom) / 2 };

  if (shown->drawing->size >= CROWDED
      && (is_cut_off (shown, &box, at)
          || !is_in_facet (shown, item->object, middle))
      && !is_led (shown, placed->item, &box, at))
    g_error ("%s: %s at %g, %g lies outside its facet, in %g … %g, %g … %g",
             what, item->label, at.x, at.y, box.left, box.right, box.top,
             box.bottom);
}

guint
names_judge (const Shown *shown, const char *what)
{
  guint n_names = 0;

  for (uint32_t i = 0; i < shown->drawing->n_placed; i++) {
    const PlacedName *placed = &shown->drawing->placed[i];
    const SceneItem *item = &shown->scene.items[placed->item];
    const PixelBox box = names_letters_of (placed);
    const char *fault;

    if (item->role == ROLE_FACET_NAME)
      judge_facet (shown, i, what);
    if (!names_is_of_site (item))
      continue;
    fault = names_fault_of (shown, i, &box, NEARER);
    if (fault != NULL)
      g_error ("%s: %s %s", what, item->label, fault);
    n_names++;
  }
  return n_names;
}

void
names_check_none_is_missing (const Shown *shown, const char *what)
{
  for (uint32_t i = 0; i < shown->scene.n_items; i++) {
    const SceneItem *item = &shown->scene.items[i];
    gboolean is_named = FALSE;

    if (item->label == NULL || !has_to_be_there (item))
      continue;
    for (uint32_t k = 0; k < shown->drawing->n_placed; k++)
      is_named = is_named || shown->drawing->placed[k].item == i;
    if (!is_named)
      g_error ("%s: %s has no name", what, item->label);
  }
}

double
names_ink_under (const Shown *shown, const PixelBox *letters)
{
  const Drawing *drawing = shown->drawing;
  const Pixel low = { letters->left - 3, letters->top - 3 };
  const Pixel high = { letters->right + 3, letters->bottom + 3 };
  double ink = 0;

  for (uint32_t i = 0; i < drawing->n_strokes; i++) {
    const Stroke *stroke = &drawing->strokes[i];
    const Pixel *pixels = &drawing->pixels[stroke->first];
    const double width = drawing->styles[stroke->style].width;

    if (stroke->kind != STROKE_LINE)
      continue;
    for (uint32_t k = 0; k + 1 < stroke->n; k++) {
      Pixel ends[2] = { pixels[k], pixels[k + 1] };

      if (clip_to_rectangle (low, high, ends))
        ink += width * hypot (ends[1].x - ends[0].x, ends[1].y - ends[0].y);
    }
  }
  return ink;
}
