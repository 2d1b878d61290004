/* Marks of pictures, as the legend tells them apart. Most are a role; what a
 * person has selected or points at is one of its own, whatever its role.
 *
 *   LegendMarks marks = { 0 };
 *
 *   legend_marks_add_stock (&marks, &scene);
 *   legend_marks_add_pointed (&marks, &scene);
 *   if (marks.shapes[ROLE_HORIZON] != 0) …
 */
#ifndef LEGEND_MARK_H
#define LEGEND_MARK_H

#include "scene.h"

/* A mark below N_ROLES is that role, as it is by itself. ROLE_LIT: whatever is
 * selected. */
enum {
  LEGEND_NEW_CELL = N_ROLES, /* of the current site */
  LEGEND_OTHER_NEW_CELL,     /* of that of another run beside it */
  LEGEND_SELECTED_VERTEX,    /* the Voronoi vertex of the selected circle */
  LEGEND_SELECTED_CELL,      /* of the selected site */
  LEGEND_SELECTED_LIFT,
  LEGEND_POINTED,        /* whatever the pointer is on */
  LEGEND_POINTED_VERTEX, /* the Voronoi vertex of the facet it is on */
  LEGEND_POINTED_CELL,   /* of the site it is on */
  LEGEND_POINTED_LIFT,
  N_LEGEND_MARKS,
};

typedef struct LegendMarks {
  unsigned char shapes[N_LEGEND_MARKS]; /* 1 << SceneShape each; 0: it is in no
                                           picture */
  bool is_strong[N_LEGEND_MARKS]; /* not all that there is of it is pale */
  bool has_hull; /* in space, where it hides sites that are on it */
  uint32_t new_hue, other_new_hue;
} LegendMarks;

/* Adds the stock of a scene, as it is when nothing of it is lit. */
void legend_marks_add_stock (LegendMarks *marks, const Scene *scene);

/* Adds the light on the stock, and what is there only because a person points
 * at it. */
void legend_marks_add_pointed (LegendMarks *marks, const Scene *scene);

/* Adds all marks of @from. */
void legend_marks_merge (LegendMarks *marks, const LegendMarks *from);

/* The item of which painter_swatch() draws @mark: as pale as it is where it is
 * strongest, so that the sample looks like what it explains. Of two marks (n)
 * the second lies behind the hull.
 *
 * @kind: of the object that is selected or pointed at. */
SceneItem
legend_mark_sample (const LegendMarks *marks, int mark, ObjectKind kind);

#endif
