/* Measures how long the main loop of a program of GTK is kept from the next
 * event: GTK_MODULES=…/loop-watch.so HULL2VD_LOOP_WATCH=FILE PROGRAM
 *
 * FILE holds a LoopWatch, which another program reads, and clears, meanwhile.
 */
#include <gtk/gtk.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

/* Of the longest time between two questions for events, since it was cleared:
 * by the clock, and what the thread itself has worked in it. */
typedef struct LoopWatch {
  double longest_ms;
  double worked_ms;
} LoopWatch;

static LoopWatch *watch;
static double left_ms, left_worked_ms; /* when the last question was answered */

void gtk_module_init (const int *argc, char ***argv);

static double
milliseconds (clockid_t clock)
{
  struct timespec time;

  clock_gettime (clock, &time);
  return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

static int
ask (GPollFD *files, guint n_files, int timeout_ms)
{
  const double ms = milliseconds (CLOCK_MONOTONIC) - left_ms;
  const double worked_ms
      = milliseconds (CLOCK_THREAD_CPUTIME_ID) - left_worked_ms;
  int result;

  watch->longest_ms = MAX (watch->longest_ms, ms);
  watch->worked_ms = MAX (watch->worked_ms, worked_ms);
  result = g_poll (files, n_files, timeout_ms);
  left_ms = milliseconds (CLOCK_MONOTONIC);
  left_worked_ms = milliseconds (CLOCK_THREAD_CPUTIME_ID);
  return result;
}

void
gtk_module_init (const int *argc, char ***argv)
{
  const char *path = g_getenv ("HULL2VD_LOOP_WATCH");
  const int file = path == NULL ? -1 : open (path, O_RDWR);

  (void)argc;
  (void)argv;
  if (file < 0)
    return;
  watch
      = mmap (NULL, sizeof *watch, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close (file);
  if (watch == MAP_FAILED)
    return;
  left_ms = milliseconds (CLOCK_MONOTONIC);
  left_worked_ms = milliseconds (CLOCK_THREAD_CPUTIME_ID);
  g_main_context_set_poll_func (NULL, ask);
}
