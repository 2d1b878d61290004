/* The keys of actions: those of the registry, or what the person wants instead,
 * which is the setting "keys":
 *
 *   gsettings set io.github.hull2vd.Hull2VD keys "{'play': 'p', 'next': 'F8'}"
 *
 * A key that is given to one action is taken from the others; no text is no
 * key. The setting is read once, at the start. */
#ifndef KEYS_H
#define KEYS_H

#include "action.h"

G_BEGIN_DECLS

/* Returns: (transfer none): GTK accelerators, maybe none; ends with NULL. */
const char *const *keys_of (const Action *action);

/* Says on stderr what in the setting is no action or no key. */
void keys_check (void);

G_END_DECLS

#endif
