/* Numbers as text, the same in every locale: "C", through newlocale. */
#ifndef NUMBER_H
#define NUMBER_H

#include <stdbool.h>
#include <stddef.h>

#define NUMBER_ROOM 32

/* Reads one decimal number (no hexadecimal, infinity or nan) from the start
 * of @text, which ends with a zero byte.
 *
 * Returns: the first byte after it, or NULL, and then *@number tells why:
 *          infinite when it is beyond the double range, 0 when it is not zero
 *          but nearer to zero than to any other double, NAN when there is
 *          none. */
const char *number_parse (const char *text, double *number);

/* Writes few digits, at most 17, that read back as the same double. */
void number_write (double number, char text[NUMBER_ROOM]);

/* Writes 17 significant digits, which always read back as the same double. */
void number_write_whole (double number, char text[NUMBER_ROOM]);

#endif
