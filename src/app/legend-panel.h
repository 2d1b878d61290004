/* The legend: a sample and the name of every role that the pictures show, in
 * the order in which the algorithm makes them. */
#ifndef LEGEND_PANEL_H
#define LEGEND_PANEL_H

#include "canvas.h"

G_BEGIN_DECLS

#define LEGEND_PANEL_TYPE (legend_panel_get_type ())
G_DECLARE_FINAL_TYPE (LegendPanel, legend_panel, HULL2VD, LEGEND_PANEL, GtkBox)

void legend_panel_set_session (LegendPanel *panel, Session *session);

/* The legend explains what @view shows, while it is shown. */
void legend_panel_add_view (LegendPanel *panel, Canvas *view);

/* Two columns unless there is little room. */
void legend_panel_set_columns (LegendPanel *panel, int n_columns);

G_END_DECLS

#endif
