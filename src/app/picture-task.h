/* Pictures for other programs: a thread draws what the session shows when they
 * are asked for, as a chore of the session, which can be given up. */
#ifndef PICTURE_TASK_H
#define PICTURE_TASK_H

#include "picture.h"
#include "session.h"

G_BEGIN_DECLS

typedef struct PictureTask PictureTask;

typedef struct PictureFile {
  PictureFormat format;
  double scale;
  char *path;    /* NULL: it is no file, but bytes */
  GBytes *bytes; /* what has been drawn */
} PictureFile;

#define N_PICTURE_FILES 2

/* Told on the main loop when all is drawn and written; not when it was given
 * up. May take bytes.
 *
 * Errors: DOCUMENT_ERROR_CANNOT_WRITE, or it cannot be drawn. */
typedef void (*PictureTaskDone) (PictureFile files[N_PICTURE_FILES],
                                 const GError *error,
                                 gpointer user);

/* Draws @picture, which has its size, view and theme, once for each of @files
 * and copies what it is given. @destroy: of @user, in any case.
 *
 * Returns: (transfer none): valid until @destroy. */
PictureTask *picture_task_begin (Session *session,
                                 const Picture *picture,
                                 const PictureFile *files,
                                 guint n_files,
                                 PictureTaskDone done,
                                 gpointer user,
                                 GDestroyNotify destroy);

/* Nobody wants it any more. */
void picture_task_give_up (PictureTask *task);

G_END_DECLS

#endif
