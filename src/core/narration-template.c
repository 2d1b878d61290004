#include "narration-template.h"

#include <stdio.h>

static int
write_part (char part, const NarrationParts *parts, char *text, size_t room)
{
  switch (part) {
  case 'p':
    return snprintf (text, room, "s%u", parts->site);
  case 'q':
    return snprintf (text, room, "s%u", parts->other);
  case 'f':
    return snprintf (text, room, "f%u", parts->facet);
  case 'e':
    return snprintf (text, room, "e%u", parts->facet);
  case 'a':
    return snprintf (text, room, "s%u", parts->ridge[0]);
  case 'b':
    return snprintf (text, room, "s%u", parts->ridge[1]);
  default:
    return snprintf (text, room, "%u", parts->number);
  }
}

/* The length without a last character that may be cut in two. */
static size_t
whole_characters (const char *text, size_t n)
{
  while (n > 0 && ((unsigned char)text[n - 1] & 0xc0) == 0x80)
    n--;
  return n > 0 && (unsigned char)text[n - 1] >= 0xc0 ? n - 1 : n;
}

void
narration_fill (const char *template,
                const NarrationParts *parts,
                char text[NARRATION_ROOM])
{
  const char *from = template;
  size_t n = 0;

  while (*from != '\0' && n + 16 < NARRATION_ROOM) {
    if (from[0] == '{' && from[1] != '\0' && from[2] == '}') {
      n += (size_t)write_part (from[1], parts, text + n, NARRATION_ROOM - n);
      from += 3;
    } else {
      text[n++] = *from++;
    }
  }
  if (*from != '\0')
    n = whole_characters (text, n);
  text[n] = '\0';
}
