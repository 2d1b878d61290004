#include "site-source.h"

#include "action.h"
#include "generator.h"
#include "site-file.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

static void
refuse (const char *reason, GError **error)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER, "%s", reason);
}

/* A generator: "random 8 seed 3". A second word is a number, and so on; the
 * rule says which words are numbers (N) and which are as they stand. */
typedef struct Rule {
  const char *pattern;
  Site *(*make) (const guint64 *numbers, guint *n_sites, GError **error);
} Rule;

static guint
as_count (guint64 number)
{
  return (guint)MIN (number, G_MAXUINT32);
}

static Site *
make_random (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_random (*n_sites, numbers[1], error);
}

static Site *
make_clusters (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_clusters (*n_sites, numbers[1], error);
}

static Site *
make_near_circle (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_near_circle (*n_sites, numbers[1], error);
}

static Site *
make_kuzmin (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_kuzmin (*n_sites, numbers[1], error);
}

static Site *
make_spiral (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_spiral (*n_sites, error);
}

static Site *
make_grid (const guint64 *numbers, guint *n_sites, GError **error)
{
  const guint width = as_count (numbers[0]), height = as_count (numbers[1]);

  *n_sites = width * height;
  return generator_grid (width, height, error);
}

static Site *
make_circle (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_circle (*n_sites, error);
}

static Site *
make_line (const guint64 *numbers, guint *n_sites, GError **error)
{
  *n_sites = as_count (numbers[0]);
  return generator_line (*n_sites, error);
}

static const Rule rules[] = {
  { "random N seed S", make_random },
  { "clusters N seed S", make_clusters },
  { "grid W H", make_grid },
  { "circle N", make_circle },
  { "near-circle N seed S", make_near_circle },
  { "line N", make_line },
  { "spiral N", make_spiral },
  { "kuzmin N seed S", make_kuzmin },
};

/* Capital letters of a pattern stand for whole numbers. */
static gboolean
match (char **pattern, char **words, guint64 *numbers)
{
  for (; *pattern != NULL && *words != NULL; pattern++, words++) {
    if (!g_ascii_isupper (**pattern)) {
      if (!g_str_equal (*pattern, *words))
        return FALSE;
      continue;
    }
    if (!words_parse_number (*words, G_MAXUINT64, numbers))
      return FALSE;
    numbers += 1;
  }
  return *pattern == NULL && *words == NULL;
}

static Site *
make_by_rule (const Rule *rule, char **words, guint *n_sites, GError **error)
{
  g_auto (GStrv) pattern = g_strsplit (rule->pattern, " ", -1);
  guint64 numbers[2];
  g_autoptr (GError) reason = NULL;
  Site *sites;

  if (!match (pattern, words, numbers)) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                 _ ("write “%s”, with whole numbers"), rule->pattern);
    return NULL;
  }
  sites = rule->make (numbers, n_sites, &reason);
  if (sites == NULL)
    refuse (reason->message, error);
  return sites;
}

static const Rule *
find_rule (const char *word)
{
  for (guint i = 0; i < G_N_ELEMENTS (rules); i++)
    if (g_str_has_prefix (rules[i].pattern, word)
        && rules[i].pattern[strlen (word)] == ' ')
      return &rules[i];
  return NULL;
}

/* Adds the site written in @length bytes of @text. */
static gboolean
add_site (GArray *sites, const char *text, gsize length, GError **error)
{
  const char *reason;
  Site site;

  if (strspn (text, " \t") >= length) {
    refuse (_ ("a site is missing: write “x y; x y; …”"), error);
    return FALSE;
  }
  reason = site_file_parse_line (text, length, &site);
  if (reason != NULL) {
    refuse (_ (reason), error);
    return FALSE;
  }
  if (sites->len >= GENERATOR_MAX) {
    refuse (_ ("there are more than 20000 sites"), error);
    return FALSE;
  }
  g_array_append_val (sites, site);
  return TRUE;
}

/* Coordinates too far apart in size are refused at the site that is. */
static gboolean
add_to_range (SiteRange *range, const GArray *sites, GError **error)
{
  const Site *site = &g_array_index (sites, Site, sites->len - 1);

  if (site_range_add (range, site))
    return TRUE;
  refuse (_ ("this site’s coordinates differ too much in size from the others’ "
             "to be compared exactly"),
          error);
  return FALSE;
}

static Site *
make_written (const char *text, guint *n_sites, gsize *fault, GError **error)
{
  g_autoptr (GArray) sites = g_array_new (FALSE, FALSE, sizeof (Site));
  SiteRange range = SITE_RANGE_INIT;
  const char *piece = text;

  for (;;) {
    const gsize length = strcspn (piece, ";");

    *fault = (gsize)(piece - text) + MIN (strspn (piece, " \t"), length);
    if (!add_site (sites, piece, length, error)
        || !add_to_range (&range, sites, error))
      return NULL;
    if (piece[length] == '\0')
      break;
    piece += length + 1;
  }
  *n_sites = sites->len;
  return (Site *)g_array_free (g_steal_pointer (&sites), FALSE);
}

static void
refuse_word (const char *word, GError **error)
{
  static const char *const names[]
      = { "random", "clusters", "grid",   "circle", "near-circle",
          "line",   "spiral",   "kuzmin", NULL };
  g_autofree char *hint = words_hint (word, names);

  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("“%s” makes no sites%s; write “x y; x y; …”, random, "
                  "clusters, grid, circle, near-circle, line, spiral or "
                  "kuzmin"),
               word, hint);
}

Site *
site_source_make (const char *text,
                  guint *n_sites,
                  gsize *fault,
                  GError **error)
{
  g_auto (GStrv) words = words_split (text);
  const Rule *rule;

  *fault = 0;
  if (words[0] == NULL || !g_ascii_isalpha (words[0][0]))
    return make_written (text, n_sites, fault, error);
  rule = find_rule (words[0]);
  if (rule != NULL)
    return make_by_rule (rule, words, n_sites, error);
  refuse_word (words[0], error);
  return NULL;
}
