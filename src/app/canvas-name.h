/* What a person is told of an object: its name, where it is, what it is. */
#ifndef CANVAS_NAME_H
#define CANVAS_NAME_H

#include "session.h"

G_BEGIN_DECLS

/* Returns: (transfer full): "s3 (0.5, 1), on the hull"; while a question is
 *          open, what would not answer it, and whether it is chosen.
 * Coordinates are exact: the fewest digits that read back the same. */
char *canvas_name_object (Session *session, Object object);

/* Returns: (transfer full): "s3 (0.5, 1)". */
char *canvas_name_place (Session *session, guint site);

G_END_DECLS

#endif
