#include "trace-file.h"

#include "number.h"
#include "trace-format.h"

#include <inttypes.h>

/* What a line does not say, the current round says: the site of a ridge of
 * the horizon and of a retired facet is the site that was selected. */
const char *
trace_format_fields (EventKind kind)
{
  static const char *const fields[N_EVENT_KINDS] = {
    [EVENT_DUPLICATE] = "s", [EVENT_FLAT] = "",     [EVENT_SIMPLEX] = "fabs",
    [EVENT_CLAIM] = "sf",    [EVENT_SELECT] = "fs", [EVENT_VISIBLE] = "fs",
    [EVENT_HORIZON] = "abf", [EVENT_CONE] = "fabs", [EVENT_RETIRE] = "f",
    [EVENT_COMPLETE] = "",
  };

  return fields[kind];
}

uint32_t *
trace_format_field (Event *event, char field)
{
  switch (field) {
  case 'f':
    return &event->facet;
  case 'a':
    return &event->ridge[0];
  case 'b':
    return &event->ridge[1];
  default:
    return &event->site;
  }
}

char
trace_format_letter (char field)
{
  return field == 'f' ? 'f' : 's';
}

static void
write_order (const Order *order, FILE *file)
{
  if (order->kind == ORDER_RANDOM)
    fprintf (file, "order random %" PRIu64 "\n", order->seed);
  else
    fprintf (file, "order %s\n", order_kind_name (order->kind));
}

static void
write_sites (const SiteSet *set, FILE *file)
{
  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    const Site given = site_set_given (set, i);
    char x[NUMBER_ROOM], y[NUMBER_ROOM];

    number_write (given.x, x);
    number_write (given.y, y);
    fprintf (file, "site %u %s %s\n", i, x, y);
  }
}

static void
write_event (Event event, FILE *file)
{
  fputs (event_kind_name (event.kind), file);
  for (const char *field = trace_format_fields (event.kind); *field != '\0';
       field += 1)
    fprintf (file, " %c%u", trace_format_letter (*field),
             *trace_format_field (&event, *field));
  fputs ("\n", file);
}

/* All before round 1. */
static void
write_start (const Trace *trace, FILE *file)
{
  const uint32_t n_duplicates = trace->set->n_sites - trace->set->n_distinct;

  if (trace->is_flat)
    fprintf (file, "flat duplicates %u\n", n_duplicates);
  else
    fprintf (file, "simplex duplicates %u facets 4 claims %u\n", n_duplicates,
             trace->start_end - trace->simplex_end);
}

static void
write_phases (const RoundRow *row, uint32_t round, FILE *file)
{
  fprintf (file, "round %u choose f%u s%u\n", round, row->facet, row->site);
  fprintf (file, "round %u see %u\n", round,
           row->last_visible - row->first_visible + 1);
  fprintf (file, "round %u horizon %u\n", round,
           row->last_horizon - row->first_horizon + 1);
  fprintf (file, "round %u cone %u\n", round,
           row->last_cone - row->first_cone + 1);
  fprintf (file, "round %u hand-over retired %u claims %u\n", round,
           row->last_retire - row->first_retire + 1,
           row->end - row->last_retire);
}

static void
write_round (const RoundRow *row, uint32_t round, FILE *file)
{
  fprintf (file, "round %u f%u s%u visible %u horizon %u cone %u claims %u\n",
           round, row->facet, row->site,
           row->last_visible - row->first_visible + 1,
           row->last_horizon - row->first_horizon + 1,
           row->last_cone - row->first_cone + 1, row->end - row->last_retire);
}

static void
write_rounds (const Trace *trace,
              void (*write) (const RoundRow *row, uint32_t round, FILE *file),
              FILE *file)
{
  write_start (trace, file);
  for (uint32_t i = 0; i < trace->n_rounds; i += 1)
    write (&trace->rounds[i], i + 1, file);
  fputs ("complete\n", file);
}

static void
write_head (const Trace *trace, const char *detail, FILE *file)
{
  fprintf (file, "%s %d\n%s", TRACE_MAGIC, TRACE_VERSION, detail);
  write_order (&trace->order, file);
  write_sites (trace->set, file);
}

bool
trace_file_write (const Trace *trace, Grain grain, FILE *file)
{
  switch (grain) {
  case GRAIN_EVENT:
    write_head (trace, "", file);
    for (uint32_t i = 0; i < trace->n_events; i += 1)
      write_event (trace_event (trace, i), file);
    break;
  case GRAIN_PHASE:
    write_head (trace, "detail phase\n", file);
    write_rounds (trace, write_phases, file);
    break;
  case GRAIN_ROUND:
    write_head (trace, "detail round\n", file);
    write_rounds (trace, write_round, file);
    break;
  }
  return !ferror (file);
}
