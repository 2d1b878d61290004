/* Lessons played: their commands carried out, their questions asked. */
#include "action.h"
#include "attempt.h"
#include "expect.h"
#include "session-private.h"
#include "words.h"

#include <glib/gi18n.h>

/* The frames that finding the answers needs, in sites: so many that no lesson
 * can take long. */
#define MAX_SITES_ASKED (10 * LESSON_MAX_SITES)

/* How far a run has been shown, and by which stop. */
typedef struct Reached {
  guint step;
  guint line;
} Reached;

/* One playing of a lesson, or of one stop of it. */
typedef struct Player {
  Session *session;
  LessonStop *stop; /* the current one */
  SessionExpect on_expect;
  gpointer user;
  LessonFaults *faults;
  gboolean is_filling; /* the first time: states and places are found */
  gboolean is_over;    /* nothing more may be played */
  guint n_sites_asked;
  /* How far each run has been shown: what is asked of it after that is no
   * question any more. */
  GHashTable *reached; /* of Reached by Run */
} Player;

/* Names the place in front of what went wrong. Takes @reason. */
static void
blame (Player *player, guint line, guint column, GError *reason)
{
  g_autofree char *words = words_shorten (reason->message);

  lesson_faults_take (
      player->faults,
      g_error_new (LESSON_ERROR, LESSON_ERROR_BROKEN, "%s:%u:%u: %s",
                   player->session->lesson->path, line, column, words));
  g_error_free (reason);
}

static void
play_command (Player *player, const LessonCommand *command)
{
  GError *reason = NULL;
  g_autofree char *actual = NULL;
  gboolean holds;

  if (!g_str_equal (command->verb, "expect")) {
    if (!action_run (player->session, command->verb, command->parameter,
                     &reason))
      blame (player, command->line, command->column, reason);
    return;
  }
  if (player->on_expect != NULL) {
    holds = expect_check (player->session,
                          g_variant_get_string (command->parameter, NULL),
                          &actual);
    player->on_expect (command, holds, actual, player->user);
  }
}

/* Every set that a lesson makes counts, so that none can run for long. */
static void
check_few_sites (Player *player, const LessonCommand *command)
{
  if (!player->is_filling || player->session->n_sites_made <= LESSON_MAX_SITES)
    return;
  player->is_over = TRUE;
  blame (player, command->line, command->column,
         g_error_new (
             LESSON_ERROR, LESSON_ERROR_BROKEN,
             _ ("the sets of this lesson have more than %d sites in total"),
             LESSON_MAX_SITES));
}

/* Leaks: what a person has seen is where a stop comes to rest, not what its
 * commands pass on the way. */

static void
note_reached (Player *player)
{
  Session *session = player->session;
  Reached *reached = g_hash_table_lookup (player->reached, session->run);

  if (reached == NULL) {
    reached = g_new0 (Reached, 1);
    g_hash_table_insert (player->reached, run_ref (session->run), reached);
  }
  if (session->step > reached->step)
    *reached = (Reached){ session->step, player->stop->line };
}

static GError *
find_leak (Player *player, const Occasion *occasion)
{
  const Reached *reached
      = g_hash_table_lookup (player->reached, player->session->run);

  if (occasion->reveal == occasion->step || reached == NULL
      || reached->step <= occasion->step)
    return NULL;
  return g_error_new (
      LESSON_ERROR, LESSON_ERROR_BROKEN,
      _ ("this gives the answer away: the stop on line %u has shown these "
         "sites beyond “%s”, or the answer to its question has"),
      reached->line, player->stop->question->position);
}

/* Questions */

/* Puts a question that the engine makes in place of its order. */
static gboolean
generate (Player *player, GError **error)
{
  Question *written = player->stop->question;
  Question *question;

  if (written->generate == NULL || player->stop->ask_state != NULL)
    return TRUE;
  question = question_generate (session_get_trace (player->session),
                                written->generate, written->seed, error);
  if (question == NULL)
    return FALSE;
  question->line = written->line;
  question->column = written->column;
  question->generate = g_steal_pointer (&written->generate);
  question->seed = written->seed;
  question->n_retries = written->n_retries;
  question->prompt = g_steal_pointer (&written->prompt);
  g_ptr_array_extend_and_steal (question->hints,
                                g_steal_pointer (&written->hints));
  written->hints = g_ptr_array_new ();
  question_unref (written);
  player->stop->question = question;
  return TRUE;
}

static gboolean
check_few_asked (Player *player, GError **error)
{
  player->n_sites_asked += session_get_set (player->session)->n_sites;
  if (player->n_sites_asked <= MAX_SITES_ASKED)
    return TRUE;
  player->is_over = TRUE;
  g_set_error (
      error, LESSON_ERROR, LESSON_ERROR_BROKEN,
      _ ("the questions of this lesson are about more than %d sites in total"),
      MAX_SITES_ASKED);
  return FALSE;
}

/* Finds where the question is asked, and keeps it with the stop. */
static gboolean
find_question (Player *player)
{
  LessonStop *stop = player->stop;
  Session *session = player->session;
  GError *reason = NULL;

  /* Questions are about the hull of the lifts. */
  session_put_exhibit (session, EXHIBIT_LIFTS, session->step);
  if (!check_few_asked (player, &reason) || !generate (player, &reason)
      || !question_locate (stop->question, session_get_trace (session),
                           &stop->occasion, &reason)
      || (reason = find_leak (player, &stop->occasion)) != NULL) {
    blame (player, stop->question->line, stop->question->column, reason);
    return FALSE;
  }
  session_put_step (session, stop->occasion.step);
  stop->ask_state = session_get_state (session);
  return TRUE;
}

static void
tell (Player *player, const char *text, gboolean holds, const char *actual)
{
  LessonCommand command = { .line = player->stop->question->line,
                            .column = 1,
                            .text = (char *)text };

  player->on_expect (&command, holds, actual, player->user);
}

/* A question is a test of itself: what the engine answers is right, and
 * something else is wrong. */
static void
check_question (Player *player)
{
  const Question *question = player->stop->question;
  const Occasion *occasion = &player->stop->occasion;
  g_autoptr (Attempt) model = answer_model (question, occasion);
  g_autoptr (Attempt) wrong = answer_wrong (question, occasion);
  g_autoptr (Verdict) right = attempt_grade (model, question, occasion);
  g_autoptr (Verdict) verdict = attempt_grade (wrong, question, occasion);
  g_autofree char *graded = g_strdup_printf (
      "%u of %u right, %u wrong", right->right, right->total, right->wrong);

  tell (player, "ask: its place exists, before its answer is shown", TRUE,
        NULL);
  tell (player, "ask: the answer is not empty", right->total > 0, "nothing");
  tell (player, "ask: a model answer is right", right->is_right, graded);
  tell (player, "ask: a wrong answer is wrong", !verdict->is_right, "right");
}

/* A performance too: what QuickHull does itself scores 100 %. */
static void
check_performance (Player *player)
{
  const LessonStop *stop = player->stop;
  g_autoptr (Exercise) model
      = exercise_new (stop->question, player->session->run, &stop->occasion);
  g_autoptr (Exercise) wrong
      = exercise_new (stop->question, player->session->run, &stop->occasion);
  g_autofree char *right = NULL, *score = NULL;

  performance_play (model->performance, TRUE);
  performance_play (wrong->performance, FALSE);
  exercise_finish (model);
  exercise_finish (wrong);
  right = performance_score_text (model->performance);
  score = performance_score_text (wrong->performance);
  tell (player, "ask: its place exists, before its answer is shown", TRUE,
        NULL);
  tell (player, "ask: there are tasks to perform",
        model->performance->tasks->len > 0, "none");
  tell (player, "ask: the model answer of the performance scores 100 %",
        model->verdict->is_right, right);
  tell (player, "ask: wrong answers to all tasks score nothing",
        wrong->verdict->right == 0, score);
}

static void
play_question (Player *player)
{
  LessonStop *stop = player->stop;

  if (player->is_filling && !find_question (player))
    return;
  if (player->on_expect != NULL && stop->question->kind == QUESTION_PERFORM)
    check_performance (player);
  else if (player->on_expect != NULL)
    check_question (player);
  session_put_step (player->session, stop->occasion.reveal);
  if (player->is_filling)
    note_reached (player);
}

/* Stops */

static gboolean
is_over (const Player *player)
{
  return player->is_over || lesson_faults_is_full (player->faults);
}

static void
play_commands (Player *player)
{
  LessonStop *stop = player->stop;
  const guint n = stop->commands->len;

  for (guint i = 0; i <= n && !is_over (player); i++) {
    const LessonCommand *command
        = i < n ? g_ptr_array_index (stop->commands, i) : NULL;

    if (stop->question != NULL && i == stop->n_setup)
      play_question (player);
    if (command == NULL)
      break;
    play_command (player, command);
    check_few_sites (player, command);
  }
  if (player->is_filling)
    note_reached (player);
}

static void
play_stop (Player *player, guint stop)
{
  Session *session = player->session;
  Lesson *lesson = session->lesson;

  session_hold (session);
  session->is_replaying = TRUE;
  session_put_state (session, NULL,
                     stop == 0 ? lesson->start
                               : lesson_stop (lesson, stop - 1)->state);
  session->stop = stop;
  player->stop = g_ptr_array_index (lesson->stops, stop);
  /* Beside a question stands what its own scene selects alone. */
  if (player->stop->question != NULL)
    session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  play_commands (player);
  session->is_replaying = FALSE;
  session_tell (session, CHANGED_LESSON);
  session_release (session);
}

gboolean
session_play_stop (Session *session,
                   guint stop,
                   SessionExpect on_expect,
                   gpointer user,
                   GError **error)
{
  g_autoptr (LessonFaults) faults = lesson_faults_new ();
  Player player = {
    .session = session, .on_expect = on_expect, .user = user, .faults = faults
  };

  g_return_val_if_fail (stop < session_get_n_stops (session), FALSE);
  play_stop (&player, stop);
  if (faults->errors->len == 0)
    return TRUE;
  g_propagate_error (error,
                     g_error_copy (g_ptr_array_index (faults->errors, 0)));
  return FALSE;
}

void
lesson_fill_states (Lesson *lesson, LessonFaults *faults)
{
  g_autoptr (Session) session = session_new ();
  g_autoptr (GHashTable) reached
      = g_hash_table_new_full (NULL, NULL, (GDestroyNotify)run_unref, g_free);
  Player player = {
    .session = session, .faults = faults, .is_filling = TRUE, .reached = reached
  };
  GError *error = NULL;

  /* Scaling fails only beyond the range, which the reader has checked. */
  if (!session_set_sites (session, lesson->sites, lesson->n_sites, &error)) {
    lesson_faults_take (faults, error);
    return;
  }
  session_put_step (session, 0);
  session_tell_theme (session, lesson->theme);
  session_set_views (session, lesson->views);
  lesson->start = session_get_state (session);
  session->lesson = lesson_ref (lesson);
  session->n_sites_made = lesson->n_sites;

  for (guint i = 0; i < lesson->stops->len && !is_over (&player); i++) {
    LessonStop *stop = g_ptr_array_index (lesson->stops, i);

    play_stop (&player, i);
    stop->state = session_get_state (session);
    stop->step = session_get_step (session);
  }
}
