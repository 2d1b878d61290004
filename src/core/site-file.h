/* Point files: two finite decimal numbers a line, separated by blanks, tabs,
 * one comma or one semicolon; blank lines and lines that begin with # are
 * skipped; LF or CRLF; a byte order mark may come first. All else is refused
 * with its line. */
#ifndef SITE_FILE_H
#define SITE_FILE_H

#include "site.h"

#include <stddef.h>
#include <stdio.h>

typedef struct SiteFileError {
  uint32_t line;    /* from 1; 0 when the fault has no line */
  char reason[160]; /* English, without a full stop, no control bytes */
} SiteFileError;

/* Reads @length bytes of text.
 *
 * Returns: the set, or NULL with *@error filled. */
SiteSet *
site_file_parse (const char *text, size_t length, SiteFileError *error);

/* Reads two numbers from a line, as in a file; @length excludes line ends.
 *
 * Returns: NULL, or the reason why not. */
const char *site_file_parse_line (const char *line, size_t length, Site *site);

/* Writes the given coordinates, shortest digits that read back the same.
 *
 * Returns: false when writing failed (errno). */
bool site_file_write (const SiteSet *set, FILE *file);

/* Its line in such a file, with its end. */
#define SITE_LINE_ROOM 80
void site_file_write_line (const Site *site, char line[SITE_LINE_ROOM]);

#endif
