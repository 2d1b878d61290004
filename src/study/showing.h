/* What a picture shows at one moment, kept: another thread can make a scene of
 * it, whatever the session shows by then. */
#ifndef SHOWING_H
#define SHOWING_H

#include "exhibit.h"
#include "kept-frame.h"
#include "scene.h"

G_BEGIN_DECLS

typedef struct Showing {
  KeptFrame *frame; /* NULL: of another exhibit */
  Run *run;         /* whose hues the look has */
  Exhibit *exhibit; /* its own */
  guint step, pane;
  gboolean is_space;
  SceneLook look; /* owns its answers and its selected sites */
} Showing;

Showing *showing_new (KeptFrame *frame,
                      Run *run,
                      gboolean is_space,
                      const SceneLook *look);

/* Of an exhibit but the lifts and their comparison. */
Showing *showing_new_exhibit (const Exhibit *exhibit,
                              guint step,
                              guint pane,
                              const SceneLook *look);
void showing_free (Showing *showing);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Showing, showing_free)

/* Puts another light on @scene, which was made of the same moment.
 *
 * Returns: FALSE: its stock is another, and nothing has been done. */
gboolean showing_relight (const Showing *showing, Scene *scene);

/* Fills @scene anew. */
void showing_fill (const Showing *showing, Scene *scene);

G_END_DECLS

#endif
