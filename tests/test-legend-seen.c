/* A row of the legend is there only when its mark can be seen: pictures with
 * and without it differ. */
#include "action.h"
#include "command.h"
#include "document.h"
#include "legend.h"
#include "locate.h"
#include "moment.h"
#include "sight.h"

#include <math.h>

#define WIDTH 340
#define HEIGHT 400
#define PX_PER_PT 2.1 /* of moments */

/* An area of a pale hue has many pixels; of lines and hatches one sees those
 * that stand out. Ink is the sum of log2 of contrasts: 25 pixels of 2 to 1. */
#define CONTRAST_OF_AREAS 1.03
#define CONTRAST_OF_LINES 1.35
#define INK_LEAST 25.0

static cairo_surface_t *
paint (Session *session, MomentView view, ThemeKind kind)
{
  const Appearance appearance = { kind, 1, 1, 1 };
  const cairo_rectangle_t area
      = { 0, 0, WIDTH / PX_PER_PT, HEIGHT / PX_PER_PT };
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
  cairo_t *cr = cairo_create (surface);

  cairo_scale (cr, PX_PER_PT, PX_PER_PT);
  moment_paint (session, view, &appearance, cr, &area);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

static Colour
colour_at (cairo_surface_t *surface, int x, int y)
{
  const guchar *at = cairo_image_surface_get_data (surface)
                     + y * cairo_image_surface_get_stride (surface) + 4 * x;

  return (Colour){ at[2] / 255.0, at[1] / 255.0, at[0] / 255.0, 1 };
}

/* Returns: by how much ink two pictures differ, of pixels of a contrast. */
static double
ink_between (cairo_surface_t *a, cairo_surface_t *b, double told)
{
  double ink = 0;

  for (int y = 0; y < HEIGHT; y++)
    for (int x = 0; x < WIDTH; x++) {
      const Colour p = colour_at (a, x, y), q = colour_at (b, x, y);
      double contrast;

      if (colour_equal (p, q))
        continue;
      contrast = sight_contrast (p, q);
      ink += contrast >= told ? log2 (contrast) : 0;
    }
  return ink;
}

/* Returns: how much of a role is seen in one picture. */
static double
ink_of (Session *session, MomentView view, ThemeKind kind, Role role)
{
  const gboolean has_line = sight_style (theme_get (kind), role).line.alpha > 0;
  cairo_surface_t *with = paint (session, view, kind), *without;
  double ink;

  session_set_role_opacity (session, role, 0);
  without = paint (session, view, kind);
  session_set_role_opacity (session, role, 1);
  ink = ink_between (with, without,
                     has_line ? CONTRAST_OF_LINES : CONTRAST_OF_AREAS);
  cairo_surface_destroy (with);
  cairo_surface_destroy (without);
  return ink;
}

static void
check_row (Session *session, ThemeKind kind, const LegendRow *row)
{
  double ink = 0;

  if (!legend_mark_is_switch (row->mark))
    return;
  for (int view = MOMENT_PLANE; view <= MOMENT_SPACE && ink < INK_LEAST; view++)
    ink += ink_of (session, (MomentView)view, kind, (Role)row->mark);
  if (ink < INK_LEAST)
    sight_fault (theme_get (kind), row->text, row->mark, "pictures", ink);
}

static Session *lesson; /* in which no triangle dies */

static void
check_theme (const Theme *theme)
{
  g_autoptr (GPtrArray) rows = NULL;
  LegendMarks marks = { 0 };
  ThemeKind kind = THEME_LIGHT;

  while (theme_get (kind) != theme)
    kind++;
  moment_add_marks (lesson, MOMENT_SHOWN, MOMENT_VIEWS, &marks);
  rows = legend_rows (lesson, &marks, theme);
  g_assert_cmpuint (rows->len, >=, 12);
  for (guint i = 0; i < rows->len; i++)
    check_row (lesson, kind, g_ptr_array_index (rows, i));
}

/* The cone is in front of all that will go. */
static void
test_cone (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  lesson = session_new ();
  g_assert_true (document_open (lesson, g_ptr_array_index (paths, 8), NULL));
  session_set_stop (lesson, 5);
  sight_for_each_theme (check_theme);
  g_clear_object (&lesson);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/legend-seen/whatever-has-a-row-is-seen-under-a-cone",
                   test_cone);
  return g_test_run ();
}
