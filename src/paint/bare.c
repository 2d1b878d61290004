#include "bare.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

void
bare_clear (Bare *bare)
{
  free (bare->vertices);
  free (bare->runs);
  memset (bare, 0, sizeof *bare);
}

void
bare_begin (Bare *bare)
{
  bare->n_vertices = bare->n_runs = 0;
}

static void
begin_run (Bare *bare, BareKind kind, BarePlace place)
{
  if (bare->n_runs == bare->runs_room)
    bare->runs = memory_grow (bare->runs, &bare->runs_room, bare->n_runs + 1,
                              sizeof *bare->runs);
  bare->runs[bare->n_runs++] = (BareRun){ kind, place, bare->n_vertices, 0 };
}

/* Returns: room for @n vertices more, which are to be written. */
static BareVertex *
grow (Bare *bare, BareKind kind, BarePlace place, uint32_t n)
{
  const BareRun *last
      = bare->n_runs == 0 ? NULL : &bare->runs[bare->n_runs - 1];

  if (last == NULL || last->kind != kind || last->place.before != place.before
      || last->place.layer != place.layer)
    begin_run (bare, kind, place);
  if (bare->n_vertices + n > bare->vertices_room)
    bare->vertices = memory_grow (bare->vertices, &bare->vertices_room,
                                  bare->n_vertices + n, sizeof *bare->vertices);
  bare->runs[bare->n_runs - 1].n += n;
  bare->n_vertices += n;
  return &bare->vertices[bare->n_vertices - n];
}

void
bare_copy (Bare *bare, BarePlace place, const Bare *from, const BareRun *run)
{
  memcpy (grow (bare, run->kind, place, run->n), &from->vertices[run->first],
          run->n * sizeof *from->vertices);
}

bool
bare_cut_next (BareCut *cut, uint32_t n, uint32_t triangle[3])
{
  for (; n >= 3 && cut->step < n - 1; cut->step *= 2) {
    const uint32_t middle = cut->first + cut->step;

    if (middle < n - 1) {
      triangle[0] = cut->first;
      triangle[1] = middle;
      triangle[2] = middle + cut->step < n ? middle + cut->step : n - 1;
      cut->first = triangle[2];
      return true;
    }
    cut->first = 0;
  }
  return false;
}

static void
put (BareVertex *vertex, Pixel at, double scale)
{
  vertex->at[0] = (float)(scale * at.x);
  vertex->at[1] = (float)(scale * at.y);
}

void
bare_polygon (Bare *bare,
              BarePlace place,
              const Pixel *corners,
              uint32_t n,
              double scale,
              Colour colour)
{
  BareVertex any = { 0 };
  BareCut cut = BARE_CUT_INIT;
  uint32_t triangle[3];
  int i;

  bare_bytes (colour, any.colour);
  while (bare_cut_next (&cut, n, triangle)) {
    BareVertex *vertices = grow (bare, BARE_TRIANGLES, place, 3);

    for (i = 0; i < 3; i++) {
      vertices[i] = any;
      put (&vertices[i], corners[triangle[i]], scale);
    }
  }
}

void
bare_path (Bare *bare,
           BarePlace place,
           const Pixel *pixels,
           uint32_t n,
           bool is_closed,
           double scale,
           Colour colour)
{
  const uint32_t n_lines = is_closed || n == 0 ? n : n - 1;
  BareVertex any = { 0 };
  BareVertex *vertices;
  uint32_t i;

  if (n_lines == 0)
    return;
  bare_bytes (colour, any.colour);
  vertices = grow (bare, BARE_LINES, place, 2 * n_lines);
  for (i = 0; i < n_lines; i++, vertices += 2) {
    vertices[0] = vertices[1] = any;
    put (&vertices[0], pixels[i], scale);
    put (&vertices[1], pixels[i + 1 < n ? i + 1 : 0], scale);
  }
}

void
bare_mark (Bare *bare,
           BarePlace place,
           Pixel at,
           const double radii[2],
           double scale,
           Colour colour)
{
  BareVertex *vertex = grow (bare, BARE_DISCS, place, 1);

  put (vertex, at, scale);
  vertex->radii[0] = (float)(scale * radii[0]);
  vertex->radii[1] = (float)(scale * radii[1]);
  bare_bytes (colour, vertex->colour);
}

bool
bare_line_colour (const Style *style, double scale, Colour *colour)
{
  const double width = style->width * scale;

  if (style->dash > 0 || style->halo.alpha > 0 || width > BARE_WIDEST)
    return false;
  *colour = style->line;
  colour->alpha *= width < 1 ? width : 1;
  return true;
}

static unsigned char
channel (double value, double alpha)
{
  return (unsigned char)(255 * value * alpha + 0.5);
}

void
bare_bytes (Colour colour, unsigned char bytes[4])
{
  const double alpha = colour.alpha < 0   ? 0
                       : colour.alpha > 1 ? 1
                                          : colour.alpha;

  bytes[0] = channel (colour.red, alpha);
  bytes[1] = channel (colour.green, alpha);
  bytes[2] = channel (colour.blue, alpha);
  bytes[3] = channel (alpha, 1);
}
