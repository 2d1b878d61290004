/* An answer as JSON: {"objects": ["f3", "s2", "1"], "numbers": [4],
 * "sites": [[0.5, 1], …], "shown": true}; of a performance {"tasks": …}.
 * Options are told by their number. */
#include "object-name.h"
#include "performance.h"
#include "progress.h"
#include "words.h"

static JsonArray *
write_objects (const Attempt *attempt)
{
  JsonArray *array = json_array_new ();

  for (guint i = 0; i < attempt->objects->len; i++) {
    const Object object = g_array_index (attempt->objects, Object, i);
    char name[OBJECT_NAME_ROOM];

    if (object.kind == OBJECT_NONE)
      g_snprintf (name, sizeof name, "%u", object.number);
    else
      object_name_write (object, name);
    json_array_add_string_element (array, name);
  }
  return array;
}

static JsonArray *
write_numbers (const Attempt *attempt)
{
  JsonArray *array = json_array_new ();

  for (guint i = 0; i < attempt->numbers->len; i++)
    json_array_add_int_element (array,
                                g_array_index (attempt->numbers, gint64, i));
  return array;
}

static JsonArray *
write_sites (const Run *run)
{
  JsonArray *array = json_array_new ();
  g_autofree Site *sites = run_given (run);

  for (guint i = 0; i < run->set->n_sites; i++) {
    JsonArray *site = json_array_new ();

    json_array_add_double_element (site, sites[i].x);
    json_array_add_double_element (site, sites[i].y);
    json_array_add_array_element (array, site);
  }
  return array;
}

JsonObject *
exercise_remember (const Exercise *exercise)
{
  const Attempt *attempt = exercise->attempt;
  JsonObject *memory;

  memory = json_object_new ();
  if (exercise->performance != NULL)
    json_object_set_array_member (memory, "tasks",
                                  performance_remember (exercise->performance));
  if (attempt->objects->len > 0)
    json_object_set_array_member (memory, "objects", write_objects (attempt));
  if (attempt->numbers->len > 0)
    json_object_set_array_member (memory, "numbers", write_numbers (attempt));
  if (attempt->run != NULL)
    json_object_set_array_member (memory, "sites", write_sites (attempt->run));
  json_object_set_boolean_member (memory, "shown", exercise->is_shown);
  return memory;
}

/* Back: each part goes through what a person's hand goes through. */

static JsonArray *
get_array (JsonObject *memory, const char *name)
{
  JsonNode *node = json_object_get_member (memory, name);

  return node != NULL && JSON_NODE_HOLDS_ARRAY (node)
             ? json_node_get_array (node)
             : NULL;
}

static gboolean
read_object (JsonNode *node, Object *object)
{
  const char *name;
  guint64 number;

  if (json_node_get_value_type (node) != G_TYPE_STRING)
    return FALSE;
  name = json_node_get_string (node);
  if (!words_parse_number (name, G_MAXUINT32 - 1, &number))
    return object_name_parse (name, object) && object->kind != OBJECT_NONE;
  *object = (Object){ OBJECT_NONE, (guint32)number };
  return TRUE;
}

static gboolean
recall_objects (Exercise *exercise, JsonArray *array)
{
  for (guint i = 0; array != NULL && i < json_array_get_length (array); i++) {
    Object object;

    if (!read_object (json_array_get_element (array, i), &object)
        || attempt_has (exercise->attempt, object)
        || !exercise_toggle (exercise, object))
      return FALSE;
  }
  return TRUE;
}

static gboolean
recall_numbers (Exercise *exercise, JsonArray *array)
{
  for (guint i = 0; array != NULL && i < json_array_get_length (array); i++) {
    JsonNode *node = json_array_get_element (array, i);

    if (json_node_get_value_type (node) != G_TYPE_INT64
        || i >= exercise->attempt->numbers->len)
      return FALSE;
    exercise_set_number (exercise, i, json_node_get_int (node));
  }
  return TRUE;
}

static gboolean
read_site (JsonNode *node, Site *site)
{
  JsonArray *pair
      = JSON_NODE_HOLDS_ARRAY (node) ? json_node_get_array (node) : NULL;

  if (pair == NULL || json_array_get_length (pair) != 2)
    return FALSE;
  for (guint i = 0; i < 2; i++) {
    JsonNode *number = json_array_get_element (pair, i);

    if (!JSON_NODE_HOLDS_VALUE (number)
        || (json_node_get_value_type (number) != G_TYPE_DOUBLE
            && json_node_get_value_type (number) != G_TYPE_INT64))
      return FALSE;
  }
  *site = (Site){ json_array_get_double_element (pair, 0),
                  json_array_get_double_element (pair, 1) };
  return TRUE;
}

static gboolean
recall_sites (Exercise *exercise, JsonArray *array)
{
  const guint n = array == NULL ? 0 : json_array_get_length (array);
  g_autofree Site *sites = g_new (Site, MAX (n, 1));
  g_autoptr (Run) run = NULL;

  if (array == NULL)
    return TRUE;
  if (n == 0 || n > QUESTION_MAX_SITES)
    return FALSE;
  for (guint i = 0; i < n; i++)
    if (!read_site (json_array_get_element (array, i), &sites[i]))
      return FALSE;
  run = run_new (sites, n, &exercise->run->trace->order);
  if (run != NULL)
    exercise_set_run (exercise, run);
  return run != NULL;
}

static gboolean
was_shown (JsonObject *memory)
{
  JsonNode *node = json_object_get_member (memory, "shown");

  return node == NULL || json_node_get_value_type (node) != G_TYPE_BOOLEAN
         || json_node_get_boolean (node);
}

/* As if nothing had been answered. */
static gboolean
forget (Exercise *exercise)
{
  attempt_free (exercise->attempt);
  exercise->attempt = attempt_new (exercise->question);
  g_ptr_array_set_size (exercise->undo, 0);
  return FALSE;
}

gboolean
exercise_recall (Exercise *exercise, JsonObject *memory)
{
  if (exercise->performance != NULL) {
    JsonArray *tasks = get_array (memory, "tasks");

    if (tasks != NULL)
      performance_recall (exercise->performance, tasks);
    exercise_finish (exercise);
    return tasks != NULL;
  }
  if (!recall_objects (exercise, get_array (memory, "objects"))
      || !recall_numbers (exercise, get_array (memory, "numbers"))
      || !recall_sites (exercise, get_array (memory, "sites")))
    return forget (exercise);
  g_ptr_array_set_size (exercise->undo, 0);
  exercise->is_open = FALSE;
  exercise->is_shown = was_shown (memory);
  if (!attempt_is_empty (exercise->attempt))
    exercise->verdict = attempt_grade (exercise->attempt, exercise->question,
                                       &exercise->occasion);
  return TRUE;
}
