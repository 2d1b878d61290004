/* Frames that are shared by reference, with their runs: what another thread
 * makes of one goes on when the session shows another. A kept frame never
 * changes. */
#ifndef KEPT_FRAME_H
#define KEPT_FRAME_H

#include "frame.h"
#include "run.h"

G_BEGIN_DECLS

typedef struct KeptFrame {
  int reference_count;
  Run *run; /* NULL: not shared yet */
  Frame frame;
} KeptFrame;

/* Returns: (transfer full): the frame of @trace at @step. Before others see it
 *          kept_frame_share() gives it its run, that of the trace, which is
 *          not to be shared before its hues are known. */
KeptFrame *kept_frame_new (const Trace *trace, guint step);
void kept_frame_share (KeptFrame *kept, Run *run);

KeptFrame *kept_frame_ref (KeptFrame *kept);
void kept_frame_unref (KeptFrame *kept);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (KeptFrame, kept_frame_unref)

G_END_DECLS

#endif
