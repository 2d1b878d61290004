/* Which sites are selected. SceneLook.selection is one of them, the one that
 * was selected last, or something that is no site. */
#include "session-private.h"

#include <glib/gi18n.h>
#include <string.h>

static int
compare_numbers (const void *left, const void *right)
{
  const guint32 a = *(const guint32 *)left, b = *(const guint32 *)right;

  return a < b ? -1 : a > b;
}

/* Takes @sites, in any order, each once. */
static void
put (Session *session, Object selection, GArray *sites)
{
  g_array_sort (sites, compare_numbers);
  g_clear_pointer (&session->selected, g_array_unref);
  session->selected = sites;
  session->look.selection = selection;
  session->look.selected = (const guint32 *)sites->data;
  session->look.n_selected = sites->len;
  session_tell (session, CHANGED_LOOK);
}

static GArray *
make_list (const guint32 *sites, guint n)
{
  GArray *list = g_array_sized_new (FALSE, FALSE, sizeof *sites, n);

  g_array_append_vals (list, sites, n);
  return list;
}

void
session_set_selection (Session *session, Object object)
{
  const guint n_sites = object.kind == OBJECT_SITE ? 1 : 0;

  if (object_equal (object, session->look.selection)
      && session->look.n_selected == n_sites)
    return;
  put (session, object, make_list (&object.number, n_sites));
}

const guint32 *
session_get_selected_sites (Session *session, guint *n_sites)
{
  *n_sites = session->look.n_selected;
  return session->look.selected;
}

gboolean
session_is_selected (Session *session, guint site)
{
  const SceneLook *look = &session->look;

  return scene_is_selected (look, site);
}

void
session_select_sites (Session *session, const guint32 *sites, guint n)
{
  const Object last
      = n > 0 ? (Object){ OBJECT_SITE, sites[n - 1] } : (Object){ 0 };
  GArray *list = make_list (sites, n);
  guint n_kept = 0;

  g_array_sort (list, compare_numbers);
  for (guint i = 0; i < n; i++) {
    const guint32 site = g_array_index (list, guint32, i);

    if (n_kept == 0 || site != g_array_index (list, guint32, n_kept - 1))
      g_array_index (list, guint32, n_kept++) = site;
  }
  g_array_set_size (list, n_kept);
  put (session, last, list);
}

void
session_toggle_site (Session *session, guint site)
{
  const gboolean leaves = session_is_selected (session, site);
  GArray *list = g_array_new (FALSE, FALSE, sizeof (guint32));
  Object last = { OBJECT_NONE, 0 };

  for (guint i = 0; i < session->look.n_selected; i++) {
    const guint32 other = session->look.selected[i];

    if (other == site)
      continue;
    g_array_append_val (list, other);
    last = (Object){ OBJECT_SITE, other };
  }
  if (!leaves) {
    g_array_append_val (list, site);
    last = (Object){ OBJECT_SITE, site };
  }
  put (session, last, list);
}

void
session_trim_selection (Session *session, guint n_sites)
{
  const Object old = session->look.selection;
  GArray *list;
  guint n = session->look.n_selected;

  while (n > 0 && session->look.selected[n - 1] >= n_sites)
    n -= 1;
  if (n == session->look.n_selected
      && (old.kind == OBJECT_NONE
          || (old.kind == OBJECT_SITE && old.number < n_sites)))
    return;
  list = make_list (session->look.selected, n);
  if (old.kind == OBJECT_SITE && old.number < n_sites)
    put (session, old, list);
  else
    put (session,
         n > 0 ? (Object){ OBJECT_SITE, session->look.selected[n - 1] }
               : (Object){ OBJECT_NONE, 0 },
         list);
}

void
session_forget_site (Session *session, guint site)
{
  const Object old = session->look.selection;
  GArray *list = g_array_new (FALSE, FALSE, sizeof (guint32));
  Object last = { OBJECT_NONE, 0 };

  for (guint i = 0; i < session->look.n_selected; i++) {
    const guint32 other = session->look.selected[i];
    const guint32 renamed = other > site ? other - 1 : other;

    if (other == site)
      continue;
    g_array_append_val (list, renamed);
    if (last.kind == OBJECT_NONE || other == old.number)
      last = (Object){ OBJECT_SITE, renamed };
  }
  put (session, old.kind == OBJECT_SITE ? last : old, list);
}

/* Edits of all that are selected */

static char *
move_text (const guint32 *selected, guint n)
{
  return n == 1 ? g_strdup_printf (_ ("moving s%u"), selected[0])
                : g_strdup_printf (
                    ngettext ("moving %u site", "moving %u sites", n), n);
}

gboolean
session_move_selected (Session *session, guint lead, Site to, GError **error)
{
  guint n;
  const guint32 *selected = session_get_selected_sites (session, &n);
  g_autofree Site *sites = NULL;
  g_autofree char *edit = NULL;
  Site by;

  g_assert (session_is_selected (session, lead));
  if (n <= 1)
    return session_move_site (session, lead, to, error);
  sites = session_copy_sites (session);
  by = (Site){ to.x - sites[lead].x, to.y - sites[lead].y };
  if (by.x == 0 && by.y == 0)
    return TRUE;
  for (guint i = 0; i < n; i++) {
    sites[selected[i]].x += by.x;
    sites[selected[i]].y += by.y;
  }
  /* A sum may be rounded. */
  sites[lead] = to;
  edit = move_text (selected, n);
  return session_edit_sites (session, sites, session_get_set (session)->n_sites,
                             edit, error);
}

gboolean
session_remove_selected (Session *session, GError **error)
{
  guint n_kept = 0, n;
  const guint32 *selected = session_get_selected_sites (session, &n);
  const guint n_sites = session_get_set (session)->n_sites;
  g_autofree Site *sites = NULL;
  g_autofree char *edit = NULL;

  if (n == 0)
    return TRUE;
  if (!session_can_edit (session, error))
    return FALSE;
  if (n == 1)
    return session_remove_site (session, selected[0], error);
  sites = session_copy_sites (session);
  for (guint i = 0; i < n_sites; i++)
    if (!session_is_selected (session, i))
      sites[n_kept++] = sites[i];
  edit = g_strdup_printf (ngettext ("deleting %u site", "deleting %u sites", n),
                          n);
  session_hold (session);
  session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  /* Fewer of the same sites are in range as well. */
  session_edit_sites (session, sites, n_kept, edit, error);
  session_release (session);
  return TRUE;
}
