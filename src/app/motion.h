/* What all things that move by themselves have in common: how long, how
 * eased, and when not at all. */
#ifndef MOTION_H
#define MOTION_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define MOTION_MS 450

/* Returns: whether things may move at @widget: it is on the screen, and the
 *          desktop has not turned animations off. Tests turn them off by
 *          HULL2VD_ANIMATIONS=0. */
gboolean motion_is_wanted (GtkWidget *widget);

/* Returns: the part, 0 … 1, of a motion that began so long ago. */
double motion_part (gint64 since_us);

/* Keys and clicks end all motions that are under way: a motion that began at
 * one number of them is over at the next. */
guint motion_n_skips (void);

G_END_DECLS

#endif
