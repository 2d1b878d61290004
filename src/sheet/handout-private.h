/* What the parts of a handout share; for handout*.c alone. */
#ifndef HANDOUT_PRIVATE_H
#define HANDOUT_PRIVATE_H

#include "handout.h"
#include "moment.h"
#include "page.h"

G_BEGIN_DECLS

/* Pictures of both views are twice as wide as high. */
#define PICTURE_RATIO 2.0

/* pt between columns, and between parts that belong together. */
#define COLUMN_GAP 15.0
#define PART_GAP 6.0
#define STOP_GAP 16.0

struct Handout {
  Session *session;
  Lesson *lesson;
  HandoutOptions options;
  Press press;
  Pages *pages;
  double width;      /* of a page's blocks */
  gboolean has_part; /* some part is set already */
  Listing listing;   /* of the last stop that was set */
  GPtrArray *legend; /* of LegendRow: what the pictures so far show */
};

/* Parts; each adds its blocks to the pages. */
void handout_add_page (Handout *handout);
void handout_add_stops (Handout *handout);
void handout_add_steps (Handout *handout);
void handout_add_key (Handout *handout);

/* A heading of a part, which begins a page and is in the outline. */
void handout_add_part (Handout *handout, const char *title);

/* Puts title, @under in small letters, and introduction into @stack. */
void handout_head (const Handout *handout, Block *stack, const char *under);

/* Returns: (transfer full): what the notes cite; NULL: nothing. */
Block *handout_sources (const Handout *handout);

/* Adds lines for the learner's own notes, as many as the last page has room
 * for. */
void handout_add_lines (Handout *handout);

/* Returns: (transfer full): what stands under the title: author and minutes,
 *          and with @counts how many stops and questions there are. */
char *handout_measures (const Handout *handout, gboolean counts);

/* Returns: (transfer full): plain words in a style. */
Block *handout_words (const Handout *handout,
                      TextStyle style,
                      double width,
                      const char *words);

/* The legend tells of what a picture shows, of @session, which is there. */
void handout_tell_of (Handout *handout,
                      Session *session,
                      MomentFace face,
                      MomentView view);

/* Returns: the picture of a stop, as wide as @width. */
Block *handout_picture (const Handout *handout,
                        guint stop,
                        MomentFace face,
                        double width);

/* Returns: whether the stop has a question that can be printed. */
gboolean handout_asks (const Handout *handout, guint stop);

guint handout_count_questions (const Handout *handout);

/* What a stop asks: the prompt, and either room for the answer or, with
 * @is_answered, the answer itself. */
Block *handout_question (const Handout *handout,
                         guint stop,
                         double width,
                         gboolean is_answered);

/* Whether its answer is a mark in the picture. */
gboolean handout_marks_picture (const Handout *handout, guint stop);

/* A listing of the code panel; NULL when the stop shows the algorithm that
 * runs. The session is at the stop. */
Block *handout_listing (const Handout *handout, double width);

/* The names of places in the file. */
char *handout_stop_name (guint stop); /* "stop-3" */
char *handout_key_name (guint stop);  /* "key-3" */

G_END_DECLS

#endif
