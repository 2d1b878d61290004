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

    g_assert_true (g_file_set_contents (path, text, (gssize)i, NULL));
    progress_read (progress, NULL);
    text[i] = (char)(text[i] ^ (1 << (i % 7)));
    g_assert_true (g_file_set_contents (path, text, (gssize)length, NULL));
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
