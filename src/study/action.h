/* The action registry: everything a person does, by name. A key, a menu
 * item, a lesson verb, a D-Bus call and a test verb are rows of one table.
 *
 *   action_run (session, "goto", g_variant_new_string ("round 1 see"), &error);
 *
 * Three kinds of rows are told apart by their functions:
 *
 *   run                  an action; with get_state it has a state as well
 *   get_state alone      a state to read, which no one can set
 *   neither              the window does it: files, panels, windows
 */
#ifndef ACTION_H
#define ACTION_H

#include "session.h"

G_BEGIN_DECLS

typedef enum ActionWhere {
  ACTION_IN_LESSON = 1, /* a verb of lesson files; never touches files,
                           windows or programs */
  ACTION_IN_WINDOW = 2, /* an action of the window, on D-Bus too */
} ActionWhere;

typedef struct Action Action;

struct Action {
  const char *name;
  const char *parameter; /* GVariant type string, or NULL: none */
  const char *state;     /* type of its state, or NULL: none */
  const char *sentence;  /* what it does; marked for translation */
  const char *keys;      /* GTK accelerators, separated by blanks, or NULL */
  guint where;           /* ActionWhere bits */
  gboolean (*run) (const Action *action,
                   Session *session,
                   GVariant *parameter,
                   GError **error);
  GVariant *(*get_state) (const Action *action, Session *session);
  gboolean (*is_enabled) (const Action *action, Session *session);
  guint data; /* for the functions: a layer, a grain, a direction */
};

#define ACTION_ERROR (action_error_quark ())
GQuark action_error_quark (void);
typedef enum ActionError {
  ACTION_ERROR_UNKNOWN,   /* no such action, or it needs the window */
  ACTION_ERROR_PARAMETER, /* of another type, or no such thing */
  ACTION_ERROR_DISABLED,  /* not now: is_enabled says no */
  ACTION_ERROR_POSITION,  /* there is no such place in the run */
} ActionError;

const Action *action_table (guint *n_actions);
const Action *action_find (const char *name); /* NULL: no such action */

/* Returns: the state (floating), or NULL when it has none, or when the
 *          window keeps it. */
GVariant *action_get_state (const Action *action, Session *session);

/* Returns: whether it can be done now; TRUE for what the window does. */
gboolean action_is_enabled (const Action *action, Session *session);

/* Runs an action without a display. A floating @parameter is taken.
 *
 * Returns: FALSE with @error set when it has no such name, needs a window,
 *          has another type of parameter, or could not be done. */
gboolean action_run (Session *session,
                     const char *name,
                     GVariant *parameter,
                     GError **error);

G_END_DECLS

#endif
