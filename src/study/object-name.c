#include "object-name.h"

#include "words.h"

#include <glib/gi18n.h>

static const char letters[] = {
  [OBJECT_SITE] = 's',
  [OBJECT_FACET] = 'f',
  [OBJECT_VERTEX] = 'v',
  [OBJECT_RIDGE] = 'r',
};

void
object_name_write (Object object, char name[OBJECT_NAME_ROOM])
{
  if (object.kind == OBJECT_NONE)
    g_strlcpy (name, "none", OBJECT_NAME_ROOM);
  else
    g_snprintf (name, OBJECT_NAME_ROOM, "%c%u", letters[object.kind],
                object.number);
}

gboolean
object_name_parse (const char *name, Object *object)
{
  guint64 number;

  if (g_str_equal (name, "none")) {
    *object = (Object){ OBJECT_NONE, 0 };
    return TRUE;
  }
  for (guint i = OBJECT_SITE; i < G_N_ELEMENTS (letters); i++)
    if (name[0] == letters[i]
        && words_parse_number (name + 1, INDEX_NONE - 1, &number)) {
      *object = (Object){ (ObjectKind)i, (guint32)number };
      return TRUE;
    }
  return FALSE;
}

const char *
facing_name (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return _ ("lower");
  case FACING_VERTICAL:
    return _ ("vertical");
  case FACING_UPPER:
    return _ ("upper");
  }
  return "";
}
