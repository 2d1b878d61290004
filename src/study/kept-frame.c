#include "kept-frame.h"

KeptFrame *
kept_frame_new (const Trace *trace, guint step)
{
  KeptFrame *kept = g_new0 (KeptFrame, 1);

  kept->reference_count = 1;
  frame_init (&kept->frame, trace, step);
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
