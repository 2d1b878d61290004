/* Where the names of a picture stand, judged from what is drawn alone: within
 * the frame, apart, on no mark, nearer to their own site than to any other, and
 * with no heavy line between. What is loud or lit has to have its name: where
 * it stands otherwise, a leader tells whose it is. */
#ifndef NAMES_JUDGE_H
#define NAMES_JUDGE_H

#include "drawing.h"
#include "fixture.h"

/* Another site is at least so many times as far from a name as its own; where
 * it is twice as far, there is no question whose name it is. */
#define NEARER 1.1
#define MUCH_NEARER 2.0

/* A picture as a canvas shows it. */
typedef struct Shown {
  Scene scene;
  Projection projection;
  Names *names;
  Drawing *drawing;
} Shown;

typedef struct Moment {
  const Frame *frame;
  gboolean is_space;
  ThemeKind theme;
  double width, height;
  Object selection, measured;
  const SceneAnswer *answers; /* n_answers of them */
  guint n_answers;
} Moment;

void shown_init (Shown *shown);
void shown_clear (Shown *shown);

/* Shows another moment in the same view. */
void show (Shown *shown, const Moment *moment, const Camera *camera);

/* Returns: the place of a mark. */
Pixel names_pixel_of (const Shown *shown, const SceneItem *item);

/* The letters of a name, without what is round them. */
PixelBox names_letters_of (const PlacedName *placed);

bool names_is_of_site (const SceneItem *item);

/* Whether a box lies on no other name than @name. */
bool
names_is_apart (const Drawing *drawing, uint32_t name, const PixelBox *box);

/* From the dot that a leader is of; there may be a ring between, px. */
#define LEADER_BEGINS 9.0

/* Returns: how large the site's own dot is; 0 where there is none. */
double names_radius_at (const Drawing *drawing, Pixel at);
double names_distance_to (const PixelBox *box, Pixel at);
double names_distance_from_line (Pixel at, Pixel a, Pixel b);

/* Whether two lines, from a to b and from c to d, meet. */
bool names_is_crossed (Pixel a, Pixel b, Pixel c, Pixel d);

/* Returns: what would be wrong with a name whose letters were in @box, or
 *          NULL. */
const char *names_fault_of (const Shown *shown,
                            uint32_t name,
                            const PixelBox *box,
                            double nearer);

/* Fails when there is something wrong with any name of a site.
 *
 * Returns: how many there are. */
guint names_judge (const Shown *shown, const char *what);

/* Fails when a leader meets another one, or that of a site touches the dot of
 * another, or the name at its end stands beside one.
 *
 * Returns: how many there are. */
guint names_judge_leaders (const Shown *shown, const char *what);

/* Fails when the middle of a facet, from which its name goes, lies close to the
 * dot of a site.
 *
 * Returns: how many there are. */
guint names_judge_middles (const Shown *shown);

/* Returns: how many of @sites have no name, though their dots lie free. */
guint names_count_nameless (const Shown *shown, const uint32_t sites[3]);

/* Fails when the name of an answer stands close to a dot, or right above or
 * below the name of a site, though there is a free place in its triangle.
 *
 * Returns: how many there are. */
guint names_judge_answers (const Shown *shown,
                           const Fixture *fixture,
                           const char *what);

/* Fails when what is loud or lit has no name. */
void names_check_none_is_missing (const Shown *shown, const char *what);

/* Returns: how much ink of lines lies under letters and their casing, px². */
double names_ink_under (const Shown *shown, const PixelBox *letters);

#endif
