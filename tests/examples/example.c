#include "example.h"

#include "site-file.h"

#include <stdlib.h>

enum { ROOM = 1 << 20 };

SiteSet *
example_read (int argc, char **argv)
{
  static char text[ROOM];
  FILE *file = argc == 2 ? fopen (argv[1], "rb") : NULL;
  SiteFileError error;
  SiteSet *set;
  size_t length;

  if (file == NULL) {
    fprintf (stderr, "usage: %s POINTS\n", argv[0]);
    exit (64);
  }
  length = fread (text, 1, sizeof text, file);
  fclose (file);
  set = site_file_parse (text, length, &error);
  if (set == NULL) {
    fprintf (stderr, "%s:%u: %s\n", argv[1], error.line, error.reason);
    exit (1);
  }
  return set;
}
