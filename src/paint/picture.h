/* Pictures of a frame as files: SVG, PDF, PNG. */
#ifndef PICTURE_H
#define PICTURE_H

#include "painter.h"

#include <cairo.h>
#include <stdio.h>

typedef enum PictureView {
  PICTURE_PLANE,
  PICTURE_SPACE,
  PICTURE_BOTH, /* side by side */
} PictureView;

typedef enum PictureFormat {
  PICTURE_SVG,
  PICTURE_PDF,
  PICTURE_PNG,
} PictureFormat;

/* Fills the scene of a pane: 0 the left one, that of PICTURE_PLANE, 1 the
 * other. The rectangle of @look is what the picture shows. */
typedef void (*PictureFill) (Scene *scene,
                             int pane,
                             const SceneLook *look,
                             void *user);

typedef struct Picture {
  PictureView view;
  double width, height; /* px of the PNG, pt of the others, before scaling */
  double scale;         /* of everything: 2 is for screens of twice the dots */
  bool is_transparent;  /* no background */
  SceneLook look;       /* low and high are set by the picture itself */
  Camera camera;
  PlaneCamera plane_camera;
  const Theme *theme;
  const char *title;       /* may be NULL; SVG <title>, PDF metadata */
  const char *description; /* may be NULL: the narration */
  PictureFill fill;        /* NULL: the plane and the space of the frame */
  void *fill_user;
  bool is_space[2]; /* what the panes show, when @fill fills them */
} Picture;

/* The largest side of a picture, after scaling. */
#define PICTURE_MOST 16384

/* Returns: whether each side lies between 1 and PICTURE_MOST after scaling. */
bool picture_has_good_size (const Picture *picture);

/* A picture of everything in its default look, 960 × 480 for both views. */
void picture_init (Picture *picture, PictureView view, const Frame *frame);

/* Paints without a file and without scaling, for the screen, pages and tests.
 */
void picture_paint (const Picture *picture, const Frame *frame, cairo_t *cr);

/* Writes the picture. The same frame gives the same bytes. Names of sites are
 * text in a PDF, to be searched and copied, and outlines in an SVG.
 *
 * Returns: false when writing failed. */
bool picture_write (const Picture *picture,
                    const Frame *frame,
                    PictureFormat format,
                    FILE *file);

/* Returns: whether @path ends as a picture's name does; sets *@format. */
bool picture_format_of (const char *path, PictureFormat *format);

#endif
