/* A frame without what its round has found: what is shown while a question
 * about the round is open. */
#ifndef FRAME_MASK_H
#define FRAME_MASK_H

#include "frame.h"

typedef struct FrameMask {
  Frame frame; /* as the frame that is masked, but that facets only stand, and
                  that there is no horizon and no dying vertex */
} FrameMask;

/* The current site stays. Shares the diagrams of @frame, which must outlive
 * it. */
void frame_mask_init (FrameMask *mask, const Frame *frame);
void frame_mask_clear (FrameMask *mask);

#endif
