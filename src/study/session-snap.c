/* The grid on which the mouse puts sites. */
#include "session-private.h"

#include <math.h>

/* The grid has this many steps, as a power of two, from the centre of the view
 * to its border; without snapping, more than there are pixels. */
#define GRID_BITS 6
#define FREE_BITS 16

gboolean
session_get_snaps (Session *session)
{
  return !session->is_free;
}

void
session_set_snaps (Session *session, gboolean snaps)
{
  if (snaps == !session->is_free)
    return;
  session->is_free = !snaps;
  session_tell (session, CHANGED_LOOK);
}

/* The binary exponent of the grid, in units of SiteSet.sites. */
static int
grid_exponent (Session *session)
{
  const double zoom = MAX (session->plane_camera.zoom, 1);

  return ilogb (session->look.extent.radius / zoom)
         - (session->is_free ? FREE_BITS : GRID_BITS);
}

double
session_get_grid (Session *session)
{
  return ldexp (1, grid_exponent (session) + session->run->set->exponent);
}

static double
snap (double coordinate, int exponent)
{
  const double steps = ldexp (coordinate, -exponent);

  /* Beyond 2^53 steps doubles are coarser than the grid. */
  return fabs (steps) < 0x1p53 ? ldexp (nearbyint (steps), exponent)
                               : coordinate;
}

Site
session_snap (Session *session, Site point)
{
  const int exponent = grid_exponent (session);
  const int given = session->run->set->exponent;

  return (Site){ ldexp (snap (point.x, exponent), given),
                 ldexp (snap (point.y, exponent), given) };
}
