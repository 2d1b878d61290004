/* The exact coordinates of what the pointer is on, else of what is selected,
 * in a label. */
#ifndef SITE_READOUT_H
#define SITE_READOUT_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Lets @label follow @session. */
void site_readout_attach (GtkLabel *label, Session *session);

G_END_DECLS

#endif
