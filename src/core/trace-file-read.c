/* The recorder refuses events that are not legal at their place; this reader
 * also refuses those that are not true of the sites, so that whatever comes
 * out of a file shows right hulls. */
#include "trace-file.h"

#include "memory.h"
#include "number.h"
#include "trace-format.h"
#include "trace-recorder.h"

#include <stdlib.h>
#include <string.h>

#define MAX_SITES 10000000u
#define LINE_ROOM 128

typedef struct TraceReader {
  const char *text, *end; /* what is left */
  char line[LINE_ROOM];
  uint32_t n_lines; /* read so far */

  Order order;
  Site *sites;
  uint32_t n_sites, sites_room;
  SiteRange range;
  SiteSet *set; /* from the first event on */
  TraceRecorder *recorder;

  uint32_t (*facets)[3];
  uint32_t n_facets, facets_room;
  uint32_t apex; /* the site of the current round */
  uint32_t n_visible, n_horizon;
} TraceReader;

/* Puts the next line into reader->line.
 *
 * Returns: NULL, or why it is none. */
static const char *
read_line (TraceReader *reader)
{
  const size_t rest = (size_t)(reader->end - reader->text);
  const char *feed = rest > 0 ? memchr (reader->text, '\n', rest) : NULL;
  size_t length;

  reader->n_lines += 1;
  if (rest == 0)
    return "the file ends before complete";
  if (feed == NULL)
    return "the last line has no end";
  length = (size_t)(feed - reader->text);
  if (length >= LINE_ROOM)
    return "the line is too long";
  if (memchr (reader->text, '\0', length) != NULL)
    return "a NUL byte";
  memcpy (reader->line, reader->text, length);
  reader->line[length] = '\0';
  reader->text = feed + 1;
  return NULL;
}

/* Moves *@text over @word, which must stand there. */
static bool
take (const char **text, const char *word)
{
  const size_t length = strlen (word);

  if (strncmp (*text, word, length) != 0)
    return false;
  *text += length;
  return true;
}

/* Reads a whole number of at most @most, written in the only way. */
static bool
take_number (const char **text, uint64_t most, uint64_t *number)
{
  const char *digit = *text;

  *number = 0;
  for (; *digit >= '0' && *digit <= '9'; digit += 1) {
    const uint64_t value = (uint64_t)(*digit - '0');

    if (*number > (most - value) / 10)
      return false;
    *number = *number * 10 + value;
  }
  if (digit == *text || (**text == '0' && digit > *text + 1))
    return false;
  *text = digit;
  return true;
}

static bool
take_index (const char **text, uint32_t *index)
{
  uint64_t number;

  if (!take_number (text, INDEX_NONE - 1, &number))
    return false;
  *index = (uint32_t)number;
  return true;
}

static const char *
parse_magic (const char *line)
{
  uint32_t version;

  if (!take (&line, TRACE_MAGIC " ") || !take_index (&line, &version)
      || *line != '\0')
    return "not a trace file: the first line is \"" TRACE_MAGIC " 1\"";
  if (version != TRACE_VERSION)
    return "a trace file of another version; this program reads version 1";
  return NULL;
}

static const char *
parse_order (const char *line, Order *order)
{
  if (take (&line, "detail "))
    return "only traces with every event can be read back";
  *order = (Order){ ORDER_FURTHEST, 0 };
  if (!take (&line, "order "))
    return "expected the order";
  if (take (&line, "random ")) {
    order->kind = ORDER_RANDOM;
    if (!take_number (&line, UINT64_MAX, &order->seed) || *line != '\0')
      return "the seed is a whole number";
  } else if (!order_kind_parse (line, &order->kind)
             || order->kind == ORDER_RANDOM)
    return "expected order furthest, input, seeded, hilbert, or random and "
           "its seed";
  return NULL;
}

static const char *
add_site (TraceReader *reader, const Site *site)
{
  if (reader->n_sites == MAX_SITES)
    return "more than 10000000 sites";
  if (!site_range_add (&reader->range, site))
    return "too large or too small compared with the numbers before it";
  if (reader->n_sites == reader->sites_room)
    reader->sites = memory_grow (reader->sites, &reader->sites_room,
                                 reader->n_sites + 1, sizeof *reader->sites);
  reader->sites[reader->n_sites] = *site;
  reader->n_sites += 1;
  return NULL;
}

/* @line: what follows "site ". */
static const char *
parse_site (TraceReader *reader, const char *line)
{
  uint32_t index;
  Site site;

  if (!take_index (&line, &index) || index != reader->n_sites)
    return "sites are numbered in order from 0";
  if (!take (&line, " ") || (line = number_parse (line, &site.x)) == NULL
      || !take (&line, " ") || (line = number_parse (line, &site.y)) == NULL
      || *line != '\0')
    return "a site is its number and two decimal numbers";
  return add_site (reader, &site);
}

static bool
parse_kind (const char **line, EventKind *kind)
{
  const size_t length = strcspn (*line, " ");

  for (EventKind i = 0; i < N_EVENT_KINDS; i += 1) {
    const char *name = event_kind_name (i);

    if (strlen (name) == length && strncmp (*line, name, length) == 0) {
      *kind = i;
      *line += length;
      return true;
    }
  }
  return false;
}

static const char *
parse_event (const TraceReader *reader, const char *line, Event *event)
{
  *event = (Event){
    EVENT_COMPLETE, INDEX_NONE, INDEX_NONE, { INDEX_NONE, INDEX_NONE }
  };
  if (!parse_kind (&line, &event->kind))
    return "no such event";
  for (const char *field = trace_format_fields (event->kind); *field != '\0';
       field += 1) {
    const char letter[] = { ' ', trace_format_letter (*field), '\0' };

    if (!take (&line, letter)
        || !take_index (&line, trace_format_field (event, *field)))
      return "a facet is f and its number, a site is s and its number";
  }
  if (*line != '\0')
    return "expected nothing more on the line";
  if (event->kind == EVENT_HORIZON || event->kind == EVENT_RETIRE)
    event->site = reader->apex;
  return NULL;
}

static bool
is_coplanar (const SiteSet *set, const uint32_t plane[3], uint32_t site)
{
  return lift_orient (&set->sites[plane[0]], &set->sites[plane[1]],
                      &set->sites[plane[2]], &set->sites[site])
         == 0;
}

/* No three lifts are collinear: the first three span the plane. */
static bool
is_flat (const SiteSet *set)
{
  uint32_t plane[3], n = 0;

  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    if (set->first[i] != i)
      continue;
    if (n < 3)
      plane[n] = i;
    else if (!is_coplanar (set, plane, i))
      return false;
    n += 1;
  }
  return true;
}

static int
side_of_facet (const TraceReader *reader, uint32_t facet, uint32_t site)
{
  const Site *sites = reader->set->sites;
  const uint32_t *corner = reader->facets[facet];

  return lift_orient (&sites[corner[0]], &sites[corner[1]], &sites[corner[2]],
                      &sites[site]);
}

static void
add_facet (TraceReader *reader, const Event *event)
{
  uint32_t *corner;

  if (reader->n_facets == reader->facets_room)
    reader->facets = memory_grow (reader->facets, &reader->facets_room,
                                  reader->n_facets + 1, sizeof *reader->facets);
  corner = reader->facets[reader->n_facets];
  corner[0] = event->ridge[0];
  corner[1] = event->ridge[1];
  corner[2] = event->site;
  reader->n_facets += 1;
}

/* Each corner of the simplex must lie behind the facet that it is not on. */
static bool
is_simplex (const TraceReader *reader)
{
  for (uint32_t i = 0; i < 4; i += 1)
    for (uint32_t k = 0; k < 12; k += 1) {
      const uint32_t site = reader->facets[k / 3][k % 3];
      const uint32_t *corner = reader->facets[i];

      if (site != corner[0] && site != corner[1] && site != corner[2]
          && side_of_facet (reader, i, site) >= 0)
        return false;
    }
  return true;
}

static const char *
simplex_fault (TraceReader *reader, const Event *event)
{
  add_facet (reader, event);
  if (reader->n_facets == 4 && !is_simplex (reader))
    return "the simplex is flat or inside out";
  return NULL;
}

static const char *
visible_fault (TraceReader *reader, const Event *event)
{
  reader->n_visible += 1;
  if (event->site != reader->apex)
    return "that site is not the one selected";
  if (side_of_facet (reader, event->facet, event->site) <= 0)
    return "the site does not see the facet";
  return NULL;
}

static const char *
horizon_fault (TraceReader *reader, const Event *event)
{
  reader->n_horizon += 1;
  if (side_of_facet (reader, event->facet, reader->apex) > 0)
    return "the selected site sees the facet beyond the ridge";
  return NULL;
}

/* The visible facets are a disc of triangles without a corner inside. */
static const char *
cone_fault (TraceReader *reader, const Event *event)
{
  add_facet (reader, event);
  if (reader->n_horizon != reader->n_visible + 2)
    return "the horizon does not go round all visible facets";
  return NULL;
}

/* Returns: NULL, or why a legal event is not true of the sites. */
static const char *
truth_fault (TraceReader *reader, const Event *event)
{
  switch (event->kind) {
  case EVENT_FLAT:
    return is_flat (reader->set) ? NULL : "the lifts are not flat";
  case EVENT_SIMPLEX:
    return simplex_fault (reader, event);
  case EVENT_CLAIM:
    return side_of_facet (reader, event->facet, event->site) > 0
               ? NULL
               : "the site does not see the facet";
  case EVENT_SELECT:
    reader->apex = event->site;
    reader->n_visible = 0;
    reader->n_horizon = 0;
    return NULL;
  case EVENT_VISIBLE:
    return visible_fault (reader, event);
  case EVENT_HORIZON:
    return horizon_fault (reader, event);
  case EVENT_CONE:
    return cone_fault (reader, event);
  case EVENT_DUPLICATE:
  case EVENT_RETIRE:
  case EVENT_COMPLETE:
    return NULL;
  }
  return NULL;
}

static const char *
add_event (TraceReader *reader, bool *is_complete)
{
  const char *fault;
  Event event;

  if (reader->recorder == NULL) {
    reader->set = site_set_new (reader->sites, reader->n_sites);
    reader->recorder = trace_recorder_new (reader->set, &reader->order);
  }
  fault = parse_event (reader, reader->line, &event);
  if (fault == NULL)
    fault = trace_recorder_add (reader->recorder, &event);
  *is_complete = event.kind == EVENT_COMPLETE;
  return fault != NULL ? fault : truth_fault (reader, &event);
}

static const char *
read_body (TraceReader *reader)
{
  bool is_complete = false;

  while (!is_complete) {
    const char *fault = read_line (reader);
    const char *line = reader->line;

    if (fault == NULL && reader->recorder == NULL && take (&line, "site "))
      fault = parse_site (reader, line);
    else if (fault == NULL)
      fault = add_event (reader, &is_complete);
    if (fault != NULL)
      return fault;
  }
  if (reader->text == reader->end)
    return NULL;
  reader->n_lines += 1;
  return "expected nothing after complete";
}

static const char *
read_all (TraceReader *reader)
{
  const char *fault = read_line (reader);

  if (fault == NULL)
    fault = parse_magic (reader->line);
  if (fault == NULL)
    fault = read_line (reader);
  if (fault == NULL)
    fault = parse_order (reader->line, &reader->order);
  return fault != NULL ? fault : read_body (reader);
}

Trace *
trace_file_parse (const char *text,
                  size_t length,
                  SiteSet **set,
                  TraceFileError *error)
{
  TraceReader reader
      = { .text = text, .end = text + length, .range = SITE_RANGE_INIT };
  const char *fault = read_all (&reader);
  Trace *trace = reader.recorder == NULL
                     ? NULL
                     : trace_recorder_finish (reader.recorder);

  free (reader.sites);
  free (reader.facets);
  *set = NULL;
  if (fault == NULL) {
    *set = reader.set;
    return trace;
  }
  error->line = reader.n_lines;
  snprintf (error->reason, sizeof error->reason, "%s", fault);
  trace_free (trace);
  site_set_free (reader.set);
  return NULL;
}
