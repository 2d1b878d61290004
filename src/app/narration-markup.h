/* The narration as markup: names bold, what is loud in the pictures in its
 * own colour. */
#ifndef NARRATION_MARKUP_H
#define NARRATION_MARKUP_H

#include "frame.h"
#include "theme.h"

#include <glib.h>

G_BEGIN_DECLS

/* Returns: (transfer full): Pango markup of @sentence, a narration in which
 *          @apex is the current site, to be read on @background. */
char *narration_to_markup (const char *sentence,
                           guint apex,
                           const Theme *theme,
                           Colour background);

G_END_DECLS

#endif
