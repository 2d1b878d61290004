/* Asks for a key by waiting until it is pressed. */
#ifndef KEY_CAPTURE_H
#define KEY_CAPTURE_H

#include "action.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Gives the key that is pressed to the action, beside those that it has or
 * instead of them. A key that another action has is taken after a question, one
 * that the pictures keep is refused, both in words; Escape changes nothing. */
void
key_capture_ask (GtkWindow *parent, const Action *action, gboolean is_added);

G_END_DECLS

#endif
