/* The way through time: first, back, play, next, last, the scrubber, speed. */
#ifndef TRANSPORT_H
#define TRANSPORT_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define TRANSPORT_TYPE (transport_get_type ())
G_DECLARE_FINAL_TYPE (Transport, transport, HULL2VD, TRANSPORT, GtkBox)

void transport_set_session (Transport *transport, Session *session);

G_END_DECLS

#endif
