/* Documents: files of points and lessons, opened into a session and saved
 * from it. */
#ifndef DOCUMENT_H
#define DOCUMENT_H

#include "session.h"

G_BEGIN_DECLS

#define DOCUMENT_ERROR (document_error_quark ())
GQuark document_error_quark (void);
typedef enum DocumentError {
  DOCUMENT_ERROR_CANNOT_OPEN,
  DOCUMENT_ERROR_REFUSED, /* the message is FILE:LINE: reason */
  DOCUMENT_ERROR_CANNOT_WRITE,
} DocumentError;

/* Returns: whether @path is a lesson by its name: it ends in .md. */
gboolean document_is_lesson (const char *path);

/* Opens a lesson or a points file; "-" is the standard input: a lesson when it
 * has a lesson block, points when it has none. A lesson stands at its first
 * stop, points at their last step.
 *
 * Errors: DOCUMENT_ERROR or LESSON_ERROR; then the session is unchanged. */
gboolean document_open (Session *session, const char *path, GError **error);

/* Opens a lesson, whatever its name is; "-" is the standard input. */
gboolean
document_open_lesson (Session *session, const char *path, GError **error);

/* Reads points; @name is for messages. */
SiteSet *document_parse_points (const char *text,
                                gsize length,
                                const char *name,
                                GError **error);

/* Reads as input_read().
 *
 * Returns: (transfer full): its bytes, or NULL with @error
 *          (DOCUMENT_ERROR_CANNOT_OPEN) set. */
char *document_read (const char *path,
                     gsize *length,
                     GCancellable *cancellable,
                     GError **error);

/* Returns: (transfer full): the points of a file, free with
 *          site_set_free(), or NULL with @error set. */
SiteSet *document_read_points (const char *path, GError **error);

/* Returns: (transfer full): the session's sites as given, one Site after the
 *          other: for a thread, or to be compared. Equal bytes, equal files. */
GBytes *document_sites (Session *session);

/* Returns: (transfer full): such sites as the text of a points file. */
char *document_sites_text (GBytes *sites);

/* Returns: (transfer full): the session's sites as such a text. */
char *document_copy (Session *session);

/* Puts @length bytes at @path whole or not at all: a temporary file in the
 * same folder takes its place. A symbolic link is followed, the mode of an
 * existing file kept; what is not a regular file is written to.
 *
 * Errors: DOCUMENT_ERROR_CANNOT_WRITE. */
gboolean document_write (const char *path,
                         const char *bytes,
                         gsize length,
                         GError **error);

G_END_DECLS

#endif
