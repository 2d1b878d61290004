#include "handout-perform.h"

#include "form.h"
#include "performance.h"
#include "question-bank.h"
#include "stop-state.h"

#include <glib/gi18n.h>

#define ROW_GAP 4.0

/* Before the names of what is chosen. */
static const char *
label_of (TaskKind kind)
{
  switch (kind) {
  case TASK_PARTITION:
    return _ ("Outside sets:");
  case TASK_FACET:
    return _ ("Facet:");
  case TASK_SITE:
    return _ ("Furthest site:");
  case TASK_SEE:
    return _ ("It sees:");
  case TASK_HORIZON:
    return _ ("Horizon:");
  case TASK_CONE:
    return _ ("New triangles over:");
  case TASK_HAND_OVER:
    return _ ("Handed over:");
  }
  return "";
}

static void
add_heading (const Handout *handout, Block *stack, guint insertion)
{
  g_autofree char *text = g_strdup_printf (_ ("Insertion %u"), insertion);

  block_add_below (
      stack, handout_words (handout, TEXT_LABEL, stack->width, text), PART_GAP);
}

/* Room */

void
handout_add_tasks (const Handout *handout, const LessonStop *stop, Block *stack)
{
  for (guint i = 1; i <= stop->question->n_insertions; i++) {
    add_heading (handout, stack, i);
    for (guint kind = TASK_FACET; kind < N_TASK_KINDS; kind++)
      block_add_below (
          stack,
          form_entry (&handout->press, stack->width, label_of ((TaskKind)kind)),
          ROW_GAP);
  }
}

/* Answer */

/* The objects of an answer; where each is a whole one, the first. */
static char *
names_of (const Exercise *exercise)
{
  GString *names = g_string_new (NULL);
  const GArray *objects = exercise->attempt->objects;
  Frame frame;

  frame_init (&frame, exercise->occasion.trace, exercise->occasion.step);
  for (guint i = 0; i < objects->len; i++) {
    g_autofree char *name = question_object_text (
        exercise->question, &frame, g_array_index (objects, Object, i));

    g_string_append_printf (names, "%s%s", i == 0 ? "" : ", ", name);
  }
  frame_clear (&frame);
  return g_string_free (names, FALSE);
}

static void
add_task (const Handout *handout, const Task *task, Block *stack)
{
  g_autofree char *names = names_of (task->exercise);
  g_autofree char *site = task->site == INDEX_NONE
                              ? g_strdup ("")
                              : g_strdup_printf ("s%u → ", task->site);
  g_autofree char *markup
      = g_markup_printf_escaped ("%s %s%s", label_of (task->kind), site, names);

  block_add_below (
      stack, block_text (&handout->press, TEXT_SMALL, stack->width, markup), 1);
}

void
handout_add_performance (const Handout *handout,
                         const LessonStop *stop,
                         Block *stack)
{
  const Question *question = stop->question;
  g_autoptr (Performance) performance
      = performance_new (stop->ask_state->run, &stop->occasion,
                         (guint)question->n_insertions, question->n_retries);
  guint round = 0;

  performance_play (performance, TRUE);
  for (guint i = 0; i < performance->tasks->len; i++) {
    const Task *task = g_ptr_array_index (performance->tasks, i);

    if (task->round != round)
      add_heading (handout, stack, task->round - performance->first_round + 1);
    round = task->round;
    add_task (handout, task, stack);
  }
}
