/* Judges the legend. */
#include "legend-judge.h"

#include "sight.h"

#include <string.h>

#define SWATCH_WIDTH 30
#define SWATCH_HEIGHT 18

typedef struct Moment {
  Session *session;
  const char *name;
  guint place;
  LegendMarks marks;
  GPtrArray *rows; /* in the theme in hand */
} Moment;

static GHashTable *faults; /* told once each */
static gboolean is_met[N_LEGEND_MARKS];

static void
tell (const Moment *moment, const Theme *theme, char *what)
{
  if (g_hash_table_add (faults, g_strdup (what)))
    g_test_message ("%s %u, %s: %s", moment->name, moment->place, theme->name,
                    what);
  g_free (what);
}

/* Looks */

static gboolean
is_same_look (const Style *a, const Style *b)
{
  return colour_equal (a->fill, b->fill) && a->hatch == b->hatch
         && colour_equal (a->line, b->line) && a->width == b->width
         && a->dash == b->dash && a->gap == b->gap && a->mark == b->mark
         && a->radius == b->radius && a->hatch_width == b->hatch_width;
}

static Style
look_of (const Theme *theme, const SceneItem *item, Lit lit)
{
  SceneItem plain = *item;

  /* A small patch of a pale hue would be white; hues are the sites'. */
  if (theme_has_hue (item->role) && item->emphasis == EMPHASIS_PALE)
    plain.emphasis = EMPHASIS_NORMAL;
  if (plain.emphasis != EMPHASIS_LOUD)
    plain.hue = 0;
  plain.fade = 0;
  plain.lit = lit;
  return theme_style (theme, &plain);
}

static gboolean
is_seen (const Theme *theme, const SceneItem *item)
{
  const Style style = look_of (theme, item, LIT_NONE);
  const Colour fill = sight_over (style.fill, theme->background);

  if (item->shape == SHAPE_MARK)
    return style.mark != MARK_NONE;
  if (style.line.alpha > 0 && (style.width > 0 || style.hatch != HATCH_NONE))
    return TRUE;
  return item->shape == SHAPE_POLYGON && style.fill.alpha > 0
         && sight_contrast (fill, theme->background) > 1.001;
}

/* Of what a row explains too. */
static gboolean
is_kin (Role role, Role row)
{
  return (role == ROLE_RIM && row == ROLE_SHEET)
         || (role == ROLE_FOOT_APEX && row == ROLE_SITE_APEX);
}

static gboolean
is_explained (const Moment *moment, const Theme *theme, const SceneItem *item)
{
  const Style look = look_of (theme, item, LIT_NONE);

  for (guint i = 0; i < moment->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (moment->rows, i);
    const Style sample = look_of (theme, &row->sample, LIT_NONE);

    if (is_kin (item->role, row->sample.role) || is_same_look (&look, &sample))
      return TRUE;
  }
  return FALSE;
}

/* What of an object looks like nothing else that is lit with it: its lift, its
 * cell, or its Voronoi vertex. */
static gboolean
has_own_light (Role role)
{
  return role == ROLE_CELL || (role >= ROLE_LIFT && role <= ROLE_LIFT_OUTSIDE)
         || (role >= ROLE_VORONOI_VERTEX && role <= ROLE_FURTHEST_VERTEX);
}

static gboolean
is_same_family (Role a, Role b)
{
  return has_own_light (b) && (a == ROLE_CELL) == (b == ROLE_CELL)
         && (a >= ROLE_VORONOI_VERTEX) == (b >= ROLE_VORONOI_VERTEX);
}

/* What is selected is an outline or a ring, and has a row for each; what is
 * pointed at has one row; what looks like neither has its own. */
static gboolean
is_light_explained (const Moment *moment,
                    const Theme *theme,
                    const SceneItem *item)
{
  for (guint i = 0; i < moment->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (moment->rows, i);
    const Style sample = theme_style (theme, &row->sample);

    if (has_own_light (item->role)
        && !is_same_family (item->role, row->sample.role))
      continue;
    if (row->sample.lit == item->lit
        && (item->lit == LIT_HOVER || item->shape != SHAPE_MARK
            || sample.mark != MARK_NONE))
      return TRUE;
  }
  return FALSE;
}

/* Outlines and circles of what is lit are nothing else. */
static gboolean
is_only_light (const SceneItem *item)
{
  return item->role == ROLE_LIT || item->role == ROLE_CIRCLE_SELECTED;
}

/* What is quiet may be paler than its sample, but for the horizon: black and
 * grey would be two things. */
static gboolean
is_other_ink (const Theme *theme, const SceneItem *item)
{
  const SceneItem sample = { .role = item->role,
                             .shape = item->shape,
                             .emphasis = EMPHASIS_NORMAL };

  return (item->role == ROLE_HORIZON || item->role == ROLE_HORIZON_UPPER)
         && item->lit == LIT_NONE
         && !colour_equal (theme_style (theme, item).line,
                           theme_style (theme, &sample).line);
}

/* Of what is pale here and strong there, the sample is strong. */
static gboolean
is_stronger_elsewhere (const GArray *looks, const SceneItem *item)
{
  for (guint i = 0; i < looks->len; i++) {
    const SceneItem *other = &g_array_index (looks, SceneItem, i);

    if (other->role == item->role && other->lit == item->lit
        && other->emphasis != EMPHASIS_PALE)
      return item->emphasis == EMPHASIS_PALE;
  }
  return FALSE;
}

static void
check_item (const Moment *moment, const Theme *theme, const SceneItem *item)
{
  if (item->role == ROLE_GROUND)
    return;
  if (!is_only_light (item) && is_seen (theme, item)
      && !is_explained (moment, theme, item))
    tell (moment, theme,
          g_strdup_printf ("no row for %s", role_name (item->role)));
  if (is_other_ink (theme, item))
    tell (moment, theme, g_strdup ("the horizon has another ink"));
  /* Names are not lit. */
  if (item->lit != LIT_NONE && item->role < ROLE_POWER
      && !is_light_explained (moment, theme, item))
    tell (moment, theme,
          g_strdup_printf ("no row for %s that is %s", role_name (item->role),
                           item->lit == LIT_HOVER ? "pointed at" : "selected"));
}

/* Samples */

/* A few pixels of quite another colour are another shape, such as the gaps of a
 * thin line; an area of a colour that can just be told is another area. */
#define CHANNEL_APART 40
#define PIXELS_APART 9
#define CHANNEL_TOLD 14
#define PIXELS_TOLD 140

static char *
key_of (const Theme *theme, const SceneItem *sample)
{
  return g_strdup_printf ("%s %d %d %d %d %u %u", theme->name,
                          (int)sample->role, (int)sample->shape,
                          (int)sample->emphasis, (int)sample->lit, sample->hue,
                          sample->n);
}

static cairo_surface_t *
get_sample (const Theme *theme, const SceneItem *sample)
{
  static GHashTable *surfaces;
  g_autofree char *key = key_of (theme, sample);
  cairo_surface_t *surface;

  if (surfaces == NULL)
    surfaces = g_hash_table_new_full (g_str_hash, g_str_equal, g_free,
                                      (GDestroyNotify)cairo_surface_destroy);
  surface = g_hash_table_lookup (surfaces, key);
  if (surface == NULL) {
    surface = sight_paint_sample (theme, sample, SWATCH_WIDTH, SWATCH_HEIGHT);
    g_hash_table_insert (surfaces, g_steal_pointer (&key), surface);
  }
  return surface;
}

/* Returns: how many pixels differ by more than @least. */
static guint
count_apart (cairo_surface_t *a, cairo_surface_t *b, int least)
{
  const int stride = cairo_image_surface_get_stride (a);
  const guchar *p = cairo_image_surface_get_data (a);
  const guchar *q = cairo_image_surface_get_data (b);
  guint n = 0;

  for (int y = 0; y < SWATCH_HEIGHT; y++)
    for (int x = 0; x < SWATCH_WIDTH; x++) {
      const guchar *at = p + y * stride + 4 * x, *to = q + y * stride + 4 * x;

      n += ABS (at[0] - to[0]) > least || ABS (at[1] - to[1]) > least
           || ABS (at[2] - to[2]) > least;
    }
  return n;
}

static void
check_pair (const Moment *moment,
            const Theme *theme,
            const LegendRow *a,
            const LegendRow *b)
{
  static GHashTable *known;
  g_autofree char *one = key_of (theme, &a->sample);
  g_autofree char *other = key_of (theme, &b->sample);
  guint apart, told;

  if (known == NULL)
    known = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  if (strcmp (a->text, b->text) == 0)
    tell (moment, theme, g_strdup_printf ("two rows “%s”", a->text));
  if (!g_hash_table_add (known, g_strconcat (one, "|", other, NULL)))
    return;
  apart = count_apart (get_sample (theme, &a->sample),
                       get_sample (theme, &b->sample), CHANNEL_APART);
  told = count_apart (get_sample (theme, &a->sample),
                      get_sample (theme, &b->sample), CHANNEL_TOLD);
  if (apart < PIXELS_APART && told < PIXELS_TOLD)
    tell (moment, theme,
          g_strdup_printf ("“%s” and “%s” look alike in %s: %u, %u pixels",
                           a->text, b->text, theme->name, apart, told));
}

static void
check_rows (const Moment *moment, const Theme *theme)
{
  for (guint i = 0; i < moment->rows->len; i++)
    is_met[((LegendRow *)g_ptr_array_index (moment->rows, i))->mark] = TRUE;
  for (guint i = 0; i < moment->rows->len; i++)
    for (guint k = i + 1; k < moment->rows->len; k++)
      check_pair (moment, theme, g_ptr_array_index (moment->rows, i),
                  g_ptr_array_index (moment->rows, k));
}

/* Moments */

/* Whether both look the same in every theme. */
static gboolean
is_alike (const SceneItem *a, const SceneItem *b)
{
  return a->role == b->role && a->shape == b->shape && a->lit == b->lit
         && a->emphasis == b->emphasis
         && (a->emphasis != EMPHASIS_LOUD || a->hue == b->hue);
}

/* Adds one of each of the items of a scene that can be seen. */
static void
gather (GArray *looks, const Scene *scene)
{
  for (guint i = 0; i < scene->n_items; i++) {
    const SceneItem *item = &scene->items[i];
    guint k = looks->len;

    while (k > 0 && !is_alike (item, &g_array_index (looks, SceneItem, k - 1)))
      k--;
    if (k == 0 && item->fade < 1)
      g_array_append_val (looks, *item);
  }
}

static void
check_themes (Moment *moment, const GArray *looks)
{
  for (int kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);

    moment->rows = legend_rows (moment->session, &moment->marks, theme);
    for (guint i = 0; i < looks->len; i++) {
      const SceneItem *item = &g_array_index (looks, SceneItem, i);

      if (!is_stronger_elsewhere (looks, item))
        check_item (moment, theme, item);
    }
    check_rows (moment, theme);
    g_ptr_array_unref (moment->rows);
  }
}

void
legend_judge (Session *session, const char *name, guint place)
{
  SceneLook look = *session_get_look (session);
  Moment moment = { .session = session, .name = name, .place = place };
  g_autoptr (GArray) looks = g_array_new (FALSE, FALSE, sizeof (SceneItem));

  look.low = (Point3){ -1.4, -1.4, 0 };
  look.high = (Point3){ 1.4, 1.4, 0 };
  for (guint pane = 0; pane < N_PANES; pane++) {
    Scene scene = { 0 };

    if (session_get_pane (session, pane) == PANE_NONE)
      continue;
    session_fill_scene (session, pane, &scene, &look);
    legend_marks_add_stock (&moment.marks, &scene);
    legend_marks_add_pointed (&moment.marks, &scene);
    gather (looks, &scene);
    scene_clear (&scene);
  }
  check_themes (&moment, looks);
}

void
legend_judge_open (void)
{
  faults = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
}

void
legend_judge_close (void)
{
  const guint n = g_hash_table_size (faults);

  g_clear_pointer (&faults, g_hash_table_unref);
  if (n > 0)
    g_test_fail ();
}

gboolean
legend_judge_has_met (int mark)
{
  return is_met[mark];
}
