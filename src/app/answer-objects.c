#include "answer-objects.h"

#define KEY "answer-objects"

/* What was listed last, and of what: whoever walks through all objects asks
 * for each of them. */
typedef struct AnswerObjects {
  const Question *question; /* as the next one: only to be compared */
  const Trace *trace;
  guint step;
  GArray *objects;  /* of Object */
  GHashTable *keys; /* of the same */
} AnswerObjects;

static void
answer_objects_free (gpointer data)
{
  AnswerObjects *list = data;

  g_array_unref (list->objects);
  g_hash_table_unref (list->keys);
  g_free (list);
}

void
answer_objects_forget (Canvas *canvas)
{
  g_object_set_data (G_OBJECT (canvas), KEY, NULL);
}

static const Question *
get_question (Canvas *canvas)
{
  return session_get_exercise (canvas_get_session (canvas))->question;
}

static gboolean
takes (Canvas *canvas, Object *object)
{
  return question_takes (get_question (canvas),
                         session_get_frame (canvas_get_session (canvas)),
                         object);
}

static void
add (Canvas *canvas, AnswerObjects *list, ObjectKind kind, guint number)
{
  Object object = { kind, number };

  if (takes (canvas, &object)
      && g_hash_table_add (
          list->keys,
          GSIZE_TO_POINTER (((gsize)object.number << 3) | object.kind)))
    g_array_append_val (list->objects, object);
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

/* All of them, sites first. */
static AnswerObjects *
list_objects (Canvas *canvas, const Frame *frame)
{
  AnswerObjects *list = g_new0 (AnswerObjects, 1);

  list->question = get_question (canvas);
  list->trace = frame->trace;
  list->step = frame->step;
  list->objects = g_array_new (FALSE, FALSE, sizeof (Object));
  list->keys = g_hash_table_new (NULL, NULL);
  for (guint i = 0; i < frame->n_sites; i++)
    add (canvas, list, OBJECT_SITE, i);
  for (guint i = 0; i < frame->n_facets; i++)
    if (is_shown (canvas, frame->facets[i].facet))
      add (canvas, list, OBJECT_FACET, frame->facets[i].facet);
  for (guint i = 0; i < frame->n_ridges; i++)
    if (is_ridge_shown (canvas, frame->ridges[i].ridge))
      add (canvas, list, OBJECT_RIDGE, frame->ridges[i].ridge);
  return list;
}

static const GArray *
get_objects (Canvas *canvas)
{
  const Frame *frame = session_get_frame (canvas_get_session (canvas));
  AnswerObjects *list = g_object_get_data (G_OBJECT (canvas), KEY);

  if (list == NULL || list->question != get_question (canvas)
      || list->trace != frame->trace || list->step != frame->step) {
    list = list_objects (canvas, frame);
    g_object_set_data_full (G_OBJECT (canvas), KEY, list, answer_objects_free);
  }
  return list->objects;
}

guint
answer_objects_count (Canvas *canvas)
{
  return get_objects (canvas)->len;
}

Object
answer_objects_get (Canvas *canvas, guint index)
{
  const GArray *objects = get_objects (canvas);

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
