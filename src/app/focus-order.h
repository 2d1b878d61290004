/* Where Tab goes, where GTK would lead it astray. */
#ifndef FOCUS_ORDER_H
#define FOCUS_ORDER_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Tab goes through the first child, then the second. GTK goes to the narrower
 * one first, because each child has a window of its own. */
void focus_order_of_paned (GtkPaned *paned);

/* Tab passes over a list whose rows take no focus. GTK would stop there for
 * ever. */
void focus_order_pass_over (GtkListBox *list);

G_END_DECLS

#endif
