#include "label-field.h"

#include <math.h>

#define CELL 40.0 /* side of a square, px */

typedef enum Thing {
  THING_LINE,
  THING_MARK,
  THING_NAME,
} Thing;

#define N_THINGS (THING_NAME + 1)

/* A thing in a square. */
typedef struct Entry {
  guint32 number;
  guint32 next; /* entry + 1 of the same square; 0: none */
} Entry;

/* Where a thing was last found. */
typedef struct Layer {
  GArray *things;
  GArray *found; /* guint32: the search that it was last found in */
  GArray *entries;
  guint32 *heads; /* of each square: entry + 1 */
} Layer;

struct LabelField {
  PixelBox frame;
  int columns, rows;
  guint32 n_searches;
  Layer layers[N_THINGS];
};

/* Columns first … last and rows top … bottom. */
typedef struct Cells {
  int first, last, top, bottom;
} Cells;

LabelField *
label_field_new (const PixelBox *frame)
{
  static const guint sizes[N_THINGS]
      = { sizeof (FieldLine), sizeof (FieldMark), sizeof (FieldName) };
  LabelField *field = g_new0 (LabelField, 1);

  field->frame = *frame;
  field->columns = 1 + (int)(MAX (frame->right - frame->left, 0) / CELL);
  field->rows = 1 + (int)(MAX (frame->bottom - frame->top, 0) / CELL);
  for (int i = 0; i < N_THINGS; i++) {
    Layer *layer = &field->layers[i];

    layer->things = g_array_new (FALSE, FALSE, sizes[i]);
    layer->found = g_array_new (FALSE, TRUE, sizeof (guint32));
    layer->entries = g_array_new (FALSE, FALSE, sizeof (Entry));
    layer->heads = g_new0 (guint32, field->columns * field->rows);
  }
  return field;
}

void
label_field_free (LabelField *field)
{
  for (int i = 0; i < N_THINGS; i++) {
    g_array_unref (field->layers[i].things);
    g_array_unref (field->layers[i].found);
    g_array_unref (field->layers[i].entries);
    g_free (field->layers[i].heads);
  }
  g_free (field);
}

static int
column_at (const LabelField *field, double x)
{
  return CLAMP ((int)floor ((x - field->frame.left) / CELL), 0,
                field->columns - 1);
}

static int
row_at (const LabelField *field, double y)
{
  return CLAMP ((int)floor ((y - field->frame.top) / CELL), 0, field->rows - 1);
}

static Cells
cells_of (const LabelField *field, const PixelBox *box)
{
  return (Cells){ column_at (field, box->left), column_at (field, box->right),
                  row_at (field, box->top), row_at (field, box->bottom) };
}

/* Lists the last thing of a layer in some squares. */
static void
list_last (LabelField *field, Layer *layer, Cells cells)
{
  for (int row = cells.top; row <= cells.bottom; row++)
    for (int column = cells.first; column <= cells.last; column++) {
      guint32 *head = &layer->heads[row * field->columns + column];
      const Entry entry = { layer->things->len - 1, *head };

      g_array_append_val (layer->entries, entry);
      *head = layer->entries->len;
    }
}

/* The columns that a line crosses while it is in a row. */
static void
cells_of_row (const LabelField *field,
              const Pixel ends[2],
              int row,
              Cells *cells)
{
  const double rise = ends[1].y - ends[0].y;
  double x[2] = { ends[0].x, ends[1].x };

  for (int i = 0; i < 2 && fabs (rise) > 0; i++) {
    const double y = field->frame.top + (row + i) * CELL;
    const double part = CLAMP ((y - ends[0].y) / rise, 0, 1);

    x[i] = ends[0].x + part * (ends[1].x - ends[0].x);
  }
  cells->first = column_at (field, MIN (x[0], x[1]));
  cells->last = column_at (field, MAX (x[0], x[1]));
  cells->top = cells->bottom = row;
}

void
label_field_add_line (LabelField *field, const FieldLine *line)
{
  Layer *layer = &field->layers[THING_LINE];
  const PixelBox *frame = &field->frame;
  FieldLine within = *line;
  int first, last;

  if (!clip_to_rectangle ((Pixel){ frame->left, frame->top },
                          (Pixel){ frame->right, frame->bottom }, within.ends))
    return;
  g_array_append_val (layer->things, within);
  first = row_at (field, MIN (within.ends[0].y, within.ends[1].y));
  last = row_at (field, MAX (within.ends[0].y, within.ends[1].y));
  for (int row = first; row <= last; row++) {
    Cells cells;

    cells_of_row (field, within.ends, row, &cells);
    list_last (field, layer, cells);
  }
}

void
label_field_add_mark (LabelField *field, const FieldMark *mark)
{
  Layer *layer = &field->layers[THING_MARK];
  const PixelBox box = { (float)mark->at.x, (float)mark->at.y,
                         (float)mark->at.x, (float)mark->at.y };

  g_array_append_val (layer->things, *mark);
  list_last (field, layer, cells_of (field, &box));
}

void
label_field_add_name (LabelField *field, const FieldName *name)
{
  Layer *layer = &field->layers[THING_NAME];

  g_array_append_val (layer->things, *name);
  list_last (field, layer, cells_of (field, &name->box));
}

void
label_near_init (LabelNear *near)
{
  near->lines = g_array_new (FALSE, FALSE, sizeof (FieldLine));
  near->marks = g_array_new (FALSE, FALSE, sizeof (FieldMark));
  near->names = g_array_new (FALSE, FALSE, sizeof (FieldName));
}

void
label_near_clear (LabelNear *near)
{
  g_array_unref (near->lines);
  g_array_unref (near->marks);
  g_array_unref (near->names);
}

/* A thing that lies in several squares is found in the first of them. */
static void
find_in (LabelField *field, Layer *layer, Cells cells, GArray *near)
{
  const guint size = g_array_get_element_size (near);

  g_array_set_size (near, 0);
  g_array_set_size (layer->found, layer->things->len);
  for (int row = cells.top; row <= cells.bottom; row++)
    for (int column = cells.first; column <= cells.last; column++) {
      guint32 entry = layer->heads[row * field->columns + column];

      while (entry > 0) {
        const Entry *here = &g_array_index (layer->entries, Entry, entry - 1);
        guint32 *found = &g_array_index (layer->found, guint32, here->number);

        if (*found != field->n_searches)
          g_array_append_vals (
              near, layer->things->data + (gsize)here->number * size, 1);
        *found = field->n_searches;
        entry = here->next;
      }
    }
}

/* Of those found keeps the lines whose boxes meet @box. */
static void
narrow_lines (const PixelBox *box, GArray *lines)
{
  FieldLine *line = (FieldLine *)(void *)lines->data;
  guint n = 0;

  for (guint i = 0; i < lines->len; i++) {
    const Pixel a = line[i].ends[0], b = line[i].ends[1];

    if (MIN (a.x, b.x) <= box->right && MAX (a.x, b.x) >= box->left
        && MIN (a.y, b.y) <= box->bottom && MAX (a.y, b.y) >= box->top)
      line[n++] = line[i];
  }
  g_array_set_size (lines, n);
}

/* The same of marks. */
static void
narrow_marks (const PixelBox *box, GArray *marks)
{
  FieldMark *mark = (FieldMark *)(void *)marks->data;
  guint n = 0;

  for (guint i = 0; i < marks->len; i++) {
    const double reach = mark[i].reach;

    if (mark[i].at.x >= box->left - reach && mark[i].at.x <= box->right + reach
        && mark[i].at.y >= box->top - reach
        && mark[i].at.y <= box->bottom + reach)
      mark[n++] = mark[i];
  }
  g_array_set_size (marks, n);
}

void
label_field_find (LabelField *field, const PixelBox *box, LabelNear *near)
{
  const Cells cells = cells_of (field, box);

  field->n_searches++;
  find_in (field, &field->layers[THING_LINE], cells, near->lines);
  find_in (field, &field->layers[THING_MARK], cells, near->marks);
  find_in (field, &field->layers[THING_NAME], cells, near->names);
  narrow_lines (box, near->lines);
  narrow_marks (box, near->marks);
}
