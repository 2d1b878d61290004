/* You be QuickHull: a person does what the algorithm does, task by task, and
 * the run follows what they choose.
 *
 *   partition   each waiting site to a facet of the first simplex
 *   facet       one with an outside set
 *   site        the furthest of it
 *   see         every facet that the site sees
 *   horizon     every ridge of the horizon
 *   cone        the ridges over which a new triangle is born
 *   hand over   each site of the outside sets that retire to a new facet
 *
 * Each task is an exercise of its own and is graded by legality: whatever
 * QuickHull may do is right. What is right is done, so that the next task is
 * about its consequences; where an answer is not right the performance goes
 * on as the engine would.
 */
#ifndef PERFORMANCE_H
#define PERFORMANCE_H

#include "exercise.h"

G_BEGIN_DECLS

typedef enum TaskKind {
  TASK_PARTITION,
  TASK_FACET,
  TASK_SITE,
  TASK_SEE,
  TASK_HORIZON,
  TASK_CONE,
  TASK_HAND_OVER,
} TaskKind;

#define N_TASK_KINDS (TASK_HAND_OVER + 1)

typedef struct Task {
  TaskKind kind;
  guint round;        /* from 1; 0: the first partition */
  guint site;         /* to be handed over, or INDEX_NONE */
  guint place, n;     /* it is this one, from 1, of so many to be handed over */
  Exercise *exercise; /* in the run of the performance */
  gboolean is_settled; /* its choice is made */
} Task;

typedef struct Performance {
  Run *run;         /* follows the choices made so far */
  GArray *choices;  /* of HullChoice */
  GPtrArray *tasks; /* of Task, in their order; the last is the current one */
  guint first_round, last_round;
  gboolean has_partition;
  guint n_retries; /* of each task */
  gboolean is_over;
  guint shown; /* the task that is looked at; until it is over, the current
                  one */
} Performance;

/* Of what is over, of the whole; else of the tasks that are settled. */
typedef struct PerformanceScore {
  guint total;   /* tasks */
  guint correct; /* right at the first check */
  guint undone;  /* steps of answers taken back */
  guint hinted;  /* hints taken */
} PerformanceScore;

/* Begins at the place of @occasion, which question_locate() has found, with
 * the first partition when that is still to come. */
Performance *performance_new (Run *run,
                              const Occasion *occasion,
                              guint n_insertions,
                              guint n_retries);
void performance_free (Performance *performance);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Performance, performance_free)

/* The current task, and the one that is looked at. */
Task *performance_task (const Performance *performance);
Task *performance_shown (const Performance *performance);

/* Once the exercise of the current task is closed: does what was chosen. After
 * the last task the performance is over. */
void performance_settle (Performance *performance);

/* Goes on to the next task.
 *
 * Returns: FALSE: the current task is not settled, or it was the last. */
gboolean performance_advance (Performance *performance);

/* Gives up what is still to be done: the answers are shown. */
void performance_give_up (Performance *performance);

/* Looks at the task before or after, when it is over.
 *
 * Returns: FALSE: there is none. */
gboolean performance_browse (Performance *performance, gboolean forwards);

PerformanceScore performance_score (const Performance *performance);

/* Answers all tasks as the engine does, or wrongly. */
void performance_play (Performance *performance, gboolean rightly);

/* In words. */

/* Returns: "partition", "facet", "site", "see", "horizon", "cone",
 *          "hand-over". */
const char *task_kind_name (TaskKind kind);

/* Returns: (transfer full): "round 2 hand-over s5", for programs. */
char *task_text (const Task *task);

/* Returns: (transfer full): "Insertion 2 of 3, step 3 of 6: what s5 sees",
 *          translated. */
char *performance_progress (const Performance *performance);

/* Returns: how much is done, 0 … 1. */
double performance_fraction (const Performance *performance);

/* Returns: (transfer full): "17 of 20 right, 2 hints, 1 step taken back". */
char *performance_score_text (const Performance *performance);

/* Returns: (transfer full): how each task went, a line for each insertion. */
char *performance_marks (const Performance *performance);

/* performance-task.c */

/* Returns: (transfer full): the task of this kind in @run. */
Task *
task_new (Run *run, TaskKind kind, guint round, guint site, guint n_retries);
void task_free (Task *task);

/* Lets the task stand in another run, that is the same up to its place. */
void task_move (Task *task, Run *run);

/* Returns: (transfer full) (element-type guint): the sites that are handed
 *          over in a round, ascending; round 0: in the first partition. */
GArray *task_sites (const Trace *trace, guint round);

G_END_DECLS

#endif
