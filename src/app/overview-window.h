/* All stops of a lesson as small pictures, to choose one. */
#ifndef OVERVIEW_WINDOW_H
#define OVERVIEW_WINDOW_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Shows the stops of the session's lesson in a window over @parent; the stop
 * that is chosen is gone to by @actions. */
void overview_window_show (GtkWindow *parent,
                           GActionGroup *actions,
                           Session *session);

G_END_DECLS

#endif
