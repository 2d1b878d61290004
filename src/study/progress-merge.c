/* Progress that several programs keep in one file. */
#include "progress.h"

#include <fcntl.h>
#include <glib/gstdio.h>
#include <sys/file.h>
#include <unistd.h>

/* Of a question the better outcome counts; of two as good, theirs, which was
 * written first. */
static gboolean
is_better (const QuestionRecord *ours, const QuestionRecord *theirs)
{
  if (theirs->outcome == OUTCOME_OPEN)
    return ours->outcome != OUTCOME_OPEN || ours->n_checks > theirs->n_checks
           || ours->memory != NULL;
  if (ours->outcome == OUTCOME_OPEN)
    return FALSE;
  /* What was shown first may have been found later. */
  return theirs->outcome == OUTCOME_SHOWN && ours->outcome != OUTCOME_SHOWN;
}

/* Puts theirs in the place of ours, or behind all: what order things are kept
 * in must not tell when the file was written. */
static void
replace (GPtrArray *all, gconstpointer ours, gpointer theirs)
{
  guint at;

  if (ours == NULL || !g_ptr_array_find (all, ours, &at)) {
    g_ptr_array_add (all, theirs);
    return;
  }
  g_ptr_array_remove_index (all, at);
  g_ptr_array_insert (all, (gint)at, theirs);
}

/* Of a lesson in which both have gone on nothing is lost. */
static void
join_questions (LessonRecord *ours, GPtrArray *theirs)
{
  for (guint i = 0; i < theirs->len;) {
    const QuestionRecord *other = g_ptr_array_index (theirs, i);
    const QuestionRecord *old = lesson_record_find (ours, other->key);

    if (old != NULL && is_better (old, other))
      i += 1;
    else
      replace (ours->questions, old, g_ptr_array_steal_index (theirs, i));
  }
}

static void
join_lesson (LessonRecord *ours, LessonRecord *theirs)
{
  join_questions (ours, theirs->questions);
  ours->furthest = MAX (ours->furthest, theirs->furthest);
  ours->seconds = MAX (ours->seconds, theirs->seconds);
  if (theirs->first != 0 && (ours->first == 0 || theirs->first < ours->first))
    ours->first = theirs->first;
}

/* Whoever has cleared the file since has cleared this too. */
static void
drop_cleared (Progress *progress, const Progress *theirs)
{
  for (guint i = progress->lessons->len; i > 0; i--) {
    const LessonRecord *ours = g_ptr_array_index (progress->lessons, i - 1);

    if (!ours->is_changed && progress_find (theirs, ours->key) == NULL)
      g_ptr_array_remove_index (progress->lessons, i - 1);
  }
}

void
progress_merge (Progress *progress, Progress *theirs)
{
  g_free (progress->learner);
  progress->learner = g_strdup (theirs->learner);
  drop_cleared (progress, theirs);
  for (guint i = 0; i < theirs->lessons->len;) {
    LessonRecord *other = g_ptr_array_index (theirs->lessons, i);
    LessonRecord *ours = progress_find (progress, other->key);

    if (ours != NULL && ours->is_changed) {
      join_lesson (ours, other);
      i += 1;
    } else {
      replace (progress->lessons, ours,
               g_ptr_array_steal_index (theirs->lessons, i));
    }
  }
}

/* A program that has stopped must not stop this one. */
#define MOST_TRIES 50
#define PAUSE_US 10000

int
progress_lock (const char *folder)
{
  const int lock = g_open (folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);

  for (guint i = 0; lock >= 0 && i < MOST_TRIES; i++) {
    if (flock (lock, LOCK_EX | LOCK_NB) == 0)
      break;
    g_usleep (PAUSE_US);
  }
  return lock;
}

void
progress_unlock (int lock)
{
  if (lock >= 0)
    close (lock);
}
