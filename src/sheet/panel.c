#include "panel.h"

#include "block.h"
#include "moment.h"
#include "prose.h"

#include <glib/gi18n.h>
#include <pango/pangocairo.h>

#define FONT "DejaVu Sans, sans"
#define TITLE_PT 10.5
#define TEXT_PT 8.5
#define LEAST_PART 0.66
#define GAP 10.0

/* A hull of more rounds shows this many of them. */
#define MOST_ROUNDS 60

static guint
n_rounds_shown (const Trace *trace)
{
  return MIN (trace->n_rounds, MOST_ROUNDS);
}

guint
panel_count (Session *session)
{
  if (session_get_n_stops (session) > 0)
    return session_get_n_stops (session);
  return n_rounds_shown (session_get_trace (session)) + 2;
}

/* The rounds shown are spread evenly; the last is always among them. */
static guint
round_of_panel (const Trace *trace, guint index)
{
  return (guint)((guint64)index * trace->n_rounds / n_rounds_shown (trace));
}

/* Without a lesson: the simplex, each round at its cone, and the end. */
static void
enter_round (Session *session, guint index, Panel *panel)
{
  const Trace *trace = session_get_trace (session);
  guint round;

  if (index == 0) {
    session_set_step (session, trace->start_end);
    panel->title = g_strdup (trace->is_flat ? _ ("No simplex")
                                            : _ ("The first simplex"));
    return;
  }
  if (index == panel_count (session) - 1) {
    session_set_step (session, trace->n_events);
    panel->title = g_strdup (_ ("The end"));
    return;
  }
  round = round_of_panel (trace, index);
  session_set_step (session, trace->rounds[round - 1].last_cone);
  panel->title = g_strdup_printf (_ ("Round %u: s%u"), round,
                                  trace->rounds[round - 1].site);
}

/* A question that is open has its pictures masked, and stands where the
 * sentence would answer it. */
static char *
read_narration (Session *session)
{
  const Exercise *exercise = session_get_exercise (session);
  g_autofree char *words = NULL;

  if (exercise != NULL && exercise->is_open) {
    words = question_prompt (exercise->question, &exercise->occasion);
    return prose_to_markup (words);
  }
  words = session_narrate (session);
  return g_markup_printf_escaped ("<i>%s</i>", words);
}

Panel *
panel_new (Session *session, guint index)
{
  Panel *panel = g_new0 (Panel, 1);
  Lesson *lesson = session_get_lesson (session);

  panel->number = index + 1;
  if (session_get_n_stops (session) > 0) {
    const LessonStop *stop = lesson_stop (lesson, index);

    session_set_stop (session, index);
    panel->title = g_strdup (stop->title);
    panel->prose = prose_to_markup (stop->prose != NULL ? stop->prose : "");
  } else {
    enter_round (session, index, panel);
    panel->prose = g_strdup ("");
  }
  panel->narration = read_narration (session);
  return panel;
}

void
panel_free (Panel *panel)
{
  g_free (panel->title);
  g_free (panel->prose);
  g_free (panel->narration);
  g_free (panel);
}

static PangoLayout *
layout_new (const char *markup, double width)
{
  g_auto (Press) press;
  PangoLayout *layout;

  press_init (&press);
  layout = pango_layout_new (press.context);

  pango_layout_set_width (layout, (int)(width * PANGO_SCALE));
  pango_layout_set_wrap (layout, PANGO_WRAP_WORD_CHAR);
  pango_layout_set_markup (layout, markup, -1);
  return layout;
}

static double
set_size (PangoLayout *layout, double size)
{
  PangoFontDescription *font = pango_font_description_from_string (FONT);
  int height;

  pango_font_description_set_absolute_size (font, size * PANGO_SCALE);
  pango_layout_set_font_description (layout, font);
  pango_font_description_free (font);
  pango_layout_get_size (layout, NULL, &height);
  return (double)height / PANGO_SCALE;
}

double
panel_paint_text (cairo_t *cr,
                  const char *markup,
                  double size,
                  const cairo_rectangle_t *area)
{
  g_autoptr (PangoLayout) layout = layout_new (markup, area->width);
  double at = size, height = set_size (layout, size);

  if (area->height <= 0)
    return 0;
  while (height > area->height && at > LEAST_PART * size) {
    at *= 0.96;
    height = set_size (layout, at);
  }
  if (height > area->height) {
    pango_layout_set_height (layout, (int)(area->height * PANGO_SCALE));
    pango_layout_set_ellipsize (layout, PANGO_ELLIPSIZE_END);
    height = area->height;
  }
  cairo_set_source_rgb (cr, 0.14, 0.12, 0.19);
  cairo_move_to (cr, area->x, area->y);
  pango_cairo_show_layout (cr, layout);
  return height;
}

/* Title, prose, and below a fine line the sentence of the step. */
static void
paint_words (const Panel *panel, cairo_t *cr, cairo_rectangle_t area)
{
  g_autofree char *title
      = g_markup_printf_escaped ("<b>%u  %s</b>", panel->number, panel->title);
  const double bottom = area.y + area.height;
  const double n_narration = area.height * 0.3;
  double height;

  height = panel_paint_text (cr, title, TITLE_PT, &area) + 4;
  area.y += height;
  area.height = bottom - area.y - n_narration;
  if (panel->prose[0] != '\0')
    area.y += panel_paint_text (cr, panel->prose, TEXT_PT, &area) + 6;
  cairo_move_to (cr, area.x, area.y + 0.25);
  cairo_rel_line_to (cr, 28, 0);
  cairo_set_line_width (cr, 0.7);
  cairo_set_source_rgb (cr, 0.4, 0.4, 0.4);
  cairo_stroke (cr);
  area.y += 4;
  area.height = bottom - area.y;
  panel_paint_text (cr, panel->narration, TEXT_PT, &area);
}

void
panel_paint (const Panel *panel,
             Session *session,
             const Appearance *appearance,
             cairo_t *cr,
             const cairo_rectangle_t *area)
{
  const double pictures = MIN (2 * area->height, 0.64 * area->width);
  const cairo_rectangle_t picture
      = { area->x, area->y, pictures, area->height };
  const cairo_rectangle_t words
      = { area->x + pictures + GAP, area->y, area->width - pictures - GAP,
          area->height };

  moment_paint (session, MOMENT_VIEWS, appearance, cr, &picture);
  paint_words (panel, cr, words);
}
