/* Asks how a handout is to be printed, and shows its pages. */
#ifndef HANDOUT_DIALOG_H
#define HANDOUT_DIALOG_H

#include "handout.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define HANDOUT_DIALOG_TYPE (handout_dialog_get_type ())
G_DECLARE_FINAL_TYPE (
    HandoutDialog, handout_dialog, HULL2VD, HANDOUT_DIALOG, GtkDialog)

/* Responds with GTK_RESPONSE_ACCEPT when the handout is wanted; its pages are
 * chores of @session. */
HandoutDialog *
handout_dialog_new (GtkWindow *parent, Session *session, Lesson *lesson);

/* Lets @options be as the dialog says. */
void handout_dialog_fill (HandoutDialog *dialog, HandoutOptions *options);

G_END_DECLS

#endif
