#include "question.h"

#include "object-name.h"
#include "prose.h"
#include "question-click.h"
#include "scene.h"

#include <glib/gi18n.h>
#include <string.h>

static void
option_free (gpointer data)
{
  QuestionOption *option = data;

  g_free (option->text);
  g_clear_pointer (&option->condition, condition_free);
  g_free (option);
}

Question *
question_new (void)
{
  Question *question = g_new0 (Question, 1);

  question->reference_count = 1;
  question->hints = g_ptr_array_new_with_free_func (g_free);
  question->options = g_ptr_array_new_with_free_func (option_free);
  question->quantities = g_array_new (FALSE, FALSE, sizeof (Quantity));
  question->site = INDEX_NONE;
  return question;
}

Question *
question_ref (Question *question)
{
  g_atomic_int_inc (&question->reference_count);
  return question;
}

void
question_unref (Question *question)
{
  if (!g_atomic_int_dec_and_test (&question->reference_count))
    return;
  g_free (question->position);
  g_free (question->prompt);
  g_ptr_array_unref (question->hints);
  g_ptr_array_unref (question->options);
  g_array_unref (question->quantities);
  g_clear_pointer (&question->condition, condition_free);
  g_free (question->generate);
  g_free (question->fresh);
  g_free (question);
}

const RoundRow *
occasion_round (const Occasion *occasion)
{
  return occasion->round == 0 || occasion->round > occasion->trace->n_rounds
             ? NULL
             : &occasion->trace->rounds[occasion->round - 1];
}

/* What would give it away */

static gboolean
is_about_facing (const Question *question)
{
  for (guint i = 0; i < question->quantities->len; i++) {
    const Quantity quantity = g_array_index (question->quantities, Quantity, i);

    if (quantity >= QUANTITY_LOWER && quantity <= QUANTITY_VERTICAL)
      return TRUE;
  }
  return question->kind == QUESTION_CHOOSE
         && question->argument.kind == OBJECT_FACET;
}

guint
question_mask (const Question *question)
{
  if (question->kind == QUESTION_CLICK)
    return question->click->mask;
  if (question->kind == QUESTION_DRAG || question->kind == QUESTION_ALWAYS)
    return 0;
  if (is_about_facing (question))
    return MASK_FACING;
  return question->kind == QUESTION_ORDER ? MASK_ROUND : 0;
}

/* What is asked, in words */

/* Returns: (transfer full): @template with the names in place of {p}, {f},
 *          {a}. */
static char *
fill (const char *template, const Question *question, const Occasion *occasion)
{
  GString *text = g_string_new (template);
  const RoundRow *round = occasion_round (occasion);
  char name[OBJECT_NAME_ROOM];

  object_name_write (question->argument, name);
  g_string_replace (text, "{a}", name, 0);
  if (round != NULL) {
    object_name_write ((Object){ OBJECT_SITE, round->site }, name);
    g_string_replace (text, "{p}", name, 0);
    object_name_write ((Object){ OBJECT_FACET, round->facet }, name);
    g_string_replace (text, "{f}", name, 0);
  }
  return g_string_free (text, FALSE);
}

static const char *
order_template (QuestionOrder order)
{
  switch (order) {
  case ORDER_OF_SITES:
    return _ ("In which order will QuickHull **insert** these sites?");
  case ORDER_OF_OUTSIDE_SET:
    return _ ("Put the outside set of {a} in order: **the furthest from {a} "
              "first**.");
  case ORDER_OF_PHASES:
    return _ ("Put the phases of this round **in order**.");
  }
  return "";
}

static const char *
template_of (const Question *question)
{
  switch (question->kind) {
  case QUESTION_CHOOSE:
    if (question->argument.kind == OBJECT_FACET)
      return _ ("Which kind of facet is {a}?");
    return question->is_several ? _ ("Which are right?")
                                : _ ("Which is right?");
  case QUESTION_NUMBERS:
    return question->quantities->len == 1 ? _ ("How many?")
                                          : _ ("Predict the numbers.");
  case QUESTION_CLICK:
    return _ (question->click->prompt);
  case QUESTION_ORDER:
    return order_template (question->order);
  case QUESTION_DRAG:
  case QUESTION_ALWAYS:
    break;
  case QUESTION_PERFORM:
    return _ ("**You be QuickHull.** Do what the algorithm does.");
  }
  return "";
}

char *
question_prompt (const Question *question, const Occasion *occasion)
{
  g_autofree char *sentence = NULL;

  if (question->prompt != NULL)
    return g_strdup (question->prompt);
  if (question->condition == NULL)
    return fill (template_of (question), question, occasion);
  sentence = condition_sentence (question->condition);
  if (question->kind == QUESTION_DRAG)
    return g_strdup_printf (_ ("Drag **s%u** until %s."), question->site,
                            sentence);
  return g_strdup_printf (_ ("Is this true for **every** set of sites? %s"),
                          sentence);
}

char *
question_instruction (const Question *question)
{
  switch (question->kind) {
  case QUESTION_CHOOSE:
    return g_strdup (question->is_several ? _ ("Choose all that are right.")
                                          : _ ("Choose one."));
  case QUESTION_NUMBERS:
    return g_strdup (question->quantities->len == 1
                         ? _ ("Type a whole number.")
                         : _ ("Type a whole number for each."));
  case QUESTION_CLICK:
    return g_strdup (_ ("Click in either picture; a second click takes it "
                        "back. Tab and Enter do the same."));
  case QUESTION_ORDER:
    return g_strdup (_ ("Choose them one after the other."));
  case QUESTION_DRAG:
    return g_strdup (_ ("Drag in the plane, or use the arrow keys; sites snap "
                        "to a grid, so that ties can be hit."));
  case QUESTION_ALWAYS:
    return g_strdup (_ ("If it is not true, drag sites until it fails."));
  case QUESTION_PERFORM:
    return g_strdup (_ ("Every move that QuickHull may make is right."));
  }
  return NULL;
}

/* What can be chosen */

/* The vertex of the circle group of a triangle. */
static gboolean
take_vertex (const Frame *frame, Object *object)
{
  const Delaunay *delaunay = &frame->delaunay;

  for (guint i = 0; i < delaunay->n_triangles; i++)
    if (delaunay->triangles[i].facet == object->number) {
      const guint group = delaunay->triangles[i].group;
      const guint first = frame->voronoi.vertices[group].triangle;

      *object = (Object){ OBJECT_VERTEX, delaunay->triangles[first].facet };
      return TRUE;
    }
  return FALSE;
}

gboolean
question_takes (const Question *question, const Frame *frame, Object *object)
{
  if (question->kind == QUESTION_ORDER)
    return object->kind == OBJECT_SITE && question->order != ORDER_OF_PHASES;
  if (question->kind != QUESTION_CLICK)
    return FALSE;
  if (question->click->target == OBJECT_VERTEX
      && (object->kind == OBJECT_FACET || object->kind == OBJECT_VERTEX))
    return take_vertex (frame, object);
  return object->kind == question->click->target;
}

static void
add_item (GArray *items, ObjectKind kind, guint number)
{
  const Object item = { kind, number };

  g_array_append_val (items, item);
}

static int
compare_items (gconstpointer a, gconstpointer b)
{
  const Object *left = a, *right = b;

  return left->number < right->number ? -1 : left->number > right->number;
}

/* Phases stand by their names, which is not their order. */
static void
add_phases (GArray *items)
{
  static const Phase phases[]
      = { PHASE_CHOOSE, PHASE_CONE, PHASE_HAND_OVER, PHASE_HORIZON, PHASE_SEE };

  for (guint i = 0; i < G_N_ELEMENTS (phases); i++)
    add_item (items, OBJECT_NONE, phases[i]);
}

GArray *
question_items (const Question *question, const Occasion *occasion)
{
  GArray *items = g_array_new (FALSE, FALSE, sizeof (Object));
  const Trace *trace = occasion->trace;

  if (question->order == ORDER_OF_PHASES) {
    add_phases (items);
    return items;
  }
  for (guint i = 0; i < trace->n_claims; i++)
    if (span_has (trace_claim (trace, i).span, occasion->step)
        && (question->order == ORDER_OF_SITES
            || trace_claim (trace, i).facet == question->argument.number))
      add_item (items, OBJECT_SITE, trace_claim (trace, i).site);
  g_array_sort (items, compare_items);
  return items;
}

static const char *
phase_text (guint phase)
{
  switch ((Phase)phase) {
  case PHASE_CHOOSE:
    return _ ("choose a facet and its furthest site");
  case PHASE_SEE:
    return _ ("find the visible facets");
  case PHASE_HORIZON:
    return _ ("find the horizon");
  case PHASE_CONE:
    return _ ("build the cone");
  case PHASE_HAND_OVER:
    return _ ("retire the visible facets, and hand over the outside sets");
  case PHASE_START:
  case PHASE_SIMPLEX:
  case PHASE_COMPLETE:
    break;
  }
  return "";
}

/* The one place of @format is for a number, also in other languages. */
static char *
numbered (const char *format, guint32 number)
{
  g_auto (GStrv) parts = g_strsplit (format, "%u", 2);

  if (parts[0] == NULL || parts[1] == NULL)
    return g_strdup (format);
  return g_strdup_printf ("%s%u%s", parts[0], number, parts[1]);
}

/* The last one: there may be others in the text. */
const char *
question_find_if (const char *option)
{
  const char *found = NULL;

  for (const char *at = strstr (option, " if "); at != NULL;
       at = strstr (at + 1, " if "))
    found = at;
  return found;
}

char *
question_option_words (const char *option)
{
  const char *at = question_find_if (option);

  return at == NULL ? NULL : g_strstrip (g_strndup (option, at - option));
}

char *
question_item_text (const Question *question, Object item)
{
  char name[OBJECT_NAME_ROOM];

  if (item.kind != OBJECT_NONE && question->click != NULL
      && question->click->item != NULL)
    return numbered (_ (question->click->item), item.number);
  if (item.kind != OBJECT_NONE) {
    object_name_write (item, name);
    return g_strdup (name);
  }
  if (question->kind == QUESTION_ORDER)
    return g_strdup (phase_text (item.number));
  if (question->kind == QUESTION_ALWAYS)
    return g_strdup (item.number == 0 ? _ ("Yes, for every set")
                                      : _ ("No, not for every set"));
  return prose_to_text (
      ((QuestionOption *)g_ptr_array_index (question->options, item.number))
          ->text);
}
