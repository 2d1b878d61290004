/* The keys of actions: those of the registry, or what the person wants instead,
 * which is the setting "keys":
 *
 *   gsettings set io.github.hull2vd.Hull2VD keys "{'play': 'p', 'next': 'F8'}"
 *
 * A key that is given to one action is taken from the others; no text is no
 * key. Where there is no setting, what is changed holds while the program
 * runs. A key is a text that GTK reads, such as "<Primary>p". */
#ifndef KEYS_H
#define KEYS_H

#include "action.h"

G_BEGIN_DECLS

/* Reads the setting, says on stderr what in it is no action or no key, and
 * calls @on_changed each time that keys have changed. */
void keys_init (void (*on_changed) (gpointer user), gpointer user);

/* Returns: whether there is a key that could do it: it is the window's, needs
 *          no parameter and is no state to read. */
gboolean keys_can_do (const Action *action);

/* Returns: (transfer none): its keys, maybe none, until keys change; ends with
 *          NULL. */
const char *const *keys_of (const Action *action);

/* Returns: whether the person has chosen them. */
gboolean keys_are_own (const Action *action);

/* Returns: the action that has the key, or NULL. */
const Action *keys_find_action (const char *key);

/* Gives these keys to the action and takes them from all others. */
void keys_set (const Action *action, const char *const *keys);

/* The keys of the registry again, but for those that the person has given to
 * others; of one action or of all. */
void keys_reset (const Action *action);
void keys_reset_all (void);

/* Returns: (transfer full): as it is written on keyboards. */
char *keys_label (const char *key);

/* Returns: (transfer full): all keys of the action so; empty: none. */
char *keys_label_all (const Action *action);

G_END_DECLS

#endif
