#include "results.h"

#include <string.h>

#define HOME "https://hull2vd.github.io"
#define VERBS "http://adlnet.gov/expapi/verbs/"
#define ACTIVITIES "http://adlnet.gov/expapi/activities/"

static const char *
who (const Progress *progress, const char *name)
{
  return name != NULL && *name != '\0' ? name : progress->learner;
}

/* Returns: (transfer full): "2026-11-26T02:03:04Z", or "" for never. */
static char *
time_text (gint64 seconds)
{
  g_autoptr (GDateTime) time
      = seconds == 0 ? NULL : g_date_time_new_from_unix_utc (seconds);

  return time == NULL ? g_strdup ("")
                      : g_date_time_format (time, "%Y-%m-%dT%H:%M:%SZ");
}

/* Tenths, the same in every locale. */
static char *
seconds_text (double seconds)
{
  char text[G_ASCII_DTOSTR_BUF_SIZE];

  return g_strdup (g_ascii_formatd (text, sizeof text, "%.1f", seconds));
}

static gint
compare_stops (gconstpointer left, gconstpointer right)
{
  const QuestionRecord *a = *(QuestionRecord *const *)left;
  const QuestionRecord *b = *(QuestionRecord *const *)right;

  return (a->stop > b->stop) - (a->stop < b->stop);
}

/* Returns: (transfer container): its questions in the order of its stops,
 *          whichever was met first, or kept first. */
static GPtrArray *
questions_of (const LessonRecord *lesson)
{
  GPtrArray *records = g_ptr_array_new ();

  g_ptr_array_extend (records, lesson->questions, NULL, NULL);
  g_ptr_array_sort (records, compare_stops);
  return records;
}

/* CSV */

static void
add_field (GString *csv, const char *field)
{
  if (csv->len > 0 && csv->str[csv->len - 1] != '\n')
    g_string_append_c (csv, ',');
  if (strpbrk (field, ",\"\r\n") == NULL) {
    g_string_append (csv, field);
    return;
  }
  g_string_append_c (csv, '"');
  for (; *field != '\0'; field++)
    g_string_append (csv, *field == '"' ? "\"\"" : (char[]){ *field, '\0' });
  g_string_append_c (csv, '"');
}

static void
add_count (GString *csv, guint count)
{
  g_string_append_printf (csv, ",%u", count);
}

static void
add_row (GString *csv,
         const char *person,
         const LessonRecord *lesson,
         const QuestionRecord *record)
{
  g_autofree char *seconds = seconds_text (record->seconds);
  g_autofree char *answered = time_text (record->answered);

  add_field (csv, person);
  add_field (csv, lesson->key);
  add_field (csv, lesson->title);
  add_count (csv, record->stop + 1);
  add_field (csv, record->title);
  add_field (csv, record->key);
  add_field (csv, outcome_name (record->outcome));
  add_count (csv, record->total);
  add_count (csv, record->correct);
  add_count (csv, record->n_checks);
  add_count (csv, record->hinted);
  add_count (csv, record->undone);
  add_field (csv, seconds);
  add_field (csv, answered);
  g_string_append (csv, "\r\n");
}

char *
results_csv (const Progress *progress, const char *name)
{
  GString *csv = g_string_new (
      "person,lesson,lesson title,stop,stop title,question,outcome,total,"
      "correct,checks,hinted,undone,seconds,answered\r\n");

  for (guint i = 0; i < progress->lessons->len; i++) {
    const LessonRecord *lesson = g_ptr_array_index (progress->lessons, i);
    g_autoptr (GPtrArray) questions = questions_of (lesson);

    for (guint k = 0; k < questions->len; k++)
      add_row (csv, who (progress, name), lesson,
               g_ptr_array_index (questions, k));
  }
  return g_string_free (csv, FALSE);
}

/* xAPI */

static void
put (JsonBuilder *builder, const char *name, const char *text)
{
  json_builder_set_member_name (builder, name);
  json_builder_add_string_value (builder, text);
}

static void
begin (JsonBuilder *builder, const char *name)
{
  json_builder_set_member_name (builder, name);
  json_builder_begin_object (builder);
}

static void
put_number (JsonBuilder *builder, const char *name, double number)
{
  json_builder_set_member_name (builder, name);
  json_builder_add_double_value (builder, number);
}

static void
put_flag (JsonBuilder *builder, const char *name, gboolean flag)
{
  json_builder_set_member_name (builder, name);
  json_builder_add_boolean_value (builder, flag);
}

/* A statement that is exported twice is one statement: its name follows from
 * what it says. */
static void
put_id (JsonBuilder *builder, const char *what)
{
  g_autofree char *digest
      = g_compute_checksum_for_string (G_CHECKSUM_SHA1, what, -1);
  g_autofree char *id
      = g_strdup_printf ("%.8s-%.4s-5%.3s-8%.3s-%.12s", digest, digest + 8,
                         digest + 13, digest + 17, digest + 20);

  put (builder, "id", id);
}

static void
put_actor (JsonBuilder *builder, const Progress *progress, const char *name)
{
  begin (builder, "actor");
  put (builder, "objectType", "Agent");
  if (name != NULL && *name != '\0')
    put (builder, "name", name);
  begin (builder, "account");
  put (builder, "homePage", HOME);
  put (builder, "name", progress->learner);
  json_builder_end_object (builder);
  json_builder_end_object (builder);
}

static void
put_verb (JsonBuilder *builder, const char *verb)
{
  g_autofree char *id = g_strconcat (VERBS, verb, NULL);

  begin (builder, "verb");
  put (builder, "id", id);
  begin (builder, "display");
  put (builder, "en", verb);
  json_builder_end_object (builder);
  json_builder_end_object (builder);
}

/* Returns: (transfer full): of a lesson, or of a question of it. */
static char *
activity_id (const LessonRecord *lesson, const QuestionRecord *record)
{
  g_autofree char *base = g_path_get_basename (lesson->key);
  g_autofree char *name = g_uri_escape_string (base, NULL, FALSE);

  return record == NULL
             ? g_strdup_printf (HOME "/lessons/%s", name)
             : g_strdup_printf (HOME "/lessons/%s#%s", name, record->key);
}

static void
put_activity (JsonBuilder *builder,
              const char *id,
              const char *type,
              const char *title)
{
  g_autofree char *whole = g_strconcat (ACTIVITIES, type, NULL);

  put (builder, "objectType", "Activity");
  put (builder, "id", id);
  begin (builder, "definition");
  put (builder, "type", whole);
  begin (builder, "name");
  put (builder, "und", title);
  json_builder_end_object (builder);
  json_builder_end_object (builder);
}

static void
put_duration (JsonBuilder *builder, double seconds)
{
  g_autofree char *text = seconds_text (seconds);
  g_autofree char *duration = g_strdup_printf ("PT%sS", text);

  put (builder, "duration", duration);
}

static void
put_score (JsonBuilder *builder, guint total, guint correct)
{
  begin (builder, "score");
  put_number (builder, "scaled", total == 0 ? 0 : (double)correct / total);
  put_number (builder, "raw", correct);
  put_number (builder, "min", 0);
  put_number (builder, "max", total);
  json_builder_end_object (builder);
}

static void
put_result (JsonBuilder *builder, const QuestionRecord *record)
{
  begin (builder, "result");
  if (record->total > 0)
    put_score (builder, record->total, record->correct);
  put_flag (builder, "success", record->outcome == OUTCOME_AT_ONCE);
  put_flag (builder, "completion", TRUE);
  put (builder, "response", outcome_name (record->outcome));
  put_duration (builder, record->seconds);
  begin (builder, "extensions");
  put_number (builder, HOME "/xapi/checks", record->n_checks);
  put_number (builder, HOME "/xapi/hinted", record->hinted);
  put_number (builder, HOME "/xapi/undone", record->undone);
  json_builder_end_object (builder);
  json_builder_end_object (builder);
}

static void
put_parent (JsonBuilder *builder, const LessonRecord *lesson)
{
  g_autofree char *id = activity_id (lesson, NULL);

  begin (builder, "context");
  begin (builder, "contextActivities");
  json_builder_set_member_name (builder, "parent");
  json_builder_begin_array (builder);
  json_builder_begin_object (builder);
  put_activity (builder, id, "lesson", lesson->title);
  json_builder_end_object (builder);
  json_builder_end_array (builder);
  json_builder_end_object (builder);
  json_builder_end_object (builder);
}

static void
put_object (JsonBuilder *builder,
            const LessonRecord *lesson,
            const QuestionRecord *record)
{
  g_autofree char *id = activity_id (lesson, record);

  begin (builder, "object");
  put_activity (builder, id, record == NULL ? "lesson" : "question",
                record == NULL ? lesson->title : record->title);
  json_builder_end_object (builder);
}

/* What a whole lesson came to. */
static void
put_whole (JsonBuilder *builder, const LessonRecord *lesson)
{
  guint total = 0, correct = 0;

  for (guint i = 0; i < lesson->questions->len; i++) {
    const QuestionRecord *record = g_ptr_array_index (lesson->questions, i);

    total += 1;
    correct += record->outcome == OUTCOME_AT_ONCE;
  }
  begin (builder, "result");
  if (total > 0)
    put_score (builder, total, correct);
  put_flag (builder, "completion", TRUE);
  put_duration (builder, lesson->seconds);
  json_builder_end_object (builder);
}

/* @record NULL: the lesson. */
static void
add_statement (GString *lines,
               const Progress *progress,
               const char *name,
               const LessonRecord *lesson,
               const QuestionRecord *record)
{
  g_autoptr (JsonBuilder) builder = json_builder_new ();
  g_autofree char *time
      = time_text (record == NULL ? lesson->last : record->answered);
  g_autofree char *what
      = g_strdup_printf ("%s %s %s %s", progress->learner, lesson->key,
                         record == NULL ? "" : record->key,
                         record == NULL ? "" : outcome_name (record->outcome));
  g_autofree char *line = NULL;
  g_autoptr (JsonNode) root = NULL;

  json_builder_begin_object (builder);
  put_id (builder, what);
  put_actor (builder, progress, name);
  put_verb (builder, record == NULL ? "completed" : "answered");
  put_object (builder, lesson, record);
  if (record == NULL)
    put_whole (builder, lesson);
  else
    put_result (builder, record);
  if (record != NULL)
    put_parent (builder, lesson);
  if (*time != '\0')
    put (builder, "timestamp", time);
  json_builder_end_object (builder);
  root = json_builder_get_root (builder);
  line = json_to_string (root, FALSE);
  g_string_append_printf (lines, "%s\n", line);
}

char *
results_xapi (const Progress *progress, const char *name)
{
  GString *lines = g_string_new (NULL);

  for (guint i = 0; i < progress->lessons->len; i++) {
    const LessonRecord *lesson = g_ptr_array_index (progress->lessons, i);
    g_autoptr (GPtrArray) questions = questions_of (lesson);

    for (guint k = 0; k < questions->len; k++) {
      const QuestionRecord *record = g_ptr_array_index (questions, k);

      if (record->outcome != OUTCOME_OPEN)
        add_statement (lines, progress, name, lesson, record);
    }
    if (lesson_record_is_done (lesson))
      add_statement (lines, progress, name, lesson, NULL);
  }
  return g_string_free (lines, FALSE);
}
