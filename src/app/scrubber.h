/* The time line: a scale from the first to the last step, with ticks where
 * rounds begin and dots at the stops of the lesson. */
#ifndef SCRUBBER_H
#define SCRUBBER_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define SCRUBBER_TYPE (scrubber_get_type ())
G_DECLARE_FINAL_TYPE (Scrubber, scrubber, HULL2VD, SCRUBBER, GtkScale)

void scrubber_set_session (Scrubber *scrubber, Session *session);

G_END_DECLS

#endif
