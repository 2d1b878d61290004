/* What threads do for the person, and what is left when they are not wanted
 * any more. */
#include "chore-task.h"
#include "document.h"
#include "session-chore.h"

#include <glib/gstdio.h>
#include <string.h>

/* A task that goes on when the test lets it. */
typedef struct Work {
  ChoreTask *task;
  char *path;
  GBytes *sites;
  gint may_go_on, has_begun; /* atomic */
  guint n_done, n_freed;
  gboolean has_failed;
} Work;

static gboolean
write_sites (ChoreTask *task, gpointer data, GError **error)
{
  Work *work = data;
  g_autofree char *text = document_sites_text (work->sites);

  g_atomic_int_set (&work->has_begun, 1);
  while (!g_atomic_int_get (&work->may_go_on))
    g_thread_yield ();
  return chore_task_write (task, work->path, text, strlen (text), error);
}

static void
on_done (gpointer data, const GError *error)
{
  Work *work = data;

  work->n_done += 1;
  work->has_failed = error != NULL;
}

static void
on_free (gpointer data)
{
  ((Work *)data)->n_freed += 1;
}

static void
begin (Work *work, Session *session, const char *name)
{
  work->path = g_build_filename (g_get_tmp_dir (), name, NULL);
  work->sites = document_sites (session);
  work->task = chore_task_begin (session, "It is being written", write_sites,
                                 on_done, work, on_free);
}

static void
wait_for (Work *work)
{
  while (work->n_freed == 0)
    g_main_context_iteration (NULL, TRUE);
}

static void
clear (Work *work)
{
  g_unlink (work->path);
  g_free (work->path);
  g_bytes_unref (work->sites);
}

static Session *
three_new (void)
{
  const Site sites[] = { { 0, 0 }, { 0.1, 1.0 / 3 }, { -0.0, 0.25 } };
  Session *session = session_new ();

  g_assert_true (
      session_set_sites (session, sites, G_N_ELEMENTS (sites), NULL));
  return session;
}

static char *
read_all (const char *path)
{
  char *text = NULL;

  return g_file_get_contents (path, &text, NULL, NULL) ? text : NULL;
}

static void
test_goes_on (void)
{
  g_autoptr (Session) session = three_new ();
  g_autofree char *before = document_copy (session);
  g_autofree char *text = NULL;
  Work work = { .n_done = 0 };
  guint n_turns = 0;

  begin (&work, session, "hull2vd-chore-goes-on");
  g_assert_cmpstr (session_get_chore (session), ==, "It is being written");
  for (; n_turns < 100; n_turns++)
    g_main_context_iteration (NULL, FALSE);
  g_assert_cmpuint (work.n_done, ==, 0);
  /* What is edited meanwhile is not written. */
  g_assert_true (session_add_site (session, (Site){ 3, 3 }, NULL));
  g_atomic_int_set (&work.may_go_on, 1);
  wait_for (&work);
  g_assert_cmpuint (work.n_done, ==, 1);
  g_assert_false (work.has_failed);
  g_assert_null (session_get_chore (session));
  text = read_all (work.path);
  g_assert_cmpstr (text, ==, before);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 4);
  clear (&work);
}

static void
test_given_up (void)
{
  g_autoptr (Session) session = three_new ();
  g_autofree char *before = document_copy (session);
  g_autofree char *after = NULL;
  Work work = { .n_done = 0 };

  begin (&work, session, "hull2vd-chore-given-up");
  while (!g_atomic_int_get (&work.has_begun))
    g_thread_yield ();
  g_assert_true (session_give_up (session));
  g_assert_null (session_get_chore (session));
  g_assert_true (chore_task_is_given_up (work.task));
  g_atomic_int_set (&work.may_go_on, 1);
  wait_for (&work);
  g_assert_cmpuint (work.n_done, ==, 0);
  g_assert_false (g_file_test (work.path, G_FILE_TEST_EXISTS));
  after = document_copy (session);
  g_assert_cmpstr (after, ==, before);
  clear (&work);
}

static void
test_last_wish (void)
{
  g_autoptr (Session) session = three_new ();
  g_autofree char *after = NULL, *text = NULL;
  Work first = { .n_done = 0 }, second = { .may_go_on = 1 };

  begin (&first, session, "hull2vd-chore-last-wish");
  g_assert_true (session_add_site (session, (Site){ 3, 3 }, NULL));
  after = document_copy (session);
  chore_task_give_up (first.task);
  begin (&second, session, "hull2vd-chore-last-wish");
  wait_for (&second);
  g_atomic_int_set (&first.may_go_on, 1);
  wait_for (&first);
  text = read_all (second.path);
  g_assert_cmpstr (text, ==, after);
  clear (&first);
  clear (&second);
}

static void
test_fault (void)
{
  g_autoptr (Session) session = three_new ();
  Work work = { .may_go_on = 1 };

  begin (&work, session, "no-such-folder/hull2vd-chore");
  wait_for (&work);
  g_assert_cmpuint (work.n_done, ==, 1);
  g_assert_true (work.has_failed);
  clear (&work);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/chore-task/the-main-loop-goes-on-and-so-do-edits",
                   test_goes_on);
  g_test_add_func ("/chore-task/what-is-given-up-leaves-no-file",
                   test_given_up);
  g_test_add_func ("/chore-task/the-last-wish-is-what-lies-in-the-file",
                   test_last_wish);
  g_test_add_func ("/chore-task/a-fault-is-told", test_fault);
  return g_test_run ();
}
