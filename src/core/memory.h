/* Memory that is there or the program ends: out of memory aborts. */
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdint.h>

/* Returns: room for @n elements of @size bytes, all zero; free with free(). */
void *memory_new (size_t n, size_t size);

/* Grows @array, whose room for *@capacity elements of @size bytes is too
 * small for @n, to at least @n and at least double.
 *
 * Returns: the array, perhaps elsewhere; new room is not cleared.
 */
void *memory_grow (void *array, uint32_t *capacity, uint32_t n, size_t size);

/* Lets freed memory stay with the program. A drag makes a trace anew at every
 * move of the pointer, and to fetch its pages from the system each time costs
 * more than the hull. To be called once, first of all. */
void memory_keep (void);

#endif
