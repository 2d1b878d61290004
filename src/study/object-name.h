/* Objects in words: "s3" a site, "f12" a facet, "v12" the Voronoi vertex of
 * the circle group whose first facet is f12, "r7" a ridge, "none". */
#ifndef OBJECT_NAME_H
#define OBJECT_NAME_H

#include "object.h"
#include "predicate.h"

#include <glib.h>

G_BEGIN_DECLS

#define OBJECT_NAME_ROOM 12

void object_name_write (Object object, char name[OBJECT_NAME_ROOM]);
gboolean object_name_parse (const char *name, Object *object);

/* Returns: "lower", "upper" or "vertical", translated. */
const char *facing_name (Facing facing);

G_END_DECLS

#endif
