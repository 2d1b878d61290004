/* Edits of large sets: what is asked for is kept until a thread has made the
 * run that it needs, and is asked for again then. Private to session*.c. */
#ifndef SESSION_WORK_H
#define SESSION_WORK_H

#include "run.h"
#include "session.h"

G_BEGIN_DECLS

typedef enum EditKind {
  EDIT_REPLACE,
  EDIT_OPEN,
  EDIT_PUT,
  EDIT_ADD,
  EDIT_MOVE,
  EDIT_REMOVE,
  EDIT_ORDER,
  EDIT_COMPARE,
  EDIT_PLANAR, /* no sites are edited: the hull in the plane is shown */
  EDIT_UNDO,
  EDIT_REDO,
} EditKind;

typedef struct Edit {
  EditKind kind;
  const Site *sites; /* as they will be, borrowed */
  guint n_sites;
  Order order;      /* as it will be */
  Order other;      /* of the run beside it, for EDIT_COMPARE */
  guint site;       /* that is moved or removed */
  Site to;          /* where a site is added, or moved to */
  const char *name; /* for undo, borrowed, or NULL */
} Edit;

typedef struct SessionWork SessionWork;

/* Returns: (transfer full): the run that the edit needs, when a thread has
 *          just made it; else NULL. */
Run *session_take_ready (Session *session, const Edit *edit);

/* Whether an edit is put off until a thread has made its run. Then the thread
 * is at work, and the edit will be asked for again. */
gboolean session_defer (Session *session, const Edit *edit);

/* Whether a site is being dragged and its run is not there yet: then it goes
 * to @edit next, and the places between are left out. */
gboolean session_defer_move (Session *session, const Edit *edit);

G_END_DECLS

#endif
