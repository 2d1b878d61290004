/* The bar that says what a thread works on, how far it is where that is known,
 * and gives it up. It lies over the pictures: they keep their sizes. */
#ifndef WORK_BAR_H
#define WORK_BAR_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define WORK_BAR_TYPE (work_bar_get_type ())
G_DECLARE_FINAL_TYPE (WorkBar, work_bar, HULL2VD, WORK_BAR, GtkRevealer)

void work_bar_set_session (WorkBar *bar, Session *session);

G_END_DECLS

#endif
