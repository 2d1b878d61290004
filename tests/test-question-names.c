/* Whatever facet a question calls by its name has that name in the pictures;
 * and nobody is told what is right in names that only lessons have. */
#include "attempt.h"
#include "document.h"
#include "locate.h"
#include "question.h"
#include "scene.h"
#include "session.h"

#include <string.h>

static gboolean
has_name (const Scene *scene, const char *name)
{
  for (guint i = 0; i < scene->n_items; i++) {
    const char *label = scene->items[i].label;

    if (label != NULL && g_regex_match_simple (name, label, 0, 0))
      return TRUE;
  }
  return FALSE;
}

static gboolean
is_named (Session *session, const char *facet)
{
  const Frame *frame = session_get_frame (session);
  SceneLook look = *session_get_look (session);
  g_autofree char *name = g_strdup_printf ("\\b%s\\b", facet);
  Scene plane = { 0 }, space = { 0 };
  gboolean is_there;

  look.low = (Point3){ -2, -2, 0 };
  look.high = (Point3){ 2, 2, 0 };
  scene_plane (&plane, frame, &look);
  scene_space (&space, frame, &look);
  is_there = has_name (&plane, name) || has_name (&space, name);
  scene_clear (&plane);
  scene_clear (&space);
  return is_there;
}

/* Returns: (transfer full): all that is read before it is answered. */
static char *
words_of (const Exercise *exercise)
{
  const Question *question = exercise->question;
  g_autofree char *prompt = question_prompt (question, &exercise->occasion);
  GString *words = g_string_new (prompt);

  for (guint i = 0; question->options != NULL && i < question->options->len;
       i++) {
    const QuestionOption *option = g_ptr_array_index (question->options, i);

    g_string_append_printf (words, "\n%s", option->text);
  }
  return g_string_free (words, FALSE);
}

/* Returns: how many names were looked for. */
static guint
check_question (Session *session, const char *lesson, guint stop)
{
  g_autofree char *words = words_of (session_get_exercise (session));
  g_autoptr (GRegex) names = g_regex_new ("\\bf[0-9]+\\b", 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  guint n = 0;

  for (g_regex_match (names, words, 0, &match); g_match_info_matches (match);
       g_match_info_next (match, NULL)) {
    g_autofree char *name = g_match_info_fetch (match, 0);

    if (!is_named (session, name))
      g_error ("%s, stop %u: nothing is called %s", lesson, stop + 1, name);
    n += 1;
  }
  return n;
}

static void
test_lessons (void)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();
  guint n = 0;

  for (guint i = 0; i < paths->len; i++) {
    g_autoptr (Session) session = session_new ();
    const char *path = g_ptr_array_index (paths, i);

    g_assert_true (document_open (session, path, NULL));
    for (guint stop = 0; stop < session_get_n_stops (session); stop++) {
      session_set_stop (session, stop);
      if (session_is_asking (session))
        n += check_question (session, path, stop);
    }
  }
  g_assert_cmpuint (n, >=, 10);
}

static void
test_a_drag_away_from_a_tie_is_told_in_words (void)
{
  static const char asked[]
      = "# L\n\n```lesson\nformat 1\nsites 0.5 0; 0 0.5; -0.5 0; 0 -0.5\n```\n"
        "\n## A\n\n```ask\ncomplete\ndrag s0 until not no-simplex\n```\n";
  g_autoptr (Lesson) lesson
      = lesson_parse (asked, sizeof asked - 1, "l.md", NULL);
  const LessonStop *stop = lesson_stop (lesson, 0);
  g_autoptr (Attempt) attempt = attempt_new (stop->question);
  g_autoptr (Verdict) verdict
      = attempt_grade (attempt, stop->question, &stop->occasion);

  g_assert_cmpstr (g_ptr_array_index (verdict->reasons, 0), ==,
                   "It is still the case that there is no simplex.");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/question-names/what-lessons-ask-about-can-be-found",
                   test_lessons);
  g_test_add_func ("/question-names/a-drag-away-from-a-tie-is-told-in-words",
                   test_a_drag_away_from_a_tie_is_told_in_words);
  return g_test_run ();
}
