/* Progress: what is written down, kept, recalled and told to others. */
#include "action.h"
#include "lesson-text.h"
#include "results.h"

#include <glib/gstdio.h>
#include <string.h>

#define WHICH                                                                  \
  "## Which?\n\n```ask\nbefore round 1 see\nclick visible-facets\n"            \
  "hint one\nretry 1\n```\n\n"
#define NUMBERS                                                                \
  "## Numbers, \"and\" more\n\n```ask\nbefore round 2 see\n"                   \
  "number visible cone\n```\n\n"
#define DRAG "## Drag\n\n```ask\ncomplete\ndrag s7 until unbounded s7\n```\n\n"

static const char lesson_text[]
    = LECTURE "## Start\n\n```steps\ngoto start\n```\n\n" WHICH NUMBERS DRAG;

static char *folder;

static char *
file (const char *name)
{
  return g_build_filename (folder, name, NULL);
}

static Session *
begin_with (const char *text, Progress *progress)
{
  Session *session = session_new ();
  g_autoptr (GError) error = NULL;
  g_autofree char *path = file ("l.md");
  Lesson *lesson = lesson_parse (text, strlen (text), path, &error);

  g_assert_no_error (error);
  if (progress != NULL)
    session_set_progress (session, progress);
  session_set_lesson (session, lesson);
  lesson_unref (lesson);
  return session;
}

/* A program that is started: with what is in the file. */
static Session *
start (const char *text)
{
  g_autofree char *path = file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);
  g_autofree char *message = progress_open (progress);

  g_assert_null (message);
  return begin_with (text, progress);
}

static void
end (Session *session)
{
  g_autoptr (GError) error = NULL;

  progress_write (session_get_progress (session), &error);
  g_assert_no_error (error);
  g_object_unref (session);
}

static void
act (Session *session, const char *name, GVariant *parameter)
{
  g_autoptr (GError) error = NULL;

  action_run (session, name, parameter, &error);
  g_assert_no_error (error);
}

static void
answer (Session *session, const char *objects)
{
  g_auto (GStrv) names = g_strsplit (objects, " ", -1);

  for (guint i = 0; names[i] != NULL; i++)
    act (session, "answer-toggle", g_variant_new_string (names[i]));
  act (session, "check", NULL);
}

static void
clear_folder (void)
{
  g_autoptr (GDir) directory = g_dir_open (folder, 0, NULL);
  const char *name;

  while ((name = g_dir_read_name (directory)) != NULL) {
    g_autofree char *path = file (name);

    g_unlink (path);
  }
}

static char *
read_file (const char *name)
{
  g_autofree char *path = file (name);
  char *text = NULL;

  return g_file_get_contents (path, &text, NULL, NULL) ? text : NULL;
}

static const QuestionRecord *
record_of (Session *session, guint stop)
{
  const QuestionRecord *record = session_get_record_of (session, stop);

  g_assert_nonnull (record);
  return record;
}

/* Answers the three questions: at once, after help, shown. */
static void
answer_all (Session *session)
{
  session_set_stop (session, 1);
  answer (session, "f0 f1");
  session_set_stop (session, 2);
  act (session, "answer-number", g_variant_new ("(uu)", 1, 90));
  act (session, "answer-number", g_variant_new ("(uu)", 1, 91));
  act (session, "answer-undo", NULL);
  act (session, "show-answer", NULL);
  session_set_stop (session, 3);
  act (session, "show-answer", NULL);
}

static void
test_what_was_answered_is_answered_the_next_time (void)
{
  Session *session = start (lesson_text);
  const Exercise *exercise;

  answer_all (session);
  end (session);
  session = start (lesson_text);
  g_assert_cmpuint (session_get_stop (session), ==, 0);
  g_assert_cmpint (record_of (session, 1)->outcome, ==, OUTCOME_AT_ONCE);
  g_assert_cmpint (record_of (session, 2)->outcome, ==, OUTCOME_SHOWN);
  exercise = session_get_exercise_of (session, 1);
  g_assert_false (exercise->is_open);
  g_assert_true (exercise->verdict->is_right);
  g_assert_cmpuint (exercise->attempt->objects->len, ==, 2);
  exercise = session_get_exercise_of (session, 2);
  g_assert_true (exercise->is_shown);
  g_assert_cmpuint (exercise->n_undone, ==, 1);
  g_assert_cmpint (g_array_index (exercise->attempt->numbers, gint64, 0), ==,
                   90);
  g_assert_false (session_get_exercise_of (session, 3)->is_open);
  end (session);
}

static void
test_a_person_goes_on_where_they_were (void)
{
  Session *session = start (lesson_text);
  guint stop;

  g_assert_false (session_can_resume (session, NULL));
  session_set_stop (session, 2);
  end (session);
  session = start (lesson_text);
  g_assert_true (session_can_resume (session, &stop));
  g_assert_cmpuint (stop, ==, 2);
  act (session, "resume", NULL);
  g_assert_cmpuint (session_get_stop (session), ==, 2);
  g_assert_false (session_can_resume (session, NULL));
  /* Who went back to the start of it begins there. */
  session_set_stop (session, 0);
  end (session);
  session = start (lesson_text);
  g_assert_false (session_can_resume (session, NULL));
  g_assert_cmpuint (session_get_record (session)->furthest, ==, 2);
  end (session);
}

static void
test_opening_a_lesson_keeps_the_place (void)
{
  Session *session = start (lesson_text);

  session_set_stop (session, 3);
  end (session);
  for (guint i = 0; i < 2; i++) {
    session = start (lesson_text);
    g_assert_cmpuint (session_get_record (session)->stop, ==, 3);
    end (session);
  }
}

/* A hint, and a wrong check before, are help; a start of the program between
 * does not wipe them out. */
static void
test_help_is_remembered_before_the_answer (void)
{
  Session *session = start (lesson_text);

  session_set_stop (session, 1);
  answer (session, "f0");
  g_assert_true (session_get_exercise (session)->is_open);
  end (session);
  session = start (lesson_text);
  act (session, "resume", NULL);
  g_assert_cmpuint (session_get_exercise (session)->n_checks, ==, 1);
  answer (session, "f0 f1");
  g_assert_cmpint (record_of (session, 1)->outcome, ==, OUTCOME_AFTER_HELP);
  g_assert_cmpuint (record_of (session, 1)->total, ==, 2);
  g_assert_cmpuint (record_of (session, 1)->correct, ==, 1);
  end (session);
}

static void
test_the_first_answer_stays (void)
{
  Session *session = start (lesson_text);

  session_set_stop (session, 1);
  answer (session, "f0 f1");
  act (session, "retry", NULL);
  act (session, "show-answer", NULL);
  g_assert_cmpint (record_of (session, 1)->outcome, ==, OUTCOME_AT_ONCE);
  session_set_stop (session, 2);
  act (session, "show-answer", NULL);
  g_assert_cmpint (record_of (session, 2)->outcome, ==, OUTCOME_SHOWN);
  act (session, "retry", NULL);
  act (session, "answer-number", g_variant_new ("(uu)", 1, 1));
  act (session, "check", NULL);
  g_assert_cmpint (record_of (session, 2)->outcome, ==, OUTCOME_SHOWN);
  end (session);
}

/* An edited lesson: a question that moved keeps its credit, another in its
 * place gets none, and neither does the same about other sites. */
static void
test_credit_belongs_to_what_was_asked (void)
{
  static const char edited[]
      = LECTURE "## Start\n\n```steps\ngoto start\n```\n\n## New\n\n```ask\n"
                "before round 1 see\nclick dying-triangles\n```\n\n"
                "## Later\n\n```steps\ngoto start\n```\n\n"
                "## Reworded\n\n```ask\nbefore round 2 see\n"
                "prompt In other words?\nnumber visible cone\n```\n";
  static const char elsewhere[] = HEAD WHICH;
  Session *session = start (lesson_text);

  session_set_stop (session, 1);
  answer (session, "f0 f1");
  session_set_stop (session, 2);
  act (session, "show-answer", NULL);
  end (session);
  session = start (edited);
  g_assert_cmpint (record_of (session, 1)->outcome, ==, OUTCOME_OPEN);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  g_assert_cmpint (record_of (session, 3)->outcome, ==, OUTCOME_SHOWN);
  g_object_unref (session);
  session = start (elsewhere);
  g_assert_true (session_get_exercise_of (session, 0)->is_open);
  g_object_unref (session);
}

/* The picture is that after the answer, not that of the open question. */
static void
test_a_first_stop_that_was_answered_shows_its_end (void)
{
  static const char text[] = LECTURE WHICH "```steps\ngoto round 1 see\n```\n";
  Session *session = start (text);
  guint step;

  answer (session, "f0 f1");
  step = session_get_step (session);
  end (session);
  session = start (text);
  g_assert_cmpuint (session_get_step (session), ==, step);
  g_assert_false (session_is_asking (session));
  g_assert_cmpuint (session_get_look (session)->mask, ==, 0);
  end (session);
}

static void
test_drags_are_recalled_with_their_sites (void)
{
  Session *session = start (lesson_text);
  g_autoptr (Attempt) model = NULL;
  const Exercise *exercise;
  Site to;

  session_set_stop (session, 3);
  exercise = session_get_exercise (session);
  model = answer_model (exercise->question, &exercise->occasion);
  to = site_set_given (model->run->set, 7);
  session_begin_edit (session);
  g_assert_true (session_move_site (session, 7, to, NULL));
  session_end_edit (session);
  g_assert_cmpint (record_of (session, 3)->outcome, ==, OUTCOME_AT_ONCE);
  end (session);
  session = start (lesson_text);
  exercise = session_get_exercise_of (session, 3);
  g_assert_true (exercise->verdict->is_right);
  g_assert_cmpfloat (site_set_given (exercise->attempt->run->set, 7).x, ==,
                     to.x);
  end (session);
}

/* Files that are not good */

static void
check_kept (const char *text, const char *reason)
{
  g_autofree char *path = file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);
  g_autofree char *message = NULL, *again = NULL, *kept = NULL;
  g_autoptr (GError) error = NULL;

  clear_folder ();
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  message = progress_open (progress);
  g_assert_nonnull (message);
  if (strstr (message, reason) == NULL)
    g_error ("%s: %s", reason, message);
  g_assert_nonnull (strstr (message, path));
  kept = read_file ("progress.json.kept-1");
  g_assert_cmpstr (kept, ==, text);
  again = progress_open (progress);
  g_assert_null (again);
  progress_lesson (progress, "x")->is_changed = TRUE;
  progress->is_changed = TRUE;
  g_assert_true (progress_write (progress, &error));
  g_assert_no_error (error);
}

#define FORM(rest) "{\"format\": 1, \"learner\": \"u\", \"lessons\": " rest "}"
#define LESSON_FORM(rest)                                                      \
  FORM ("[{\"lesson\": \"a.md\", \"title\": \"A\", \"stop\": 1, "              \
        "\"furthest\": 1, \"stops\": 3, \"seconds\": 1.5, \"first\": 1, "      \
        "\"last\": 2, \"questions\": " rest "}]")

static void
test_a_file_that_is_broken_or_newer_is_kept_and_told_once (void)
{
  check_kept ("", "JSON");
  check_kept ("{\"format\": 1,\n\"a\": 2,\n\"b\": oops", ":3: ");
  check_kept ("[]", "no object");
  check_kept ("{}", "“format”");
  check_kept ("{\"format\": \"1\"}", "“format”");
  check_kept ("{\"format\": 2, \"all\": \"else\"}", "newer");
  check_kept (FORM ("7"), "“lessons”");
  check_kept (FORM ("[7]"), "lesson");
  check_kept (FORM ("[{\"lesson\": 7}]"), "“lesson”");
  check_kept (LESSON_FORM ("{}"), "“questions”");
  check_kept (LESSON_FORM ("[[]]"), "question");
  check_kept (LESSON_FORM ("[{\"question\": \"q\"}]"), "“title”");
  check_kept (LESSON_FORM ("[{\"question\": \"q\", \"title\": \"t\", "
                           "\"stop\": -1}]"),
              "“stop”");
  check_kept (LESSON_FORM ("[{\"question\": \"q\", \"title\": \"t\", "
                           "\"stop\": 1, \"outcome\": \"great\"}]"),
              "outcome");
}

/* Whatever part of it is lost or turned, a file is read or refused. */
static void
test_no_damage_is_too_much (void)
{
  g_autofree char *path = file ("progress.json");
  Session *session = start (lesson_text);
  g_autofree char *text = NULL;
  gsize length;

  answer_all (session);
  end (session);
  g_assert_true (g_file_get_contents (path, &text, &length, NULL));
  for (gsize i = 0; i < length; i += 3) {
    g_autoptr (Progress) progress = progress_new (path);
    const char byte = text[i];

    g_assert_true (g_file_set_contents (path, text, (gssize)i, NULL));
    progress_read (progress, NULL);
    text[i] ^= (char)(1u << (i % 7));
    g_assert_true (g_file_set_contents (path, text, (gssize)length, NULL));
    text[i] = byte;
    if (progress_read (progress, NULL))
      g_object_unref (begin_with (lesson_text, progress));
  }
}

static void
test_answers_that_do_not_fit_are_no_answers (void)
{
  static const char *const answers[]
      = { "{}",
          "{\"objects\": [\"f99\"]}",
          "{\"objects\": [\"f0\", \"f0\"]}",
          "{\"objects\": [7, null, {}]}",
          "{\"objects\": 7, \"shown\": \"yes\"}",
          "{\"numbers\": [1, 2, 3]}",
          "{\"sites\": [[0, 0], [1]]}",
          "{\"sites\": [[1e300, 1e-300], [0, 1]]}",
          "{\"sites\": []}" };

  for (guint i = 0; i < G_N_ELEMENTS (answers); i++) {
    g_autoptr (Session) session = begin_with (lesson_text, NULL);
    g_autoptr (JsonNode) node = json_from_string (answers[i], NULL);

    for (guint stop = 1; stop < 4; stop++)
      exercise_recall ((Exercise *)session_get_exercise_of (session, stop),
                       json_node_get_object (node));
  }
}

static void
test_two_programs_do_not_wipe_out_each_other (void)
{
  g_autofree char *path = file ("progress.json");
  g_autoptr (Progress) first = progress_new (path);
  g_autoptr (Progress) second = progress_new (path);
  g_autoptr (Progress) third = progress_new (path);

  progress_lesson (first, "a")->is_changed = TRUE;
  first->is_changed = TRUE;
  g_assert_true (progress_write (first, NULL));
  progress_lesson (second, "b")->is_changed = TRUE;
  second->is_changed = TRUE;
  g_assert_true (progress_write (second, NULL));
  progress_lesson (first, "a")->stop = 5;
  progress_lesson (first, "a")->is_changed = TRUE;
  first->is_changed = TRUE;
  g_assert_true (progress_write (first, NULL));
  g_assert_true (progress_read (third, NULL));
  g_assert_cmpuint (third->lessons->len, ==, 2);
  g_assert_cmpuint (progress_find (third, "a")->stop, ==, 5);
  g_assert_cmpstr (first->learner, ==, second->learner);
}

static void
test_clearing_forgets_and_keeps_a_copy (void)
{
  Session *session = start (lesson_text);
  g_autofree char *kept = NULL, *copy = NULL;

  answer_all (session);
  end (session);
  session = start (lesson_text);
  kept = session_clear_progress (session);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  copy = read_file ("progress.json~");
  g_assert_nonnull (strstr (copy, "at-once"));
  end (session);
  session = start (lesson_text);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  end (session);
}

static void
test_a_place_that_cannot_be_written_is_told (void)
{
  g_autoptr (Progress) progress = progress_new ("/proc/none/progress.json");
  g_autoptr (GError) error = NULL;

  progress->is_changed = TRUE;
  g_assert_false (progress_write (progress, &error));
  g_assert_nonnull (strstr (error->message, "/proc/none"));
  g_assert_true (progress->is_changed);
}

/* Results */

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
  Session *session = start (lesson_text);
  g_autofree char *csv = NULL;
  g_autoptr (GPtrArray) rows = NULL;

  answer_all (session);
  csv = results_csv (session_get_progress (session), "Ann, \"A\"");
  rows = lines_of (csv, "\r\n");
  g_assert_cmpuint (rows->len, ==, 4);
  g_assert_true (g_str_has_prefix (rows->pdata[0], "person,lesson,"));
  g_assert_true (g_str_has_prefix (rows->pdata[1], "\"Ann, \"\"A\"\"\","));
  g_assert_nonnull (strstr (rows->pdata[1], ",2,Which?,"));
  g_assert_nonnull (strstr (rows->pdata[1], ",at-once,2,2,1,0,0,"));
  g_assert_nonnull (strstr (rows->pdata[2], ",\"Numbers, \"\"and\"\" more\","));
  g_assert_nonnull (strstr (rows->pdata[2], ",shown,0,0,0,0,1,"));
  end (session);
}

static void
test_statements_are_lines_of_json (void)
{
  Session *session = start (lesson_text);
  Progress *progress = session_get_progress (session);
  g_autofree char *text = NULL, *again = NULL;
  g_autoptr (GPtrArray) lines = NULL;

  answer_all (session);
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
  end (session);
}

static void
run (void (*const *test) (void))
{
  clear_folder ();
  (*test) ();
}

#define ADD(name, function)                                                    \
  do {                                                                         \
    static void (*const test) (void) = function;                               \
    g_test_add_data_func ("/progress/" name, &test, (GTestDataFunc)run);       \
  } while (0)

int
main (int argc, char **argv)
{
  int status;

  g_test_init (&argc, &argv, NULL);
  folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  ADD ("what-was-answered-is-answered-the-next-time",
       test_what_was_answered_is_answered_the_next_time);
  ADD ("a-person-goes-on-where-they-were",
       test_a_person_goes_on_where_they_were);
  ADD ("opening-a-lesson-keeps-the-place",
       test_opening_a_lesson_keeps_the_place);
  ADD ("help-is-remembered-before-the-answer",
       test_help_is_remembered_before_the_answer);
  ADD ("the-first-answer-stays", test_the_first_answer_stays);
  ADD ("credit-belongs-to-what-was-asked",
       test_credit_belongs_to_what_was_asked);
  ADD ("a-first-stop-that-was-answered-shows-its-end",
       test_a_first_stop_that_was_answered_shows_its_end);
  ADD ("drags-are-recalled-with-their-sites",
       test_drags_are_recalled_with_their_sites);
  ADD ("a-file-that-is-broken-or-newer-is-kept-and-told-once",
       test_a_file_that_is_broken_or_newer_is_kept_and_told_once);
  ADD ("no-damage-is-too-much", test_no_damage_is_too_much);
  ADD ("answers-that-do-not-fit-are-no-answers",
       test_answers_that_do_not_fit_are_no_answers);
  ADD ("two-programs-do-not-wipe-out-each-other",
       test_two_programs_do_not_wipe_out_each_other);
  ADD ("clearing-forgets-and-keeps-a-copy",
       test_clearing_forgets_and_keeps_a_copy);
  ADD ("a-place-that-cannot-be-written-is-told",
       test_a_place_that_cannot_be_written_is_told);
  ADD ("csv-has-a-row-for-each-question", test_csv_has_a_row_for_each_question);
  ADD ("statements-are-lines-of-json", test_statements_are_lines_of_json);
  status = g_test_run ();
  clear_folder ();
  g_rmdir (folder);
  g_free (folder);
  return status;
}
