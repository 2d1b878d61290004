/* What pictures show, the legend explains: every item of every scene, in each
 * theme, looks like the sample of a row; and no two rows look alike. */
#include "action.h"
#include "command.h"
#include "document.h"
#include "legend.h"
#include "locate.h"
#include "painter.h"

#include <math.h>
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
         && a->radius == b->radius;
}

static Style
look_of (const Theme *theme, const SceneItem *item, Lit lit)
{
  SceneItem plain = *item;

  /* Paleness is of the step; hues are the sites'. */
  if (item->role != ROLE_CELL || item->emphasis == EMPHASIS_PALE)
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
  const Colour fill
      = colour_mix (theme->background, style.fill, style.fill.alpha);

  if (item->shape == SHAPE_MARK)
    return style.mark != MARK_NONE;
  if (style.line.alpha > 0 && (style.width > 0 || style.hatch != HATCH_NONE))
    return TRUE;
  return item->shape == SHAPE_POLYGON && style.fill.alpha > 0
         && colour_contrast (fill, theme->background) > 1.001;
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

/* What is selected is an outline or a ring, and has a row for each; what is
 * pointed at has one row. */
static gboolean
is_light_explained (const Moment *moment,
                    const Theme *theme,
                    const SceneItem *item)
{
  for (guint i = 0; i < moment->rows->len; i++) {
    const LegendRow *row = g_ptr_array_index (moment->rows, i);
    const Style sample = theme_style (theme, &row->sample);

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

static void
check_item (const Moment *moment, const Theme *theme, const SceneItem *item)
{
  if (item->fade >= 1 || item->role == ROLE_GROUND)
    return;
  if (!is_only_light (item) && is_seen (theme, item)
      && !is_explained (moment, theme, item))
    tell (moment, theme,
          g_strdup_printf ("no row for %s", role_name (item->role)));
  /* Names are not lit. */
  if (item->lit != LIT_NONE && item->role < ROLE_POWER
      && !is_light_explained (moment, theme, item))
    tell (moment, theme,
          g_strdup_printf ("no row for %s that is %s", role_name (item->role),
                           item->lit == LIT_HOVER ? "pointed at" : "selected"));
}

/* Samples */

/* A few pixels of quite another colour are another shape; an area of a colour
 * that can just be told is another area. */
#define CHANNEL_APART 40
#define PIXELS_APART 14
#define CHANNEL_TOLD 14
#define PIXELS_TOLD 140

static char *
key_of (const Theme *theme, const SceneItem *sample)
{
  return g_strdup_printf ("%s %d %d %d %d %u", theme->name, (int)sample->role,
                          (int)sample->shape, (int)sample->emphasis,
                          (int)sample->lit, sample->hue);
}

static cairo_surface_t *
paint_sample (const Theme *theme, const SceneItem *sample)
{
  cairo_surface_t *surface = cairo_image_surface_create (
      CAIRO_FORMAT_RGB24, SWATCH_WIDTH, SWATCH_HEIGHT);
  cairo_t *cr = cairo_create (surface);
  const Colour ground = theme->background;

  cairo_set_source_rgb (cr, ground.red, ground.green, ground.blue);
  cairo_paint (cr);
  painter_swatch (cr, sample, theme, SWATCH_WIDTH, SWATCH_HEIGHT);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
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
    surface = paint_sample (theme, sample);
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

/* Each mark that has words is among what the tests look at. */
static void
test_all_are_met (void)
{
  for (int mark = 0; mark < N_LEGEND_MARKS; mark++)
    if (legend_mark_has_words (mark) && !is_met[mark])
      g_error ("mark %d (%s) is never shown", mark,
               mark < N_ROLES ? role_name ((Role)mark) : "no role");
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

static void
check_themes (Moment *moment, const Scene *scenes)
{
  for (int kind = 0; kind < N_THEMES; kind++) {
    const Theme *theme = theme_get ((ThemeKind)kind);

    moment->rows = legend_rows (moment->session, &moment->marks, theme);
    for (guint pane = 0; pane < N_PANES; pane++)
      for (guint i = 0; i < scenes[pane].n_items; i++)
        check_item (moment, theme, &scenes[pane].items[i]);
    check_rows (moment, theme);
    g_ptr_array_unref (moment->rows);
  }
}

static void
check (Session *session, const char *name, guint place)
{
  SceneLook look = *session_get_look (session);
  Moment moment = { .session = session, .name = name, .place = place };
  Scene scenes[N_PANES] = { { 0 }, { 0 } };

  look.low = (Point3){ -1.4, -1.4, 0 };
  look.high = (Point3){ 1.4, 1.4, 0 };
  for (guint pane = 0; pane < N_PANES; pane++) {
    if (session_get_pane (session, pane) == PANE_NONE)
      continue;
    session_fill_scene (session, pane, &scenes[pane], &look);
    legend_marks_add_stock (&moment.marks, &scenes[pane]);
    legend_marks_add_pointed (&moment.marks, &scenes[pane]);
  }
  check_themes (&moment, scenes);
  for (guint pane = 0; pane < N_PANES; pane++)
    scene_clear (&scenes[pane]);
}

static void
open_faults (void)
{
  faults = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
}

static void
close_faults (void)
{
  const guint n = g_hash_table_size (faults);

  g_clear_pointer (&faults, g_hash_table_unref);
  if (n > 0)
    g_test_fail ();
}

/* Lessons */

/* All that can be clicked is chosen, and nothing of it right. */
static void
answer_anything (Session *session)
{
  for (int kind = OBJECT_NONE + 1; kind <= OBJECT_VERTEX; kind++)
    for (guint number = 0; number < 5; number++)
      session_answer_toggle (session, (Object){ (ObjectKind)kind, number });
}

static void
check_question (Session *session, const char *name, guint stop)
{
  answer_anything (session);
  check (session, name, stop);
  session_check (session);
  check (session, name, stop);
  session_reveal (session);
  check (session, name, stop);
}

static void
check_stop (Session *session, const char *name, guint stop)
{
  const Performance *performance;

  session_set_stop (session, stop);
  check (session, name, stop);
  performance = session_get_performance (session);
  if (performance == NULL && session_get_exercise (session) != NULL)
    check_question (session, name, stop);
  for (guint i = 0; performance != NULL && !performance->is_over && i < 12;
       i++) {
    check_question (session, name, stop);
    session_continue (session);
    performance = session_get_performance (session);
  }
}

static void
test_lessons (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  open_faults ();
  g_assert_cmpuint (paths->len, >=, 15);
  for (guint i = 0; i < paths->len; i++) {
    g_autoptr (Session) session = session_new ();
    const char *path = g_ptr_array_index (paths, i);
    g_autofree char *name = g_path_get_basename (path);

    g_assert_true (document_open (session, path, NULL));
    for (guint stop = 0; stop < session_get_n_stops (session); stop++)
      check_stop (session, name, stop);
  }
  close_faults ();
}

/* Free states */

static const char *const states[][8] = {
  { "sites random 12 seed 7", "compare furthest input", "goto round 4 cone" },
  { "sites random 12 seed 7", "compare furthest input", "goto round 5",
    "select s3" },
  { "sites random 12 seed 7", "view planar", "goto round 2 choose" },
  { "sites random 12 seed 7", "view planar", "goto round 2 see" },
  { "sites random 12 seed 7", "view planar", "goto round 2 cone" },
  { "sites random 12 seed 7", "view planar" },
  { "rounding fig2a" },
  { "rounding A1", "view rounded" },
  { "rounding A1", "view rounded", "goto round 3" },
  { "sites random 12 seed 7", "show why", "select f39", "measure s7" },
  { "sites random 12 seed 7", "show why", "select f39", "measure s2",
    "show circumcircles", "show furthest", "show tangents" },
  { "sites random 12 seed 7", "show why", "select f30", "measure s2",
    "show circumcircles", "hide voronoi", "show furthest", "show tangents" },
  { "sites random 12 seed 7", "hide voronoi", "hide hull", "show tangents" },
  { "sites random 12 seed 7", "goto round 4 choose", "show why", "measure s2" },
  { "sites random 12 seed 7", "goto round 4 see", "show circumcircles" },
  { "sites random 12 seed 7", "goto round 4 horizon", "show why", "select f7",
    "measure s5" },
  { "sites random 12 seed 7", "goto round 4 cone", "show why", "select f7",
    "measure s2" },
  { "sites random 12 seed 7", "goto round 4 hand-over", "lift 0.5" },
  { "sites grid 4 3", "select f3" },
  { "sites grid 4 3", "goto round 3 see", "show why" },
  { "sites grid 4 3", "goto round 4 cone", "show furthest" },
  { "sites circle 12" },
  { "sites line 5" },
  { "sites 0.1 0.1; 0.1 0.1; -0.3 0.4; 0.5 0.2; 0 -0.6; -0.4 -0.1" },
  { "sites 0 0" },
  { "sites random 12 seed 7", "goto start" },
  { "sites random 12 seed 7", "goto simplex" },
};

static void
run (Session *session, const char *text)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GVariant) parameter = NULL;
  g_autofree char *verb = NULL;

  command_parse (text, &verb, &parameter, &error);
  g_assert_no_error (error);
  action_run (session, verb, parameter, &error);
  g_assert_no_error (error);
}

/* The pointer on things of each kind; then on none, where a site would be. */
static void
point_around (Session *session, guint state)
{
  static const Site places[] = { { 0.1, 0.15 }, { -0.2, 0.3 }, { 1.2, 1.1 } };
  const char *what = states[state][1];

  for (int kind = OBJECT_NONE + 1; kind <= OBJECT_VERTEX; kind++)
    for (guint number = 0; number < 40; number += 3) {
      session_set_hover (session, (Object){ (ObjectKind)kind, number });
      check (session, what != NULL ? what : "hover", state);
      session_set_selection (session, (Object){ (ObjectKind)kind, number + 3 });
      check (session, what != NULL ? what : "hover, selected", state);
      session_set_selection (session, (Object){ OBJECT_NONE, 0 });
    }
  session_set_hover (session, (Object){ OBJECT_NONE, 0 });
  for (guint i = 0; i < G_N_ELEMENTS (places); i++) {
    session_set_preview (session, &places[i]);
    check (session, "preview", state);
  }
  session_set_preview (session, NULL);
}

static void
test_free_states (void)
{
  open_faults ();
  for (guint i = 0; i < G_N_ELEMENTS (states); i++) {
    g_autoptr (Session) session = session_new ();

    for (guint k = 0; k < 8 && states[i][k] != NULL; k++)
      run (session, states[i][k]);
    check (session, "state", i);
    point_around (session, i);
  }
  close_faults ();
}

static void
test_every_step (void)
{
  static const guint32 some[] = { 1, 3, 4 };
  static const char *const sets[]
      = { "sites random 12 seed 7", "sites grid 4 3" };

  open_faults ();
  for (guint i = 0; i < G_N_ELEMENTS (sets); i++) {
    g_autoptr (Session) session = session_new ();

    run (session, sets[i]);
    for (guint step = 0; step <= session_get_n_steps (session); step++) {
      session_set_step (session, step);
      check (session, sets[i], step);
    }
    session_select_sites (session, some, G_N_ELEMENTS (some));
    check (session, "sites selected", i);
  }
  close_faults ();
}

static void
test_performance (void)
{
  g_autoptr (Session) session = session_new ();

  open_faults ();
  run (session, "sites random 8 seed 3");
  g_assert_true (session_perform (session, "", NULL));
  for (guint i = 0; i < 30 && !session_get_performance (session)->is_over;
       i++) {
    check_question (session, "performance", i);
    session_continue (session);
  }
  session_grade (session);
  check (session, "graded", 0);
  close_faults ();
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/legend/lessons-show-no-mark-that-it-does-not-explain",
                   test_lessons);
  g_test_add_func ("/legend/free-sites-show-no-mark-that-it-does-not-explain",
                   test_free_states);
  g_test_add_func ("/legend/no-step-shows-a-mark-that-it-does-not-explain",
                   test_every_step);
  g_test_add_func ("/legend/no-task-shows-a-mark-that-it-does-not-explain",
                   test_performance);
  g_test_add_func ("/legend/every-row-that-there-is-was-looked-at",
                   test_all_are_met);
  return g_test_run ();
}
