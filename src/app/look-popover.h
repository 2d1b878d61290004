/* The sliders of the look: lift, height of the paraboloid, and how opaque
 * paraboloid, hull and plane are. */
#ifndef LOOK_POPOVER_H
#define LOOK_POPOVER_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Returns: (transfer floating): a button that opens the sliders, which act on
 *          @session. */
GtkWidget *look_popover_button_new (Session *session);

G_END_DECLS

#endif
