#include "action-groups.h"

#include <glib/gi18n.h>

/* The first group whose prefix an action's name has takes it, but for those
 * that are named whole. None is higher than a small screen. */
static const struct {
  const char *title;
  const char *prefixes; /* separated by blanks */
} groups[N_ACTION_GROUPS] = {
  { N_ ("Steps"), "next back first last play goto" },
  { N_ ("Lesson"), "next-stop previous-stop next-task previous-task "
                   "next-lesson" },
  { N_ ("Sites"), "select delete undo redo nudge copy paste add move-site snap "
                  "generate" },
  { N_ ("Pictures"), "layer camera fit zoom" },
  { N_ ("Panels"), "panel fullscreen blank" },
  { N_ ("Files and window"), "" },
};

static gboolean
has_whole (guint group, const char *name)
{
  g_auto (GStrv) words = g_strsplit (groups[group].prefixes, " ", -1);

  return g_strv_contains ((const char *const *)words, name);
}

static gboolean
has_prefix (guint group, const char *name)
{
  g_auto (GStrv) prefixes = g_strsplit (groups[group].prefixes, " ", -1);

  for (guint k = 0; prefixes[k] != NULL; k++)
    if (g_str_has_prefix (name, prefixes[k]))
      return TRUE;
  return prefixes[0] == NULL;
}

const char *
action_group_title (guint group)
{
  return _ (groups[group].title);
}

guint
action_group_of (const Action *action)
{
  guint group = 0;

  for (guint i = 0; i < N_ACTION_GROUPS; i++)
    if (has_whole (i, action->name))
      return i;
  while (!has_prefix (group, action->name))
    group++;
  return group;
}
