/* Numbers as text, the same in every locale: "C", through newlocale. */
#ifndef NUMBER_H
#define NUMBER_H

#include <stdbool.h>
#include <stddef.h>

#define NUMBER_ROOM 32

/* Reads one decimal number (no hexadecimal, infinity or nan) from the start
 * of @text, which ends with a zero byte.
 *
 * Returns: the first byte after it, or NULL when there is none or it is not
 *          finite. */
const char *number_parse (const char *text, double *number);

/* Writes the fewest digits that read back as the same double. */
void number_write (double number, char text[NUMBER_ROOM]);

#endif
