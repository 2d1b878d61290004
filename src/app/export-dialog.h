/* Asks how a picture is to be exported, and shows what it will look like. */
#ifndef EXPORT_DIALOG_H
#define EXPORT_DIALOG_H

#include "picture.h"
#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define EXPORT_DIALOG_TYPE (export_dialog_get_type ())
G_DECLARE_FINAL_TYPE (
    ExportDialog, export_dialog, HULL2VD, EXPORT_DIALOG, GtkDialog)

/* Responds with GTK_RESPONSE_ACCEPT when the picture is wanted. */
ExportDialog *export_dialog_new (GtkWindow *parent, Session *session);

/* Lets @picture, of the session's frame, be as the dialog says; @theme is its
 * theme and must last as long as it. */
void export_dialog_fill (ExportDialog *dialog, Picture *picture, Theme *theme);

PictureFormat export_dialog_get_format (ExportDialog *dialog);

G_END_DECLS

#endif
