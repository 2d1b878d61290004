/* The application: its windows, files given to it, and its name. */
#ifndef HULL2VD_APPLICATION_H
#define HULL2VD_APPLICATION_H

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define HULL2VD_APPLICATION_ID "io.github.hull2vd.Hull2VD"

/* The hint of g_application_open() for files that take no window. */
#define HULL2VD_OPEN_ALONE "alone"

#define HULL2VD_APPLICATION_TYPE (hull2vd_application_get_type ())
G_DECLARE_FINAL_TYPE (Hull2vdApplication,
                      hull2vd_application,
                      HULL2VD,
                      APPLICATION,
                      GtkApplication)

Hull2vdApplication *hull2vd_application_new (void);

G_END_DECLS

#endif
