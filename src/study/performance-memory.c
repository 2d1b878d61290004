/* A performance as JSON: [{"objects": ["f3"], "shown": false, "at-once": true,
 * "undone": 0, "hinted": 1}, …], a row for each task that is settled. */
#include "performance.h"
#include "progress.h"

JsonArray *
performance_remember (const Performance *performance)
{
  JsonArray *tasks = json_array_new ();

  for (guint i = 0; i < performance->tasks->len; i++) {
    const Task *task = g_ptr_array_index (performance->tasks, i);
    const Exercise *exercise = task->exercise;
    JsonObject *memory;

    if (!task->is_settled)
      break;
    memory = exercise_remember (exercise);
    json_object_set_boolean_member (memory, "at-once",
                                    exercise->was_right_at_once);
    json_object_set_int_member (memory, "undone", exercise->n_undone);
    json_object_set_int_member (memory, "hinted", exercise->n_hints);
    json_array_add_object_element (tasks, memory);
  }
  return tasks;
}

static gint64
get_number (JsonObject *memory, const char *name, guint most)
{
  JsonNode *node = json_object_get_member (memory, name);

  return node != NULL && json_node_get_value_type (node) == G_TYPE_INT64
             ? CLAMP (json_node_get_int (node), 0, most)
             : 0;
}

static gboolean
get_flag (JsonObject *memory, const char *name)
{
  JsonNode *node = json_object_get_member (memory, name);

  return node != NULL && json_node_get_value_type (node) == G_TYPE_BOOLEAN
         && json_node_get_boolean (node);
}

/* What was answered is graded again. */
static gboolean
recall_task (Task *task, JsonObject *memory)
{
  Exercise *exercise = task->exercise;

  if (!exercise_recall (exercise, memory))
    return FALSE;
  exercise->n_undone = (guint)get_number (memory, "undone", G_MAXUINT16);
  exercise->n_hints
      = (guint)get_number (memory, "hinted", exercise->question->hints->len);
  exercise->was_right_at_once = get_flag (memory, "at-once")
                                && exercise->verdict != NULL
                                && exercise->verdict->is_right;
  return TRUE;
}

void
performance_recall (Performance *performance, JsonArray *tasks)
{
  for (guint i = 0; i < json_array_get_length (tasks); i++) {
    JsonNode *node = json_array_get_element (tasks, i);

    if (!JSON_NODE_HOLDS_OBJECT (node)
        || !recall_task (performance_task (performance),
                         json_node_get_object (node)))
      return;
    performance_settle (performance);
    if (!performance_advance (performance))
      return;
  }
}
