/* Point files: refused with a line that the file has, or read; then what is
 * written reads back the same, and the hull is right. */
#include "fuzz-check.h"
#include "fuzz.h"

#include "site-file.h"

#include <string.h>

static void
check_refusal (const SiteFileError *error, const uint8_t *data, size_t size)
{
  uint32_t n_lines = 1;

  for (size_t i = 0; i < size; i += 1)
    n_lines += data[i] == '\n';
  fuzz_assert (error->line >= 1 && error->line <= n_lines);
  fuzz_assert (error->reason[0] != '\0');
  for (const char *c = error->reason; *c != '\0'; c += 1)
    fuzz_assert (*c >= ' ' && *c <= '~');
}

static void
check_round_trip (const SiteSet *set)
{
  SiteFileError error = { 0, "" };
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream (&text, &length);
  SiteSet *again;

  fuzz_assert (site_file_write (set, file) && fclose (file) == 0);
  again = site_file_parse (text, length, &error);
  fuzz_assert (again != NULL && again->n_sites == set->n_sites
               && again->exponent == set->exponent);
  fuzz_assert (
      set->n_sites == 0
      || memcmp (set->sites, again->sites, set->n_sites * sizeof *set->sites)
             == 0);
  site_set_free (again);
  free (text);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  SiteFileError error = { 0, "" };
  SiteSet *set = site_file_parse ((const char *)data, size, &error);

  if (set == NULL) {
    check_refusal (&error, data, size);
    return 0;
  }
  check_round_trip (set);
  if (set->n_sites <= 64)
    fuzz_check_orders (set);
  site_set_free (set);
  return 0;
}
