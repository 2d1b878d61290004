#include "label.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <string.h>

/* The raster: a cell is so many pixels wide and high. */
#define CELL 2.0

/* Ink in a cell: how bad it is to cover. */
#define INK_PALE 1 /* lines that are hardly seen, below PALE_PX */
#define INK_LINE 3
#define INK_HEAVY 12 /* lines of HEAVY_PX and more */
#define INK_NAME 30  /* of a name that may be covered */
#define INK_MARK 60
#define INK_LABEL 255 /* counts as COST_LABEL */
#define PALE_PX 0.6
#define HEAVY_PX 2.2
#define WIDE_PX 3.5 /* from here on ink lies in cells side by side */

#define MANY_LABELS 24

/* Places round a mark: directions, and distances in px. */
#define N_DIRECTIONS 16
#define N_DISTANCES 4
#define N_DISTANCES_MOST 5 /* of numbers */
#define DISTANCE_STEP 5.0
#define TURN 6.28318530717958647692

/* What a place costs besides ink; beyond the limit a label is left out. */
#define COST_DISTANCE 8
#define COST_OFF 24 /* the same for what is best right on its mark */
#define COST_OUTSIDE 4000
#define COST_LIMIT 1400
#define COST_LABEL 4000

/* A name that is nearer to the mark of another would seem to be its name: it is
 * left out, and where that must not be it rather covers some lines. */
#define COST_MISTAKEN 220
#define COST_DOUBTFUL 40
#define DOUBTFUL_PX 3.0 /* hardly nearer to its own mark */

/* A mark that has a name. */
typedef struct Named {
  Pixel at;
  double reach;
} Named;

struct LabelSheet {
  int left, top; /* its first cell */
  int columns, rows;
  double width, height;
  unsigned char *ink;
  guint32 *sums;  /* of the ink above and left of each cell, before any label */
  GArray *named;  /* Named */
  GArray *rivals; /* Named: those near the label in hand */
  Pixel directions[N_DIRECTIONS];
};

/* Directions fan out from the upper right to both sides. */
static void
find_directions (LabelSheet *sheet)
{
  int i;

  for (i = 0; i < N_DIRECTIONS; i++) {
    const int side = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const double angle = TURN / 8 + TURN * side / N_DIRECTIONS;

    sheet->directions[i] = (Pixel){ cos (angle), -sin (angle) };
  }
}

LabelSheet *
label_sheet_new (double width, double height, const PixelBox *area)
{
  LabelSheet *sheet = g_new0 (LabelSheet, 1);
  int right = (int)ceil (width / CELL), bottom = (int)ceil (height / CELL);

  if (area != NULL) {
    sheet->left = CLAMP ((int)floor (area->left / CELL), 0, right);
    sheet->top = CLAMP ((int)floor (area->top / CELL), 0, bottom);
    right = CLAMP ((int)ceil (area->right / CELL), sheet->left, right);
    bottom = CLAMP ((int)ceil (area->bottom / CELL), sheet->top, bottom);
  }
  sheet->width = width;
  sheet->height = height;
  sheet->columns = right - sheet->left;
  sheet->rows = bottom - sheet->top;
  sheet->ink = g_malloc0 ((gsize)sheet->columns * (gsize)sheet->rows + 1);
  sheet->named = g_array_new (FALSE, FALSE, sizeof (Named));
  sheet->rivals = g_array_new (FALSE, FALSE, sizeof (Named));
  find_directions (sheet);
  return sheet;
}

void
label_sheet_free (LabelSheet *sheet)
{
  g_array_unref (sheet->named);
  g_array_unref (sheet->rivals);
  g_free (sheet->ink);
  g_free (sheet->sums);
  g_free (sheet);
}

static void
spill (LabelSheet *sheet, double x, double y, unsigned char ink)
{
  /* Rounded towards 0 is rounded down where the sheet is. */
  const int column = (int)(x / CELL) - sheet->left;
  const int row = (int)(y / CELL) - sheet->top;
  unsigned char *cell;

  if (x < 0 || y < 0 || column < 0 || column >= sheet->columns || row < 0
      || row >= sheet->rows)
    return;
  cell = &sheet->ink[row * sheet->columns + column];
  *cell = MAX (*cell, ink);
}

/* Which of the places 0 … @n on a line from @from by @by have their coordinate
 * between @low and @high; some others may be among them. */
static void
narrow (double from, double by, double low, double high, int n, int range[2])
{
  const double a = (low - from) / by * n, b = (high - from) / by * n;
  const double first = floor (MIN (a, b)) - 1, last = ceil (MAX (a, b)) + 1;

  /* A line that runs along has no such places, or all are. */
  if (!isfinite (a) || !isfinite (b))
    return;
  range[0] = (int)CLAMP (first, range[0], n + 1);
  range[1] = (int)CLAMP (last, -1, range[1]);
}

static void
add_stroke (LabelSheet *sheet, const Pixel ends[2], unsigned char ink)
{
  const double left = sheet->left * CELL, top = sheet->top * CELL;
  Pixel cut[2] = { ends[0], ends[1] };
  double dx, dy;
  int range[2];
  int i, n;

  if (!clip_to_rectangle ((Pixel){ 0, 0 },
                          (Pixel){ sheet->width, sheet->height }, cut))
    return;
  dx = cut[1].x - cut[0].x;
  dy = cut[1].y - cut[0].y;
  n = (int)ceil (MAX (fabs (dx), fabs (dy)) / CELL) + 1;
  range[0] = 0;
  range[1] = n;
  narrow (cut[0].x, dx, left, left + sheet->columns * CELL, n, range);
  narrow (cut[0].y, dy, top, top + sheet->rows * CELL, n, range);
  for (i = range[0]; i <= range[1]; i++)
    spill (sheet, cut[0].x + dx * i / n, cut[0].y + dy * i / n, ink);
}

void
label_sheet_line (LabelSheet *sheet, const Pixel ends[2], double width_px)
{
  const unsigned char ink = width_px >= HEAVY_PX  ? INK_HEAVY
                            : width_px >= PALE_PX ? INK_LINE
                                                  : INK_PALE;
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  const double length = hypot (dx, dy);
  const double across[2] = { -width_px * dy / length, width_px * dx / length };
  int n = width_px < WIDE_PX || length <= 0 ? 1 : (int)(width_px / CELL) + 1;

  for (int i = 0; i < n; i++) {
    const double part = n == 1 ? 0 : (double)i / (n - 1) - 0.5;
    const Pixel side[2]
        = { { ends[0].x + part * across[0], ends[0].y + part * across[1] },
            { ends[1].x + part * across[0], ends[1].y + part * across[1] } };

    add_stroke (sheet, n == 1 ? ends : side, ink);
  }
}

void
label_sheet_mark (LabelSheet *sheet, Pixel at, double reach)
{
  const int cells = (int)ceil (reach / CELL);
  int column, row;

  for (row = -cells; row <= cells; row++)
    for (column = -cells; column <= cells; column++) {
      const double x = CELL * column, y = CELL * row;

      if (x * x + y * y <= reach * reach)
        spill (sheet, at.x + x, at.y + y, INK_MARK);
    }
}

/* A label's rectangle in cells, within the sheet. */
typedef struct Cells {
  int left, right, top, bottom; /* right and bottom not in it */
} Cells;

static Cells
cells_of (const LabelSheet *sheet, Pixel low, double width, double height)
{
  const double right = (low.x + width) / CELL;
  const double bottom = (low.y + height) / CELL;

  /* Rounded towards 0 is rounded down, as far as the sheet goes. */
  return (Cells){
    MAX ((int)(low.x / CELL) - sheet->left, 0),
    MIN ((int)right + (right > (int)right) - sheet->left, sheet->columns),
    MAX ((int)(low.y / CELL) - sheet->top, 0),
    MIN ((int)bottom + (bottom > (int)bottom) - sheet->top, sheet->rows)
  };
}

void
label_sheet_name (LabelSheet *sheet, const PixelBox *box)
{
  const Cells cells = cells_of (sheet, (Pixel){ box->left, box->top },
                                box->right - box->left, box->bottom - box->top);
  int row, column;

  for (row = cells.top; row < cells.bottom; row++)
    for (column = cells.left; column < cells.right; column++) {
      unsigned char *cell = &sheet->ink[row * sheet->columns + column];

      *cell = MAX (*cell, INK_NAME);
    }
}

/* Sums up the ink, so that the ink under a rectangle is four numbers, where it
 * is asked for often. */
static void
sum_ink (LabelSheet *sheet, uint32_t n_labels)
{
  const int stride = sheet->columns + 1;
  int row, column;

  g_clear_pointer (&sheet->sums, g_free);
  if (n_labels < MANY_LABELS)
    return;
  sheet->sums = g_new0 (guint32, (gsize)stride * (gsize)(sheet->rows + 1));
  for (row = 0; row < sheet->rows; row++) {
    const unsigned char *ink = &sheet->ink[row * sheet->columns];
    const guint32 *above = &sheet->sums[row * stride];
    guint32 *sums = &sheet->sums[(row + 1) * stride];
    guint32 sum = 0;

    for (column = 0; column < sheet->columns; column++) {
      sum += ink[column];
      sums[column + 1] = above[column + 1] + sum;
    }
  }
}

static bool
has_label (const LabelSheet *sheet, Cells cells)
{
  const size_t n = (size_t)(cells.right - cells.left);
  int row;

  for (row = cells.top; row < cells.bottom; row++)
    if (memchr (&sheet->ink[row * sheet->columns + cells.left], INK_LABEL, n)
        != NULL)
      return true;
  return false;
}

/* The same without sums: for few labels, which need few of them. */
static double
count_ink_under (const LabelSheet *sheet, Cells cells)
{
  guint32 sum = 0;
  int row, column;

  if (has_label (sheet, cells))
    return COST_LABEL;
  for (row = cells.top; row < cells.bottom; row++)
    for (column = cells.left; column < cells.right; column++)
      sum += sheet->ink[row * sheet->columns + column];
  return sum;
}

/* Returns: how bad it is to cover these cells; something above @most when it
 *          is worse than that. */
static double
ink_under (const LabelSheet *sheet, Cells cells, double most)
{
  const int stride = sheet->columns + 1;
  const guint32 *top, *bottom;
  guint32 sum;

  if (cells.right <= cells.left || cells.bottom <= cells.top)
    return 0;
  if (sheet->sums == NULL)
    return count_ink_under (sheet, cells);
  top = &sheet->sums[cells.top * stride];
  bottom = &sheet->sums[cells.bottom * stride];
  sum = bottom[cells.right] - bottom[cells.left] - top[cells.right]
        + top[cells.left];
  if (sum <= most && has_label (sheet, cells))
    return sum + COST_LABEL;
  return sum;
}

void
label_sheet_named (LabelSheet *sheet, Pixel at, double reach)
{
  const Named named = { at, reach };

  g_array_append_val (sheet->named, named);
}

/* From a rectangle to the mark round @at. */
static double
distance_to (const Label *label, Pixel low, Pixel at, double reach)
{
  const double x = CLAMP (at.x, low.x, low.x + label->width);
  const double y = CLAMP (at.y, low.y, low.y + label->height);

  return MAX (hypot (at.x - x, at.y - y) - reach, 0);
}

/* Finds the marks that the name might be taken for a name of. Marks in the same
 * place share theirs. */
static void
find_rivals (LabelSheet *sheet, const Label *label)
{
  const double far = label->reach + LABEL_NEAR_PX + DOUBTFUL_PX
                     + MAX (label->width, label->height);

  g_array_set_size (sheet->rivals, 0);
  if (label->is_number)
    return;
  for (guint i = 0; i < sheet->named->len; i++) {
    const Named *named = &g_array_index (sheet->named, Named, i);
    const double x = fabs (named->at.x - label->at.x);
    const double y = fabs (named->at.y - label->at.y);
    const double reach = 2 * far + named->reach;

    if (x < reach && y < reach && x + y > 1)
      g_array_append_val (sheet->rivals, *named);
  }
}

static double
cost_of_mistake (const LabelSheet *sheet, const Label *label, Pixel low)
{
  const double own = distance_to (label, low, label->at, label->reach);
  double cost = 0;

  for (guint i = 0; i < sheet->rivals->len; i++) {
    const Named *rival = &g_array_index (sheet->rivals, Named, i);
    const double other = distance_to (label, low, rival->at, rival->reach);

    if (other < own)
      return label->is_important ? COST_MISTAKEN : COST_LIMIT;
    if (other < own + DOUBTFUL_PX)
      cost = COST_DOUBTFUL;
  }
  return cost;
}

static double
cost_of (const LabelSheet *sheet, const Label *label, Pixel low, double most)
{
  const bool is_inside = low.x >= 0 && low.y >= 0
                         && low.x + label->width <= sheet->width
                         && low.y + label->height <= sheet->height;

  return ink_under (sheet, cells_of (sheet, low, label->width, label->height),
                    most)
         + (is_inside ? 0 : COST_OUTSIDE);
}

/* The rectangle that touches, in a direction of length 1, a circle of @radius
 * round the mark. */
static Pixel
place_at (const Label *label, Pixel direction, double radius)
{
  const double x = direction.x, y = direction.y;

  return (Pixel){ label->at.x + radius * x + (x - 1) * label->width / 2,
                  label->at.y + radius * y + (y - 1) * label->height / 2 };
}

typedef struct Best {
  double cost;
  Pixel low;
} Best;

/* Takes a place that costs so much more than its ink if it is the best. */
static void
consider (const LabelSheet *sheet, const Label *label, Best here, Best *best)
{
  here.cost += cost_of_mistake (sheet, label, here.low);
  here.cost += cost_of (sheet, label, here.low, best->cost - here.cost);
  if (here.cost < best->cost)
    *best = here;
}

/* Nearer places and earlier directions win ties. A place has to cost less than
 * @limit. */
static Best
find_place (const LabelSheet *sheet, const Label *label, double limit)
{
  const double step = label->is_centred ? COST_OFF : COST_DISTANCE;
  const int n = label->is_number ? N_DISTANCES_MOST : N_DISTANCES;
  Best best = { limit, label->at };
  int distance, i;

  if (label->is_centred)
    consider (sheet, label,
              (Best){ 0,
                      { label->at.x - label->width / 2,
                        label->at.y - label->height / 2 } },
              &best);
  for (distance = 0; distance < n; distance++)
    for (i = 0; i < N_DIRECTIONS; i++) {
      const double radius = label->reach + 1.5 + DISTANCE_STEP * distance;
      const double more = step * distance + 0.1 * i;

      /* All places to come cost at least this much. */
      if (best.cost <= more)
        return best;
      consider (sheet, label,
                (Best){ more, place_at (label, sheet->directions[i], radius) },
                &best);
    }
  return best;
}

static void
place (LabelSheet *sheet, Label *label, double limit)
{
  Best best;
  Cells cells;
  int row;

  find_rivals (sheet, label);
  best = find_place (sheet, label, limit);
  label->is_placed = best.cost < limit;
  label->low = best.low;
  if (!label->is_placed)
    return;
  cells = cells_of (sheet, best.low, label->width, label->height);
  for (row = cells.top; row < cells.bottom && cells.right > cells.left; row++)
    memset (&sheet->ink[row * sheet->columns + cells.left], INK_LABEL,
            (size_t)(cells.right - cells.left));
}

/* The middle of a facet is no mark, nor is that of a gap. */
static void
add_named (LabelSheet *sheet, const Label *labels, uint32_t n_labels)
{
  for (uint32_t i = 0; i < n_labels; i++)
    if (!labels[i].is_centred && !labels[i].is_number)
      label_sheet_named (sheet, labels[i].at, labels[i].reach);
}

void
label_sheet_place (LabelSheet *sheet, Label *labels, uint32_t n_labels)
{
  uint32_t i;

  add_named (sheet, labels, n_labels);
  sum_ink (sheet, n_labels);
  for (i = 0; i < n_labels; i++)
    if (labels[i].is_important)
      place (sheet, &labels[i], COST_OUTSIDE);
  for (i = 0; i < n_labels; i++)
    if (!labels[i].is_important)
      place (sheet, &labels[i], COST_LIMIT);
}

void
label_sheet_place_over (LabelSheet *sheet, Label *labels, uint32_t n_labels)
{
  uint32_t i;

  add_named (sheet, labels, n_labels);
  sum_ink (sheet, n_labels);
  for (i = 0; i < n_labels; i++)
    place (sheet, &labels[i], DBL_MAX);
}
