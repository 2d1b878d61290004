/* The names of a drawing as one texture, so that GL paints them with the
 * strokes. A name is put there when it is first seen. */
#ifndef GL_ATLAS_H
#define GL_ATLAS_H

#include "gl-batch.h"

typedef struct GlAtlas GlAtlas;

/* With a context that is current; so for all functions. */
GlAtlas *gl_atlas_new (void);
void gl_atlas_free (GlAtlas *atlas);

/* Adds the names of @drawing to @batch, over its strokes. */
void
gl_atlas_add_names (GlAtlas *atlas, GlBatch *batch, const Drawing *drawing);

/* Returns: the texture; red is the casing, green the letters. */
unsigned gl_atlas_get_texture (const GlAtlas *atlas);

#endif
