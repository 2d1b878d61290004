#include "decimal-comma.h"

#include <string.h>

#define NUMBER "[+-]?[0-9]+(?:,[0-9]+)?(?:[eE][+-]?[0-9]+)?"
#define ROW "^[ \t]*" NUMBER "[ \t]*;[ \t]*" NUMBER "[ \t]*$"
/* A comma that cannot be one of thousands. */
#define SURE                                                                   \
  "(?:^|[^0-9])(?:0[0-9]*|[0-9]{4,}),|,(?:[0-9]{1,2}|[0-9]{4,})(?![0-9])"

static gboolean
says_nothing (const char *line)
{
  line += strspn (line, " \t");
  return *line == '\0' || *line == '#';
}

static gboolean
are_rows (char **lines)
{
  g_autoptr (GRegex) row = g_regex_new (ROW, G_REGEX_OPTIMIZE, 0, NULL);

  for (guint i = 0; lines[i] != NULL; i++)
    if (!says_nothing (lines[i]) && !g_regex_match (row, lines[i], 0, NULL))
      return FALSE;
  return TRUE;
}

static gboolean
has_sure_comma (char **lines)
{
  g_autoptr (GRegex) sure = g_regex_new (SURE, G_REGEX_OPTIMIZE, 0, NULL);

  for (guint i = 0; lines[i] != NULL; i++)
    if (!says_nothing (lines[i]) && g_regex_match (sure, lines[i], 0, NULL))
      return TRUE;
  return FALSE;
}

gboolean
decimal_comma_is_sure (const char *rows, gsize length)
{
  g_autofree char *text = NULL;
  g_auto (GStrv) lines = NULL;

  if (memchr (rows, ',', length) == NULL || memchr (rows, ';', length) == NULL
      || !g_utf8_validate (rows, (gssize)length, NULL))
    return FALSE;
  text = g_strndup (rows, length);
  g_strdelimit (text, "\r", ' ');
  lines = g_strsplit (text, "\n", -1);
  return are_rows (lines) && has_sure_comma (lines);
}

char *
decimal_comma_replace (const char *rows, gsize length)
{
  char *text = g_strndup (rows, length);
  gboolean is_remark = FALSE;

  for (char *c = text; *c != '\0'; c++) {
    is_remark = *c == '#' || (is_remark && *c != '\n');
    if (*c == ',' && !is_remark)
      *c = '.';
  }
  return text;
}
