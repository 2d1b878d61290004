/* Where to go, as a number that is typed: a stop of the lesson, else a step. A
 * lecturer who is asked about an earlier picture types its number. */
#ifndef NUMBER_ENTRY_H
#define NUMBER_ENTRY_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Asks above @at; after it the focus is where it was. */
void number_entry_show (GtkWidget *at, Session *session);

G_END_DECLS

#endif
