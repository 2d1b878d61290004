/* Questions made by the engine from a kind and a seed. */
#include "lesson.h"
#include "question-click.h"

#include <glib/gi18n.h>

/* Of a round: asked before the phase. */
typedef struct Generator {
  const char *name;
  const char *phase; /* NULL: the state after a round */
  const char *click; /* NULL: numbers */
  Quantity quantities[4];
  guint n_quantities;
} Generator;

static const Generator generators[] = {
  { .name = "visible-facets", .phase = "see", .click = "visible-facets" },
  { .name = "dying-triangles", .phase = "see", .click = "dying-triangles" },
  { .name = "circles", .phase = "see", .click = "circles" },
  { .name = "dying-vertices", .phase = "see", .click = "dying-vertices" },
  { .name = "horizon", .phase = "horizon", .click = "horizon" },
  { .name = "new-triangles", .phase = "cone", .click = "new-triangles" },
  { .name = "furthest-site", .phase = "choose", .click = "furthest-site" },
  { .name = "next-facet", .phase = "choose", .click = "next-facet" },
  { .name = "unbounded-cells", .click = "unbounded-cells" },
  { .name = "hull-corners", .click = "hull-corners" },
  { .name = "visible",
    .phase = "see",
    .quantities = { QUANTITY_VISIBLE },
    .n_quantities = 1 },
  { .name = "cone",
    .phase = "horizon",
    .quantities = { QUANTITY_HORIZON, QUANTITY_CONE },
    .n_quantities = 2 },
  { .name = "delta",
    .phase = "see",
    .quantities = { QUANTITY_DYING_TRIANGLES, QUANTITY_NEW_TRIANGLES,
                    QUANTITY_HULL_CORNERS, QUANTITY_FACETS },
    .n_quantities = 4 },
};

const char *const *
question_generate_kinds (void)
{
  static const char *names[G_N_ELEMENTS (generators) + 1];

  for (guint i = 0; i < G_N_ELEMENTS (generators); i++)
    names[i] = generators[i].name;
  return names;
}

static const Generator *
find (const char *kind)
{
  for (guint i = 0; i < G_N_ELEMENTS (generators); i++)
    if (g_str_equal (kind, generators[i].name))
      return &generators[i];
  return NULL;
}

static Question *
make (const Generator *generator, guint round)
{
  Question *question = question_new ();

  question->position
      = generator->phase == NULL
            ? g_strdup_printf ("round %u", round)
            : g_strdup_printf ("before round %u %s", round, generator->phase);
  question->kind = generator->click == NULL ? QUESTION_NUMBERS : QUESTION_CLICK;
  if (generator->click != NULL)
    question->click = click_kind_find (generator->click);
  g_array_append_vals (question->quantities, generator->quantities,
                       generator->n_quantities);
  return question;
}

/* The seed chooses the round; where the question cannot be asked there, the
 * next one. */
Question *
question_generate (const Trace *trace,
                   const char *kind,
                   guint64 seed,
                   GError **error)
{
  const Generator *generator = find (kind);
  guint64 state = seed;
  guint first;

  g_return_val_if_fail (generator != NULL, NULL);
  first = trace->n_rounds == 0 ? 0 : order_random (&state) % trace->n_rounds;
  for (guint i = 0; i < trace->n_rounds; i++) {
    g_autoptr (Question) question
        = make (generator, 1 + (first + i) % trace->n_rounds);
    Occasion occasion;

    if (question_locate (question, trace, &occasion, NULL))
      return g_steal_pointer (&question);
  }
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
               _ ("no round of these sites has a question “%s”"), kind);
  return NULL;
}

static gboolean
is_like (const Generator *generator, const Question *question)
{
  if (generator->click != NULL)
    return question->kind == QUESTION_CLICK
           && g_str_equal (question->click->name, generator->click);
  if (question->kind != QUESTION_NUMBERS
      || question->quantities->len != generator->n_quantities)
    return FALSE;
  for (guint i = 0; i < generator->n_quantities; i++)
    if (g_array_index (question->quantities, Quantity, i)
        != generator->quantities[i])
      return FALSE;
  return TRUE;
}

const char *
question_generator_of (const Question *question)
{
  for (guint i = 0; i < G_N_ELEMENTS (generators); i++)
    if (is_like (&generators[i], question))
      return generators[i].name;
  return NULL;
}
