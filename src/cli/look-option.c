/* The options that say how pictures look. */
#include "cli.h"
#include "scene.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

#define ZOOM_LEAST 0.1
#define ZOOM_MOST 100.0

void
cli_look_clear (CliLook *options)
{
  g_free (options->theme);
  g_free (options->line_scale);
  g_free (options->mark_scale);
  g_free (options->text_scale);
  g_free (options->layers);
  g_free (options->camera);
}

gboolean
cli_decimal (const CliCommand *command,
             const char *option,
             const char *value,
             double least,
             double most,
             double *number)
{
  double read;

  if (words_parse_double (value, &read) && read >= least && read <= most) {
    *number = read;
    return TRUE;
  }
  cli_usage (command, _ ("%s: “%s” is not a number from %g to %g%s"), option,
             value, least, most, words_comma_hint (value));
  return FALSE;
}

/* Says that there is no such word, which ones there are, and which one was
 * perhaps meant. */
static gboolean
refuse (const CliCommand *command,
        const char *rule,
        const char *word,
        const char *const *names)
{
  g_autofree char *hint = words_hint (word, names);
  g_autofree char *list = g_strjoinv (", ", (char **)names);

  cli_usage (command, rule, word, hint, list);
  return FALSE;
}

static gboolean
parse_theme (const CliCommand *command, const char *name, ThemeKind *theme)
{
  const char *names[N_THEMES + 1] = { NULL };

  if (name == NULL || theme_kind_parse (name, theme))
    return TRUE;
  for (guint i = 0; i < N_THEMES; i++)
    names[i] = theme_kind_name ((ThemeKind)i);
  return refuse (command, _ ("there is no theme “%s”%s; the themes are %s"),
                 name, names);
}

static gboolean
parse_scale (const CliCommand *command,
             const char *option,
             const char *value,
             double *scale)
{
  return value == NULL
         || cli_decimal (command, option, value, SCALE_LEAST, SCALE_MOST,
                         scale);
}

static gboolean
refuse_layer (const CliCommand *command, const char *word)
{
  const char *names[N_LAYERS + 1] = { NULL };

  for (guint i = 0; i < N_LAYERS; i++)
    names[i] = layer_name ((Layer)(1u << i));
  return refuse (command, _ ("there is no layer “%s”%s; the layers are %s"),
                 word, names);
}

/* A first layer without a sign begins with none. */
static gboolean
parse_layers (const CliCommand *command, const char *text, guint *layers)
{
  g_auto (GStrv) words = g_strsplit (text != NULL ? text : "", ",", -1);

  for (guint i = 0; words[i] != NULL; i++) {
    const gboolean is_less = words[i][0] == '-';
    const char *name = words[i] + (is_less || words[i][0] == '+' ? 1 : 0);
    Layer layer;

    if (!layer_parse (name, &layer))
      return refuse_layer (command, name);
    if (i == 0 && name == words[i])
      *layers = 0;
    *layers = is_less ? *layers & ~(guint)layer : *layers | layer;
  }
  return TRUE;
}

static gboolean
refuse_camera (const CliCommand *command, const char *word)
{
  const char *names[N_CAMERA_PRESETS + 1] = { NULL };

  for (guint i = 0; i < N_CAMERA_PRESETS; i++)
    names[i] = camera_preset_name ((CameraPreset)i);
  return refuse (command,
                 _ ("there is no camera “%s”%s; the cameras are %s, or "
                    "degrees: AZIMUTH,ELEVATION[,ZOOM]"),
                 word, names);
}

static gboolean
parse_camera (const CliCommand *command, const char *text, Camera *camera)
{
  const char *const option = "--camera";
  g_auto (GStrv) parts = g_strsplit (text != NULL ? text : "", ",", 4);
  const guint n_parts = g_strv_length (parts);
  double azimuth, elevation, zoom = 1;
  CameraPreset preset;

  if (text == NULL)
    return TRUE;
  if (camera_preset_parse (text, &preset)) {
    camera_init (camera, preset);
    return TRUE;
  }
  if (n_parts < 2 || n_parts > 3)
    return refuse_camera (command, text);
  if (!cli_decimal (command, option, parts[0], -360, 360, &azimuth)
      || !cli_decimal (command, option, parts[1], -90, 90, &elevation)
      || (n_parts == 3
          && !cli_decimal (command, option, parts[2], ZOOM_LEAST, ZOOM_MOST,
                           &zoom)))
    return FALSE;
  camera_stand (camera, azimuth, elevation);
  camera->zoom = zoom;
  return TRUE;
}

gboolean
cli_look (const CliCommand *command,
          const CliLook *options,
          Appearance *appearance,
          guint *layers,
          Camera *camera)
{
  return parse_theme (command, options->theme, &appearance->theme)
         && parse_scale (command, "--line-scale", options->line_scale,
                         &appearance->line_scale)
         && parse_scale (command, "--mark-scale", options->mark_scale,
                         &appearance->mark_scale)
         && parse_scale (command, "--text-scale", options->text_scale,
                         &appearance->text_scale)
         && parse_layers (command, options->layers, layers)
         && parse_camera (command, options->camera, camera);
}
