/* One sentence: what has just happened; and where in time that is. */
#ifndef NARRATION_BAR_H
#define NARRATION_BAR_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define NARRATION_BAR_TYPE (narration_bar_get_type ())
G_DECLARE_FINAL_TYPE (
    NarrationBar, narration_bar, HULL2VD, NARRATION_BAR, GtkBox)

void narration_bar_set_session (NarrationBar *bar, Session *session);

G_END_DECLS

#endif
