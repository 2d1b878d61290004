/* The pseudo-code, with the line marked that the last event carried out. */
#ifndef CODE_PANEL_H
#define CODE_PANEL_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define CODE_PANEL_TYPE (code_panel_get_type ())
G_DECLARE_FINAL_TYPE (CodePanel, code_panel, HULL2VD, CODE_PANEL, GtkBox)

void code_panel_set_session (CodePanel *panel, Session *session);

/* Brings the current line into view, or the first where none is. */
void code_panel_scroll (CodePanel *panel);

G_END_DECLS

#endif
