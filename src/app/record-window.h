/* What is recorded, as it grows: text of a lesson, to be copied. */
#ifndef RECORD_WINDOW_H
#define RECORD_WINDOW_H

#include "session-record.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define RECORD_WINDOW_TYPE (record_window_get_type ())
G_DECLARE_FINAL_TYPE (
    RecordWindow, record_window, HULL2VD, RECORD_WINDOW, GtkWindow)

/* Returns: a window beside @parent, whose actions its buttons run. */
RecordWindow *record_window_new (GtkApplicationWindow *parent,
                                 Session *session);

/* Shows what @record says from now on; NULL: it is over, the text stays. */
void record_window_set_record (RecordWindow *window, SessionRecord *record);
void record_window_copy (RecordWindow *window);

G_END_DECLS

#endif
