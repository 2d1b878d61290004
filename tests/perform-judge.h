/* What is legal in a task of a performance, by the definitions alone: who sees
 * what is judged in integers of any size, and where sites wait is remembered
 * from the choices made, not read from the run. */
#ifndef PERFORM_JUDGE_H
#define PERFORM_JUDGE_H

#include "performance.h"
#include "standing.h"

typedef struct PerformJudge {
  Judge *judge;
  guint *waits_at; /* per site: its facet, or INDEX_NONE */
  guint facet;     /* that was chosen for the current round */
} PerformJudge;

PerformJudge *perform_judge_new (const SiteSet *set);
void perform_judge_free (PerformJudge *judge);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (PerformJudge, perform_judge_free)

/* Returns: (transfer full) (element-type Object): all that is legal, or all
 *          that is right, in the current task. */
GArray *perform_judge_answer (const PerformJudge *judge,
                              const Performance *performance);

/* Remembers what was chosen in it. */
void perform_judge_follow (PerformJudge *judge,
                           const Performance *performance,
                           Object chosen);

#endif
