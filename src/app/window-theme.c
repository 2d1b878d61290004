/* The theme and sizes of the pictures: what is remembered of them, and how
 * the chrome round the pictures follows. */
#include "window-private.h"

#include "theme.h"

#include <math.h>

#define PAPER_DARK 0.2 /* a background of less luminance is dark */
#define SHEETS "/io/github/hull2vd/Hull2VD/"

/* Of what is said about faults. */
static const Colour fault_on_light = { 0.647, 0.114, 0.176, 1 };
static const Colour fault_on_dark = { 1, 0.71, 0.66, 1 };

/* Settings */

static void
restore (Hull2vdWindow *window)
{
  GSettings *settings = window->settings;
  const Appearance own
      = { .theme = (ThemeKind)g_settings_get_enum (settings, "theme"),
          .line_scale = g_settings_get_double (settings, "line-scale"),
          .mark_scale = g_settings_get_double (settings, "mark-scale"),
          .text_scale = g_settings_get_double (settings, "text-scale") };

  session_set_own_appearance (window->session, &own);
}

static void
save (Hull2vdWindow *window)
{
  GSettings *settings = window->settings;
  const Appearance *own = session_get_own_appearance (window->session);

  g_settings_set_enum (settings, "theme", (int)own->theme);
  g_settings_set_double (settings, "line-scale", own->line_scale);
  g_settings_set_double (settings, "mark-scale", own->mark_scale);
  g_settings_set_double (settings, "text-scale", own->text_scale);
}

/* Colours for style.css */

static Colour
opaque (Colour colour)
{
  colour.alpha = 1;
  return colour;
}

static void
define (GString *css, const char *name, Colour colour)
{
  g_string_append_printf (css, "@define-color hull2vd_%s #%02lx%02lx%02lx;\n",
                          name, (unsigned long)lround (255 * colour.red),
                          (unsigned long)lround (255 * colour.green),
                          (unsigned long)lround (255 * colour.blue));
}

static gboolean
is_dark (const Theme *theme)
{
  const Colour black = { 0, 0, 0, 1 };

  return colour_contrast (theme->background, black) < PAPER_DARK * 20 + 1;
}

static char *
write_colours (const Theme *theme)
{
  GString *css = g_string_new (NULL);
  const Colour ground = theme->background;
  const Colour accent = opaque (theme->styles[ROLE_DELAUNAY_EDGE].line);
  const Colour visible = opaque (theme->styles[ROLE_VISIBLE].line);

  define (css, "view", ground);
  define (css, "text", theme->text);
  define (css, "muted", colour_mix (theme->text, ground, 0.28));
  define (css, "readout", colour_mix (theme->text, ground, 0.12));
  define (css, "fault", is_dark (theme) ? fault_on_dark : fault_on_light);
  define (css, "accent", accent);
  define (css, "chosen", colour_mix (ground, accent, 0.2));
  define (css, "current", colour_mix (ground, visible, 0.18));
  define (css, "current_line", visible);
  define (css, "right", opaque (theme->styles[ROLE_CONE_EDGE].line));
  define (css, "stop", opaque (theme->styles[ROLE_SITE_APEX].line));
  return g_string_free (css, FALSE);
}

static void
load_colours (const Theme *theme)
{
  static GtkCssProvider *provider;
  g_autofree char *css = write_colours (theme);

  if (provider == NULL) {
    provider = gtk_css_provider_new ();
    gtk_style_context_add_provider_for_screen (
        gdk_screen_get_default (), GTK_STYLE_PROVIDER (provider),
        GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
  }
  gtk_css_provider_load_from_data (provider, css, -1, NULL);
}

/* Chrome */

/* What GTK's dark looks leave too faint. */
static const char *
sheet_of (ThemeKind kind)
{
  if (kind == THEME_CONTRAST)
    return SHEETS "contrast.css";
  return is_dark (theme_get (kind)) ? SHEETS "dark.css" : NULL;
}

static void
load_sheet (ThemeKind kind)
{
  static GtkCssProvider *provider;
  const char *sheet = sheet_of (kind);

  if (provider == NULL) {
    provider = gtk_css_provider_new ();
    gtk_style_context_add_provider_for_screen (
        gdk_screen_get_default (), GTK_STYLE_PROVIDER (provider),
        GTK_STYLE_PROVIDER_PRIORITY_APPLICATION + 1);
  }
  if (sheet != NULL)
    gtk_css_provider_load_from_resource (provider, sheet);
  else
    gtk_css_provider_load_from_data (provider, "", -1, NULL);
}

/* The desktop's own look where the theme does not ask for another. */
static void
choose_gtk_theme (ThemeKind kind)
{
  GtkSettings *settings = gtk_settings_get_default ();

  if (kind == THEME_CONTRAST)
    g_object_set (settings, "gtk-theme-name", "HighContrastInverse", NULL);
  else
    gtk_settings_reset_property (settings, "gtk-theme-name");
  if (kind != THEME_CONTRAST && is_dark (theme_get (kind)))
    g_object_set (settings, "gtk-application-prefer-dark-theme", TRUE, NULL);
  else
    gtk_settings_reset_property (settings, "gtk-application-prefer-dark-theme");
}

static void
set_class (GtkWidget *widget, ThemeKind kind)
{
  GtkStyleContext *style = gtk_widget_get_style_context (widget);

  for (int i = 0; i < N_THEMES; i++)
    gtk_style_context_remove_class (style, theme_kind_name ((ThemeKind)i));
  gtk_style_context_add_class (style, theme_kind_name (kind));
}

void
window_theme_dress (Hull2vdWindow *window)
{
  const ThemeKind kind = session_get_appearance (window->session)->theme;

  choose_gtk_theme (kind);
  load_colours (theme_get (kind));
  load_sheet (kind);
  set_class (GTK_WIDGET (window), kind);
  if (window->space_window != NULL)
    set_class (window->space_window, kind);
  if (window->lecturer != NULL)
    set_class (GTK_WIDGET (window->lecturer), kind);
}

static void
on_changed (Session *session, guint changes, Hull2vdWindow *window)
{
  (void)session;
  if ((changes & CHANGED_APPEARANCE) == 0)
    return;
  window_theme_dress (window);
  if (window->settings != NULL)
    save (window);
}

/* GTK has one look for all windows: that of the one in use. */
static void
on_active (Hull2vdWindow *window)
{
  if (window->session != NULL && gtk_window_is_active (GTK_WINDOW (window)))
    window_theme_dress (window);
}

void
window_theme_init (Hull2vdWindow *window)
{
  if (window->settings != NULL)
    restore (window);
  window_theme_dress (window);
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_changed),
                           window, 0);
  g_signal_connect (window, "notify::is-active", G_CALLBACK (on_active), NULL);
}
