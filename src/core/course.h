/* The course of a demonstration: where each of its steps belongs, so that
 * one can go from event to event, from phase to phase and from round to
 * round, as in a trace (timeline.h).
 *
 *   Course course = { 0 };
 *
 *   course_add (&course, (Place){ 0, PHASE_SIMPLEX });
 *   course_add (&course, (Place){ 1, PHASE_CHOOSE });
 *   course_next (&course, 0, GRAIN_PHASE) == 1;
 *   course_clear (&course);
 */
#ifndef COURSE_H
#define COURSE_H

#include "timeline.h"

typedef struct Course {
  Place *places; /* places[i]: of step i + 1; step 0 is the start */
  uint32_t n_steps, room;
} Course;

void course_add (Course *course, Place place);
void course_clear (Course *course);

Place course_place (const Course *course, uint32_t step);

/* As timeline_find(). */
bool
course_find (const Course *course, Place place, bool before, uint32_t *step);

/* As timeline_next() and timeline_back(). */
uint32_t course_next (const Course *course, uint32_t step, Grain grain);
uint32_t course_back (const Course *course, uint32_t step, Grain grain);

/* Returns: the step of @to at the same place as @step of @from; the end where
 *          there is no such place, and at the end. */
uint32_t
course_same_place (const Course *from, uint32_t step, const Course *to);

#endif
