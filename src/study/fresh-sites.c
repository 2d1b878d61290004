#include "fresh-sites.h"

#include "action.h"
#include "question.h"
#include "site-source.h"

#include <glib/gi18n.h>
#include <string.h>

#define MOST_SEEDS 60
/* Of the side of the square that the sources fill. */
#define LEAST_DISTANCE 0.11

static gboolean
refuse (GError **error, const char *reason)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER, "%s", reason);
  return FALSE;
}

/* Returns: " seed S" at the end of @text, or NULL. */
static const char *
find_seed (const char *text, guint64 *seed)
{
  const char *at = g_strrstr (text, " seed ");
  g_autofree char *number
      = at == NULL ? NULL : g_strstrip (g_strdup (at + strlen (" seed ")));
  char *end;

  if (number == NULL || !g_ascii_isdigit (*number))
    return NULL;
  *seed = g_ascii_strtoull (number, &end, 10);
  return *end == '\0' ? at : NULL;
}

gboolean
fresh_sites_parse (const char *text,
                   char **source,
                   guint64 *seed,
                   gsize *fault,
                   GError **error)
{
  guint n_sites;
  g_autofree Site *sites = site_source_make (text, &n_sites, fault, error);
  const char *end;

  if (sites == NULL)
    return FALSE;
  end = find_seed (text, seed);
  if (end == NULL)
    return refuse (error, _ ("these sites are always the same: write a source "
                             "with a seed, such as random 7 seed 1"));
  if (n_sites > QUESTION_MAX_SITES)
    return refuse (error, _ ("more than 200 sites"));
  *source = g_strndup (text, (gsize)(end - text));
  return TRUE;
}

char *
fresh_sites_text (const char *source, guint64 seed)
{
  return g_strdup_printf ("%s seed %" G_GUINT64_FORMAT, source, seed);
}

/* Whether a finger could tell the sites from one another. */
static gboolean
is_legible (const Site *sites, guint n_sites)
{
  for (guint i = 0; i < n_sites; i++)
    for (guint k = 0; k < i; k++) {
      const double x = sites[i].x - sites[k].x, y = sites[i].y - sites[k].y;

      if (x * x + y * y < 4 * LEAST_DISTANCE * LEAST_DISTANCE)
        return FALSE;
    }
  return TRUE;
}

Run *
fresh_sites_next (const char *source, guint n_insertions, guint64 *seed)
{
  Run *found = NULL;
  guint64 seed_found = *seed;

  for (guint i = 1; i <= MOST_SEEDS; i++) {
    g_autofree char *text = fresh_sites_text (source, *seed + i);
    gsize fault;
    guint n_sites;
    g_autofree Site *sites = site_source_make (text, &n_sites, &fault, NULL);
    g_autoptr (Run) run
        = run_new (sites, n_sites, &(Order){ ORDER_FURTHEST, 0 });

    if (run->trace->n_rounds < n_insertions)
      continue;
    g_clear_pointer (&found, run_unref);
    found = g_steal_pointer (&run);
    seed_found = *seed + i;
    if (is_legible (sites, n_sites))
      break;
  }
  *seed = seed_found;
  return found;
}
