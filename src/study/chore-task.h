/* Work of a thread as a chore of the session: told of while it lasts, and
 * given up when the person wants that.
 *
 *   chore_task_begin (session, sentence, write_sites, on_written, save,
 *                     save_free);
 *
 * What the thread needs lies in its data, which nobody else sees meanwhile.
 */
#ifndef CHORE_TASK_H
#define CHORE_TASK_H

#include "session.h"

G_BEGIN_DECLS

typedef struct ChoreTask ChoreTask;

/* In the thread; @error is left alone by what is given up.
 *
 * Returns: FALSE with @error set when it went wrong. */
typedef gboolean (*ChoreWork) (ChoreTask *task, gpointer data, GError **error);

/* On the main loop, when it is over and was not given up; @error is NULL when
 * all went well. */
typedef void (*ChoreDone) (gpointer data, const GError *error);

/* Takes @data, which is let go by @free_data on the main loop: after @done, or
 * when the thread has noticed that it was given up. The main loop must go on
 * until then.
 *
 * Returns: (transfer none): valid until @free_data. */
ChoreTask *chore_task_begin (Session *session,
                             const char *sentence,
                             ChoreWork work,
                             ChoreDone done,
                             gpointer data,
                             GDestroyNotify free_data);

/* Nobody is told any more, and the chore is over at once. */
void chore_task_give_up (ChoreTask *task);

/* For the thread, between the pieces of its work. */
gboolean chore_task_is_given_up (ChoreTask *task);

/* The same for what waits, or asks by itself.
 *
 * Returns: (transfer none): cancelled when it is given up. */
GCancellable *chore_task_get_cancellable (ChoreTask *task);

/* What document_write() does, unless it has been given up: then there is no
 * new file. Files are written one after the other, in the order of the main
 * loop's wishes as far as these are not given up. */
gboolean chore_task_write (ChoreTask *task,
                           const char *path,
                           const char *bytes,
                           gsize length,
                           GError **error);

G_END_DECLS

#endif
