#include "frame-mask.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

static void
mask_sites (Frame *masked, const Frame *frame)
{
  uint32_t i;

  masked->sites = memory_new (frame->n_sites, sizeof *masked->sites);
  for (i = 0; i < frame->n_sites; i++) {
    masked->sites[i] = frame->sites[i];
    masked->sites[i].is_changed = false;
    if (frame->sites[i].state == SITE_OUTSIDE)
      masked->sites[i].state = SITE_WAITING;
  }
}

/* What does not stand yet is not shown. */
static void
mask_facets (Frame *masked, const Frame *frame)
{
  uint32_t i;

  masked->facets = memory_new (frame->n_facets, sizeof *masked->facets);
  masked->n_facets = 0;
  for (i = 0; i < frame->n_facets; i++)
    if (frame->facets[i].roles & FACET_STANDS)
      masked->facets[masked->n_facets++]
          = (FrameFacet){ frame->facets[i].facet, FACET_STANDS };
}

void
frame_mask_init (FrameMask *mask, const Frame *frame)
{
  Frame *masked = &mask->frame;

  *masked = *frame;
  mask_sites (masked, frame);
  mask_facets (masked, frame);
  masked->horizon = NULL;
  masked->n_horizon = 0;
  masked->is_dying
      = memory_new (frame->voronoi.n_vertices, sizeof *masked->is_dying);
}

void
frame_mask_clear (FrameMask *mask)
{
  free (mask->frame.sites);
  free (mask->frame.facets);
  free (mask->frame.is_dying);
  memset (mask, 0, sizeof *mask);
}
