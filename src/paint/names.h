/* Names: the texts beside marks, set in type once and painted often. */
#ifndef NAMES_H
#define NAMES_H

#include "clip.h"
#include "name-places.h"
#include "theme.h"

#include <cairo.h>

typedef enum NameFace {
  NAME_PLAIN,
  NAME_APEX,   /* larger and bold */
  NAME_FACET,  /* oblique */
  NAME_ANSWER, /* oblique and bold, on a plate */
} NameFace;

/* Width of the stroke round the letters in the colour of the background; a
 * plate is as large. */
#define NAME_CASING 4.0

typedef struct Names Names;

typedef struct NameSize {
  double width, height; /* of the ink, px */
} NameSize;

/* A name as pixels that a painter puts on its surface: coverage, 8 bits. */
typedef struct NameMask {
  int x, y; /* its corner, device pixels from the corner of the ink */
  int width, height, stride;
  const unsigned char *casing, *letters; /* both of this size */
} NameMask;

Names *names_new (void);

/* The same with fonts of its own, so that it need not stay in one thread. */
Names *names_new_apart (void);
void names_free (Names *names);

/* Names are set for @theme from now on. When its type is another, or there
 * are too many names, all are forgotten and their numbers void.
 *
 * Returns: the edition, which is another whenever this happens. */
uint32_t names_begin (Names *names, const Theme *theme);

/* Returns: where the names stand, borrowed. */
NamePlaces *names_places (const Names *names);

/* Returns: the number of a name; the same for the same text and face. */
uint32_t names_find (Names *names, const char *text, NameFace face);
NameSize names_size (const Names *names, uint32_t name);

/* Paints, in the colour of @cr, what parts a name from all that it lies on: a
 * casing round its letters, or a plate under them. */
void names_paint_casing (Names *names, uint32_t name, cairo_t *cr, Pixel at);

/* Adds the outlines of a name to the path of @cr, the upper left corner of
 * its ink at @at. */
void names_trace (Names *names, uint32_t name, cairo_t *cr, Pixel at);

/* Paints a name as text, for surfaces that keep text. */
void names_show (Names *names, uint32_t name, cairo_t *cr, Pixel at);

/* Returns: the name at so many device pixels per px, borrowed. */
const NameMask *names_mask (Names *names, uint32_t name, double scale);

#endif
