/* The action registry: everything a person does, by name. A key, a menu
 * item, a lesson verb, a D-Bus call and a test verb are rows of one table. */
#ifndef ACTION_H
#define ACTION_H

#include "session.h"

G_BEGIN_DECLS

typedef enum ActionWhere {
  ACTION_IN_LESSON = 1, /* a verb of lesson files; never touches files,
                           windows or programs */
  ACTION_IN_WINDOW = 2, /* an action of the window, on D-Bus too */
} ActionWhere;

typedef struct Action {
  const char *name;
  const char *parameter; /* GVariant type string, or NULL: none */
  const char *state;     /* type of a state to read, or NULL: none */
  const char *sentence;  /* what it does; marked for translation */
  const char *keys;      /* GTK accelerators, separated by blanks, or NULL */
  guint where;           /* ActionWhere bits */
  /* NULL: the window does it itself (files, windows). */
  gboolean (*run) (Session *session, GVariant *parameter, GError **error);
  GVariant *(*get_state) (Session *session); /* floating; NULL: no state */
  gboolean (*is_enabled) (Session *session); /* NULL: always */
} Action;

const Action *action_table (guint *n_actions);
const Action *action_find (const char *name); /* NULL: no such action */

/* Runs an action without a display.
 *
 * Returns: FALSE with @error set when it has no such name, needs a window,
 *          has another type of parameter, or could not be done. */
gboolean action_run (Session *session,
                     const char *name,
                     GVariant *parameter,
                     GError **error);

G_END_DECLS

#endif
