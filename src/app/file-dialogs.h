/* File dialogs: those of the desktop, without waiting in them. */
#ifndef FILE_DIALOGS_H
#define FILE_DIALOGS_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

/* Called when a file has been chosen, not when the dialog was given up. */
typedef void (*FileChosen) (const char *path, gpointer user);

gboolean file_dialog_is_open (GtkWindow *parent);

void file_dialog_open (GtkWindow *parent,
                       const char *title,
                       FileChosen on_chosen,
                       gpointer user);

/* Asks before an existing file is replaced. */
void file_dialog_save (GtkWindow *parent,
                       const char *title,
                       const char *name,
                       FileChosen on_chosen,
                       gpointer user);

/* The same; takes @user, and lets it go by @free_user after all. */
void file_dialog_save_with (GtkWindow *parent,
                            const char *title,
                            const char *name,
                            FileChosen on_chosen,
                            gpointer user,
                            GDestroyNotify free_user);

G_END_DECLS

#endif
