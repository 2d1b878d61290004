/* Trace files: refused with a line that the file has, or read; then what is
 * written is the file again, and every round is right. */
#include "fuzz-check.h"
#include "fuzz.h"

#include "trace-file.h"

#include <string.h>

static void
check_refusal (const TraceFileError *error, const uint8_t *data, size_t size)
{
  uint32_t n_lines = 1;

  for (size_t i = 0; i < size; i += 1)
    n_lines += data[i] == '\n';
  fuzz_assert (error->line >= 1 && error->line <= n_lines);
  fuzz_assert (error->reason[0] != '\0');
}

/* Numbers may be written in several ways; events in one only. */
static void
check_round_trip (const Trace *trace)
{
  TraceFileError error = { 0, "" };
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);
  SiteSet *set = NULL;
  Trace *again;

  fuzz_assert (trace_file_write (trace, GRAIN_EVENT, file)
               && fclose (file) == 0);
  again = trace_file_parse (text, length, &set, &error);
  fuzz_assert (again != NULL && again->n_events == trace->n_events);
  for (uint32_t i = 0; i < trace->n_events; i++) {
    const Event event = trace_event (trace, i), other = trace_event (again, i);

    fuzz_assert (memcmp (&event, &other, sizeof event) == 0);
  }
  trace_free (again);
  site_set_free (set);
  free (text);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  TraceFileError error = { 0, "" };
  SiteSet *set = NULL;
  Trace *trace = trace_file_parse ((const char *)data, size, &set, &error);

  if (trace == NULL) {
    check_refusal (&error, data, size);
    return 0;
  }
  check_round_trip (trace);
  if (set->n_sites <= 64)
    fuzz_check_rounds (trace);
  trace_free (trace);
  site_set_free (set);
  return 0;
}
