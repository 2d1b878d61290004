/* Whether two themes look the same, member by member. */
#include "theme.h"

#include <string.h>

bool
colour_equal (Colour a, Colour b)
{
  return a.red == b.red && a.green == b.green && a.blue == b.blue
         && a.alpha == b.alpha;
}

static bool
lines_equal (const Style *a, const Style *b)
{
  return colour_equal (a->line, b->line) && a->width == b->width
         && a->dash == b->dash && a->gap == b->gap && a->casing == b->casing;
}

static bool
areas_equal (const Style *a, const Style *b)
{
  return colour_equal (a->fill, b->fill) && a->hatch == b->hatch
         && a->hatch_width == b->hatch_width && a->is_shaded == b->is_shaded;
}

static bool
marks_equal (const Style *a, const Style *b)
{
  return a->mark == b->mark && a->radius == b->radius
         && a->ring_gap == b->ring_gap;
}

static bool
styles_equal (const Style *a, const Style *b)
{
  return lines_equal (a, b) && areas_equal (a, b) && marks_equal (a, b)
         && colour_equal (a->halo, b->halo) && a->halo_width == b->halo_width;
}

static bool
grounds_equal (const Theme *a, const Theme *b)
{
  return colour_equal (a->background, b->background)
         && colour_equal (a->selection, b->selection)
         && colour_equal (a->hover, b->hover)
         && colour_equal (a->selected_facet, b->selected_facet)
         && colour_equal (a->selected_area, b->selected_area)
         && a->has_mat == b->has_mat && a->has_plates == b->has_plates;
}

static bool
texts_equal (const Theme *a, const Theme *b)
{
  return colour_equal (a->text, b->text)
         && colour_equal (a->apex_text, b->apex_text)
         && strcmp (a->font, b->font) == 0 && a->text_px == b->text_px;
}

static bool
sizes_equal (const Theme *a, const Theme *b)
{
  return a->line_factor == b->line_factor && a->mark_factor == b->mark_factor
         && a->hatch_px == b->hatch_px;
}

static bool
inks_equal (const Theme *a, const Theme *b)
{
  return a->cell_lightness == b->cell_lightness
         && a->cell_chroma == b->cell_chroma
         && a->cell_loudness == b->cell_loudness && a->pale_line == b->pale_line
         && a->pale_contrast == b->pale_contrast
         && a->pale_width == b->pale_width && a->pale_hatch == b->pale_hatch
         && a->pale_fill == b->pale_fill && a->pale_cell == b->pale_cell
         && a->far_line == b->far_line && a->far_width == b->far_width
         && a->far_casing == b->far_casing;
}

bool
theme_equal (const Theme *a, const Theme *b)
{
  Role role;

  if (strcmp (a->name, b->name) != 0 || !grounds_equal (a, b)
      || !texts_equal (a, b) || !sizes_equal (a, b) || !inks_equal (a, b))
    return false;
  for (role = 0; role < N_ROLES; role++)
    if (!styles_equal (&a->styles[role], &b->styles[role])
        || !colour_equal (a->pale_lines[role], b->pale_lines[role]))
      return false;
  return true;
}
