/* The names of marks: measured, placed, and painted as outlines, so that they
 * are the same on every surface. */
#include "painter-private.h"

#include <glib.h>
#include <pango/pangocairo.h>

#define APEX_FACTOR 1.2
#define PADDING 1.5
#define CASING 4.0
#define CROWDED 0.75 /* where sites are drawn smaller, few have names */

static bool
is_important (const SceneItem *item)
{
  return item->emphasis == EMPHASIS_LOUD || item->lit != LIT_NONE
         || item->role == ROLE_SITE_APEX || item->role == ROLE_POWER;
}

static void
set_label (PangoLayout *layout, const Theme *theme, const SceneItem *item)
{
  const bool is_apex = item->role == ROLE_SITE_APEX;
  PangoFontDescription *font = pango_font_description_from_string (theme->font);

  pango_font_description_set_absolute_size (
      font, theme->text_px * (is_apex ? APEX_FACTOR : 1) * PANGO_SCALE);
  if (is_apex)
    pango_font_description_set_weight (font, PANGO_WEIGHT_BOLD);
  if (item->role == ROLE_FACET_NAME)
    pango_font_description_set_style (font, PANGO_STYLE_OBLIQUE);
  pango_layout_set_font_description (layout, font);
  pango_layout_set_text (layout, item->label, -1);
  pango_font_description_free (font);
}

/* The same outlines on every screen: no hinting. */
static PangoLayout *
layout_new (cairo_t *cr)
{
  PangoLayout *layout = pango_cairo_create_layout (cr);
  PangoContext *context = pango_layout_get_context (layout);
  cairo_font_options_t *options = cairo_font_options_create ();

  cairo_font_options_set_hint_style (options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics (options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options (context, options);
  cairo_font_options_destroy (options);
  return layout;
}

/* Returns: the labels of all marks in the view. */
static GArray *
measure (const Painter *painter, PangoLayout *layout)
{
  GArray *labels = g_array_new (FALSE, TRUE, sizeof (Label));
  uint32_t i;

  for (i = 0; i < painter->scene->n_items; i++) {
    const SceneItem *item = &painter->scene->items[i];
    const Style style = painter_style (painter, item);
    Label label = { .text = item->label, .item = i };
    PangoRectangle ink;

    if (item->label == NULL || item->fade >= 1
        || (painter->size < CROWDED && !is_important (item))
        || !clip_point (painter->projection,
                        painter->scene->points[item->first], &label.at)
        || label.at.x < 0 || label.at.x > painter->projection->width
        || label.at.y < 0 || label.at.y > painter->projection->height)
      continue;
    set_label (layout, painter->theme, item);
    pango_layout_get_pixel_extents (layout, &ink, NULL);
    label.width = ink.width + 2 * PADDING;
    label.height = ink.height + 2 * PADDING;
    label.reach = brush_mark_reach (&style);
    label.is_important = is_important (item);
    label.is_centred = item->role == ROLE_FACET_NAME;
    g_array_append_val (labels, label);
  }
  return labels;
}

static void
paint_label (const Painter *painter, PangoLayout *layout, const Label *label)
{
  const SceneItem *item = &painter->scene->items[label->item];
  const Theme *theme = painter->theme;
  cairo_t *cr = painter->cr;
  PangoRectangle ink;

  set_label (layout, theme, item);
  pango_layout_get_pixel_extents (layout, &ink, NULL);
  cairo_move_to (cr, label->low.x + PADDING - ink.x,
                 label->low.y + PADDING - ink.y);
  pango_cairo_layout_path (cr, layout);
  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_width (cr, CASING);
  brush_colour (cr, theme->background);
  cairo_stroke_preserve (cr);
  brush_colour (cr,
                item->role == ROLE_SITE_APEX ? theme->apex_text : theme->text);
  cairo_fill (cr);
}

void
painter_paint_labels (Painter *painter)
{
  g_autoptr (PangoLayout) layout = layout_new (painter->cr);
  g_autoptr (GArray) labels = measure (painter, layout);
  guint i;

  label_sheet_place (painter->sheet, (Label *)labels->data, labels->len);
  for (i = 0; i < labels->len; i++) {
    const Label *label = &g_array_index (labels, Label, i);

    if (label->is_placed)
      paint_label (painter, layout, label);
  }
}
