/* Panels: what a storyboard shows of one moment. */
#ifndef PANEL_H
#define PANEL_H

#include "appearance.h"
#include "session.h"

#include <cairo.h>

G_BEGIN_DECLS

typedef struct Panel {
  guint number; /* from 1 */
  char *title;
  char *prose;     /* Pango markup, may be empty */
  char *narration; /* markup: the sentence of the step, or the question that is
                      open there */
} Panel;

/* Takes the session to the moment of panel @index and reads its words.
 *
 * Returns: (transfer full): free with panel_free(). */
Panel *panel_new (Session *session, guint index);
void panel_free (Panel *panel);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Panel, panel_free)

/* Returns: how many panels the session's lesson, or its rounds, make. */
guint panel_count (Session *session);

/* Draws the panel, of the session as panel_new() left it, into a rectangle.
 * Text that does not fit is set smaller, and at last cut off with an
 * ellipsis. Units: pt. */
void panel_paint (const Panel *panel,
                  Session *session,
                  const Appearance *appearance,
                  cairo_t *cr,
                  const cairo_rectangle_t *area);

/* Sets @markup within a width and a height, down to two thirds of @size.
 *
 * Returns: the height that it takes. */
double panel_paint_text (cairo_t *cr,
                         const char *markup,
                         double size,
                         const cairo_rectangle_t *area);

G_END_DECLS

#endif
