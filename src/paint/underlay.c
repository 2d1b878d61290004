#include "underlay.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* What a square of the picture shows. */
typedef enum Shown {
  SHOWN_STOCK,
  SHOWN_LIGHT, /* under which there is nobody knows what */
  SHOWN_LIGHT_OVER_KEPT,
} Shown;

struct Underlay {
  cairo_surface_t *kept; /* as large as the picture */
  Shown *shown;          /* per square */
  uint32_t n_squares, shown_room;
};

Underlay *
underlay_new (void)
{
  return memory_new (1, sizeof (Underlay));
}

void
underlay_free (Underlay *underlay)
{
  if (underlay == NULL)
    return;
  cairo_surface_destroy (underlay->kept);
  free (underlay->shown);
  free (underlay);
}

static bool
is_as_large (cairo_surface_t *a, cairo_surface_t *b)
{
  return a != NULL
         && cairo_image_surface_get_width (a)
                == cairo_image_surface_get_width (b)
         && cairo_image_surface_get_height (a)
                == cairo_image_surface_get_height (b);
}

void
underlay_begin (Underlay *underlay,
                cairo_surface_t *picture,
                const Squares *lit)
{
  uint32_t i;

  if (!is_as_large (underlay->kept, picture)) {
    cairo_surface_destroy (underlay->kept);
    underlay->kept = cairo_image_surface_create (
        CAIRO_FORMAT_RGB24, cairo_image_surface_get_width (picture),
        cairo_image_surface_get_height (picture));
  }
  underlay->n_squares = (uint32_t)(lit->grid.columns * lit->grid.rows);
  if (underlay->n_squares > underlay->shown_room)
    underlay->shown = memory_grow (underlay->shown, &underlay->shown_room,
                                   underlay->n_squares, sizeof (Shown));
  for (i = 0; i < underlay->n_squares; i++)
    underlay->shown[i] = lit->is_marked[i] ? SHOWN_LIGHT : SHOWN_STOCK;
}

/* Copies the pixels of a square between pictures of one size. */
static void
copy_square (cairo_surface_t *from,
             cairo_surface_t *to,
             const SquareGrid *grid,
             int number)
{
  const int x = number % grid->columns * grid->side;
  const int y = number / grid->columns * grid->side;
  const int stride = cairo_image_surface_get_stride (from);
  const int width = cairo_image_surface_get_width (from) - x;
  const int height = cairo_image_surface_get_height (from) - y;
  const size_t n = 4 * (size_t)(width < grid->side ? width : grid->side);
  const size_t first = (size_t)y * (size_t)stride + 4 * (size_t)x;
  const unsigned char *source = cairo_image_surface_get_data (from) + first;
  unsigned char *target = cairo_image_surface_get_data (to) + first;
  int row;

  for (row = 0; row < grid->side && row < height; row++)
    memcpy (target + row * stride, source + row * stride, n);
}

void
underlay_move (Underlay *underlay,
               cairo_surface_t *picture,
               const Squares *lit,
               Squares *changed)
{
  const int n = (int)underlay->n_squares;
  int i;

  cairo_surface_flush (picture);
  for (i = 0; i < n; i++) {
    Shown *shown = &underlay->shown[i];

    if (!changed->is_marked[i])
      continue;
    if (lit->is_marked[i] && *shown == SHOWN_STOCK) {
      copy_square (picture, underlay->kept, &changed->grid, i);
      *shown = SHOWN_LIGHT_OVER_KEPT;
    } else if (!lit->is_marked[i]) {
      if (*shown == SHOWN_LIGHT_OVER_KEPT) {
        copy_square (underlay->kept, picture, &changed->grid, i);
        changed->is_marked[i] = false;
      }
      *shown = SHOWN_STOCK;
    }
  }
  cairo_surface_mark_dirty (picture);
}
