/* What the program remembers from one time to the next. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <gio/gio.h>

G_BEGIN_DECLS

/* Finds the schema in the build folder while the program runs from there,
 * else where it was installed.
 *
 * Returns: (transfer full): the settings, or NULL where there is no schema;
 *          then nothing is remembered. */
GSettings *settings_new (void);

G_END_DECLS

#endif
