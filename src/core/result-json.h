/* The result as JSON, in the neutral format "lift-result" 1. */
#ifndef RESULT_JSON_H
#define RESULT_JSON_H

#include "result.h"

#include <stdio.h>

typedef struct ResultForm {
  bool is_whole;  /* all sites are inserted; else `active` lists them */
  bool is_merged; /* facets of one plane are one polygon (merged.h) */
} ResultForm;

/* Writes the triangulation, the diagram and the hull.
 *
 * Shape: one JSON object and a newline; every number reads back as the same
 *        double, whatever the locale.
 * Returns: false when writing failed (errno).
 */
bool result_json_write (const Result *result, ResultForm form, FILE *file);

#endif
