/* Moments: what a picture on a page shows of a session that is played for
 * it. */
#ifndef MOMENT_H
#define MOMENT_H

#include "appearance.h"
#include "block.h"
#include "legend-mark.h"
#include "session.h"

G_BEGIN_DECLS

#define MOMENT_NONE G_MAXUINT

typedef enum MomentFace {
  MOMENT_SHOWN,  /* the stop at its end, its question answered */
  MOMENT_ASKED,  /* its question open, and what would answer it masked */
  MOMENT_MASKED, /* the stop at its end, without what its round has found: a
                    question before it asks for that */
} MomentFace;

typedef struct Moment {
  Session *session;
  guint stop; /* MOMENT_NONE: no lesson */
  MomentFace face;
  guint step; /* MOMENT_NONE: that of the stop */
} Moment;

/* Takes the session there. */
void moment_enter (const Moment *moment);

/* Which of its pictures a moment shows, while the session is there. */
typedef enum MomentView {
  MOMENT_VIEWS, /* as the stop says */
  MOMENT_PLANE,
  MOMENT_SPACE,
} MomentView;

/* Paints what the session shows into a rectangle. @appearance: the theme, and
 * how large lines, marks and names are beside those that pages have. */
void moment_paint (Session *session,
                   MomentView view,
                   const Appearance *appearance,
                   cairo_t *cr,
                   const cairo_rectangle_t *area);

/* Adds what such a picture shows to @marks, while the session is there. */
void moment_add_marks (Session *session,
                       MomentFace face,
                       MomentView view,
                       LegendMarks *marks);

/* Returns: (transfer full): a picture of a moment, with a fine frame. */
Block *moment_block (const Moment *moment,
                     MomentView view,
                     const Appearance *appearance,
                     double width,
                     double height);

G_END_DECLS

#endif
