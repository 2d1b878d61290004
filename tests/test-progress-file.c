/* The file of progress: broken, newer, shared, cleared. */
#include "learner.h"

#include <string.h>

static void
check_kept (const char *text, const char *reason)
{
  g_autofree char *path = learner_file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);
  g_autofree char *message = NULL, *again = NULL, *kept = NULL;
  g_autoptr (GError) error = NULL;

  learner_clear_folder ();
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  message = progress_open (progress);
  g_assert_nonnull (message);
  if (strstr (message, reason) == NULL)
    g_error ("%s: %s", reason, message);
  g_assert_nonnull (strstr (message, path));
  kept = learner_read ("progress.json.kept-1");
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
  check_kept ("[]", "not an object");
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

/* Not by way of the disk, which would take its time each time. */
static void
write_at_once (const char *path, const char *text, gsize length)
{
  g_assert_true (g_file_set_contents_full (
      path, text, (gssize)length, G_FILE_SET_CONTENTS_NONE, 0600, NULL));
}

/* Whatever part of it is lost or turned, a file is read or refused. */
static void
test_no_damage_is_too_much (void)
{
  g_autofree char *path = learner_file ("progress.json");
  Session *session = learner_start (LEARNER_LESSON);
  g_autofree char *text = NULL;
  gsize length;

  learner_answer_all (session);
  learner_end (session);
  g_assert_true (g_file_get_contents (path, &text, &length, NULL));
  for (gsize i = 0; i < length; i += 3) {
    g_autoptr (Progress) progress = progress_new (path);
    const char byte = text[i];

    write_at_once (path, text, i);
    progress_read (progress, NULL);
    text[i] = (char)(text[i] ^ (1 << (i % 7)));
    write_at_once (path, text, length);
    text[i] = byte;
    if (progress_read (progress, NULL))
      g_object_unref (learner_open (LEARNER_LESSON, progress));
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
    g_autoptr (Session) session = learner_open (LEARNER_LESSON, NULL);
    g_autoptr (JsonNode) node = json_from_string (answers[i], NULL);

    for (guint stop = 1; stop < 4; stop++)
      exercise_recall ((Exercise *)session_get_exercise_of (session, stop),
                       json_node_get_object (node));
  }
}

static void
test_two_programs_do_not_wipe_out_each_other (void)
{
  g_autofree char *path = learner_file ("progress.json");
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

/* The same lesson in two programs: what was answered in either counts. */
static void
test_two_programs_in_one_lesson_keep_the_answers_of_both (void)
{
  Session *first = learner_start (LEARNER_LESSON);
  Session *second = learner_start (LEARNER_LESSON);

  session_set_stop (first, 1);
  learner_answer (first, "f0 f1");
  session_set_stop (second, 1);
  learner_act (second, "show-answer", NULL);
  session_set_stop (second, 2);
  learner_act (second, "show-answer", NULL);
  session_set_stop (first, 3);
  learner_end (first);
  learner_end (second);
  first = learner_start (LEARNER_LESSON);
  g_assert_cmpint (learner_record (first, 1)->outcome, ==, OUTCOME_AT_ONCE);
  g_assert_cmpint (learner_record (first, 2)->outcome, ==, OUTCOME_SHOWN);
  g_assert_cmpuint (session_get_record (first)->furthest, ==, 3);
  learner_end (first);
}

#define N_AT_ONCE 12

static void *
write_lessons (void *name)
{
  g_autofree char *path = learner_file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);

  for (guint i = 0; i < N_AT_ONCE; i++) {
    g_autofree char *key = g_strdup_printf ("%s%u", (char *)name, i);

    progress_lesson (progress, key)->is_changed = TRUE;
    progress->is_changed = TRUE;
    g_assert_true (progress_write (progress, NULL));
  }
  return NULL;
}

static void
test_programs_that_write_at_once_lose_nothing (void)
{
  g_autoptr (GThread) other
      = g_thread_new ("other", write_lessons, (char *)"b");
  g_autofree char *path = learner_file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);

  write_lessons ((char *)"a");
  g_thread_join (g_steal_pointer (&other));
  g_assert_true (progress_read (progress, NULL));
  g_assert_cmpuint (progress->lessons->len, ==, 2 * N_AT_ONCE);
}

static void
test_what_another_program_has_cleared_stays_cleared (void)
{
  g_autofree char *path = learner_file ("progress.json");
  Session *first = learner_start (LEARNER_LESSON), *second;
  g_autoptr (Progress) third = progress_new (path);

  learner_answer_all (first);
  learner_end (first);
  first = learner_start (LEARNER_LESSON);
  second = learner_start (LEARNER_LESSON);
  g_free (session_clear_progress (second));
  learner_end (second);
  progress_lesson (session_get_progress (first), "other")->is_changed = TRUE;
  session_get_progress (first)->is_changed = TRUE;
  learner_end (first);
  g_assert_true (progress_read (third, NULL));
  for (guint i = 0; i < third->lessons->len; i++)
    g_assert_cmpuint (
        lesson_record_count (g_ptr_array_index (third->lessons, i),
                             OUTCOME_AT_ONCE),
        ==, 0);
}

static void
test_clearing_forgets_and_keeps_a_copy (void)
{
  Session *session = learner_start (LEARNER_LESSON);
  g_autofree char *kept = NULL, *copy = NULL;

  learner_answer_all (session);
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  kept = session_clear_progress (session);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  copy = learner_read ("progress.json~");
  g_assert_nonnull (strstr (copy, "at-once"));
  learner_end (session);
  session = learner_start (LEARNER_LESSON);
  g_assert_true (session_get_exercise_of (session, 1)->is_open);
  learner_end (session);
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

static const LearnerTest tests[] = {
  { "/progress-file/a-file-that-is-broken-or-newer-is-kept-and-told-once",
    test_a_file_that_is_broken_or_newer_is_kept_and_told_once },
  { "/progress-file/no-damage-is-too-much", test_no_damage_is_too_much },
  { "/progress-file/answers-that-do-not-fit-are-no-answers",
    test_answers_that_do_not_fit_are_no_answers },
  { "/progress-file/two-programs-do-not-wipe-out-each-other",
    test_two_programs_do_not_wipe_out_each_other },
  { "/progress-file/two-programs-in-one-lesson-keep-the-answers-of-both",
    test_two_programs_in_one_lesson_keep_the_answers_of_both },
  { "/progress-file/programs-that-write-at-once-lose-nothing",
    test_programs_that_write_at_once_lose_nothing },
  { "/progress-file/what-another-program-has-cleared-stays-cleared",
    test_what_another_program_has_cleared_stays_cleared },
  { "/progress-file/clearing-forgets-and-keeps-a-copy",
    test_clearing_forgets_and_keeps_a_copy },
  { "/progress-file/a-place-that-cannot-be-written-is-told",
    test_a_place_that_cannot_be_written_is_told },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  learner_add_tests (tests, G_N_ELEMENTS (tests));
  return learner_test_run ();
}
