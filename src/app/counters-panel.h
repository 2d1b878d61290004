/* The counters of the step, as laws. */
#ifndef COUNTERS_PANEL_H
#define COUNTERS_PANEL_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define COUNTERS_PANEL_TYPE (counters_panel_get_type ())
G_DECLARE_FINAL_TYPE (
    CountersPanel, counters_panel, HULL2VD, COUNTERS_PANEL, GtkBox)

void counters_panel_set_session (CountersPanel *panel, Session *session);

G_END_DECLS

#endif
