/* What the examples share: reading their points. */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include "hull.h"

#include <stdio.h>

/* Returns: the points of the file argv[1]; or ends the program. */
SiteSet *example_read (int argc, char **argv);

#endif
