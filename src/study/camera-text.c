#include "camera-text.h"

#include "action-private.h"
#include "words.h"

#include <math.h>

/* Of the numbers, and what they are when they are not written. */
enum { AZIMUTH, ELEVATION, ROLL, ZOOM, RIGHT, UP, N_NUMBERS };
static const double usual[N_NUMBERS] = { [ZOOM] = 1 };

#define PAN_MOST 1000.0

static gboolean
is_good (const double numbers[N_NUMBERS])
{
  return fabs (numbers[AZIMUTH]) <= 360 && fabs (numbers[ELEVATION]) <= 90
         && fabs (numbers[ROLL]) <= 360 && numbers[ZOOM] >= ZOOM_LEAST
         && numbers[ZOOM] <= ZOOM_MOST && fabs (numbers[RIGHT]) <= PAN_MOST
         && fabs (numbers[UP]) <= PAN_MOST;
}

/* The words behind the numbers. */
static gboolean
read_words (char **words, Camera *camera)
{
  for (guint i = 0; words[i] != NULL; i++)
    if (g_str_equal (words[i], "parallel")) {
      camera->is_parallel = TRUE;
    } else if (g_str_equal (words[i], "mirrored")) {
      camera->is_mirrored = TRUE;
    } else if (g_str_equal (words[i], "centre")) {
      if (words[i + 1] == NULL || words[i + 2] == NULL
          || !words_parse_double (words[i + 1], &camera->centre.x)
          || !words_parse_double (words[i + 2], &camera->centre.y)
          || fabs (camera->centre.x) > PAN_MOST
          || fabs (camera->centre.y) > PAN_MOST)
        return FALSE;
      i += 2;
    } else {
      return FALSE;
    }
  return TRUE;
}

gboolean
camera_text_read (const char *text, Camera *camera)
{
  g_auto (GStrv) words = words_split (text);
  double numbers[N_NUMBERS], number;
  guint n = 0;

  for (guint i = 0; i < N_NUMBERS; i++)
    numbers[i] = usual[i];
  while (n < N_NUMBERS && words[n] != NULL
         && words_parse_double (words[n], &number))
    numbers[n++] = number;
  if (n < 2 || n == N_NUMBERS - 1 || !is_good (numbers))
    return FALSE;
  camera_take_stance (
      camera,
      (CameraStance){ numbers[AZIMUTH], numbers[ELEVATION], numbers[ROLL] });
  camera->zoom = numbers[ZOOM];
  camera->pan_x = numbers[RIGHT];
  camera->pan_y = numbers[UP];
  camera->is_parallel = FALSE;
  camera->is_mirrored = FALSE;
  return read_words (words + n, camera);
}

/* Writes few digits, and no minus before nothing. */
static void
append_number (GString *text, double number, double unit)
{
  char digits[G_ASCII_DTOSTR_BUF_SIZE];
  const double rounded = round (number / unit) * unit;

  g_ascii_formatd (digits, sizeof digits, "%.7g", rounded == 0 ? 0 : rounded);
  g_string_append_printf (text, "%s%s", text->len == 0 ? "" : " ", digits);
}

static void
append_numbers (GString *text, const Camera *camera)
{
  const CameraStance stance = camera_stance (camera);
  const double numbers[N_NUMBERS]
      = { stance.azimuth, stance.elevation, stance.roll,
          camera->zoom,   camera->pan_x,    camera->pan_y };
  static const double units[N_NUMBERS]
      = { 0.01, 0.01, 0.01, 0.001, 0.001, 0.001 };
  guint n = N_NUMBERS;

  while (n > 2 && fabs (numbers[n - 1] - usual[n - 1]) < units[n - 1] / 2)
    n -= 1;
  n = n == N_NUMBERS - 1 ? N_NUMBERS : n;
  for (guint i = 0; i < n; i++)
    append_number (text, numbers[i], units[i]);
}

char *
camera_text_write (const Camera *camera)
{
  PlaneCamera plane;
  GString *text;

  plane_camera_init (&plane);
  for (CameraPreset preset = 0; preset < N_CAMERA_PRESETS; preset++) {
    Camera other;

    camera_init (&other, preset);
    if (preset == CAMERA_LOOK_UP || preset == CAMERA_LOOK_UP_UNMIRRORED
        || preset == CAMERA_LOOK_DOWN)
      camera_follow_plane (&other, &plane);
    if (camera_equal (camera, &other))
      return g_strdup (camera_preset_name (preset));
  }
  text = g_string_new (NULL);
  append_numbers (text, camera);
  if (camera->is_parallel)
    g_string_append (text, " parallel");
  if (camera->is_mirrored)
    g_string_append (text, " mirrored");
  if (fabs (camera->centre.x) >= 0.0005 || fabs (camera->centre.y) >= 0.0005) {
    g_string_append (text, " centre");
    append_number (text, camera->centre.x, 0.001);
    append_number (text, camera->centre.y, 0.001);
  }
  return g_string_free (text, FALSE);
}
