/* Points as other programs write them, for what a person opens, pastes and
 * drops. Beside point files (site-file.h) these are read:
 *
 *   x,y            a table with one line of headings: two names, neither of
 *   0.5,0.25       them a number
 *
 *   2 rbox 3 D2    what rbox writes and qhull reads: the dimension, with or
 *   3              without a comment, the number of points, the points
 *   0.5 0.25
 *   …
 *
 * The rows are as strict as in point files. Commands of hull2vd-cli and files
 * of lessons are point files alone. */
#ifndef POINT_IMPORT_H
#define POINT_IMPORT_H

#include "session.h"

G_BEGIN_DECLS

/* Reads @length bytes; @name is for messages. *@is_foreign, unless NULL, says
 * whether they are no point file.
 *
 * Returns: (transfer full): the points, free with site_set_free(), or NULL
 *          with @error (DOCUMENT_ERROR_REFUSED, NAME:LINE: reason) set. */
SiteSet *point_import_parse (const char *text,
                             gsize length,
                             const char *name,
                             gboolean *is_foreign,
                             GError **error);

/* Opens a lesson, or points in any of these forms, as document_open() does. A
 * lesson must be a regular file. */
gboolean point_import_open (Session *session,
                            const char *path,
                            gboolean *is_foreign,
                            GError **error);

/* The first half of that for a lesson; when it has been played, it is the
 * session's with session_set_lesson().
 *
 * Returns: (transfer full): the lesson, not played yet, in the person's
 *          language; or NULL with @error set. */
Lesson *point_import_read_lesson (const char *path, GError **error);

/* Both halves of that for points: what may be another thread's, which may have
 * to wait until @cancellable, unless NULL, says no; and the rest.
 *
 * Returns: (transfer full): the points, or NULL with @error set. */
SiteSet *point_import_read (const char *path,
                            gboolean *is_foreign,
                            GCancellable *cancellable,
                            GError **error);

/* Takes @set. */
gboolean point_import_put (Session *session, SiteSet *set, GError **error);

/* Replaces the session's sites by points in text; @origin is for messages,
 * @edit says what it is for undo: "paste". Text without points is refused. */
gboolean point_import_text (Session *session,
                            const char *text,
                            const char *origin,
                            const char *edit,
                            GError **error);

/* Both halves of that: what may be another thread's, and the rest, which takes
 * @set. */
SiteSet *point_import_read_text (const char *text,
                                 gsize length,
                                 const char *origin,
                                 GError **error);
gboolean point_import_replace (Session *session,
                               SiteSet *set,
                               const char *edit,
                               GError **error);

G_END_DECLS

#endif
