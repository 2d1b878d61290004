/* Times the engine and the frame, and qhull's qdelaunay when it is there.
 * Least of several runs, in milliseconds. */
#include "frame.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <locale.h>
#include <math.h>

#define N_RUNS 5

typedef double (*Work) (const SiteSet *set);

static double
record (const SiteSet *set)
{
  const gint64 start = g_get_monotonic_time ();
  Trace *trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });
  const gint64 end = g_get_monotonic_time ();

  trace_free (trace);
  return (double)(end - start) / 1000;
}

static double
show_last_frame (const SiteSet *set)
{
  Trace *trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });
  const gint64 start = g_get_monotonic_time ();
  gint64 end;
  Frame frame;

  frame_init (&frame, trace, trace->n_events);
  end = g_get_monotonic_time ();
  frame_clear (&frame);
  trace_free (trace);
  return (double)(end - start) / 1000;
}

static double
least (Work work, const SiteSet *set)
{
  double best = INFINITY;

  for (int i = 0; i < N_RUNS; i++)
    best = fmin (best, work (set));
  return best;
}

static SiteSet *
random_set (uint32_t n)
{
  g_autofree Site *sites = g_new (Site, n);
  uint64_t state = n;

  for (uint32_t i = 0; i < n; i++)
    sites[i] = (Site){ ldexp ((double)(order_random (&state) >> 36), -28),
                       ldexp ((double)(order_random (&state) >> 36), -28) };
  return site_set_new (sites, n);
}

/* In qhull's form: dimension, count, points. */
static char *
write_for_qhull (const SiteSet *set)
{
  GString *text = g_string_new (NULL);
  char *path = NULL;
  const int file = g_file_open_tmp ("hull2vd-bench-XXXXXX", &path, NULL);

  g_assert (file >= 0 && g_close (file, NULL));
  g_string_append_printf (text, "2\n%u\n", set->n_sites);
  for (uint32_t i = 0; i < set->n_sites; i++)
    g_string_append_printf (text, "%.17g %.17g\n", set->sites[i].x,
                            set->sites[i].y);
  g_assert (g_file_set_contents (path, text->str, -1, NULL));
  g_string_free (text, TRUE);
  return path;
}

static double
run_qdelaunay (const SiteSet *set)
{
  g_autofree char *path = write_for_qhull (set);
  const char *arguments[]
      = { "qdelaunay", "TI", path, "TO", "/dev/null", NULL };
  const gint64 start = g_get_monotonic_time ();
  const gboolean is_done
      = g_spawn_sync (NULL, (char **)arguments, NULL,
                      G_SPAWN_SEARCH_PATH | G_SPAWN_STDOUT_TO_DEV_NULL
                          | G_SPAWN_STDERR_TO_DEV_NULL,
                      NULL, NULL, NULL, NULL, NULL, NULL);
  const gint64 end = g_get_monotonic_time ();

  g_unlink (path);
  return is_done ? (double)(end - start) / 1000 : NAN;
}

int
main (void)
{
  static const uint32_t sizes[] = { 8, 256, 1000, 2000, 10000 };

  setlocale (LC_ALL, "C");
  g_print ("%7s %12s %12s %12s %8s\n", "sites", "record ms", "frame ms",
           "qdelaunay ms", "ratio");
  for (guint i = 0; i < G_N_ELEMENTS (sizes); i++) {
    SiteSet *set = random_set (sizes[i]);
    const double ours = least (record, set);
    const double theirs = least (run_qdelaunay, set);

    g_print ("%7u %12.3f %12.3f %12.3f %8.2f\n", sizes[i], ours,
             least (show_last_frame, set), theirs, ours / theirs);
    site_set_free (set);
  }
  return 0;
}
