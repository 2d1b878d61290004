/* Opening, replaying and closing again and again leaves nothing behind. The
 * sanitizer finds what is lost; here it is what is kept that is counted, as
 * far as the C library tells; under the sanitizer, whose memory it does not
 * know, HULL2VD_SAMPLE makes it fewer times. */
#include "document.h"
#include "replay.h"

#include <glib.h>
#include <malloc.h>
#include <stdlib.h>

enum { N_WARM = 10, N_TIMES = 50, BYTES_ALLOWED = 8 << 10 };

static const char *const documents[] = {
  "lessons/07-one-insertion-inside.md", "lessons/09-when-sites-tie.md",
  "tests/corpus/kettner-a1.txt",        "tests/corpus/grid5.txt",
  "tests/corpus/bad-word.txt",
};

static void
replay (const char *path)
{
  g_autoptr (Replay) replay = replay_new ();
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = lesson_load (path, &error);

  g_assert_no_error (error);
  g_assert_true (replay_add (replay, lesson, &error));
  g_assert_no_error (error);
  replay_end (replay);
}

/* Steps from one end to the other and back, then edits and undoes. */
static void
play (Session *session)
{
  session_first (session);
  while (session_next (session))
    g_assert_nonnull (session_get_frame (session));
  while (session_back (session))
    g_assert_nonnull (session_get_frame (session));
  session_add_site (session, (Site){ 0.25, 0.125 }, NULL);
  session_undo (session);
  session_redo (session);
}

static void
open_and_close (const char *path)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GError) error = NULL;

  session_set_step_size (session, STEP_PHASE);
  if (document_open (session, path, &error))
    play (session);
  else
    g_assert_nonnull (error);
}

static void
do_it_all (void)
{
  for (guint i = 0; i < G_N_ELEMENTS (documents); i++) {
    g_autofree char *path
        = g_build_filename (g_getenv ("HULL2VD_SOURCE"), documents[i], NULL);

    if (document_is_lesson (path))
      replay (path);
    open_and_close (path);
  }
}

static void
test_fifty_times_keep_nothing (void)
{
  const char *sample = g_getenv ("HULL2VD_SAMPLE");
  const guint one_in = sample == NULL ? 1 : (guint)MAX (1, atoi (sample));
  size_t warm = 0, end;

  for (guint i = 0; i < N_TIMES / one_in; i++) {
    if (i == N_WARM / one_in)
      warm = mallinfo2 ().uordblks;
    do_it_all ();
  }
  end = mallinfo2 ().uordblks;
  g_test_message ("%zu bytes in use, then %zu", warm, end);
  g_assert_cmpuint (end, <=, warm + BYTES_ALLOWED);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/leaks/open-replay-and-close-fifty-times-keeps-nothing",
                   test_fifty_times_keep_nothing);
  return g_test_run ();
}
