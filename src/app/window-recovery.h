/* Unsaved sites: kept while the program runs, and offered by the next one when
 * it ended without being asked to. */
#ifndef WINDOW_RECOVERY_H
#define WINDOW_RECOVERY_H

#include "hull2vd-window.h"

G_BEGIN_DECLS

typedef struct WindowRecovery WindowRecovery;

/* Keeps what is edited in @window from now on. */
void window_recovery_init (Hull2vdWindow *window);

/* Asks in @window about what is left over, one after the other. */
void window_recovery_offer (Hull2vdWindow *window);

/* The answers. What is not answered is offered on the next start. */
void window_recovery_restore (Hull2vdWindow *window);
void window_recovery_discard (Hull2vdWindow *window);

/* The file at @path is what the window shows now. If it is what was offered,
 * the window keeps it from now on.
 *
 * Returns: whether it is; then *@origin is (transfer full) the file that the
 *          sites come from, or NULL. */
gboolean
window_recovery_take (Hull2vdWindow *window, const char *path, char **origin);

/* Keeps what there is at once: the program is being ended. */
void window_recovery_flush (Hull2vdWindow *window);

/* The person closes the window: its sites are saved or given up. */
void window_recovery_clear (Hull2vdWindow *window);

/* The window goes. */
void window_recovery_end (Hull2vdWindow *window);

G_END_DECLS

#endif
