#include "sign-input.h"

#include "canvas-keys.h"

#include <math.h>

#define FAR_NODES 16

gboolean
sign_input_is_on (Canvas *canvas)
{
  return session_get_exhibit_kind (canvas_get_session (canvas))
         == EXHIBIT_SIGNS;
}

static void
put_node (Canvas *canvas, const double node[2])
{
  Session *session = canvas_get_session (canvas);
  ExhibitTurn turn = *session_get_turn (session);

  for (int axis = 0; axis < 2; axis++)
    turn.node[axis] = (guint)CLAMP (node[axis], 0, SIGN_MAP_SIDE - 1);
  session_set_turn (session, &turn);
}

void
sign_input_read (Canvas *canvas, const double at_px[2])
{
  const Projection projection = canvas_get_projection (canvas);
  const Point3 at = projection_unapply (&projection, at_px[0], at_px[1]);
  const double node[2] = { floor ((at.x + 1) / 2 * SIGN_MAP_SIDE),
                           floor ((at.y + 1) / 2 * SIGN_MAP_SIDE) };

  put_node (canvas, node);
}

gboolean
sign_input_key (Canvas *canvas, const GdkEventKey *event)
{
  const ExhibitTurn *turn = session_get_turn (canvas_get_session (canvas));
  const double step = event->state & GDK_SHIFT_MASK ? FAR_NODES : 1;
  double by[2];

  if (!canvas_arrow (event->keyval, by))
    return FALSE;
  put_node (canvas, (const double[]){ turn->node[0] + step * by[0],
                                      turn->node[1] - step * by[1] });
  return TRUE;
}
