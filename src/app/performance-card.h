/* How far a performance is and how it went: stands above its tasks. */
#ifndef PERFORMANCE_CARD_H
#define PERFORMANCE_CARD_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define PERFORMANCE_CARD_TYPE (performance_card_get_type ())
G_DECLARE_FINAL_TYPE (
    PerformanceCard, performance_card, HULL2VD, PERFORMANCE_CARD, GtkBox)

/* Shows the performance of the session as it is now; hidden when there is
 * none. */
void performance_card_show (PerformanceCard *card, Session *session);

G_END_DECLS

#endif
