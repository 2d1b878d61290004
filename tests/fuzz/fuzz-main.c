/* Runs a fuzz target without libFuzzer: on every file named, and every file
 * of every folder named; each whole, cut off at many places, and with many
 * single bits turned. One line of TAP a file. */
#include "fuzz.h"

#include <dirent.h>
#include <string.h>
#include <sys/stat.h>

enum { N_SPOILED = 24, ROOM = 4096 };

static unsigned int n_files;

static uint8_t *
read_all (FILE *file, size_t *size)
{
  size_t room = 1 << 16;
  uint8_t *data = malloc (room);

  *size = 0;
  for (;;) {
    uint8_t *more;

    fuzz_assert (data != NULL);
    *size += fread (data + *size, 1, room - *size, file);
    if (*size < room)
      return data;
    room *= 2;
    more = realloc (data, room);
    fuzz_assert (more != NULL);
    data = more;
  }
}

/* A copy of its own size, so that a sanitizer sees reads beyond the end. */
static void
run_copy (const uint8_t *data, size_t size, size_t turned_bit)
{
  uint8_t *copy = malloc (size > 0 ? size : 1);

  fuzz_assert (copy != NULL);
  memcpy (copy, data, size);
  if (turned_bit < 8 * size)
    copy[turned_bit / 8] ^= (uint8_t)(1u << turned_bit % 8);
  LLVMFuzzerTestOneInput (copy, size);
  free (copy);
}

static void
run_file (const char *path)
{
  FILE *file = fopen (path, "rb");
  const char *slash = strrchr (path, '/');
  uint8_t *data;
  size_t size;

  fuzz_assert (file != NULL);
  data = read_all (file, &size);
  fclose (file);
  run_copy (data, size, SIZE_MAX);
  for (size_t i = 0; i < N_SPOILED; i += 1) {
    run_copy (data, size * i / N_SPOILED, SIZE_MAX);
    /* A prime step reaches bytes and bits of all kinds. */
    run_copy (data, size, size == 0 ? 0 : (i * 7919 + i % 8) % (8 * size));
  }
  free (data);
  n_files += 1;
  printf ("ok %u - %s\n", n_files, slash != NULL ? slash + 1 : path);
  fflush (stdout);
}

static int
is_seed (const struct dirent *entry)
{
  return entry->d_name[0] != '.';
}

/* Files of a folder come in the order of their names. */
static void
run_folder (const char *folder)
{
  struct dirent **entries;
  const int n = scandir (folder, &entries, is_seed, alphasort);

  fuzz_assert (n >= 0);
  for (int i = 0; i < n; i += 1) {
    char path[ROOM];
    struct stat status;

    snprintf (path, sizeof path, "%s/%s", folder, entries[i]->d_name);
    if (stat (path, &status) == 0 && S_ISREG (status.st_mode))
      run_file (path);
    free (entries[i]);
  }
  free (entries);
}

int
main (int argc, char **argv)
{
  for (int i = 1; i < argc; i += 1) {
    struct stat status;

    fuzz_assert (stat (argv[i], &status) == 0);
    if (S_ISDIR (status.st_mode))
      run_folder (argv[i]);
    else
      run_file (argv[i]);
  }
  printf ("1..%u\n", n_files);
  return 0;
}
