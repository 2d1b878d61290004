/* What could not be done, and what has been: one message at a time, in a bar
 * over the pictures. It goes
 *
 *   at once when the command that it is about, or one to the same end, is
 *   carried out at last;
 *   when the document changes, but not before it can have been read;
 *   when it is closed.
 *
 * What is about no command, such as a broken file of progress, stays until it
 * is closed. hull2vd_window_say() takes the command that is being carried
 * out. */
#ifndef WINDOW_MESSAGE_H
#define WINDOW_MESSAGE_H

#include "hull2vd-window.h"

G_BEGIN_DECLS

/* Once there is a session. */
void window_message_init (Hull2vdWindow *window);
void window_message_end (Hull2vdWindow *window); /* the window goes */

/* @command: of the registry of actions, or "edit", sites by pointer or key;
 *           NULL: none. */
void window_message_say (Hull2vdWindow *window,
                         const char *command,
                         const char *message);

/* @command has been carried out. */
void window_message_settle (Hull2vdWindow *window, const char *command);

G_END_DECLS

#endif
