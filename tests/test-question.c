/* What is right, what is wrong, and why: on sets whose facts are known, and
 * on sets by seed against brute force. */
#include "attempt.h"
#include "lesson-text.h"
#include "lesson.h"
#include "lift-judge.h"
#include "standing.h"

#include <string.h>

/* A question in a lesson of its own. */
typedef struct Asked {
  Lesson *lesson;
  Question *question;
  const Occasion *occasion;
  Answer *answer;
} Asked;

static Asked
ask (const char *sites, const char *lines)
{
  g_autofree char *text
      = g_strdup_printf ("# T\n\n```lesson\nformat 1\nsites %s\n```\n\n## S\n\n"
                         "```ask\n%s\n```\n",
                         sites, lines);
  g_autoptr (GError) error = NULL;
  Asked asked;

  asked.lesson = lesson_parse (text, strlen (text), "l.md", &error);
  g_assert_no_error (error);
  asked.question = lesson_stop (asked.lesson, 0)->question;
  asked.occasion = &lesson_stop (asked.lesson, 0)->occasion;
  asked.answer = answer_new (asked.question, asked.occasion);
  return asked;
}

static void
asked_clear (Asked *asked)
{
  answer_free (asked->answer);
  lesson_unref (asked->lesson);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Asked, asked_clear)

/* Returns: (transfer full): "0 3": the numbers of the right objects. */
static char *
numbers_of (const Asked *asked)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < asked->answer->objects->len; i++)
    g_string_append_printf (
        text, "%s%u", i == 0 ? "" : " ",
        g_array_index (asked->answer->objects, Object, i).number);
  for (guint i = 0; i < asked->answer->numbers->len; i++)
    g_string_append_printf (
        text, "%s%d", i == 0 ? "" : " ",
        (int)g_array_index (asked->answer->numbers, gint64, i));
  return g_string_free (text, FALSE);
}

#define LECTURE8                                                               \
  "-1 -0.5; 1 -0.8125; 0.75 0.8125; -0.9375 0.5625; 0.1875 -0.1875; "          \
  "0.5 -0.1875; -0.0625 -0.4375; 0 0.25"
#define TIE6                                                                   \
  "-0.75 -0.5625; 0.75 -0.5625; 0 0.75; 0 -0.125; -0.25 -0.375; 0.25 -0.375"
#define MIXED8                                                                 \
  "-0.25 -0.5; -0.0625 -0.125; -0.25 -0.875; 0.8125 0.3125; 0.75 -0.9375; "    \
  "-0.875 0.5625; 0.25 -0.625; -0.625 -1"
#define VERTICAL5 "-0.625 0; 0.625 0; 0 0.6875; 0 0; 0.0625 -0.5625"
#define SQUARE4 "-0.5 -0.5; 0.5 -0.5; 0.5 0.5; -0.5 0.5"

/* Facts of the curated sets: tests/sites, verified elsewhere. */
static void
test_answers_are_the_known_facts (void)
{
  static const struct {
    const char *sites, *lines, *numbers;
  } rows[] = {
    { LECTURE8, "simplex\nclick outside-set f0", "4 5 6 7" },
    { LECTURE8, "simplex\nclick sites-that-see f1", "4 5 6 7" },
    { LECTURE8, "before round 1 choose\nclick furthest-site", "4" },
    { LECTURE8, "before round 1 see\nnumber visible horizon cone", "2 4 4" },
    { LECTURE8, "before round 3 see\ndelta", "3 5 4 10" },
    { LECTURE8, "complete\nnumber facets lower upper", "12 10 2" },
    { LECTURE8, "before round 1\norder sites", "4 5 6 7" },
    { MIXED8, "before round 2 see\nwhich-kind", "1" },
    { MIXED8, "before round 4 see\nwhich-kind", "0 1" },
    { MIXED8, "before round 2 see\ndelta", "0 3 4 8" },
    { MIXED8, "complete\nclick hull-corners", "3 5 7 4" },
    { TIE6, "before round 1\nclick furthest-site", "4 5" },
    { VERTICAL5, "before round 1 see\nnumber visible-vertical", "1" },
    { SQUARE4, "complete\nclick unbounded-cells", "0 1 2 3" },
    { SQUARE4, "complete\nclick neighbours s0", "1 3" },
    { "0 0; 1 0; 0 1; 1 0; 2 2", "complete\nclick duplicates", "3" },
    { LECTURE8, "before round 1\norder phases", "2 3 4 5 6" },
    { LECTURE8, "complete\nalways cone = visible + 2", "0" },
    { LECTURE8, "complete\nalways facets = 2*inserted - 4", "0" },
    { LECTURE8, "complete\nalways vertical = 0", "1" },
    { LECTURE8, "complete\nalways lower > upper", "1" },
    { LECTURE8, "complete\nalways voronoi-vertices = triangles", "1" },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_auto (Asked) asked = ask (rows[i].sites, rows[i].lines);
    g_autofree char *numbers = numbers_of (&asked);

    if (strcmp (numbers, rows[i].numbers) == 0)
      continue;
    g_test_message ("%s: %s, not %s", rows[i].lines, numbers, rows[i].numbers);
    g_test_fail ();
  }
}

static Verdict *
grade (const Asked *asked, const Object *objects, guint n)
{
  g_autoptr (Attempt) attempt = attempt_new (asked->question);

  for (guint i = 0; i < n; i++)
    attempt_toggle (attempt, asked->question, objects[i]);
  return attempt_grade (attempt, asked->question, asked->occasion);
}

static void
test_each_of_the_tied_is_right (void)
{
  g_auto (Asked) asked = ask (TIE6, "before round 1\nclick furthest-site");

  for (guint site = 0; site < 6; site++) {
    const Object object = { OBJECT_SITE, site };
    g_autoptr (Verdict) verdict = grade (&asked, &object, 1);

    g_assert_cmpuint (verdict->total, ==, 1);
    g_assert_cmpint (verdict->is_right, ==, site == 4 || site == 5);
  }
}

/* Both orders of two tied sites are legal, and no other is. */
static void
test_each_legal_order_is_right (void)
{
  g_auto (Asked) tied = ask (TIE6, "before round 1\norder sites");
  g_auto (Asked) plain = ask (LECTURE8, "before round 1\norder sites");
  static const guint wrong[] = { 5, 4, 6, 7 };
  Object objects[4];

  for (guint first = 4; first < 6; first++) {
    g_autoptr (Verdict) verdict = NULL;

    objects[0] = (Object){ OBJECT_SITE, first };
    objects[1] = (Object){ OBJECT_SITE, 9 - first };
    verdict = grade (&tied, objects, 2);
    g_assert_true (verdict->is_right);
  }
  for (guint i = 0; i < 4; i++)
    objects[i] = (Object){ OBJECT_SITE, wrong[i] };
  {
    g_autoptr (Verdict) verdict = grade (&plain, objects, 4);

    g_assert_false (verdict->is_right);
    g_assert_cmpstr (g_ptr_array_index (verdict->reasons, 0), ==,
                     "s5 is not the furthest of its outside set: s4 lies "
                     "further in front of the facet.");
  }
}

static void
test_reasons_are_in_the_words_of_the_mathematics (void)
{
  static const struct {
    const char *sites, *lines;
    Object object;
    const char *reason;
  } rows[] = {
    { LECTURE8,
      "before round 1 see\nclick visible-facets",
      { OBJECT_FACET, 2 },
      "s4 does not see f2, an upper facet: it lies inside f2’s circle, by a "
      "power of −" },
    { VERTICAL5,
      "before round 1 see\nclick visible-facets",
      { OBJECT_FACET, 0 },
      "s4 does not see f0, an upper facet: it lies inside f0’s circle, by a "
      "power of −0.0032." },
    { LECTURE8,
      "before round 2 see\nclick visible-facets",
      { OBJECT_FACET, 7 },
      "s5 does not see f7: it lies outside f7’s circle, by a power of " },
    { LECTURE8,
      "simplex\nclick outside-set f0",
      { OBJECT_SITE, 0 },
      "s0 does not wait: it is in no outside set." },
    { LECTURE8,
      "complete\nclick unbounded-cells",
      { OBJECT_SITE, 4 },
      "The cell of s4 is bounded: s4 lies inside the hull in the plane." },
    { SQUARE4,
      "complete\nclick neighbours s0",
      { OBJECT_SITE, 2 },
      "The cells of s0 and s2 have one point in common but no side" },
    { LECTURE8,
      "before round 1 choose\nclick furthest-site",
      { OBJECT_SITE, 7 },
      "s7 is not the furthest from f0: s4 lies further in front of it." },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_auto (Asked) asked = ask (rows[i].sites, rows[i].lines);
    g_autoptr (Verdict) verdict = grade (&asked, &rows[i].object, 1);

    g_assert_false (verdict->is_right);
    g_assert_cmpuint (verdict->reasons->len, ==, 1);
    if (!g_str_has_prefix (g_ptr_array_index (verdict->reasons, 0),
                           rows[i].reason)) {
      g_test_message ("%s: %s", rows[i].lines,
                      (char *)g_ptr_array_index (verdict->reasons, 0));
      g_test_fail ();
    }
  }
}

/* The power of (2, 0) with respect to the unit circle is 3. */
static void
test_the_power_is_that_of_the_circle (void)
{
  g_auto (Asked) asked = ask ("1 0; 0 1; -1 0; 0 -0.5; 2 0",
                              "before round 1 see\nclick visible-facets");
  const FacetRow *facets = asked.occasion->trace->facets;

  for (guint facet = 0; facet < 4; facet++) {
    const Object object = { OBJECT_FACET, facet };
    g_autoptr (Verdict) verdict = NULL;
    g_autofree char *reason = NULL;

    if (facets[facet].site[0] + facets[facet].site[1] + facets[facet].site[2]
        != 0 + 1 + 2)
      continue;
    verdict = grade (&asked, &object, 1);
    reason = g_strdup_printf ("s4 does not see f%u: it lies outside f%u’s "
                              "circle, by a power of 3.",
                              facet, facet);
    if (facets[facet].facing == FACING_LOWER)
      g_assert_cmpstr (g_ptr_array_index (verdict->reasons, 0), ==, reason);
    else
      g_assert_cmpuint (verdict->right, ==, 1);
  }
}

/* s3 inside a triangle: every condition that a hand can reach is found, and
 * holds at the place found. */
static void
test_a_drag_is_right_where_its_condition_holds (void)
{
  static const char *const conditions[]
      = { "s7 until flip",          "s3 until only-upper",
          "s7 until not inside s7", "s3 until lower-and-upper",
          "s7 until tie",           "s4 until unbounded s4",
          "s7 until vertical",      "s3 until bounded s3",
          "s7 until triangles < 10" };

  for (guint i = 0; i < G_N_ELEMENTS (conditions); i++) {
    g_autofree char *lines
        = g_strdup_printf ("complete\ndrag %s", conditions[i]);
    g_autoptr (Attempt) model = NULL, none = NULL;
    g_autoptr (Verdict) right = NULL, wrong = NULL;
    g_auto (Asked) asked = ask (LECTURE8, lines);

    g_assert_true (asked.answer->is_found);
    model = answer_model (asked.question, asked.occasion);
    none = attempt_new (asked.question);
    right = attempt_grade (model, asked.question, asked.occasion);
    wrong = attempt_grade (none, asked.question, asked.occasion);
    g_assert_true (right->is_right);
    g_assert_false (wrong->is_right);
  }
}

/* Brute force */

typedef struct Judged {
  const Fixture *fixture;
  Judge *judge;
} Judged;

static gboolean
has_object (const Answer *answer, ObjectKind kind, guint number)
{
  for (guint i = 0; i < answer->objects->len; i++)
    if (object_equal (g_array_index (answer->objects, Object, i),
                      (Object){ kind, number }))
      return TRUE;
  return FALSE;
}

/* A facet is in the answer exactly when the site sees it by the definition in
 * the plane. */
static void
judge_visible (const Judged *judged,
               const Question *question,
               const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  g_autoptr (Standing) standing
      = standing_new (judged->fixture, judged->judge, occasion->step);
  const guint site = occasion_round (occasion)->site;

  for (guint i = 0; i < standing->n_facets; i++)
    standing_assert (
        standing, has_object (answer, OBJECT_FACET, standing->facets[i])
                      == standing_sees (standing, standing->facets[i], site));
}

/* Whether no other site of the outside set lies further in front. */
static gboolean
is_furthest (const Trace *trace, const Occasion *occasion, guint site)
{
  const RoundRow *round = occasion_round (occasion);
  const uint32_t *corner = trace->facets[round->facet].site;
  const Site *sites = trace->set->sites;
  const Site plane[3]
      = { sites[corner[0]], sites[corner[1]], sites[corner[2]] };

  for (guint i = 0; i < trace->n_claims; i++)
    if (trace_claim (trace, i).facet == round->facet
        && span_has (trace_claim (trace, i).span, occasion->step)
        && lift_judge_further (plane, &sites[trace_claim (trace, i).site],
                               &sites[site])
               > 0)
      return FALSE;
  return TRUE;
}

static void
judge_furthest (const Judged *judged,
                const Question *question,
                const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  const Trace *trace = judged->fixture->trace;

  for (guint i = 0; i < trace->n_claims; i++) {
    const ClaimRow claim = trace_claim (trace, i);

    if (claim.facet == occasion_round (occasion)->facet
        && span_has (claim.span, occasion->step))
      g_assert_cmpint (has_object (answer, OBJECT_SITE, claim.site), ==,
                       is_furthest (trace, occasion, claim.site));
  }
}

static void
judge_corners (const Judged *judged,
               const Question *question,
               const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  g_autoptr (Standing) standing
      = standing_new (judged->fixture, judged->judge, occasion->step);

  g_assert_cmpuint (answer->objects->len, ==, standing->n_corners);
  for (guint i = 0; i < standing->n_corners; i++)
    standing_assert (standing,
                     has_object (answer, OBJECT_SITE, standing->corners[i]));
}

static void
judge_numbers (const Judged *judged,
               const Question *question,
               const Occasion *occasion)
{
  g_autoptr (Answer) answer = answer_new (question, occasion);
  g_autoptr (Standing) before
      = standing_new (judged->fixture, judged->judge, occasion->step);
  g_autoptr (Standing) after = standing_new (judged->fixture, judged->judge,
                                             occasion_round (occasion)->end);
  const gint64 *numbers = (const gint64 *)(gpointer)answer->numbers->data;
  const guint site = occasion_round (occasion)->site;
  guint n_dying = 0;

  for (guint i = 0; i < before->n_facets; i++)
    n_dying += standing_facing (before, before->facets[i]) == FACING_LOWER
               && standing_sees (before, before->facets[i], site);
  g_assert_cmpint (numbers[0], ==, n_dying);
  g_assert_cmpint (numbers[1], ==,
                   standing_count (after, FACING_LOWER) + n_dying
                       - standing_count (before, FACING_LOWER));
  g_assert_cmpint (numbers[2], ==, after->n_corners);
  g_assert_cmpint (numbers[3], ==, after->n_facets);
}

/* Every generated question: its place is found, a model answer is right, a
 * wrong one is not, and where brute force can tell, it agrees. */
static void
check_kind (const Judged *judged, const char *kind, guint seed)
{
  static const struct {
    const char *kind;
    void (*judge) (const Judged *judged,
                   const Question *question,
                   const Occasion *occasion);
  } judges[] = {
    { "visible-facets", judge_visible },
    { "furthest-site", judge_furthest },
    { "hull-corners", judge_corners },
    { "delta", judge_numbers },
  };
  const Trace *trace = judged->fixture->trace;
  g_autoptr (GError) error = NULL;
  g_autoptr (Question) question = question_generate (trace, kind, seed, &error);
  g_autoptr (Attempt) model = NULL, wrong = NULL;
  g_autoptr (Verdict) right = NULL, verdict = NULL;
  Occasion occasion;

  if (question == NULL)
    return; /* no round of this set has such a question */
  g_assert_true (question_locate (question, trace, &occasion, &error));
  model = answer_model (question, &occasion);
  wrong = answer_wrong (question, &occasion);
  right = attempt_grade (model, question, &occasion);
  verdict = attempt_grade (wrong, question, &occasion);
  g_assert_true (right->is_right);
  g_assert_false (verdict->is_right);
  for (guint i = 0; i < G_N_ELEMENTS (judges); i++)
    if (g_str_equal (judges[i].kind, kind))
      judges[i].judge (judged, question, &occasion);
}

static void
check_fixture (const Fixture *fixture)
{
  g_autoptr (Judge) judge = judge_new (fixture->set);
  const Judged judged = { fixture, judge };
  const char *const *kind = question_generate_kinds ();

  for (; *kind != NULL; kind++)
    for (guint seed = 0; seed < 3; seed++)
      check_kind (&judged, *kind, seed);
}

static void
test_generated_questions_agree_with_brute_force (void)
{
  fixture_for_each (4, 9, ORDER_FURTHEST, check_fixture);
  fixture_for_each (2, 9, ORDER_INPUT, check_fixture);
}

static void
test_the_same_seed_asks_the_same_question (void)
{
  g_autoptr (Fixture) fixture = fixture_load ("lecture8", ORDER_FURTHEST);
  g_autoptr (GHashTable) positions = g_hash_table_new_full (
      g_str_hash, g_str_equal, (GDestroyNotify)g_free, NULL);

  for (guint seed = 0; seed < 20; seed++) {
    g_autoptr (Question) one
        = question_generate (fixture->trace, "horizon", seed, NULL);
    g_autoptr (Question) two
        = question_generate (fixture->trace, "horizon", seed, NULL);

    g_assert_cmpstr (one->position, ==, two->position);
    g_hash_table_add (positions, g_strdup (one->position));
  }
  g_assert_cmpuint (g_hash_table_size (positions), ==, 4);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/question/answers-are-the-known-facts", test_answers_are_the_known_facts },
  { "/question/each-of-the-tied-is-right", test_each_of_the_tied_is_right },
  { "/question/each-legal-order-is-right", test_each_legal_order_is_right },
  { "/question/reasons-are-in-the-words-of-the-mathematics",
    test_reasons_are_in_the_words_of_the_mathematics },
  { "/question/the-power-is-that-of-the-circle",
    test_the_power_is_that_of_the_circle },
  { "/question/a-drag-is-right-where-its-condition-holds",
    test_a_drag_is_right_where_its_condition_holds },
  { "/question/generated-questions-agree-with-brute-force",
    test_generated_questions_agree_with_brute_force },
  { "/question/the-same-seed-asks-the-same-question",
    test_the_same_seed_asks_the_same_question },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
