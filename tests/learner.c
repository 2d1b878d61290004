#include "learner.h"

#include "action.h"

#include <glib/gstdio.h>
#include <string.h>

static char *folder;

char *
learner_file (const char *name)
{
  return g_build_filename (folder, name, NULL);
}

Session *
learner_open (const char *text, Progress *progress)
{
  Session *session = session_new ();
  g_autoptr (GError) error = NULL;
  g_autofree char *path
      = folder == NULL ? g_strdup ("l.md") : learner_file ("l.md");
  Lesson *lesson = lesson_parse (text, strlen (text), path, &error);

  g_assert_no_error (error);
  if (progress != NULL)
    session_set_progress (session, progress);
  session_set_lesson (session, lesson);
  lesson_unref (lesson);
  return session;
}

Session *
learner_start (const char *text)
{
  g_autofree char *path = learner_file ("progress.json");
  g_autoptr (Progress) progress = progress_new (path);
  g_autofree char *message = progress_open (progress);

  g_assert_null (message);
  return learner_open (text, progress);
}

void
learner_end (Session *session)
{
  g_autoptr (GError) error = NULL;

  progress_write (session_get_progress (session), &error);
  g_assert_no_error (error);
  g_object_unref (session);
}

void
learner_act (Session *session, const char *name, GVariant *parameter)
{
  g_autoptr (GError) error = NULL;

  action_run (session, name, parameter, &error);
  g_assert_no_error (error);
}

void
learner_answer (Session *session, const char *objects)
{
  g_auto (GStrv) names = g_strsplit (objects, " ", -1);

  for (guint i = 0; names[i] != NULL; i++)
    learner_act (session, "answer-toggle", g_variant_new_string (names[i]));
  learner_act (session, "check", NULL);
}

void
learner_clear_folder (void)
{
  g_autoptr (GDir) directory = g_dir_open (folder, 0, NULL);
  const char *name;

  while ((name = g_dir_read_name (directory)) != NULL) {
    g_autofree char *path = learner_file (name);

    g_unlink (path);
  }
}

char *
learner_read (const char *name)
{
  g_autofree char *path = learner_file (name);
  char *text = NULL;

  return g_file_get_contents (path, &text, NULL, NULL) ? text : NULL;
}

const QuestionRecord *
learner_record (Session *session, guint stop)
{
  const QuestionRecord *record = session_get_record_of (session, stop);

  g_assert_nonnull (record);
  return record;
}

void
learner_answer_all (Session *session)
{
  session_set_stop (session, 1);
  learner_answer (session, "f0 f1");
  session_set_stop (session, 2);
  learner_act (session, "answer-number", g_variant_new ("(uu)", 1, 90));
  learner_act (session, "answer-number", g_variant_new ("(uu)", 1, 91));
  learner_act (session, "answer-undo", NULL);
  learner_act (session, "show-answer", NULL);
  session_set_stop (session, 3);
  learner_act (session, "show-answer", NULL);
}

int
learner_test_run (void)
{
  int status;

  folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  status = g_test_run ();
  learner_clear_folder ();
  g_rmdir (folder);
  g_free (folder);
  return status;
}

static void
run (gconstpointer test)
{
  learner_clear_folder ();
  ((const LearnerTest *)test)->run ();
}

void
learner_add_tests (const LearnerTest *tests, guint n_tests)
{
  for (guint i = 0; i < n_tests; i++)
    g_test_add_data_func (tests[i].name, &tests[i], run);
}
