/* What is lit in a scene, and what a person points at, as strokes and names
 * that are laid between those of the scene's stock. A whole picture and one in
 * which only the light has changed are put together here, and so are the same.
 *
 * A name of what is lit is placed last, where it covers least; names of the
 * stock that it covers are left out as long as it is there. So no other name
 * moves when the pointer does. */
#ifndef LIT_DRAWING_H
#define LIT_DRAWING_H

#include "drawing.h"
#include "squares.h"

typedef struct LitDrawing {
  Drawing *lit;   /* all of it, as it is to be seen */
  Drawing *plain; /* what of the stock it takes the place of: strokes and
                     names */
} LitDrawing;

LitDrawing *lit_drawing_new (Names *names);
void lit_drawing_free (LitDrawing *light);

/* Returns: whether anything of a scene is lit or pointed at. */
bool scene_has_light (const Scene *scene);

/* Draws what is lit in @scene, nothing perhaps, whose stock is drawn as @stock,
 * through the same projection. @strokes lists the boxes of @stock, or is NULL.
 *
 * Cost: with @strokes O(what is lit + names); else O(strokes). */
void lit_drawing_set (LitDrawing *light,
                      const Drawing *stock,
                      const Scene *scene,
                      const Projection *projection,
                      BoxIndex *strokes);

/* Marks where two lights over one stock, or over two, are not the same. */
void lit_drawing_compare (const LitDrawing *before,
                          const LitDrawing *after,
                          Squares *squares);

/* Marks where the stock is not as it is without the light. */
void lit_drawing_mark (const LitDrawing *light, Squares *squares);

/* Puts both together in @to, back to front: all strokes of the stock when
 * @strokes is NULL, or these @n, ascending. */
void lit_drawing_merge (const LitDrawing *light,
                        const Drawing *stock,
                        const Scene *scene,
                        const uint32_t *strokes,
                        uint32_t n,
                        Drawing *to);

#endif
