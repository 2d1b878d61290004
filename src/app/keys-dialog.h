/* The dialog in which a person gives other keys to actions. What is chosen
 * holds at once, in all windows. */
#ifndef KEYS_DIALOG_H
#define KEYS_DIALOG_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define KEYS_DIALOG_TYPE (keys_dialog_get_type ())
G_DECLARE_FINAL_TYPE (KeysDialog, keys_dialog, HULL2VD, KEYS_DIALOG, GtkDialog)

GtkWidget *keys_dialog_new (GtkWindow *parent);

/* Keys have changed, whoever changed them. */
void keys_dialog_update (KeysDialog *dialog);

G_END_DECLS

#endif
