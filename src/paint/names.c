#include "names.h"

#include <glib.h>
#include <math.h>
#include <pango/pangocairo.h>

#define APEX_FACTOR 1.2
#define N_NAMES_MOST 20000
#define MASK_MARGIN 4 /* px round the ink: half the casing and what is soft */

typedef struct Name {
  char *text;
  NameFace face;
  PangoRectangle ink; /* px, from the start of the line */
  double scale;       /* of the mask; 0: there is none */
  NameMask mask;
  cairo_surface_t *surfaces[2]; /* casing, letters */
} Name;

struct Names {
  char *font; /* of the theme that the names are set for */
  double text_px;
  bool has_plates;
  uint32_t edition;
  PangoLayout *layout;
  GArray *names;
  NamePlaces *places;
  GHashTable *numbers; /* text with its face as the first letter → number + 1 */
};

static void
clear_name (gpointer data)
{
  Name *name = data;

  g_free (name->text);
  g_clear_pointer (&name->surfaces[0], cairo_surface_destroy);
  g_clear_pointer (&name->surfaces[1], cairo_surface_destroy);
}

/* The same outlines on every screen: no hinting. */
static PangoLayout *
layout_new (PangoFontMap *fonts)
{
  PangoContext *context = pango_font_map_create_context (fonts);
  cairo_font_options_t *options = cairo_font_options_create ();
  PangoLayout *layout;

  cairo_font_options_set_hint_style (options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics (options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options (context, options);
  cairo_font_options_destroy (options);
  layout = pango_layout_new (context);
  g_object_unref (context);
  return layout;
}

static Names *
new_with_fonts (PangoFontMap *fonts)
{
  Names *names = g_new0 (Names, 1);

  names->layout = layout_new (fonts);
  names->places = name_places_new ();
  names->names = g_array_new (FALSE, TRUE, sizeof (Name));
  g_array_set_clear_func (names->names, clear_name);
  names->numbers
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  return names;
}

Names *
names_new (void)
{
  return new_with_fonts (pango_cairo_font_map_get_default ());
}

Names *
names_new_apart (void)
{
  PangoFontMap *fonts = pango_cairo_font_map_new ();
  Names *names = new_with_fonts (fonts);

  g_object_unref (fonts);
  return names;
}

void
names_free (Names *names)
{
  name_places_free (names->places);
  g_hash_table_unref (names->numbers);
  g_array_unref (names->names);
  g_object_unref (names->layout);
  g_free (names->font);
  g_free (names);
}

uint32_t
names_begin (Names *names, const Theme *theme)
{
  if (g_strcmp0 (theme->font, names->font) == 0
      && theme->text_px == names->text_px
      && theme->has_plates == names->has_plates
      && names->names->len < N_NAMES_MOST)
    return names->edition;
  g_free (names->font);
  names->font = g_strdup (theme->font);
  names->text_px = theme->text_px;
  names->has_plates = theme->has_plates;
  g_hash_table_remove_all (names->numbers);
  g_array_set_size (names->names, 0);
  name_places_forget (names->places);
  return ++names->edition;
}

NamePlaces *
names_places (const Names *names)
{
  return names->places;
}

static void
set_text (Names *names, const char *text, NameFace face)
{
  const double factor = face == NAME_APEX ? APEX_FACTOR : 1;
  PangoFontDescription *font = pango_font_description_from_string (names->font);

  pango_font_description_set_absolute_size (font, names->text_px * factor
                                                      * PANGO_SCALE);
  if (face == NAME_APEX || face == NAME_ANSWER)
    pango_font_description_set_weight (font, PANGO_WEIGHT_BOLD);
  if (face == NAME_FACET || face == NAME_ANSWER)
    pango_font_description_set_style (font, PANGO_STYLE_OBLIQUE);
  pango_layout_set_font_description (names->layout, font);
  pango_layout_set_text (names->layout, text, -1);
  pango_font_description_free (font);
}

/* Returns: the number of a new name. */
static uint32_t
add_name (Names *names, const char *text, NameFace face)
{
  const guint number = names->names->len;
  Name *name;

  g_array_set_size (names->names, number + 1);
  name = &g_array_index (names->names, Name, number);
  name->text = g_strdup (text);
  name->face = face;
  set_text (names, text, face);
  pango_layout_get_pixel_extents (names->layout, &name->ink, NULL);
  return number;
}

uint32_t
names_find (Names *names, const char *text, NameFace face)
{
  char key[40];
  gpointer known;
  uint32_t number;

  g_snprintf (key, sizeof key, "%d%s", face, text);
  known = g_hash_table_lookup (names->numbers, key);
  if (known != NULL)
    return GPOINTER_TO_UINT (known) - 1;
  number = add_name (names, text, face);
  g_hash_table_insert (names->numbers, g_strdup (key),
                       GUINT_TO_POINTER (number + 1));
  return number;
}

static Name *
get_name (const Names *names, uint32_t name)
{
  return &g_array_index (names->names, Name, name);
}

NameSize
names_size (const Names *names, uint32_t name)
{
  const PangoRectangle ink = get_name (names, name)->ink;

  return (NameSize){ ink.width, ink.height };
}

void
names_trace (Names *names, uint32_t number, cairo_t *cr, Pixel at)
{
  const Name *name = get_name (names, number);

  set_text (names, name->text, name->face);
  cairo_move_to (cr, at.x - name->ink.x, at.y - name->ink.y);
  pango_cairo_layout_path (cr, names->layout);
}

static bool
has_plate (const Names *names, NameFace face)
{
  return face == NAME_ANSWER || names->has_plates;
}

void
names_paint_casing (Names *names, uint32_t number, cairo_t *cr, Pixel at)
{
  const Name *name = get_name (names, number);

  cairo_set_dash (cr, NULL, 0, 0);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width (cr, NAME_CASING);
  if (has_plate (names, name->face)) {
    cairo_rectangle (cr, at.x, at.y, name->ink.width, name->ink.height);
    cairo_fill_preserve (cr);
  } else {
    names_trace (names, number, cr, at);
  }
  cairo_stroke (cr);
}

void
names_show (Names *names, uint32_t number, cairo_t *cr, Pixel at)
{
  const Name *name = get_name (names, number);

  set_text (names, name->text, name->face);
  cairo_move_to (cr, at.x - name->ink.x, at.y - name->ink.y);
  pango_cairo_show_layout (cr, names->layout);
}

/* One of the two masks of a name: its casing or its letters. */
static void
paint_mask (Names *names, uint32_t number, int which)
{
  Name *name = get_name (names, number);
  NameMask *mask = &name->mask;
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_A8, mask->width, mask->height);
  cairo_t *cr = cairo_create (surface);

  cairo_translate (cr, -mask->x, -mask->y);
  cairo_scale (cr, name->scale, name->scale);
  if (which == 0) {
    names_paint_casing (names, number, cr, (Pixel){ 0, 0 });
  } else {
    names_trace (names, number, cr, (Pixel){ 0, 0 });
    cairo_fill (cr);
  }
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  name->surfaces[which] = surface;
}

const NameMask *
names_mask (Names *names, uint32_t number, double scale)
{
  Name *name = get_name (names, number);
  NameMask *mask = &name->mask;
  int i;

  if (name->scale == scale)
    return mask;
  name->scale = scale;
  mask->x = mask->y = -(int)ceil (MASK_MARGIN * scale);
  mask->width = (int)ceil (name->ink.width * scale) - 2 * mask->x;
  mask->height = (int)ceil (name->ink.height * scale) - 2 * mask->y;
  for (i = 0; i < 2; i++) {
    g_clear_pointer (&name->surfaces[i], cairo_surface_destroy);
    paint_mask (names, number, i);
  }
  mask->stride = cairo_image_surface_get_stride (name->surfaces[0]);
  mask->casing = cairo_image_surface_get_data (name->surfaces[0]);
  mask->letters = cairo_image_surface_get_data (name->surfaces[1]);
  return mask;
}
