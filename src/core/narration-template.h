/* Sentences with named parts, "{p} sees {f}", so that a translation may put
 * them in its own order. Private to the narrations. */
#ifndef NARRATION_TEMPLATE_H
#define NARRATION_TEMPLATE_H

#include "narration.h"

/* What the braces of a template stand for. */
typedef struct NarrationParts {
  uint32_t site;     /* {p} */
  uint32_t other;    /* {q} */
  uint32_t facet;    /* {f} of space, {e} of the plane */
  uint32_t ridge[2]; /* {a} {b} */
  uint32_t number;   /* {n} */
} NarrationParts;

/* Copies a template, each {x} replaced by its part. A template that would not
 * fit ends early, on a whole character. */
void narration_fill (const char *template,
                     const NarrationParts *parts,
                     char text[NARRATION_ROOM]);

#endif
