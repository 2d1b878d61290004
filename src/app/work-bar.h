/* The bar that says how far the hull of a large set is, and gives it up. */
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
