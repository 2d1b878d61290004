/* Results, as other programs read them. */
#include "learner.h"
#include "results.h"

#include <string.h>

static GPtrArray *
lines_of (const char *text, const char *separator)
{
  GPtrArray *lines = g_ptr_array_new_with_free_func (g_free);
  g_auto (GStrv) each = g_strsplit (text, separator, -1);

  for (guint i = 0; each[i] != NULL; i++)
    if (*each[i] != '\0')
      g_ptr_array_add (lines, g_strdup (each[i]));
  return lines;
}

static void
test_csv_has_a_row_for_each_question (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  g_autofree char *csv = NULL;
  g_autoptr (GPtrArray) rows = NULL;

  learner_answer_all (session);
  csv = results_csv (session_get_progress (session), "Ann, \"A\"");
  rows = lines_of (csv, "\r\n");
  g_assert_cmpuint (rows->len, ==, 4);
  g_assert_true (g_str_has_prefix (rows->pdata[0], "person,lesson,"));
  g_assert_true (g_str_has_prefix (rows->pdata[1], "\"Ann, \"\"A\"\"\","));
  g_assert_nonnull (strstr (rows->pdata[1], ",2,Which?,"));
  g_assert_nonnull (strstr (rows->pdata[1], ",at-once,2,2,1,0,0,"));
  g_assert_nonnull (strstr (rows->pdata[2], ",\"Numbers, \"\"and\"\" more\","));
  g_assert_nonnull (strstr (rows->pdata[2], ",shown,0,0,0,0,1,"));
  learner_end (session);
}

static void
keep (Session *session)
{
  g_autoptr (GError) error = NULL;

  progress_write (session_get_progress (session), &error);
  g_assert_no_error (error);
}

/* The file is written after each answer, and joined with what came since; the
 * last question is answered first. */
static void
test_rows_follow_the_stops (void)
{
  static const guint stops[] = { 3, 1, 2 };
  static const char *const titles[] = { "Which?", "Numbers, ", "Drag" };
  Session *session = learner_start (LEARNER_LESSON);
  g_autofree char *csv = NULL, *statements = NULL;
  g_autoptr (GPtrArray) rows = NULL, lines = NULL;

  for (guint i = 0; i < G_N_ELEMENTS (stops); i++) {
    session_set_stop (session, stops[i]);
    learner_act (session, "show-answer", NULL);
    keep (session);
  }
  csv = results_csv (session_get_progress (session), "Ann");
  statements = results_xapi (session_get_progress (session), "Ann");
  rows = lines_of (csv, "\r\n");
  lines = lines_of (statements, "\n");
  for (guint i = 0; i < G_N_ELEMENTS (titles); i++) {
    g_assert_nonnull (strstr (rows->pdata[1 + i], titles[i]));
    g_assert_nonnull (strstr (lines->pdata[i], titles[i]));
  }
  learner_end (session);
}

static void
test_statements_are_lines_of_json (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  Progress *progress = session_get_progress (session);
  g_autofree char *text = NULL, *again = NULL;
  g_autoptr (GPtrArray) lines = NULL;

  learner_answer_all (session);
  text = results_xapi (progress, NULL);
  again = results_xapi (progress, NULL);
  g_assert_cmpstr (text, ==, again);
  lines = lines_of (text, "\n");
  g_assert_cmpuint (lines->len, ==, 4); /* three answers, and the lesson */
  for (guint i = 0; i < lines->len; i++) {
    g_autoptr (JsonNode) node = json_from_string (lines->pdata[i], NULL);
    JsonObject *statement = json_node_get_object (node);
    JsonObject *result = json_object_get_object_member (statement, "result");

    g_assert_true (g_uuid_string_is_valid (
        json_object_get_string_member (statement, "id")));
    g_assert_true (json_object_has_member (statement, "timestamp"));
    g_assert_true (g_str_has_suffix (
        json_object_get_string_member (
            json_object_get_object_member (statement, "verb"), "id"),
        i < 3 ? "/answered" : "/completed"));
    g_assert_true (g_str_has_prefix (
        json_object_get_string_member (result, "duration"), "PT"));
    if (i < 3)
      g_assert_cmpint (json_object_get_boolean_member (result, "success"), ==,
                       i == 0);
  }
  learner_end (session);
}

static const LearnerTest tests[] = {
  { "/results/csv-has-a-row-for-each-question",
    test_csv_has_a_row_for_each_question },
  { "/results/rows-follow-the-stops", test_rows_follow_the_stops },
  { "/results/statements-are-lines-of-json",
    test_statements_are_lines_of_json },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  learner_add_tests (tests, G_N_ELEMENTS (tests));
  return learner_test_run ();
}
