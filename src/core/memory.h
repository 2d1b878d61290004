/* Memory that is there or the program ends: out of memory aborts. */
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdint.h>

/* Returns: room for @n elements of @size bytes, all zero; free with free(). */
void *memory_new (size_t n, size_t size);

/* Returns: the same, not cleared, where all that is read is written before. */
void *memory_room (size_t n, size_t size);

/* Grows @array, whose room for *@capacity elements of @size bytes is too
 * small for @n, to at least @n and at least double.
 *
 * Returns: the array, perhaps elsewhere; new room is not cleared.
 */
void *memory_grow (void *array, uint32_t *capacity, uint32_t n, size_t size);

/* Asks the system to keep an array in large pages where it is large and they
 * are to be had. To be called before it is written: an engine that jumps about
 * in megabytes waits less for the tables of pages. */
void memory_use_large_pages (void *array, size_t n_bytes);

/* Lets freed memory stay with the program. A drag makes a trace anew at every
 * move of the pointer, and to fetch its pages from the system each time costs
 * more than the hull. To be called once, first of all. */
void memory_keep (void);

#endif
