/* Sites by a rule and a seed: what they will be is drawn while it is chosen,
 * with the line that makes them in a lesson. */
#ifndef GENERATE_DIALOG_H
#define GENERATE_DIALOG_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define GENERATE_DIALOG_TYPE (generate_dialog_get_type ())
G_DECLARE_FINAL_TYPE (
    GenerateDialog, generate_dialog, HULL2VD, GENERATE_DIALOG, GtkDialog)

/* Returns: a dialog that keeps what was chosen while it is hidden; when it is
 *          answered the sites are those of @session, as one edit. */
GtkWidget *generate_dialog_new (GtkWindow *parent, Session *session);

G_END_DECLS

#endif
