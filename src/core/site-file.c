#include "site-file.h"

#include "memory.h"
#include "number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_SITES 10000000u
#define BYTE_ORDER_MARK "\xef\xbb\xbf"

/* The marker of strings to translate. */
#define N_(text) text

static bool
is_blank (char byte)
{
  return byte == ' ' || byte == '\t';
}

static const char *
skip_blanks (const char *text, const char *end)
{
  while (text < end && is_blank (*text))
    text += 1;
  return text;
}

/* A lead byte of UTF-8, and what the second byte may be: the limits leave out
 * overlong forms, surrogates and all beyond U+10FFFF. */
typedef struct LeadByte {
  unsigned char first, last;
  int n_more;
  unsigned char low, high;
} LeadByte;

/* Source: The Unicode Standard, table 3-7. */
static const LeadByte lead_bytes[] = {
  { 0x00, 0x7f, 0, 0x00, 0x00 }, { 0xc2, 0xdf, 1, 0x80, 0xbf },
  { 0xe0, 0xe0, 2, 0xa0, 0xbf }, { 0xe1, 0xec, 2, 0x80, 0xbf },
  { 0xed, 0xed, 2, 0x80, 0x9f }, { 0xee, 0xef, 2, 0x80, 0xbf },
  { 0xf0, 0xf0, 3, 0x90, 0xbf }, { 0xf1, 0xf3, 3, 0x80, 0xbf },
  { 0xf4, 0xf4, 3, 0x80, 0x8f },
};

/* Returns: the bytes of the character that starts @text, 0 when it is none. */
static size_t
character_length (const unsigned char *text, size_t room)
{
  const LeadByte *lead = lead_bytes;
  const LeadByte *const end = lead + sizeof lead_bytes / sizeof *lead_bytes;

  while (lead < end && (text[0] < lead->first || text[0] > lead->last))
    lead += 1;
  if (lead == end || (size_t)lead->n_more >= room)
    return 0;
  if (lead->n_more > 0 && (text[1] < lead->low || text[1] > lead->high))
    return 0;
  for (int i = 2; i <= lead->n_more; i += 1)
    if (text[i] < 0x80 || text[i] > 0xbf)
      return 0;
  return (size_t)lead->n_more + 1;
}

static const char *
control_fault (unsigned char byte)
{
  if (byte == '\0')
    return N_ ("a NUL byte");
  if (byte == '\r')
    return N_ ("a carriage return without a line feed after it");
  return N_ ("a control byte");
}

/* Returns: why the bytes of a line are no text, or NULL. */
static const char *
bytes_fault (const char *line, size_t length)
{
  const unsigned char *bytes = (const unsigned char *)line;
  size_t i = 0;

  while (i < length) {
    const size_t n = character_length (bytes + i, length - i);

    if (n == 0)
      return N_ ("not UTF-8 text");
    if ((bytes[i] < 0x20 && bytes[i] != '\t') || bytes[i] == 0x7f)
      return control_fault (bytes[i]);
    i += n;
  }
  return NULL;
}

static const char *
number_fault (double number)
{
  if (isnan (number))
    return N_ ("expected two decimal numbers such as -1.5 2e3");
  if (isinf (number))
    return N_ ("a number is too large");
  return N_ ("a number is too close to zero");
}

/* Skips blanks with at most one comma or semicolon among them.
 *
 * Returns: the next byte, or NULL when there is no separator. */
static const char *
skip_separator (const char *text, const char *end)
{
  const char *next = skip_blanks (text, end);

  if (*next == ',' || *next == ';')
    next = skip_blanks (next + 1, end);
  return next > text ? next : NULL;
}

/* Whether commas within numbers, and blanks or semicolons between them, tell
 * that the former are of decimals: 1,5 2,5. */
static bool
has_decimal_commas (const char *line)
{
  const char *comma = line;

  line += strspn (line, " \t");
  if (line[strcspn (line, " \t;")] == '\0')
    return false;
  while ((comma = strchr (comma + 1, ',')) != NULL)
    if (strchr ("0123456789", comma[-1]) != NULL && comma[1] != '\0'
        && strchr ("0123456789", comma[1]) != NULL)
      return true;
  return false;
}

/* Returns: NULL, or why what follows the second number is wrong. */
static const char *
rest_fault (const char *line, const char *rest, const char *end)
{
  const char *next = skip_separator (rest, end);
  double number;

  if (skip_blanks (rest, end) == end)
    return NULL;
  if (next != NULL && number_parse (next, &number) != NULL)
    return has_decimal_commas (line)
               ? N_ ("a comma stands between numbers: write decimals with a "
                     "point, as in 1.5 2.5")
               : N_ ("expected exactly two numbers, found more");
  return N_ ("expected nothing after the second number");
}

/* @line ends with a zero byte at @end.
 *
 * Returns: NULL, or the reason why not. */
static const char *
parse_pair (const char *line, const char *end, Site *site)
{
  const char *next = number_parse (skip_blanks (line, end), &site->x);

  if (next == NULL)
    return number_fault (site->x);
  if (skip_blanks (next, end) == end)
    return N_ ("expected two numbers, found only one");
  next = skip_separator (next, end);
  if (next == NULL)
    return N_ ("the first number is not a decimal number");
  if (*next == ',' || *next == ';')
    return N_ ("two separators between the numbers");

  next = number_parse (next, &site->y);
  if (next == NULL)
    return number_fault (site->y);
  return rest_fault (line, next, end);
}

static const char *
parse_checked_line (const char *line, size_t length, Site *site)
{
  char short_copy[128];
  const bool is_short = length < sizeof short_copy;
  char *copy = is_short ? short_copy : memory_new (length + 1, 1);
  const char *fault;

  memcpy (copy, line, length);
  copy[length] = '\0';
  fault = parse_pair (copy, copy + length, site);
  if (!is_short)
    free (copy);
  return fault;
}

const char *
site_file_parse_line (const char *line, size_t length, Site *site)
{
  const char *fault = bytes_fault (line, length);

  return fault != NULL ? fault : parse_checked_line (line, length, site);
}

typedef struct SiteReader {
  Site *sites;
  uint32_t n_sites, room;
  SiteRange range;
} SiteReader;

static bool
is_skipped (const char *line, size_t length)
{
  const char *end = line + length;
  const char *first = skip_blanks (line, end);

  return first == end || *first == '#';
}

static const char *
reader_add (SiteReader *reader, const Site *site)
{
  if (reader->n_sites == MAX_SITES)
    return N_ ("more than 10000000 sites");
  if (!site_range_add (&reader->range, site))
    return N_ ("too large or too small compared with the numbers before it");
  if (reader->n_sites == reader->room)
    reader->sites = memory_grow (reader->sites, &reader->room,
                                 reader->n_sites + 1, sizeof *reader->sites);
  reader->sites[reader->n_sites] = *site;
  reader->n_sites += 1;
  return NULL;
}

/* Returns: NULL, or why the line is refused. */
static const char *
reader_line (SiteReader *reader, const char *line, size_t length)
{
  const char *fault = bytes_fault (line, length);
  Site site;

  if (fault != NULL || is_skipped (line, length))
    return fault;
  fault = parse_checked_line (line, length, &site);
  return fault != NULL ? fault : reader_add (reader, &site);
}

static size_t
line_length (const char *line, const char *line_feed)
{
  const size_t length = (size_t)(line_feed - line);

  return length > 0 && line[length - 1] == '\r' ? length - 1 : length;
}

/* Returns: NULL, or why line *@n is refused. */
static const char *
reader_text (SiteReader *reader, const char *text, size_t length, uint32_t *n)
{
  const char *const end = text + length;
  const char *fault = NULL;

  for (*n = 0; text < end && fault == NULL; *n += 1) {
    const char *feed = memchr (text, '\n', (size_t)(end - text));

    if (feed == NULL)
      fault = reader_line (reader, text, (size_t)(end - text));
    else
      fault = reader_line (reader, text, line_length (text, feed));
    text = feed == NULL ? end : feed + 1;
  }
  return fault;
}

SiteSet *
site_file_parse (const char *text, size_t length, SiteFileError *error)
{
  const size_t mark = strlen (BYTE_ORDER_MARK);
  const bool is_marked
      = length >= mark && memcmp (text, BYTE_ORDER_MARK, mark) == 0;
  const size_t skipped = is_marked ? mark : 0;
  SiteReader reader = { .range = SITE_RANGE_INIT };
  SiteSet *set = NULL;
  const char *fault
      = reader_text (&reader, text + skipped, length - skipped, &error->line);

  if (fault == NULL)
    set = site_set_new (reader.sites, reader.n_sites);
  else
    snprintf (error->reason, sizeof error->reason, "%s", fault);
  free (reader.sites);
  return set;
}

void
site_file_write_line (const Site *site, char line[SITE_LINE_ROOM])
{
  char x[NUMBER_ROOM], y[NUMBER_ROOM];

  number_write (site->x, x);
  number_write (site->y, y);
  snprintf (line, SITE_LINE_ROOM, "%s %s\n", x, y);
}

bool
site_file_write (const SiteSet *set, FILE *file)
{
  for (uint32_t i = 0; i < set->n_sites; i += 1) {
    const Site site = site_set_given (set, i);
    char line[SITE_LINE_ROOM];

    site_file_write_line (&site, line);
    if (fputs (line, file) < 0)
      return false;
  }
  return true;
}
