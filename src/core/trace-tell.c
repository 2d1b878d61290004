/* Events, ridges and claims of a trace, told from its log. */
#include "trace-ridges.h"

#define NO_RIDGE                                                               \
  {                                                                            \
    INDEX_NONE, INDEX_NONE                                                     \
  }

/* Event @i of those before round 1. */
static Event
event_of_start (const Trace *trace, uint32_t i)
{
  const TraceLog *log = &trace->log;

  if (i < log->n_duplicates)
    return (Event){ EVENT_DUPLICATE, INDEX_NONE, log->duplicates[i], NO_RIDGE };
  if (trace->is_flat)
    return (Event){ EVENT_FLAT, INDEX_NONE, INDEX_NONE, NO_RIDGE };
  i -= log->n_duplicates;
  if (i < 4)
    return (Event){ EVENT_SIMPLEX,
                    i,
                    log->simplex[i][2],
                    { log->simplex[i][0], log->simplex[i][1] } };
  return (Event){ EVENT_CLAIM, log->claims[i - 4].facet,
                  log->claims[i - 4].site, NO_RIDGE };
}

/* An event that tells ridge @i of the horizon, or the facet on it. */
static Event
event_of_ridge (const Trace *trace, EventKind kind, uint32_t round, uint32_t i)
{
  const TraceLog *log = &trace->log;
  const LogRound said = log->rounds[round];
  const uint32_t end = trace_log_round_end (log, round).horizon;
  const LogRidge *ridge = &log->horizon[said.horizon + i];
  const LogRidge *next
      = said.horizon + i + 1 < end ? ridge + 1 : &log->horizon[said.horizon];

  return (Event){ kind,
                  kind == EVENT_CONE ? 4 + said.horizon + i : ridge->beyond,
                  said.site,
                  { ridge->tail, next->tail } };
}

static Event
event_of_round (const Trace *trace, uint32_t round, uint32_t step)
{
  const TraceLog *log = &trace->log;
  const RoundRow *row = &trace->rounds[round];
  const LogRound said = log->rounds[round];
  const LogClaim *claim;

  if (step == row->select)
    return (Event){ EVENT_SELECT, row->facet, row->site, NO_RIDGE };
  if (step <= row->last_visible)
    return (Event){ EVENT_VISIBLE,
                    log->visible[said.visible + step - row->first_visible],
                    row->site, NO_RIDGE };
  if (step <= row->last_horizon)
    return event_of_ridge (trace, EVENT_HORIZON, round,
                           step - row->first_horizon);
  if (step <= row->last_cone)
    return event_of_ridge (trace, EVENT_CONE, round, step - row->first_cone);
  if (step <= row->last_retire)
    return (Event){ EVENT_RETIRE,
                    log->retired[said.retired + step - row->first_retire],
                    row->site, NO_RIDGE };
  claim = &log->claims[said.claim + step - row->last_retire - 1];
  return (Event){ EVENT_CLAIM, claim->facet, claim->site, NO_RIDGE };
}

Event
trace_event (const Trace *trace, uint32_t i)
{
  const uint32_t step = i + 1;
  uint32_t round;

  if (step == trace->n_events)
    return (Event){ EVENT_COMPLETE, INDEX_NONE, INDEX_NONE, NO_RIDGE };
  if (step <= trace->start_end)
    return event_of_start (trace, i);
  round = trace_round (trace, step);
  return event_of_round (trace, round, step);
}

static bool
has_edge (const FacetRow *row, uint32_t tail, uint32_t head)
{
  uint32_t k = 0;

  while (k < 3 && (row->site[k] != tail || row->site[(k + 1) % 3] != head))
    k++;
  return k < 3;
}

uint32_t
trace_simplex_ridges (const Trace *trace, uint32_t facet, BornRidge born[3])
{
  const uint32_t *site = trace->facets[facet].site;
  uint32_t k, other, n = 0;

  for (k = 0; k < 3; k++)
    for (other = facet + 1; other < 4; other++)
      if (has_edge (&trace->facets[other], site[(k + 1) % 3], site[k]))
        born[n++] = (BornRidge){ k, other };
  return n;
}

/* It dies with the first of its two facets. */
static RidgeRow
row_of (const Trace *trace, uint32_t facet, const BornRidge *ridge)
{
  const FacetRow *row = &trace->facets[facet];
  const uint32_t death = row->span.death;
  const uint32_t right_death = trace->facets[ridge->right].span.death;

  return (RidgeRow){ { row->site[ridge->k], row->site[(ridge->k + 1) % 3] },
                     { facet, ridge->right },
                     { facet < 4 ? trace->simplex_end : row->span.birth,
                       death < right_death ? death : right_death } };
}

/* Writes the ridge, if it was born with the facet. */
static bool
find_ridge (const Trace *trace, uint32_t ridge, uint32_t facet, RidgeRow *row)
{
  RidgeCursor cursor = RIDGE_CURSOR;
  BornRidge born[3];
  const uint32_t n = trace_born_ridges (trace, &cursor, facet, born);
  const uint32_t i = ridge - trace_first_ridge (&cursor, facet);

  if (i >= n)
    return false;
  *row = row_of (trace, facet, &born[i]);
  return true;
}

/* Ridges 6 and 7 would be those of facet 4 if every cone facet had two; but of
 * a cone the first has one, and the last has one more. */
RidgeRow
trace_ridge (const Trace *trace, uint32_t ridge)
{
  uint32_t facet = ridge / 2 + 1;
  RidgeRow row = { 0 };

  if (ridge < 6)
    facet = ridge < 3 ? 0 : (ridge < 5 ? 1 : 2);
  if (!find_ridge (trace, ridge, facet, &row))
    find_ridge (trace, ridge, facet + 1, &row);
  return row;
}

/* The round whose claims a claim is one of; INDEX_NONE: those of the start. */
static uint32_t
round_of_claim (const Trace *trace, uint32_t claim)
{
  const LogRound *rounds = trace->log.rounds;
  uint32_t low = 0, high = trace->n_rounds;

  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;

    if (rounds[middle].claim <= claim)
      low = middle + 1;
    else
      high = middle;
  }
  return low == 0 ? INDEX_NONE : low - 1;
}

/* It dies with its facet, or in the round of the site, when that is selected.
 */
static uint32_t
death_of_claim (const Trace *trace, const LogClaim *claim)
{
  const RoundRow *last
      = &trace->rounds[trace_round (trace, trace->inserted[claim->site])];

  return last->facet == claim->facet ? last->select
                                     : trace->facets[claim->facet].span.death;
}

ClaimRow
trace_claim (const Trace *trace, uint32_t claim)
{
  const LogClaim *said = &trace->log.claims[claim];
  const uint32_t round = round_of_claim (trace, claim);
  uint32_t birth = trace->simplex_end + 1 + claim;

  if (round != INDEX_NONE)
    birth = trace->rounds[round].last_retire + 1
            + (claim - trace->log.rounds[round].claim);
  return (ClaimRow){ said->site,
                     said->facet,
                     { birth, death_of_claim (trace, said) } };
}

ClaimRange
trace_claims_with (const Trace *trace, uint32_t facet)
{
  const TraceLog *log = &trace->log;
  const uint32_t round = trace->facets[facet].round;

  if (round > 0)
    return (ClaimRange){ log->rounds[round - 1].claim,
                         trace_log_round_end (log, round - 1).claim };
  return (ClaimRange){ 0, log->n_rounds > 0 ? log->rounds[0].claim
                                            : log->n_claims };
}

uint32_t
trace_n_waiting (const Trace *trace, uint32_t facet, uint32_t step)
{
  const ClaimRange range = trace_claims_with (trace, facet);
  uint32_t i, n = 0;

  for (i = range.first; i < range.end; i++)
    n += trace->log.claims[i].facet == facet
         && span_has (trace_claim (trace, i).span, step);
  return n;
}
