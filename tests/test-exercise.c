/* A person at the questions of a lesson, through the session and its
 * actions. */
#include "action.h"
#include "attempt.h"
#include "laws.h"
#include "learner.h"

#include <math.h>
#include <string.h>

static const char lesson_text[]
    = LECTURE "## Which?\n\n```ask\nbefore round 1 see\nclick visible-facets\n"
              "hint one\nhint two\nretry 1\n```\n\n"
              "```steps\ngoto round 1 see\nshow circumcircles\n```\n\n"
              "## After\n\n```steps\ngoto round 1\n```\n\n"
              "## Numbers\n\n```ask\nbefore round 2 see\nnumber visible cone\n"
              "```\n\n"
              "## Drag\n\n```ask\ncomplete\ndrag s7 until unbounded s7\n```\n";

static Session *
begin (void)
{
  return learner_open (lesson_text, NULL);
}

static void
toggle (Session *session, const char *object)
{
  learner_act (session, "answer-toggle", g_variant_new_string (object));
}

static void
assert_state (Session *session, const char *state)
{
  g_autoptr (GVariant) value = g_variant_ref_sink (
      action_get_state (action_find ("question"), session));

  g_assert_cmpstr (g_variant_get_string (value, NULL), ==, state);
}

static void
test_a_question_stops_before_its_event (void)
{
  g_autoptr (Session) session = begin ();
  const Place place = session_get_place (session);
  g_autofree char *sentence = session_narrate (session);

  assert_state (session, "open");
  g_assert_cmpuint (place.round, ==, 1);
  g_assert_cmpint (place.phase, ==, PHASE_CHOOSE);
  g_assert_true (session_is_asking (session));
  g_assert_cmpuint (session_get_look (session)->mask, ==,
                    MASK_ROUND | MASK_WHY);
  g_assert_null (strstr (sentence, "s4"));
}

/* No shape of the masked picture has a role of the round, at any step at which
 * the question could stand. */
static void
test_the_mask_leaves_no_role_of_the_round (void)
{
  g_autoptr (Session) session = begin ();
  const Trace *trace = session_get_trace (session);
  Scene scene = { 0 };

  for (guint step = 0; step <= trace->n_events; step++)
    for (guint view = 0; view < 2; view++) {
      SceneLook look = *session_get_look (session);
      Frame frame;

      frame_init (&frame, trace, step);
      look.mask = MASK_ROUND | MASK_WHY | (step % 2 == 0 ? MASK_FACING : 0);
      look.low = (Point3){ -2, -2, 0 };
      look.high = (Point3){ 2, 2, 0 };
      (view == 0 ? scene_plane : scene_space) (&scene, &frame, &look);
      for (guint i = 0; i < scene.n_items; i++) {
        const Role role = scene.items[i].role;

        g_assert_false (role >= ROLE_VISIBLE && role <= ROLE_SELECTED_FACET);
        g_assert_true (role != ROLE_HORIZON && role != ROLE_HORIZON_UPPER
                       && role != ROLE_CIRCLE_VISIBLE && role != ROLE_DROP
                       && role != ROLE_VORONOI_VERTEX_DYING
                       && role != ROLE_SITE_OUTSIDE && role != ROLE_CONE_EDGE
                       && role != ROLE_VISIBLE_EDGE);
        if (look.mask & MASK_FACING)
          g_assert_true (role != ROLE_LOWER && role != ROLE_UPPER
                         && role != ROLE_VERTICAL && role != ROLE_TRIANGLE
                         && role != ROLE_CELL && role != ROLE_DELAUNAY_EDGE);
      }
      frame_clear (&frame);
    }
  scene_clear (&scene);
}

static void
test_a_right_answer_goes_on_to_what_it_shows (void)
{
  g_autoptr (Session) session = begin ();

  toggle (session, "f0");
  toggle (session, "f2");
  toggle (session, "f2");
  toggle (session, "f1");
  g_assert_cmpuint (session_get_look (session)->n_answers, ==, 2);
  learner_act (session, "check", NULL);
  assert_state (session, "right");
  g_assert_false (session_is_asking (session));
  g_assert_cmpuint (session_get_look (session)->mask, ==, 0);
  g_assert_cmpint (session_get_place (session).phase, ==, PHASE_SEE);
  g_assert_true (session_get_look (session)->layers & LAYER_CIRCLES);
  learner_act (session, "continue", NULL);
  g_assert_cmpuint (session_get_stop (session), ==, 1);
  /* Back, the end of the stop is shown, not its question. */
  session_set_stop (session, 0);
  assert_state (session, "right");
  g_assert_cmpint (session_get_place (session).phase, ==, PHASE_SEE);
}

static void
test_a_wrong_answer_has_its_retries (void)
{
  g_autoptr (Session) session = begin ();
  const Exercise *exercise = session_get_exercise (session);

  toggle (session, "f2");
  learner_act (session, "check", NULL);
  assert_state (session, "wrong");
  g_assert_true (session_is_asking (session));
  g_assert_cmpuint (exercise->verdict->wrong, ==, 1);
  g_assert_cmpint (session_get_look (session)->answers[0].kind, ==,
                   ANSWER_WRONG);
  g_assert_cmpuint (session_get_look (session)->n_answers, ==, 1);
  learner_act (session, "answer-undo", NULL);
  assert_state (session, "open");
  toggle (session, "f0");
  learner_act (session, "check", NULL);
  assert_state (session, "shown");
  g_assert_cmpuint (exercise->verdict->missing, ==, 1);
  g_assert_false (exercise->was_right_at_once);
  learner_act (session, "retry", NULL);
  assert_state (session, "open");
  g_assert_true (session_is_asking (session));
}

static void
test_hints_come_one_after_the_other (void)
{
  g_autoptr (Session) session = begin ();

  g_assert_cmpuint (session_get_exercise (session)->n_hints, ==, 0);
  learner_act (session, "hint", NULL);
  learner_act (session, "hint", NULL);
  g_assert_cmpuint (session_get_exercise (session)->n_hints, ==, 2);
  g_assert_false (action_run (session, "hint", NULL, NULL));
}

/* A clicker alone gets through: answer, go on, answer, go on. */
static void
test_no_question_holds_a_class_up (void)
{
  g_autoptr (Session) session = begin ();
  static const guint stops[] = { 0, 1, 2, 2, 3, 3 };

  for (guint i = 0; i < G_N_ELEMENTS (stops); i++) {
    g_assert_true (session_can_next (session));
    learner_act (session, "next", NULL);
    g_assert_cmpuint (session_get_stop (session), ==, stops[i]);
  }
  assert_state (session, "shown");
  g_assert_false (session_can_next (session));
}

static void
test_stepping_past_the_event_shows_the_answer (void)
{
  g_autoptr (Session) session = begin ();

  learner_act (session, "back-event", NULL);
  assert_state (session, "open");
  g_assert_false (session_is_asking (session));
  learner_act (session, "next-event", NULL);
  g_assert_true (session_is_asking (session));
  learner_act (session, "next-event", NULL);
  assert_state (session, "shown");
}

static void
test_numbers_are_answered_by_their_place (void)
{
  g_autoptr (Session) session = begin ();

  session_set_stop (session, 2);
  learner_act (session, "answer-number", g_variant_new ("(uu)", 1, 1));
  learner_act (session, "answer-number", g_variant_new ("(uu)", 2, 3));
  learner_act (session, "check", NULL);
  assert_state (session, "right");
}

/* Returns: (transfer full): how a question of these numbers is answered. */
static char *
instruction_of (const char *keys)
{
  g_autofree char *text = g_strdup_printf (ASK ("before round 1 see\n"
                                                "number %s"),
                                           keys);
  g_autoptr (Lesson) lesson = lesson_parse (text, strlen (text), "l.md", NULL);

  return question_instruction (lesson_stop (lesson, 0)->question);
}

static void
test_one_number_is_asked_for_as_one (void)
{
  g_autofree char *one = instruction_of ("visible");
  g_autofree char *two = instruction_of ("visible cone");

  g_assert_cmpstr (one, ==, "Type a whole number.");
  g_assert_cmpstr (two, ==, "Type a whole number for each.");
}

/* s7 of the lecture lies inside; there are 12 facets, and f2 is an upper one.
 */
static void
test_an_option_is_right_for_a_reason_in_words (void)
{
  static const char *const reasons[] = {
    "“in” is right: s7 lies inside the hull in the plane.",
    ("“out” is wrong: it is not the case that s7 lies outside the hull in the "
     "plane."),
    "“not in” is wrong: s7 lies inside the hull in the plane.",
    "“many” is right (facets of the hull: 12, sites: 8).",
    ("“sees” is wrong. s7 does not see f2, an upper facet: it lies inside f2’s "
     "circle, by a power of −1.3."),
    "“down” is wrong. f2 is an upper facet: it faces away from the plane.",
    ("“open” is wrong. The cell of s7 is bounded: s7 lies inside the hull in "
     "the plane."),
  };
  static const char asked[]
      = ASK ("complete\nchoose several\noption in if inside s7\n"
             "option out if outside s7\noption not in if not inside s7\n"
             "option many if facets > sites\noption sees if sees s7 f2\n"
             "option down if is-lower f2\noption open if unbounded s7");
  g_autoptr (Lesson) lesson
      = lesson_parse (asked, sizeof asked - 1, "l.md", NULL);
  const LessonStop *stop = lesson_stop (lesson, 0);

  for (guint i = 0; i < G_N_ELEMENTS (reasons); i++) {
    g_autofree char *reason
        = answer_reason (stop->question, &stop->occasion,
                         (Object){ OBJECT_NONE, i }, i == 0 || i == 3);

    g_assert_cmpstr (reason, ==, reasons[i]);
  }
}

static void
test_a_question_shows_what_its_scene_selects (void)
{
  static const char asked[]
      = LECTURE "## A\n\n```steps\ngoto simplex\nselect f0\n```\n\n"
                "## B\n\n```ask\nsimplex\nclick sites-that-see f1\n```\n\n"
                "## C\n\n```steps\nselect f1\n```\n\n"
                "```ask\nsimplex\nclick sites-that-see f1\n```\n";
  g_autoptr (Session) session = session_new ();
  g_autoptr (Lesson) lesson
      = lesson_parse (asked, sizeof asked - 1, "l.md", NULL);

  session_set_lesson (session, lesson);
  g_assert_cmpint (session_get_look (session)->selection.kind, ==,
                   OBJECT_FACET);
  session_set_stop (session, 1);
  g_assert_cmpint (session_get_look (session)->selection.kind, ==, OBJECT_NONE);
  session_set_stop (session, 2);
  g_assert_cmpint (session_get_look (session)->selection.kind, ==,
                   OBJECT_FACET);
  g_assert_cmpuint (session_get_look (session)->selection.number, ==, 1);
}

/* What is shown as an answer can be seen: a place outside the plane makes it
 * larger. */
static void
test_a_place_that_is_shown_lies_in_the_picture (void)
{
  static const char asked[] = SITES (
      "-0.5 -0.5; 0.5 -0.5; 0.5 0.5; -0.5 0.5") "\n```ask\ncomplete\ndrag s3 "
                                                "until outside s3\n```\n";
  g_autoptr (Session) session = session_new ();
  g_autoptr (Lesson) lesson
      = lesson_parse (asked, sizeof asked - 1, "l.md", NULL);
  const Extent *extent = &session_get_look (session)->extent;

  g_assert_nonnull (lesson);
  session_set_lesson (session, lesson);
  learner_act (session, "show-answer", NULL);
  for (guint i = 0; i < 4; i++) {
    const Site site = session_get_set (session)->sites[i];

    g_assert_cmpfloat (fabs (site.x - extent->centre.x), <=, extent->radius);
    g_assert_cmpfloat (fabs (site.y - extent->centre.y), <=, extent->radius);
  }
  g_assert_cmpfloat (session_get_plane_camera (session)->zoom, ==, 1);
}

static void
test_counters_tell_nothing_while_it_asks (void)
{
  g_autoptr (Session) session = begin ();
  g_autoptr (GPtrArray) laws = laws_of (session_get_frame (session));

  laws_hide (laws);
  for (guint i = 0; i < laws->len; i++) {
    const Law *law = g_ptr_array_index (laws, i);

    g_assert_true (g_str_equal (law->key, "inserted")
                   || g_str_equal (law->value, "?"));
  }
}

static void
test_a_drag_is_right_when_it_is_let_go (void)
{
  g_autoptr (Session) session = begin ();

  session_set_stop (session, 3);
  assert_state (session, "open");
  session_begin_edit (session);
  g_assert_true (session_move_site (session, 7, (Site){ 0.25, 0.25 }, NULL));
  g_assert_true (session_move_site (session, 7, (Site){ 2, 2 }, NULL));
  assert_state (session, "open");
  session_end_edit (session);
  assert_state (session, "right");
  g_assert_cmpfloat (session_get_set (session)->sites[7].x, ==, 2);
}

static void
test_another_is_about_other_sites (void)
{
  g_autoptr (Session) session = begin ();
  const Trace *lessons = session_get_trace (session);

  learner_act (session, "show-answer", NULL);
  for (guint i = 0; i < 5; i++) {
    learner_act (session, "another", NULL);
    g_assert_true (session_get_trace (session) != lessons);
    assert_state (session, "open");
    g_assert_true (session_is_asking (session));
    learner_act (session, "show-answer", NULL);
    assert_state (session, "shown");
  }
  learner_act (session, "continue", NULL);
  g_assert_cmpuint (session_get_stop (session), ==, 1);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 8);
}

/* A person's own sites are not lost to other ones. */
static void
test_another_on_own_sites_can_be_undone (void)
{
  g_autoptr (Session) session = begin ();

  learner_act (session, "show-answer", NULL);
  learner_act (session, "add-site", g_variant_new ("(dd)", 0.3125, 0.0625));
  learner_act (session, "another", NULL);
  learner_act (session, "show-answer", NULL);
  learner_act (session, "another", NULL);
  g_assert_cmpstr (session_get_undo_label (session), ==,
                   "Undo generating sites");
  learner_act (session, "undo", NULL);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 9);
}

/* The author saves another form of the lesson: the stop is kept by its
 * title. */
static void
test_a_changed_lesson_keeps_the_stop (void)
{
  g_autoptr (Session) session = begin ();
  g_auto (GStrv) parts = g_strsplit (lesson_text, "## Which?", 2);
  g_autofree char *text = g_strconcat (
      parts[0], "## New\n\n```steps\nviews plane\n```\n\n## Which?", parts[1],
      NULL);
  g_autoptr (Lesson) lesson = lesson_parse (text, strlen (text), "l.md", NULL);
  Camera camera = *session_get_camera (session);

  session_set_stop (session, 2);
  camera.zoom = 3;
  session_set_camera (session, &camera);
  session_renew_lesson (session, lesson);
  g_assert_true (session_get_lesson (session) == lesson);
  g_assert_cmpuint (session_get_stop (session), ==, 3);
  g_assert_cmpfloat (session_get_camera (session)->zoom, ==, 3);
  g_assert_cmpint (session_get_views (session), ==, VIEWS_PLANE);
  assert_state (session, "open");
}

static void
test_what_is_no_answer_is_refused (void)
{
  static const char *const answers[] = { "s4", "r0", "v0", "f99", "o1", "x" };
  g_autoptr (Session) session = begin ();

  for (guint i = 0; i < G_N_ELEMENTS (answers); i++)
    g_assert_false (action_run (session, "answer-toggle",
                                g_variant_new_string (answers[i]), NULL));
  g_assert_false (action_run (session, "check", NULL, NULL));
}

/* By whatever way they would come, and in the same words. */
static void
test_its_sites_stay_while_it_asks (void)
{
  static const char *const edits[][2] = {
    { "add-site", "(0.25, 0.25)" }, { "move-site", "(uint32 0, 0.5, 0.0)" },
    { "remove-site", "uint32 0" },  { "sites", "'random 9 seed 1'" },
    { "nudge", "'left'" },          { "delete-selection", NULL }
  };
  g_autoptr (Session) session = begin ();
  const guint n_sites = session_get_set (session)->n_sites;
  g_autoptr (GError) first = NULL;

  g_assert_false (session_can_edit (session, &first));
  learner_act (session, "select", g_variant_new_string ("s2"));
  for (guint i = 0; i < G_N_ELEMENTS (edits); i++) {
    g_autoptr (GError) error = NULL;
    GVariant *parameter
        = edits[i][1] == NULL ? NULL : g_variant_new_parsed (edits[i][1]);

    g_assert_false (action_run (session, edits[i][0], parameter, &error));
    g_assert_cmpstr (error->message, ==, first->message);
  }
  assert_state (session, "open");
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, n_sites);
  learner_act (session, "show-answer", NULL);
  learner_act (session, "remove-site", g_variant_new_uint32 (0));
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/exercise/its-sites-stay-while-it-asks",
    test_its_sites_stay_while_it_asks },
  { "/exercise/a-question-stops-before-its-event",
    test_a_question_stops_before_its_event },
  { "/exercise/the-mask-leaves-no-role-of-the-round",
    test_the_mask_leaves_no_role_of_the_round },
  { "/exercise/a-right-answer-goes-on-to-what-it-shows",
    test_a_right_answer_goes_on_to_what_it_shows },
  { "/exercise/a-wrong-answer-has-its-retries",
    test_a_wrong_answer_has_its_retries },
  { "/exercise/hints-come-one-after-the-other",
    test_hints_come_one_after_the_other },
  { "/exercise/no-question-holds-a-class-up",
    test_no_question_holds_a_class_up },
  { "/exercise/stepping-past-the-event-shows-the-answer",
    test_stepping_past_the_event_shows_the_answer },
  { "/exercise/numbers-are-answered-by-their-place",
    test_numbers_are_answered_by_their_place },
  { "/exercise/one-number-is-asked-for-as-one",
    test_one_number_is_asked_for_as_one },
  { "/exercise/an-option-is-right-for-a-reason-in-words",
    test_an_option_is_right_for_a_reason_in_words },
  { "/exercise/a-question-shows-what-its-scene-selects",
    test_a_question_shows_what_its_scene_selects },
  { "/exercise/a-place-that-is-shown-lies-in-the-picture",
    test_a_place_that_is_shown_lies_in_the_picture },
  { "/exercise/counters-tell-nothing-while-it-asks",
    test_counters_tell_nothing_while_it_asks },
  { "/exercise/a-drag-is-right-when-it-is-let-go",
    test_a_drag_is_right_when_it_is_let_go },
  { "/exercise/another-is-about-other-sites",
    test_another_is_about_other_sites },
  { "/exercise/another-on-own-sites-can-be-undone",
    test_another_on_own_sites_can_be_undone },
  { "/exercise/a-changed-lesson-keeps-the-stop",
    test_a_changed_lesson_keeps_the_stop },
  { "/exercise/what-is-no-answer-is-refused",
    test_what_is_no_answer_is_refused },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
