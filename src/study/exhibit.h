/* Exhibits: what a session can show of its sites instead of the hull of
 * their lifts. Each follows from the sites alone, has steps of its own, and
 * is played by the same transport.
 *
 *   Exhibit *exhibit = exhibit_new (EXHIBIT_PLANAR, run, NULL);
 *
 *   exhibit_course (exhibit)->n_steps
 *   exhibit_scene (exhibit, step, 0, &scene, &look);
 *   exhibit_free (exhibit);
 */
#ifndef EXHIBIT_H
#define EXHIBIT_H

#include "planar-frame.h"
#include "rounding.h"
#include "run.h"

G_BEGIN_DECLS

typedef enum ExhibitKind {
  EXHIBIT_LIFTS,   /* the hull of the lifts: the session's own trace and frame;
                      there is no Exhibit of it */
  EXHIBIT_COMPARE, /* that hull in two orders, in step by round; there is no
                      Exhibit of it either */
  EXHIBIT_PLANAR,  /* QuickHull in the plane, step by step */
  EXHIBIT_SIGNS,   /* the sign of a turn in plain doubles and in truth, for all
                      places of one site that are next to it */
  EXHIBIT_ROUNDED, /* the hull in the plane that such signs lead to */
} ExhibitKind;

#define N_EXHIBITS (EXHIBIT_ROUNDED + 1)

/* The turn of which the signs are shown, and the current node of the map. */
typedef struct ExhibitTurn {
  gboolean is_named; /* else the exhibit finds a wrong one */
  guint sites[3];    /* the first is the one that takes all places */
  guint node[2];     /* column, row */
} ExhibitTurn;

/* "lifts", "compare", "planar", "signs", "rounded" */
const char *exhibit_kind_name (ExhibitKind kind);
gboolean exhibit_kind_parse (const char *name, ExhibitKind *kind);

typedef struct Exhibit Exhibit;

/* Owns: keeps a reference to @run. */
Exhibit *exhibit_new (ExhibitKind kind, Run *run, const ExhibitTurn *turn);
void exhibit_free (Exhibit *exhibit);

/* Returns: (transfer full): another one of the same, for another thread: what
 *          never changes is shared. It has no course but the planar one. */
Exhibit *exhibit_share (const Exhibit *exhibit);

ExhibitKind exhibit_kind (const Exhibit *exhibit);
Run *exhibit_run (const Exhibit *exhibit);
const Course *exhibit_course (const Exhibit *exhibit);

/* NULL: another kind, or these sites have none. */
const SignMap *exhibit_map (const Exhibit *exhibit);

/* Makes another node of the sign map the current one. */
void exhibit_set_node (Exhibit *exhibit, const guint node[2]);

/* The sentence for @step, as narration_write(). */
void exhibit_narrate (Exhibit *exhibit,
                      guint step,
                      NarrationTranslate translate,
                      char text[NARRATION_ROOM]);

/* The listing, its title, and its current line. */
const char *exhibit_listing_title (const Exhibit *exhibit); /* to translate */
const PseudocodeLine *exhibit_lines (const Exhibit *exhibit, guint *n_lines);
guint exhibit_line (Exhibit *exhibit, guint step);

/* Returns: (transfer full) (element-type Law): the counters. */
GPtrArray *exhibit_laws (Exhibit *exhibit, guint step);

/* Returns: the names of all counters that frames do not have, NULL at the
 *          end. */
const char *const *exhibit_count_names (void);

/* The counter that expect calls @key.
 *
 * Returns: FALSE: the exhibit has no such counter. */
gboolean
exhibit_count (Exhibit *exhibit, guint step, const char *key, guint *count);

/* What is in the plane at @step, of each kind. */
const PlanarFrame *exhibit_planar_frame (Exhibit *exhibit, guint step);
const RoundedHull *exhibit_rounded_hull (Exhibit *exhibit, guint step);

/* Fills @scene, of the plane. Of rounding, pane 1 shows the truth. */
void exhibit_scene (Exhibit *exhibit,
                    guint step,
                    guint pane,
                    Scene *scene,
                    const SceneLook *look);

G_END_DECLS

#endif
