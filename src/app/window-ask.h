/* What is to happen once unsaved sites are saved, or given up by the person
 * who made them. */
#ifndef WINDOW_ASK_H
#define WINDOW_ASK_H

#include "window-private.h"

G_BEGIN_DECLS

typedef enum AskWhy {
  ASK_CLOSE,
  ASK_NEW,
  ASK_OPEN,
} AskWhy;

typedef void (*AskThen) (Hull2vdWindow *window, const char *path);

/* Does @then with @path at once when nothing is unsaved, else after the answer
 * and the saving. */
void
window_ask (Hull2vdWindow *window, AskWhy why, AskThen then, const char *path);

/* The sites are saved: what was asked for happens now. */
void window_ask_saved (Hull2vdWindow *window);

/* What was asked for will not happen. */
void window_ask_forget (Hull2vdWindow *window);

G_END_DECLS

#endif
