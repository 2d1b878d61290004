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

void
motion_init (Motion *motion, Canvas *canvas)
{
  *motion = (Motion){ .canvas = canvas, .part = 1 };
}

gboolean
motion_is_wanted (const Motion *motion)
{
  GtkWidget *widget = GTK_WIDGET (motion->canvas);
  gboolean is_enabled = FALSE;

  if (g_strcmp0 (g_getenv ("HULL2VD_ANIMATIONS"), "0") == 0
      || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_object_get (gtk_widget_get_settings (widget), "gtk-enable-animations",
                &is_enabled, NULL);
  return is_enabled;
}

/* Begins and ends gently. */
static double
part_of (gint64 since_us)
{
  const double part = CLAMP ((double)since_us / (1000.0 * MOTION_MS), 0, 1);

  return part * part * (3 - 2 * part);
}

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer user)
{
  Motion *motion = user;
  const gint64 now_us = gdk_frame_clock_get_frame_time (clock);

  (void)widget;
  if (motion->start_us == 0)
    motion->start_us = now_us;
  motion->part
      = motion->n_skips == n_skips ? part_of (now_us - motion->start_us) : 1;
  canvas_invalidate (motion->canvas);
  if (motion->part < 1)
    return G_SOURCE_CONTINUE;
  motion->tick = 0;
  return G_SOURCE_REMOVE;
}

void
motion_begin (Motion *motion)
{
  motion_end (motion);
  watch_presses ();
  motion->part = 0;
  motion->start_us = 0;
  motion->n_skips = n_skips;
  motion->tick = gtk_widget_add_tick_callback (GTK_WIDGET (motion->canvas),
                                               on_tick, motion, NULL);
}

void
motion_end (Motion *motion)
{
  motion->part = 1;
  if (motion->tick != 0)
    gtk_widget_remove_tick_callback (GTK_WIDGET (motion->canvas), motion->tick);
  motion->tick = 0;
}
