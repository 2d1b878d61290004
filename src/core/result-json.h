/* The result as JSON, in the neutral format "lift-result" 1. */
#ifndef RESULT_JSON_H
#define RESULT_JSON_H

#include "result.h"

#include <stdio.h>

/* Writes the triangulation, the diagram and the hull.
 * @is_whole: all sites are inserted; else `active` lists those that are.
 *
 * Shape: one JSON object and a newline; every number reads back as the same
 *        double, whatever the locale.
 * Returns: false when writing failed (errno).
 */
bool result_json_write (const Result *result, bool is_whole, FILE *file);

#endif
