#include "appearance.h"

#include <string.h>

static const char *const theme_names[N_THEMES] = {
  [THEME_LIGHT] = "light",         [THEME_PAPER] = "paper",
  [THEME_PROJECTOR] = "projector", [THEME_DARK] = "dark",
  [THEME_PRINT] = "print",         [THEME_CONTRAST] = "contrast",
};

const char *
theme_kind_name (ThemeKind kind)
{
  return theme_names[kind];
}

bool
theme_kind_parse (const char *name, ThemeKind *kind)
{
  int i;

  for (i = 0; i < N_THEMES; i++) {
    if (strcmp (name, theme_names[i]) != 0)
      continue;
    *kind = (ThemeKind)i;
    return true;
  }
  return false;
}

void
appearance_init (Appearance *appearance)
{
  *appearance = (Appearance){
    .theme = THEME_LIGHT, .line_scale = 1, .mark_scale = 1, .text_scale = 1
  };
}

bool
appearance_equal (const Appearance *a, const Appearance *b)
{
  return a->theme == b->theme && a->line_scale == b->line_scale
         && a->mark_scale == b->mark_scale && a->text_scale == b->text_scale;
}
