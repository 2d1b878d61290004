/* What buttons say of themselves: the sentence of their action and its keys,
 * from the registry. */
#ifndef TOOLTIPS_H
#define TOOLTIPS_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Gives every button below @root that runs an action of the window, and says
 * nothing yet, its tooltip and accessible name. */
void tooltips_add (GtkWidget *root);

/* Says @text, or if NULL the sentence of the action, with its keys. */
void tooltips_set (GtkWidget *button, const char *action, const char *text);

/* Says all that was said below @root again, with the keys of now. */
void tooltips_update (GtkWidget *root);

G_END_DECLS

#endif
