#include "timeline.h"

#include <string.h>

static const char *const phase_names[N_PHASES] = {
  [PHASE_START] = "start",         [PHASE_SIMPLEX] = "simplex",
  [PHASE_CHOOSE] = "choose",       [PHASE_SEE] = "see",
  [PHASE_HORIZON] = "horizon",     [PHASE_CONE] = "cone",
  [PHASE_HAND_OVER] = "hand-over", [PHASE_COMPLETE] = "complete",
};

const char *
phase_name (Phase phase)
{
  return phase_names[phase];
}

bool
phase_parse (const char *name, Phase *phase)
{
  Phase i;

  for (i = 0; i < N_PHASES; i++)
    if (strcmp (name, phase_names[i]) == 0) {
      *phase = i;
      return true;
    }
  return false;
}

static Phase
phase_of_event (EventKind kind, bool is_start)
{
  switch (kind) {
  case EVENT_DUPLICATE:
  case EVENT_FLAT:
  case EVENT_SIMPLEX:
    return PHASE_SIMPLEX;
  case EVENT_CLAIM:
    return is_start ? PHASE_SIMPLEX : PHASE_HAND_OVER;
  case EVENT_SELECT:
    return PHASE_CHOOSE;
  case EVENT_VISIBLE:
    return PHASE_SEE;
  case EVENT_HORIZON:
    return PHASE_HORIZON;
  case EVENT_CONE:
    return PHASE_CONE;
  case EVENT_RETIRE:
    return PHASE_HAND_OVER;
  case EVENT_COMPLETE:
    return PHASE_COMPLETE;
  }
  return PHASE_START;
}

Place
timeline_place (const Trace *trace, uint32_t step)
{
  const uint32_t round = trace_round (trace, step);
  Place place = { round == INDEX_NONE ? 0 : round + 1, PHASE_START };

  if (step > 0)
    place.phase
        = phase_of_event (trace_event (trace, step - 1).kind, place.round == 0);
  return place;
}

/* The first and last step of a phase of a round. */
static bool
phase_span (const RoundRow *row, Phase phase, uint32_t ends[2])
{
  switch (phase) {
  case PHASE_CHOOSE:
    ends[0] = ends[1] = row->select;
    return true;
  case PHASE_SEE:
    ends[0] = row->first_visible;
    ends[1] = row->last_visible;
    return true;
  case PHASE_HORIZON:
    ends[0] = row->first_horizon;
    ends[1] = row->last_horizon;
    return true;
  case PHASE_CONE:
    ends[0] = row->first_cone;
    ends[1] = row->last_cone;
    return true;
  case PHASE_HAND_OVER:
    ends[0] = row->first_retire;
    ends[1] = row->end;
    return true;
  case PHASE_START:
  case PHASE_SIMPLEX:
  case PHASE_COMPLETE:
    return false;
  }
  return false;
}

/* The steps that belong to no round. */
static bool
outer_span (const Trace *trace, Place place, uint32_t ends[2])
{
  if (place.phase == PHASE_COMPLETE) {
    ends[0] = ends[1] = trace->n_events;
    return true;
  }
  if (place.round != 0)
    return false;
  if (place.phase == PHASE_SIMPLEX) {
    ends[0] = 1;
    ends[1] = trace->start_end;
    return true;
  }
  if (place.phase != PHASE_START)
    return false;
  ends[0] = 1;
  ends[1] = 0;
  return true;
}

bool
timeline_find (const Trace *trace, Place place, bool before, uint32_t *step)
{
  uint32_t ends[2];

  if (!outer_span (trace, place, ends)
      && (place.round == 0 || place.round > trace->n_rounds
          || !phase_span (&trace->rounds[place.round - 1], place.phase, ends)))
    return false;
  *step = before ? ends[0] - 1 : ends[1];
  return true;
}

static bool
is_phase_end (const Trace *trace, uint32_t step)
{
  const Place here = timeline_place (trace, step);
  const Place next = timeline_place (trace, step + 1);

  return here.round != next.round || here.phase != next.phase;
}

static bool
is_round_end (const Trace *trace, uint32_t step)
{
  const uint32_t round = trace_round (trace, step);

  return round == INDEX_NONE ? step == trace->start_end
                             : step == trace->rounds[round].end;
}

static bool
is_end (const Trace *trace, uint32_t step, Grain grain)
{
  if (step == 0 || step >= trace->n_events)
    return true;
  switch (grain) {
  case GRAIN_EVENT:
    return true;
  case GRAIN_PHASE:
    return is_phase_end (trace, step);
  case GRAIN_ROUND:
    return is_round_end (trace, step);
  }
  return true;
}

uint32_t
timeline_next (const Trace *trace, uint32_t step, Grain grain)
{
  if (step >= trace->n_events)
    return trace->n_events;
  do
    step++;
  while (!is_end (trace, step, grain));
  return step;
}

uint32_t
timeline_back (const Trace *trace, uint32_t step, Grain grain)
{
  if (step == 0)
    return 0;
  do
    step--;
  while (!is_end (trace, step, grain));
  return step;
}
