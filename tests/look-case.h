/* Moments whose pictures were looked at, and the comparison of pictures with
 * them: images/NAME-plane-ref.png, images/NAME-space-ref.png. */
#ifndef LOOK_CASE_H
#define LOOK_CASE_H

#include "fixture.h"
#include "picture.h"

/* A channel may differ by so much (of 255), and so many pixels in a thousand
 * by more: room for another version of the font or of cairo's edges. */
#define LOOK_CHANNEL 40
#define LOOK_PER_THOUSAND 4

#define LOOK_SIDE 420 /* px of all pictures */

typedef struct LookCase {
  const char *name;
  const char *sites;
  Place place;
  uint32_t layers; /* more than the default ones */
  Object selection;
  ThemeKind theme;
  uint32_t hidden; /* layers of the default ones */
  Object measured;
  double unlift; /* 1 - lift */
  bool has_preview;
  Site preview;
  CameraPreset camera;
} LookCase;

extern const LookCase look_cases[];
extern const guint look_n_cases;

/* A case as both painters see it. */
typedef struct LookScene {
  Fixture *fixture;
  Frame frame;
  Scene scene;
  Projection projection;
  const Theme *theme;
} LookScene;

void look_scene_init (LookScene *look, const LookCase *what, PictureView view);
void look_scene_clear (LookScene *look);

/* Returns: (transfer full): the picture of a case by cairo. */
cairo_surface_t *look_paint (const LookCase *what, PictureView view);

/* How two pictures are compared. Painters soften edges in ways of their own:
 * with @reach 1 a pixel is as it should be when each channel is among those of
 * its neighbours in the other picture, and the other way round. */
typedef struct LookRule {
  int reach;
  guint per_thousand; /* pixels that may differ */
} LookRule;

#define LOOK_SAME ((LookRule){ 0, LOOK_PER_THOUSAND })
#define LOOK_ALIKE ((LookRule){ 1, 1 })

/* Returns: the number of pixels that differ; they are black in @diff, the
 *          others a paler picture. */
guint look_compare (cairo_surface_t *out,
                    cairo_surface_t *ref,
                    int reach,
                    cairo_surface_t *diff);

/* Fails when more pixels of @out and @ref differ than may, and leaves
 * NAME-out.png and NAME-diff.png in the working directory. */
void look_check (const char *name,
                 cairo_surface_t *out,
                 cairo_surface_t *ref,
                 LookRule rule);

/* The same against the reference of a case; @by names the painter. */
void look_check_case (const LookCase *what,
                      PictureView view,
                      const char *by,
                      cairo_surface_t *out,
                      LookRule rule);

/* Returns: (transfer full): the path of the case's reference. */
char *look_path (const LookCase *what, PictureView view);

#endif
