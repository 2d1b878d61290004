/* A look at space in words, as "camera" has them in lessons: the name of a
 * preset, or where the eye stands:
 *
 *   AZIMUTH ELEVATION [ROLL [ZOOM [RIGHT UP]]]
 *   [parallel] [mirrored] [centre X Y]
 *
 * Units: degrees; RIGHT and UP in half heights of the view; X and Y in scene
 *        coordinates.
 */
#ifndef CAMERA_TEXT_H
#define CAMERA_TEXT_H

#include "camera.h"

#include <glib.h>

G_BEGIN_DECLS

/* Reads the second form.
 *
 * Returns: FALSE: these words are not of that form. */
gboolean camera_text_read (const char *text, Camera *camera);

/* Returns: (transfer full): a preset seen beside the whole plane by its name,
 *          all else in hundredths of a degree. */
char *camera_text_write (const Camera *camera);

G_END_DECLS

#endif
