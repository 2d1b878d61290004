/* Bare shapes: triangles, lines a pixel wide and discs of one colour each, in
 * flat arrays that OpenGL takes as they are. Sketches are made of them: what
 * moves and has thousands of strokes. An edge is one line then instead of a
 * quad, each of whose pixels asks how far off the edge is: where the processor
 * does the work of OpenGL, that is three quarters of the time.
 *
 *   bare_path (&bare, place, pixels, 2, false, scale, colour);
 *   … bare.runs[i] …
 *   bare_clear (&bare);
 */
#ifndef BARE_H
#define BARE_H

#include "clip.h"
#include "theme.h"

/* Lines are bare up to this width, discs up to this radius; device pixels. */
#define BARE_WIDEST 1.5
#define BARE_LARGEST 4.0

typedef struct BareVertex {
  float at[2];             /* device pixels, y down */
  float radii[2];          /* of a disc: its own, and its casing's or 0 */
  unsigned char colour[4]; /* premultiplied */
} BareVertex;

typedef enum BareKind {
  BARE_TRIANGLES, /* three vertices for each */
  BARE_LINES,     /* two */
  BARE_DISCS,     /* one, in the middle */
} BareKind;

/* Where shapes are in the order of paint: before that one of something else,
 * and in this layer of it. */
typedef struct BarePlace {
  uint32_t before, layer;
} BarePlace;

/* What is drawn in one go. */
typedef struct BareRun {
  BareKind kind;
  BarePlace place;
  uint32_t first, n; /* vertices */
} BareRun;

typedef struct Bare {
  BareVertex *vertices;
  uint32_t n_vertices, vertices_room;
  BareRun *runs; /* in the order of paint */
  uint32_t n_runs, runs_room;
} Bare;

void bare_clear (Bare *bare);

/* Forgets all shapes, and keeps their room. */
void bare_begin (Bare *bare);

/* Adds a run of another one. */
void
bare_copy (Bare *bare, BarePlace place, const Bare *from, const BareRun *run);

/* Adds a convex polygon; corners in px, @scale device pixels each. */
void bare_polygon (Bare *bare,
                   BarePlace place,
                   const Pixel *corners,
                   uint32_t n,
                   double scale,
                   Colour colour);

/* Adds a line of @n pixels; a closed one is joined to its first. */
void bare_path (Bare *bare,
                BarePlace place,
                const Pixel *pixels,
                uint32_t n,
                bool is_closed,
                double scale,
                Colour colour);

/* Adds the discs of a mark. */
void bare_mark (Bare *bare,
                BarePlace place,
                Pixel at,
                const double radii[2],
                double scale,
                Colour colour);

/* Returns: whether a style's lines can be bare at this scale; then their
 *          colour, paler by what they are thinner than a pixel, is in *@colour.
 */
bool bare_line_colour (const Style *style, double scale, Colour *colour);

/* Premultiplies. */
void bare_bytes (Colour colour, unsigned char bytes[4]);

/* The way through a convex polygon that is cut into triangles: every other
 * corner is cut off, and again, until none is left. Triangles that all met in
 * one corner would be splinters, which take long to fill. */
typedef struct BareCut {
  uint32_t first, step;
} BareCut;

#define BARE_CUT_INIT ((BareCut){ 0, 1 })

/* Returns: false: the polygon of @n corners is cut up. */
bool bare_cut_next (BareCut *cut, uint32_t n, uint32_t triangle[3]);

#endif
