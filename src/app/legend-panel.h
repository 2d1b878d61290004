/* The legend: a sample and the name of every role that the pictures show, in
 * the order in which the algorithm makes them. */
#ifndef LEGEND_PANEL_H
#define LEGEND_PANEL_H

#include "canvas.h"

G_BEGIN_DECLS

#define LEGEND_PANEL_TYPE (legend_panel_get_type ())
G_DECLARE_FINAL_TYPE (LegendPanel, legend_panel, HULL2VD, LEGEND_PANEL, GtkBox)

/* The legend explains what these two show. */
void legend_panel_set_views (LegendPanel *panel, Canvas *plane, Canvas *space);

/* Two columns unless there is little room. */
void legend_panel_set_columns (LegendPanel *panel, int n_columns);

G_END_DECLS

#endif
