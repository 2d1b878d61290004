#include "motion.h"

static guint n_skips;

static gboolean
on_press (GSignalInvocationHint *hint,
          guint n_values,
          const GValue *values,
          gpointer user)
{
  (void)hint;
  (void)n_values;
  (void)values;
  (void)user;
  n_skips += 1;
  return TRUE;
}

/* Whichever widget it is that gets them. */
static void
watch_presses (void)
{
  static gsize is_done;

  if (!g_once_init_enter (&is_done))
    return;
  g_signal_add_emission_hook (
      g_signal_lookup ("key-press-event", GTK_TYPE_WIDGET), 0, on_press, NULL,
      NULL);
  g_signal_add_emission_hook (
      g_signal_lookup ("button-press-event", GTK_TYPE_WIDGET), 0, on_press,
      NULL, NULL);
  g_once_init_leave (&is_done, 1);
}

gboolean
motion_is_wanted (GtkWidget *widget)
{
  gboolean is_enabled = FALSE;

  if (g_strcmp0 (g_getenv ("HULL2VD_ANIMATIONS"), "0") == 0
      || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_object_get (gtk_widget_get_settings (widget), "gtk-enable-animations",
                &is_enabled, NULL);
  return is_enabled;
}

/* Begins and ends gently. */
double
motion_part (gint64 since_us)
{
  const double part = CLAMP ((double)since_us / (1000.0 * MOTION_MS), 0, 1);

  return part * part * (3 - 2 * part);
}

guint
motion_n_skips (void)
{
  watch_presses ();
  return n_skips;
}
