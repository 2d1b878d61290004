#include "course.h"

#include "memory.h"

#include <stdlib.h>

void
course_add (Course *course, Place place)
{
  if (course->n_steps == course->room)
    course->places = memory_grow (course->places, &course->room,
                                  course->n_steps + 1, sizeof *course->places);
  course->places[course->n_steps++] = place;
}

void
course_clear (Course *course)
{
  free (course->places);
  *course = (Course){ NULL, 0, 0 };
}

Place
course_place (const Course *course, uint32_t step)
{
  return step == 0 ? (Place){ 0, PHASE_START } : course->places[step - 1];
}

static bool
is_same (Place a, Place b)
{
  return a.round == b.round && a.phase == b.phase;
}

/* Whether @a comes before @b; the end comes last, whatever its round. */
static bool
is_earlier (Place a, Place b)
{
  const bool is_end[2]
      = { a.phase == PHASE_COMPLETE, b.phase == PHASE_COMPLETE };

  if (is_end[0] || is_end[1])
    return !is_end[0];
  return a.round != b.round ? a.round < b.round : a.phase < b.phase;
}

/* Returns: the first step that does not come before @place, or that comes
 *          after it, when @after; n_steps + 1 when there is none. */
static uint32_t
first_step (const Course *course, Place place, bool after)
{
  uint32_t low = 0, high = course->n_steps + 1;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    const Place here = course_place (course, middle);

    if (after ? !is_earlier (place, here) : is_earlier (here, place))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

bool
course_find (const Course *course, Place place, bool before, uint32_t *step)
{
  const uint32_t first = first_step (course, place, false);
  const uint32_t end = first_step (course, place, true);

  if (first == end)
    return false;
  *step = !before ? end - 1 : first > 0 ? first - 1 : 0;
  return true;
}

static bool
is_end (const Course *course, uint32_t step, Grain grain)
{
  const Place here = course_place (course, step);
  Place next;

  if (step == 0 || step == course->n_steps || grain == GRAIN_EVENT)
    return true;
  next = course_place (course, step + 1);
  return grain == GRAIN_PHASE
             ? !is_same (here, next)
             : here.round != next.round || next.phase == PHASE_COMPLETE;
}

uint32_t
course_next (const Course *course, uint32_t step, Grain grain)
{
  if (step >= course->n_steps)
    return course->n_steps;
  do
    step++;
  while (!is_end (course, step, grain));
  return step;
}

uint32_t
course_back (const Course *course, uint32_t step, Grain grain)
{
  if (step == 0)
    return 0;
  do
    step--;
  while (!is_end (course, step, grain));
  return step;
}

uint32_t
course_same_place (const Course *from, uint32_t step, const Course *to)
{
  const Place place = course_place (from, step);
  uint32_t start, to_start, to_end;

  if (step >= from->n_steps || !course_find (from, place, true, &start)
      || !course_find (to, place, true, &to_start)
      || !course_find (to, place, false, &to_end))
    return to->n_steps;
  return to_start + (step - start) < to_end ? to_start + (step - start)
                                            : to_end;
}
