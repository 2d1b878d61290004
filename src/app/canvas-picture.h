/* The picture of a canvas: kept until something changes, painted by the
 * raster or by OpenGL. HULL2VD_RENDERER=gl|cairo decides which; without it
 * OpenGL paints where a graphics processor does the work, and the raster where
 * OpenGL would be software too: it is faster there (CONTRIBUTING.md). Where
 * software is asked for, it paints all but scenes so large that a person would
 * wait for it: those the raster paints all the same. */
#ifndef CANVAS_PICTURE_H
#define CANVAS_PICTURE_H

#include "theme.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

typedef struct CanvasPicture CanvasPicture;

/* @may_use_gl: OpenGL may paint it at all. */
CanvasPicture *canvas_picture_new (GtkWidget *widget, gboolean may_use_gl);
void canvas_picture_free (CanvasPicture *picture);

/* The picture is to be brought up to date when it is drawn next. */
void canvas_picture_invalidate (CanvasPicture *picture);
gboolean canvas_picture_is_valid (const CanvasPicture *picture);

/* What it was made of is of no use for the next one. A thread gives that back:
 * of many sites it takes long. What is shown stays until then. */
void canvas_picture_forget (CanvasPicture *picture);

/* The window is about to go, and all that depends on it. */
void canvas_picture_release (CanvasPicture *picture);

/* Whether it was painted in a hurry: worth being painted again at rest. */
gboolean canvas_picture_is_rough (const CanvasPicture *picture);

/* Paints what has changed. Never fails: what OpenGL cannot paint the raster
 * does, from then on.
 *
 * Returns: FALSE with @error set when this has just happened. */
gboolean canvas_picture_update (CanvasPicture *picture,
                                const Scene *scene,
                                const Projection *projection,
                                const Theme *theme,
                                gboolean is_moving,
                                GError **error);

/* Whether no more than what is lit is to be painted, which takes no time. */
gboolean canvas_picture_has_stock (const CanvasPicture *picture,
                                   const Scene *scene,
                                   const Projection *projection,
                                   const Theme *theme);

/* A picture in the making: the part of an update that another thread can do.
 * It is lent and taken back on the main loop, which shows the picture as it
 * was until then; lent in vain, it is freed, and the picture begins anew. */
typedef struct PictureWork PictureWork;

/* Errors: as canvas_picture_update(), without failing. */
PictureWork *canvas_picture_lend (CanvasPicture *picture,
                                  const Projection *projection,
                                  const Theme *theme,
                                  gboolean is_moving,
                                  GError **error);
void picture_work_do (PictureWork *work, const Scene *scene);
void picture_work_prepare (PictureWork *work); /* for what will be lit */
void picture_work_free (PictureWork *work);

/* Takes @work, and shows it. The picture is valid when @is_up_to_date.
 *
 * Returns: as canvas_picture_update(). */
gboolean canvas_picture_take_back (CanvasPicture *picture,
                                   PictureWork *work,
                                   gboolean is_up_to_date,
                                   GError **error);

/* Returns: FALSE: there is nothing to be shown yet. */
gboolean canvas_picture_draw (CanvasPicture *picture, cairo_t *cr);

G_END_DECLS

#endif
