/* Which hue the cell of each site has, from edit to edit. */
#include "run.h"

#include <string.h>

/* Returns: a hue that no site of the first @n has. */
static guint32
unused_hue (const guint32 *hues, guint n)
{
  guint32 hue = 0;

  for (guint i = 0; i < n; i++)
    hue = MAX (hue, hues[i] + 1);
  return hue;
}

static gboolean
is_same_site (const Run *a, guint i, const Run *b, guint k)
{
  const Site p = site_set_given (a->set, i), q = site_set_given (b->set, k);

  return p.x == q.x && p.y == q.y;
}

/* Some sites were removed: those that are left come in the same order.
 *
 * Returns: FALSE: these are other sites. */
static gboolean
inherit_rest (Run *run, const Run *before)
{
  guint k = 0;

  for (guint i = 0; i < run->set->n_sites; i++, k++) {
    while (k < before->set->n_sites && !is_same_site (run, i, before, k))
      k++;
    if (k == before->set->n_sites)
      return FALSE;
    run->hues[i] = before->hues[k];
  }
  return TRUE;
}

void
run_inherit_hues (Run *run, const Run *before)
{
  const guint n = run->set->n_sites, n_before = before->set->n_sites;
  guint32 hue;

  /* The lesson's own, or what is shown already. */
  if (run->reference_count > 1)
    return;
  if (n < n_before && inherit_rest (run, before))
    return;
  memcpy (run->hues, before->hues, MIN (n, n_before) * sizeof *run->hues);
  hue = unused_hue (run->hues, MIN (n, n_before));
  for (guint i = n_before; i < n; i++)
    run->hues[i] = hue++;
}
