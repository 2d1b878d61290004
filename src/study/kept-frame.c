#include "kept-frame.h"

/* Facets ever born, from which on a second thread is worth its start. */
#define LARGE_TRACE 20000

static gpointer
add_diagrams (gpointer frame)
{
  frame_add_diagrams (frame);
  return NULL;
}

/* The main loop waits for what a step shows: of many sites two threads make
 * it. */
static void
make (Frame *frame, const Trace *trace, guint step)
{
  GThread *thread = NULL;

  frame_begin (frame, trace, step);
  if (trace->n_facets >= LARGE_TRACE)
    thread = g_thread_try_new ("diagrams", add_diagrams, frame, NULL);
  frame_add_hull (frame);
  if (thread != NULL)
    g_thread_join (thread);
  else
    frame_add_diagrams (frame);
  frame_end (frame);
}

KeptFrame *
kept_frame_new (const Trace *trace, guint step)
{
  KeptFrame *kept = g_new0 (KeptFrame, 1);

  kept->reference_count = 1;
  make (&kept->frame, trace, step);
  return kept;
}

void
kept_frame_share (KeptFrame *kept, Run *run)
{
  g_assert (kept->run == NULL && kept->frame.trace == run->trace);
  kept->run = run_ref (run);
}

KeptFrame *
kept_frame_ref (KeptFrame *kept)
{
  g_atomic_int_inc (&kept->reference_count);
  return kept;
}

void
kept_frame_unref (KeptFrame *kept)
{
  if (!g_atomic_int_dec_and_test (&kept->reference_count))
    return;
  frame_clear (&kept->frame);
  g_clear_pointer (&kept->run, run_unref);
  g_free (kept);
}
