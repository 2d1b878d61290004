/* The file of a person's progress: JSON, one object. */
#include "document.h"
#include "input.h"
#include "progress.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <stdio.h>

#define MOST_KEPT 1000

G_DEFINE_QUARK (progress - error - quark, progress_error)

/* Writing */

static void
add_text (JsonBuilder *builder, const char *name, const char *text)
{
  json_builder_set_member_name (builder, name);
  json_builder_add_string_value (builder, text);
}

static void
add_number (JsonBuilder *builder, const char *name, gint64 number)
{
  json_builder_set_member_name (builder, name);
  json_builder_add_int_value (builder, number);
}

static void
add_seconds (JsonBuilder *builder, double seconds)
{
  json_builder_set_member_name (builder, "seconds");
  json_builder_add_double_value (builder, seconds);
}

static void
add_question (JsonBuilder *builder, const QuestionRecord *record)
{
  json_builder_begin_object (builder);
  add_text (builder, "question", record->key);
  add_text (builder, "title", record->title);
  add_number (builder, "stop", record->stop);
  add_text (builder, "outcome", outcome_name (record->outcome));
  add_number (builder, "total", record->total);
  add_number (builder, "correct", record->correct);
  add_number (builder, "checks", record->n_checks);
  add_number (builder, "hinted", record->hinted);
  add_number (builder, "undone", record->undone);
  add_seconds (builder, record->seconds);
  add_number (builder, "answered", record->answered);
  if (record->memory != NULL) {
    JsonNode *node = json_node_new (JSON_NODE_OBJECT);

    json_node_set_object (node, record->memory);
    json_builder_set_member_name (builder, "answer");
    json_builder_add_value (builder, node);
  }
  json_builder_end_object (builder);
}

static void
add_lesson (JsonBuilder *builder, const LessonRecord *record)
{
  json_builder_begin_object (builder);
  add_text (builder, "lesson", record->key);
  add_text (builder, "title", record->title);
  add_number (builder, "stop", record->stop);
  add_number (builder, "furthest", record->furthest);
  add_number (builder, "stops", record->n_stops);
  add_seconds (builder, record->seconds);
  add_number (builder, "first", record->first);
  add_number (builder, "last", record->last);
  json_builder_set_member_name (builder, "questions");
  json_builder_begin_array (builder);
  for (guint i = 0; i < record->questions->len; i++)
    add_question (builder, g_ptr_array_index (record->questions, i));
  json_builder_end_array (builder);
  json_builder_end_object (builder);
}

static char *
to_json (const Progress *progress, gsize *length)
{
  g_autoptr (JsonBuilder) builder = json_builder_new ();
  g_autoptr (JsonGenerator) generator = json_generator_new ();
  g_autoptr (JsonNode) root = NULL;

  json_builder_begin_object (builder);
  add_number (builder, "format", PROGRESS_FORMAT);
  add_text (builder, "learner", progress->learner);
  json_builder_set_member_name (builder, "lessons");
  json_builder_begin_array (builder);
  for (guint i = 0; i < progress->lessons->len; i++)
    add_lesson (builder, g_ptr_array_index (progress->lessons, i));
  json_builder_end_array (builder);
  json_builder_end_object (builder);
  root = json_builder_get_root (builder);
  json_generator_set_pretty (generator, TRUE);
  json_generator_set_root (generator, root);
  return json_generator_to_data (generator, length);
}

/* Reading */

typedef struct Reading {
  const char *path;
  GError **error;
} Reading;

static gboolean
refuse (const Reading *reading, const char *reason)
{
  g_autofree char *shown = g_filename_display_name (reading->path);

  g_set_error (reading->error, PROGRESS_ERROR, PROGRESS_ERROR_BROKEN, "%s: %s",
               shown, reason);
  return FALSE;
}

static gboolean
get_text (const Reading *reading,
          JsonObject *object,
          const char *name,
          char **text)
{
  JsonNode *node = json_object_get_member (object, name);
  g_autofree char *reason = NULL;

  if (node != NULL && json_node_get_value_type (node) == G_TYPE_STRING) {
    g_free (*text);
    *text = json_node_dup_string (node);
    return TRUE;
  }
  reason = g_strdup_printf (_ ("“%s” is missing or is not text"), name);
  return refuse (reading, reason);
}

static gboolean
get_number (const Reading *reading,
            JsonObject *object,
            const char *name,
            gint64 *number)
{
  JsonNode *node = json_object_get_member (object, name);
  g_autofree char *reason = NULL;

  if (node != NULL && json_node_get_value_type (node) == G_TYPE_INT64
      && json_node_get_int (node) >= 0) {
    *number = json_node_get_int (node);
    return TRUE;
  }
  reason
      = g_strdup_printf (_ ("“%s” is missing or is not a whole number"), name);
  return refuse (reading, reason);
}

static gboolean
get_count (const Reading *reading,
           JsonObject *object,
           const char *name,
           guint *count)
{
  gint64 number;

  if (!get_number (reading, object, name, &number))
    return FALSE;
  *count = (guint)MIN (number, G_MAXINT32);
  return TRUE;
}

/* A whole number of seconds is one, too. */
static gboolean
get_seconds (const Reading *reading, JsonObject *object, double *seconds)
{
  JsonNode *node = json_object_get_member (object, "seconds");
  const GType type
      = node == NULL ? G_TYPE_INVALID : json_node_get_value_type (node);

  if (type != G_TYPE_DOUBLE && type != G_TYPE_INT64)
    return refuse (reading, _ ("“seconds” is missing or is not a number"));
  *seconds = MAX (json_node_get_double (node), 0);
  return TRUE;
}

static JsonObject *
get_object (JsonNode *node)
{
  return node != NULL && JSON_NODE_HOLDS_OBJECT (node)
             ? json_node_get_object (node)
             : NULL;
}

static JsonArray *
get_array (const Reading *reading, JsonObject *object, const char *name)
{
  JsonNode *node = json_object_get_member (object, name);
  g_autofree char *reason = NULL;

  if (node != NULL && JSON_NODE_HOLDS_ARRAY (node))
    return json_node_get_array (node);
  reason = g_strdup_printf (_ ("“%s” is missing or is not a list"), name);
  refuse (reading, reason);
  return NULL;
}

static gboolean
get_outcome (const Reading *reading, JsonObject *object, Outcome *outcome)
{
  g_autofree char *name = NULL;

  return get_text (reading, object, "outcome", &name)
         && (outcome_parse (name, outcome)
             || refuse (reading, _ ("there is no such outcome")));
}

static gboolean
read_question (const Reading *reading, JsonNode *node, LessonRecord *lesson)
{
  JsonObject *object = get_object (node);
  JsonObject *memory;
  g_autofree char *key = NULL;
  QuestionRecord *record;

  if (object == NULL)
    return refuse (reading, _ ("a question is not an object"));
  if (!get_text (reading, object, "question", &key))
    return FALSE;
  record = lesson_record_question (lesson, key);
  memory = get_object (json_object_get_member (object, "answer"));
  if (memory != NULL && record->memory == NULL)
    record->memory = json_object_ref (memory);
  return get_text (reading, object, "title", &record->title)
         && get_count (reading, object, "stop", &record->stop)
         && get_outcome (reading, object, &record->outcome)
         && get_count (reading, object, "total", &record->total)
         && get_count (reading, object, "correct", &record->correct)
         && get_count (reading, object, "checks", &record->n_checks)
         && get_count (reading, object, "hinted", &record->hinted)
         && get_count (reading, object, "undone", &record->undone)
         && get_seconds (reading, object, &record->seconds)
         && get_number (reading, object, "answered", &record->answered);
}

static gboolean
read_lesson (const Reading *reading, JsonNode *node, Progress *progress)
{
  JsonObject *object = get_object (node);
  g_autofree char *key = NULL;
  LessonRecord *record;
  JsonArray *questions;

  if (object == NULL)
    return refuse (reading, _ ("a lesson is not an object"));
  if (!get_text (reading, object, "lesson", &key))
    return FALSE;
  record = progress_lesson (progress, key);
  questions = get_array (reading, object, "questions");
  if (questions == NULL || !get_text (reading, object, "title", &record->title)
      || !get_count (reading, object, "stop", &record->stop)
      || !get_count (reading, object, "furthest", &record->furthest)
      || !get_count (reading, object, "stops", &record->n_stops)
      || !get_seconds (reading, object, &record->seconds)
      || !get_number (reading, object, "first", &record->first)
      || !get_number (reading, object, "last", &record->last))
    return FALSE;
  for (guint i = 0; i < json_array_get_length (questions); i++)
    if (!read_question (reading, json_array_get_element (questions, i), record))
      return FALSE;
  return TRUE;
}

static gboolean
check_format (const Reading *reading, JsonObject *root)
{
  g_autofree char *shown = g_filename_display_name (reading->path);
  gint64 format;

  if (!get_number (reading, root, "format", &format))
    return FALSE;
  if (format <= PROGRESS_FORMAT)
    return TRUE;
  g_set_error (reading->error, PROGRESS_ERROR, PROGRESS_ERROR_NEWER,
               _ ("%s: it was written by a newer Hull2VD, in format %d; this "
                  "one knows format %d"),
               shown, (int)MIN (format, G_MAXINT), PROGRESS_FORMAT);
  return FALSE;
}

static gboolean
read_root (const Reading *reading, JsonNode *node, Progress *progress)
{
  JsonObject *root = get_object (node);
  JsonArray *lessons;

  if (root == NULL)
    return refuse (reading, _ ("it is not an object"));
  if (!check_format (reading, root)
      || !get_text (reading, root, "learner", &progress->learner))
    return FALSE;
  lessons = get_array (reading, root, "lessons");
  if (lessons == NULL)
    return FALSE;
  for (guint i = 0; i < json_array_get_length (lessons); i++)
    if (!read_lesson (reading, json_array_get_element (lessons, i), progress))
      return FALSE;
  return TRUE;
}

/* Returns: (transfer full): FILE:LINE, as the parser of JSON tells. */
static char *
place_of (const char *path, const GError *error)
{
  g_autofree char *shown = g_filename_display_name (path);
  guint line = 1;

  if (error != NULL)
    (void)sscanf (error->message, "<data>:%u:", &line);
  return g_strdup_printf ("%s:%u", shown, line);
}

static gboolean
parse (const Reading *reading, const char *text, gsize length, Progress *into)
{
  g_autoptr (JsonParser) parser = json_parser_new ();
  g_autofree char *place = NULL;
  g_autoptr (GError) error = NULL;

  if (length > PROGRESS_MAX_BYTES)
    return refuse (reading, _ ("it is too large"));
  if (!g_utf8_validate (text, (gssize)length, NULL))
    return refuse (reading, _ ("it is not UTF-8"));
  if (json_parser_load_from_data (parser, text, (gssize)length, &error)
      && json_parser_get_root (parser) != NULL)
    return read_root (reading, json_parser_get_root (parser), into);
  place = place_of (reading->path, error);
  g_set_error (reading->error, PROGRESS_ERROR, PROGRESS_ERROR_BROKEN,
               _ ("%s: not valid JSON from here on"), place);
  return FALSE;
}

gboolean
progress_read (Progress *progress, GError **error)
{
  const Reading reading = { progress->path, error };
  g_autofree char *shown = g_filename_display_name (progress->path);
  gsize length;
  g_autofree char *text = input_read (progress->path, &length, NULL);
  const int reason = errno;

  g_ptr_array_set_size (progress->lessons, 0);
  if (text == NULL) {
    g_set_error (error, PROGRESS_ERROR,
                 reason == ENOENT ? PROGRESS_ERROR_MISSING
                                  : PROGRESS_ERROR_CANNOT_OPEN,
                 "%s: %s", shown, g_strerror (reason));
    return FALSE;
  }
  if (parse (&reading, text, length, progress))
    return TRUE;
  g_ptr_array_set_size (progress->lessons, 0);
  return FALSE;
}

/* Keeping */

/* Returns: (transfer full): where the file is now, or NULL. */
static char *
keep_aside (const char *path)
{
  for (guint i = 1; i <= MOST_KEPT; i++) {
    g_autofree char *kept = g_strdup_printf ("%s.kept-%u", path, i);

    if (!g_file_test (kept, G_FILE_TEST_EXISTS))
      return g_rename (path, kept) == 0 ? g_steal_pointer (&kept) : NULL;
  }
  return NULL;
}

char *
progress_open (Progress *progress)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *kept = NULL;

  if (progress_read (progress, &error) || error->code == PROGRESS_ERROR_MISSING)
    return NULL;
  if (error->code != PROGRESS_ERROR_CANNOT_OPEN)
    kept = keep_aside (progress->path);
  if (kept == NULL)
    return g_strdup (error->message);
  return g_strdup_printf (
      _ ("%s. It is kept as %s, and progress starts afresh."), error->message,
      kept);
}

/* What others have written since. */
static void
merge (Progress *progress)
{
  g_autoptr (Progress) fresh = progress_new (progress->path);

  if (progress_read (fresh, NULL))
    progress_merge (progress, fresh);
}

static gboolean
write_merged (Progress *progress, GError **error)
{
  g_autofree char *text = NULL;
  gsize length;

  if (!progress->is_cleared)
    merge (progress);
  text = to_json (progress, &length);
  return document_write (progress->path, text, length, error);
}

gboolean
progress_write (Progress *progress, GError **error)
{
  g_autofree char *folder = g_path_get_dirname (progress->path);
  gboolean is_written;
  int lock;

  if (!progress->is_changed)
    return TRUE;
  if (g_mkdir_with_parents (folder, 0700) != 0) {
    g_set_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_WRITE, "%s: %s",
                 folder, g_strerror (errno));
    return FALSE;
  }
  lock = progress_lock (folder);
  is_written = write_merged (progress, error);
  progress_unlock (lock);
  if (!is_written)
    return FALSE;
  for (guint i = 0; i < progress->lessons->len; i++)
    ((LessonRecord *)g_ptr_array_index (progress->lessons, i))->is_changed
        = FALSE;
  progress->is_changed = FALSE;
  progress->is_cleared = FALSE;
  return TRUE;
}

char *
progress_clear (Progress *progress)
{
  g_autofree char *kept = g_strconcat (progress->path, "~", NULL);
  const gboolean is_kept = g_rename (progress->path, kept) == 0;

  g_ptr_array_set_size (progress->lessons, 0);
  progress->is_changed = TRUE;
  progress->is_cleared = TRUE;
  return is_kept ? g_steal_pointer (&kept) : NULL;
}
