/* For madvise(). */
#define _DEFAULT_SOURCE

#include "memory.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

static void *
there_or_abort (void *room)
{
  if (room == NULL) {
    fputs ("hull2vd: out of memory\n", stderr);
    abort ();
  }
  return room;
}

void *
memory_new (size_t n, size_t size)
{
  assert (size > 0);
  return there_or_abort (calloc (n > 0 ? n : 1, size));
}

void *
memory_room (size_t n, size_t size)
{
  assert (size > 0);
  if (n > SIZE_MAX / size)
    return there_or_abort (NULL);
  return there_or_abort (malloc (n > 0 ? n * size : 1));
}

void *
memory_grow (void *array, uint32_t *capacity, uint32_t n, size_t size)
{
  const uint32_t twice
      = *capacity <= UINT32_MAX / 2 ? 2 * *capacity : UINT32_MAX;
  const uint32_t room = n > twice ? n : twice;

  assert (size > 0 && n > *capacity);
  if (room > SIZE_MAX / size)
    return there_or_abort (NULL);
  *capacity = room;
  return there_or_abort (realloc (array, room * size));
}

void
memory_use_large_pages (void *array, size_t n_bytes)
{
#ifdef MADV_HUGEPAGE
  const uintptr_t page = (uintptr_t)2 << 20;
  const uintptr_t first = ((uintptr_t)array + page - 1) / page * page;
  const uintptr_t end = ((uintptr_t)array + n_bytes) / page * page;

  /* It is advice: where it is not taken nothing is lost. */
  if (end > first)
    (void)madvise ((void *)first, end - first, MADV_HUGEPAGE);
#else
  (void)array;
  (void)n_bytes;
#endif
}

void
memory_keep (void)
{
#ifdef __GLIBC__
  mallopt (M_MMAP_THRESHOLD, 1 << 30);
  mallopt (M_TRIM_THRESHOLD, 1 << 30);
  mallopt (M_TOP_PAD, 16 << 20);
#endif
}
