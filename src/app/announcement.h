/* Sentences for readers of the screen, which are said once and whatever has
 * the focus. */
#ifndef ANNOUNCEMENT_H
#define ANNOUNCEMENT_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Lets @widget say @sentence; nothing, where ATK is too old for it. */
void announce (GtkWidget *widget, const char *sentence);

G_END_DECLS

#endif
