#include "narration-markup.h"

#include <glib/gi18n.h>
#include <math.h>

/* Text needs more contrast than marks do. Source: WCAG 2.1, 1.4.3. */
#define TEXT_CONTRAST 4.5

/* The words of a sentence that stand for something loud. */
typedef struct KeyWord {
  const char *word; /* marked for translation, as in the narration */
  Role role;
} KeyWord;

static const KeyWord key_words[] = {
  { N_ ("sees"), ROLE_VISIBLE },
  { N_ ("visible"), ROLE_VISIBLE },
  { N_ ("horizon"), ROLE_HORIZON },
  { N_ ("cone"), ROLE_CONE_EDGE },
};

typedef struct Markup {
  guint apex; /* current site, or INDEX_NONE */
  const Theme *theme;
  Colour background;
} Markup;

/* The colour of a role, mixed with black or white until it can be read. */
static Colour
text_colour (const Markup *markup, Role role)
{
  const Colour black = { 0, 0, 0, 1 };
  const Colour white = { 1, 1, 1, 1 };
  const Colour ground = markup->background;
  const Colour far
      = colour_contrast (ground, black) > colour_contrast (ground, white)
            ? black
            : white;
  const Style *style = &markup->theme->styles[role];
  Colour colour = style->line.alpha > 0 ? style->line : style->fill;

  colour.alpha = 1;
  for (int i = 0; i < 20; i++) {
    if (colour_contrast (colour, ground) >= TEXT_CONTRAST)
      break;
    colour = colour_mix (colour, far, 0.1);
  }
  return colour;
}

static void
append_bold (GString *result, const char *text, const Markup *markup, int role)
{
  Colour colour;

  if (role < 0) {
    g_string_append_printf (result, "<b>%s</b>", text);
    return;
  }
  colour = text_colour (markup, (Role)role);
  g_string_append_printf (result,
                          "<span weight=\"bold\" color=\"#%02lx%02lx%02lx\">"
                          "%s</span>",
                          (unsigned long)lround (255 * colour.red),
                          (unsigned long)lround (255 * colour.green),
                          (unsigned long)lround (255 * colour.blue), text);
}

/* The role whose colour @word gets, or -1: bold alone. */
static int
role_of (const char *word, guint apex)
{
  for (guint i = 0; i < G_N_ELEMENTS (key_words); i++)
    if (g_str_equal (word, _ (key_words[i].word)))
      return key_words[i].role;
  if (word[0] == 's' && apex != INDEX_NONE
      && g_ascii_strtoull (word + 1, NULL, 10) == apex)
    return ROLE_SITE_APEX;
  return -1;
}

static gboolean
on_word (const GMatchInfo *match, GString *result, gpointer user)
{
  const Markup *markup = user;
  g_autofree char *word = g_match_info_fetch (match, 0);

  append_bold (result, word, markup, role_of (word, markup->apex));
  return FALSE;
}

static GRegex *
make_regex (void)
{
  g_autoptr (GString) pattern = g_string_new ("\\b(?:[sfe][0-9]+");

  for (guint i = 0; i < G_N_ELEMENTS (key_words); i++) {
    g_autofree char *word = g_regex_escape_string (_ (key_words[i].word), -1);

    g_string_append_printf (pattern, "|%s", word);
  }
  g_string_append (pattern, ")\\b");
  return g_regex_new (pattern->str, 0, 0, NULL);
}

char *
narration_to_markup (const char *sentence,
                     guint apex,
                     const Theme *theme,
                     Colour background)
{
  Markup markup = { apex, theme, background };
  g_autofree char *escaped = g_markup_escape_text (sentence, -1);
  g_autoptr (GRegex) regex = make_regex ();
  char *result = NULL;

  if (regex != NULL)
    result = g_regex_replace_eval (regex, escaped, -1, 0, 0, on_word, &markup,
                                   NULL);
  return result != NULL ? result : g_steal_pointer (&escaped);
}
