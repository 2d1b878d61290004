#include "action-private.h"
#include "site-source.h"

#include <glib/gi18n.h>
#include <math.h>

static gboolean
refuse (ActionError code, const char *reason, GError **error)
{
  g_set_error (error, ACTION_ERROR, (gint)code, "%s", reason);
  return FALSE;
}

static gboolean
is_finite (Site site, GError **error)
{
  return (isfinite (site.x) && isfinite (site.y))
         || refuse (ACTION_ERROR_PARAMETER,
                    _ ("coordinates are finite numbers"), error);
}

ACTION_RUN (action_add_site)
{
  Site site;

  g_variant_get (parameter, "(dd)", &site.x, &site.y);
  return is_finite (site, error) && session_add_site (session, site, error);
}

ACTION_RUN (action_move_site)
{
  guint number;
  Site site;

  g_variant_get (parameter, "(udd)", &number, &site.x, &site.y);
  return is_finite (site, error)
         && session_move_site (session, number, site, error);
}

ACTION_RUN (action_remove_site)
{
  return session_remove_site (session, g_variant_get_uint32 (parameter), error);
}

static gboolean
get_selected_site (Session *session, guint *site, GError **error)
{
  const Object selection = session_get_look (session)->selection;

  *site = selection.number;
  return selection.kind == OBJECT_SITE
         || refuse (ACTION_ERROR_DISABLED, _ ("no site is selected"), error);
}

ACTION_RUN (action_delete_selection)
{
  guint site;

  return get_selected_site (session, &site, error)
         && session_remove_selected (session, error);
}

ACTION_RUN (action_snap)
{
  session_set_snaps (session, !session_get_snaps (session));
  return TRUE;
}

/* Sets the direction, in steps of the grid. */
static gboolean
parse_direction (const char *name, Site *direction)
{
  static const struct {
    const char *name;
    Site direction;
  } directions[] = { { "left", { -1, 0 } },
                     { "right", { 1, 0 } },
                     { "up", { 0, 1 } },
                     { "down", { 0, -1 } } };

  for (guint i = 0; i < G_N_ELEMENTS (directions); i++)
    if (g_str_equal (name, directions[i].name)) {
      *direction = directions[i].direction;
      return TRUE;
    }
  return FALSE;
}

ACTION_RUN (action_nudge)
{
  const SiteSet *set = session_get_set (session);
  const double grid = ldexp (session_get_grid (session), -set->exponent);
  Site direction, to;
  guint site;

  if (!parse_direction (g_variant_get_string (parameter, NULL), &direction))
    return refuse (ACTION_ERROR_PARAMETER,
                   _ ("the directions are left, right, up and down"), error);
  if (!get_selected_site (session, &site, error))
    return FALSE;
  to = session_snap (session,
                     (Site){ set->sites[site].x + direction.x * grid,
                             set->sites[site].y + direction.y * grid });
  return session_move_selected (session, site, to, error);
}

ACTION_RUN (action_sites)
{
  g_autofree Site *sites = NULL;
  guint n_sites;
  gsize fault;

  sites = site_source_make (g_variant_get_string (parameter, NULL), &n_sites,
                            &fault, error);
  return sites != NULL && session_set_sites (session, sites, n_sites, error);
}

ACTION_RUN (action_new)
{
  return session_open_sites (session, NULL, 0, _ ("clearing the plane"), error);
}

ACTION_RUN (action_undo)
{
  return session_undo (session)
         || refuse (ACTION_ERROR_DISABLED, _ ("there is nothing to undo"),
                    error);
}

ACTION_RUN (action_redo)
{
  return session_redo (session)
         || refuse (ACTION_ERROR_DISABLED, _ ("there is nothing to redo"),
                    error);
}

ACTION_RUN (action_cancel) { return session_give_up (session); }
