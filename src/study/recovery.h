/* Recovery files: sites that are in no file yet, kept against an end of the
 * program that nobody asked for.
 *
 *   Recovery *mine = recovery_new (folder);
 *   recovery_write (mine, "square.txt", "0 0\n1 0\n1 1\n0 1\n", &error);
 *   …
 *   recovery_clear (mine);  the sites are saved
 *
 * Each window has one, in a folder that all programs of a person share:
 *
 *   NAME.txt   a point file; comments come first, with the URI of the file
 *              that the sites come from
 *   NAME.lock  locked while the program lives
 *
 * What no living program holds is left over: a person is asked about it, and
 * who claims it holds it. Nobody but its holder takes it away. A Recovery is
 * for one thread at a time. */
#ifndef RECOVERY_H
#define RECOVERY_H

#include <glib.h>

G_BEGIN_DECLS

typedef struct Recovery Recovery;

/* Returns: (transfer full): the folder of this person. */
char *recovery_default_folder (void);

/* Returns: (transfer full): one without a file yet. */
Recovery *recovery_new (const char *folder);

/* Returns: (transfer full): the oldest that is left over, held from now on, or
 *          NULL: there is none. */
Recovery *recovery_claim (const char *folder);

/* Lets go of it: what is written stays, and is left over. */
void recovery_free (Recovery *recovery);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Recovery, recovery_free)

/* Returns: (transfer none): the path of its text. */
const char *recovery_get_path (const Recovery *recovery);

/* Returns: (transfer none): the path of the file that the sites come from, or
 *          NULL: they are new. */
const char *recovery_get_origin (const Recovery *recovery);

/* Returns: (transfer full): when it was written, or NULL: never. */
GDateTime *recovery_get_time (const Recovery *recovery);

/* Puts the text of a point file in the place of the one before, whole or not
 * at all.
 *
 * Errors: DOCUMENT_ERROR_CANNOT_WRITE. */
gboolean recovery_write (Recovery *recovery,
                         const char *origin,
                         const char *text,
                         GError **error);

/* Takes its file away: the sites are saved, or given up. */
void recovery_clear (Recovery *recovery);

G_END_DECLS

#endif
