#include "answer-objects.h"

static gboolean
takes (Canvas *canvas, Object *object)
{
  Session *session = canvas_get_session (canvas);

  return question_takes (session_get_exercise (session)->question,
                         session_get_frame (session), object);
}

static void
add (Canvas *canvas, GArray *objects, ObjectKind kind, guint number)
{
  Object object = { kind, number };

  if (!takes (canvas, &object))
    return;
  for (guint i = 0; i < objects->len; i++)
    if (object_equal (g_array_index (objects, Object, i), object))
      return;
  g_array_append_val (objects, object);
}

/* In the plane only what has a shadow can be pointed at. */
static gboolean
is_shown (Canvas *canvas, guint facet)
{
  return HULL2VD_CANVAS_GET_CLASS (canvas)->is_space
         || session_get_trace (canvas_get_session (canvas))
                    ->facets[facet]
                    .facing
                == FACING_LOWER;
}

/* Of the hull's ridges only those of lower facets have a line there. */
static gboolean
is_ridge_shown (Canvas *canvas, guint ridge)
{
  const RidgeRow row
      = trace_ridge (session_get_trace (canvas_get_session (canvas)), ridge);

  return is_shown (canvas, row.facet[0]) || is_shown (canvas, row.facet[1]);
}

/* Returns: (transfer full): all of them, sites first. */
static GArray *
list_objects (Canvas *canvas)
{
  const Frame *frame = session_get_frame (canvas_get_session (canvas));
  GArray *objects = g_array_new (FALSE, FALSE, sizeof (Object));

  for (guint i = 0; i < frame->n_sites; i++)
    add (canvas, objects, OBJECT_SITE, i);
  for (guint i = 0; i < frame->n_facets; i++)
    if (is_shown (canvas, frame->facets[i].facet))
      add (canvas, objects, OBJECT_FACET, frame->facets[i].facet);
  for (guint i = 0; i < frame->n_ridges; i++)
    if (is_ridge_shown (canvas, frame->ridges[i].ridge))
      add (canvas, objects, OBJECT_RIDGE, frame->ridges[i].ridge);
  return objects;
}

guint
answer_objects_count (Canvas *canvas)
{
  g_autoptr (GArray) objects = list_objects (canvas);

  return objects->len;
}

Object
answer_objects_get (Canvas *canvas, guint index)
{
  g_autoptr (GArray) objects = list_objects (canvas);

  return index < objects->len ? g_array_index (objects, Object, index)
                              : (Object){ OBJECT_NONE, 0 };
}

Object
answer_objects_pick (Canvas *canvas,
                     const Scene *scene,
                     const double at_px[2],
                     double reach_px)
{
  const Projection projection = canvas_get_projection (canvas);
  Scene filtered = *scene;
  Object picked;

  filtered.items
      = g_memdup2 (scene->items, scene->n_items * sizeof *scene->items);
  for (guint i = 0; i < filtered.n_items; i++) {
    Object *object = &filtered.items[i].object;

    if (object->kind != OBJECT_NONE && !takes (canvas, object))
      *object = (Object){ OBJECT_NONE, 0 };
  }
  picked = scene_pick (&filtered, &projection, at_px, reach_px);
  g_free (filtered.items);
  return picked;
}

void
canvas_answer (Canvas *canvas, Object object)
{
  Session *session = canvas_get_session (canvas);

  canvas_set_cursor (canvas, object);
  if (session_is_answering (session))
    session_answer_toggle (session, object);
  else
    session_set_selection (session, object);
}
