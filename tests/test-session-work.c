/* Sets so large that a thread makes their hull: what a person sees of it, in
 * the order in which it happens. */
#include "document.h"
#include "session-chore.h"

#include <string.h>

#define N_LARGE (SESSION_AT_ONCE + 300)

static Site *
random_sites (guint n, guint32 seed)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);
  Site *sites = g_new (Site, n);

  for (guint i = 0; i < n; i++)
    sites[i] = (Site){ g_rand_double (rand), g_rand_double (rand) };
  return sites;
}

static Session *
patient_new (guint n)
{
  g_autofree Site *sites = random_sites (n, 1);
  Session *session = session_new ();

  g_assert_true (session_set_sites (session, sites, n, NULL));
  session_set_patient (session, TRUE);
  return session;
}

/* Lets the main loop run until no thread is at work. */
static guint
wait (Session *session)
{
  guint n_turns = 0;

  while (session_is_working (session, NULL)) {
    g_main_context_iteration (NULL, TRUE);
    n_turns += 1;
  }
  return n_turns;
}

/* Returns: what the same edits lead to at once. */
static char *
text_of (Session *session)
{
  return document_copy (session);
}

static void
on_changed (Session *session, guint changes, guint *all)
{
  (void)session;
  *all |= changes;
}

static void
test_stays (void)
{
  g_autoptr (Session) session = patient_new (8);
  g_autofree Site *sites = random_sites (N_LARGE, 2);
  const Trace *before = session_get_trace (session);
  guint changes = 0;
  double part = -1;

  g_signal_connect (session, "changed", G_CALLBACK (on_changed), &changes);
  g_assert_true (session_set_sites (session, sites, N_LARGE, NULL));
  g_assert_true (session_is_working (session, &part));
  g_assert_true (part >= 0 && part <= 1);
  g_assert_cmpuint (session_get_n_awaited (session), ==, N_LARGE);
  g_assert_true (session_get_trace (session) == before);
  g_assert_cmpuint (changes, ==, CHANGED_WORK);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE);
  g_assert_true (changes & CHANGED_SITES);
  g_assert_cmpstr (session_get_undo_label (session), !=, NULL);
}

/* The hull is that which is made at once. */
static void
test_same (void)
{
  g_autoptr (Session) patient = patient_new (8);
  g_autoptr (Session) other = session_new ();
  g_autofree Site *sites = random_sites (N_LARGE, 3);
  const Trace *a, *b;

  session_set_sites (other, sites, N_LARGE, NULL);
  session_set_sites (patient, sites, N_LARGE, NULL);
  wait (patient);
  a = session_get_trace (patient);
  b = session_get_trace (other);
  g_assert_cmpuint (a->n_events, ==, b->n_events);
  for (guint i = 0; i < a->n_events; i++) {
    const Event p = trace_event (a, i), q = trace_event (b, i);

    g_assert_cmpmem (&p, sizeof p, &q, sizeof q);
  }
}

/* So is the frame, which the thread makes too, wherever one looks at it. */
static void
test_frame (void)
{
  g_autoptr (Session) patient = patient_new (N_LARGE);
  g_autoptr (Session) other = patient_new (N_LARGE);
  guint64 hashes[2];

  session_set_patient (other, FALSE);
  for (guint i = 0; i < 2; i++) {
    Session *session = i == 0 ? patient : other;

    session_set_step (session, 3 * session_get_n_steps (session) / 4);
    session_move_site (session, 7, (Site){ 0.25, 0.5 }, NULL);
    wait (session);
    hashes[i] = frame_hash (session_get_frame (session));
    session_next (session);
    hashes[i] ^= 3 * frame_hash (session_get_frame (session));
    session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
    session_next (session);
    wait (session);
    hashes[i] ^= 5 * frame_hash (session_get_frame (session));
  }
  g_assert_cmpuint (hashes[0], ==, hashes[1]);
}

/* Of so many sites two threads make a frame: it is that of one. */
static void
test_pieces (void)
{
  g_autoptr (Session) session = patient_new (4000);
  const guint n_steps = session_get_n_steps (session);

  g_assert_cmpuint (session_get_trace (session)->n_facets, >, 20000);
  for (guint i = 0; i <= 6; i++) {
    const guint step = i * (n_steps / 6);
    Frame frame;

    session_set_step (session, step);
    wait (session);
    frame_init (&frame, session_get_trace (session), step);
    g_assert_cmpuint (frame_hash (&frame), ==,
                      frame_hash (session_get_frame (session)));
    frame_clear (&frame);
  }
}

static void
test_cancel (void)
{
  g_autoptr (Session) session = patient_new (8);
  g_autofree char *before = text_of (session);
  g_autofree Site *sites = random_sites (N_LARGE, 4);
  g_autofree char *after = NULL;

  session_set_sites (session, sites, N_LARGE, NULL);
  session_cancel (session);
  g_assert_false (session_is_working (session, NULL));
  for (guint i = 0; i < 200; i++) {
    g_main_context_iteration (NULL, FALSE);
    g_usleep (2000);
  }
  after = text_of (session);
  g_assert_cmpstr (after, ==, before);
}

/* Who asks for what cannot be compared is told at once. */
static void
test_range (void)
{
  g_autoptr (Session) session = patient_new (8);
  g_autofree Site *sites = random_sites (N_LARGE, 5);
  g_autoptr (GError) error = NULL;

  sites[0].x = 1e-300;
  sites[1].x = 1e300;
  g_assert_false (session_set_sites (session, sites, N_LARGE, &error));
  g_assert_error (error, SESSION_ERROR, SESSION_ERROR_RANGE);
  g_assert_false (session_is_working (session, NULL));
}

static void
test_small (void)
{
  g_autoptr (Session) session = patient_new (8);

  g_assert_true (session_add_site (session, (Site){ 0.5, 0.5 }, NULL));
  g_assert_false (session_is_working (session, NULL));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 9);
}

static void
test_edits (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  g_autofree char *before = text_of (session);
  g_autofree char *undone = NULL;

  session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE + 1);
  session_remove_site (session, 3, NULL);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE);
  g_assert_true (session_undo (session));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE + 1);
  session_undo (session);
  wait (session);
  undone = text_of (session);
  g_assert_cmpstr (undone, ==, before);
  session_redo (session);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE + 1);
}

/* Cells keep their hues through deletion and undo, as they do at once. */
static void
test_hues (void)
{
  g_autoptr (Session) patient = patient_new (N_LARGE);
  g_autoptr (Session) other = patient_new (N_LARGE);

  session_set_patient (other, FALSE);
  for (guint i = 0; i < 2; i++) {
    Session *session = i == 0 ? patient : other;

    session_remove_site (session, 3, NULL);
    wait (session);
    session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
    wait (session);
    session_undo (session);
    wait (session);
  }
  g_assert_cmpmem (session_get_look (patient)->hues, (N_LARGE - 1) * 4,
                   session_get_look (other)->hues, (N_LARGE - 1) * 4);
  g_assert_cmpuint (session_get_look (patient)->hues[3], ==, 4);
}

/* What was given up can be undone no more than what was never asked for. */
static void
test_undo_cancelled (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  g_autofree char *label = NULL;

  session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
  wait (session);
  label = g_strdup (session_get_undo_label (session));
  session_undo (session);
  session_cancel (session);
  g_assert_cmpstr (session_get_undo_label (session), ==, label);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE + 1);
}

static void
test_order (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  const Order input = { ORDER_INPUT, 0 };

  session_set_order (session, &input);
  g_assert_cmpint (session_get_order (session).kind, ==, ORDER_FURTHEST);
  wait (session);
  g_assert_cmpint (session_get_order (session).kind, ==, ORDER_INPUT);
}

/* However many places a site is dragged over, the last one counts, and it is
 * one edit. */
static void
test_drag (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  g_autofree char *before = text_of (session);
  g_autofree char *undone = NULL;
  Site at;

  session_begin_edit (session);
  for (guint i = 0; i < 40; i++) {
    session_move_site (session, 7, (Site){ 0.25 + i / 128.0, 0.5 }, NULL);
    g_main_context_iteration (NULL, FALSE);
  }
  session_end_edit (session);
  wait (session);
  at = site_set_given (session_get_set (session), 7);
  g_assert_cmpfloat (at.x, ==, 0.25 + 39 / 128.0);
  session_undo (session);
  wait (session);
  undone = text_of (session);
  g_assert_cmpstr (undone, ==, before);
}

/* The edit that was asked for last counts. */
static void
test_replaced (void)
{
  g_autoptr (Session) session = patient_new (8);
  g_autofree Site *first = random_sites (N_LARGE, 6);
  g_autofree Site *second = random_sites (N_LARGE + 5, 7);

  session_set_sites (session, first, N_LARGE, NULL);
  session_set_sites (session, second, N_LARGE + 5, NULL);
  wait (session);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, N_LARGE + 5);
  session_set_sites (session, first, N_LARGE, NULL);
  session_set_sites (session, second, 5, NULL);
  g_assert_false (session_is_working (session, NULL));
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 5);
}

/* A session that goes away while a thread works for it. */
static void
test_left (void)
{
  Session *session = patient_new (8);
  g_autofree Site *sites = random_sites (N_LARGE, 8);

  session_set_sites (session, sites, N_LARGE, NULL);
  g_object_unref (session);
  for (guint i = 0; i < 200; i++) {
    g_main_context_iteration (NULL, FALSE);
    g_usleep (2000);
  }
}

/* The main loop turns while the thread is at work. */
static gboolean
on_idle (gpointer user)
{
  guint *n = user;

  *n += 1;
  g_usleep (500);
  return G_SOURCE_CONTINUE;
}

static void
test_loop (void)
{
  g_autoptr (Session) session = patient_new (8);
  g_autofree Site *sites = random_sites (20000, 9);
  guint n_idle = 0;
  const guint source = g_idle_add (on_idle, &n_idle);

  session_set_sites (session, sites, 20000, NULL);
  wait (session);
  g_source_remove (source);
  g_assert_cmpuint (n_idle, >, 0);
  g_assert_cmpuint (session_get_set (session)->n_sites, ==, 20000);
}

static const Order two_orders[2]
    = { { ORDER_FURTHEST, 0 }, { ORDER_INPUT, 0 } };

/* Two runs beside each other are those that are made at once. */
static void
test_compare (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  g_autoptr (Session) at_once = patient_new (N_LARGE);
  const guint step = session_get_n_steps (session) / 2;

  session_set_patient (at_once, FALSE);
  session_set_step (session, step);
  session_set_step (at_once, step);
  session_compare (at_once, two_orders);
  session_compare (session, two_orders);
  g_assert_true (session_is_working (session, NULL));
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
  wait (session);
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_COMPARE);
  g_assert_cmpuint (session_get_step (session), ==, step);
  g_assert_cmpuint (session_get_other_step (session), ==,
                    session_get_other_step (at_once));
  g_assert_cmpuint (session_get_other_trace (session)->n_events, ==,
                    session_get_other_trace (at_once)->n_events);
  g_assert_cmpuint (session_get_other_frame (session)->counts.facets, ==,
                    session_get_other_frame (at_once)->counts.facets);
  /* An edit brings both. */
  session_add_site (session, (Site){ 0.5, 0.25 }, NULL);
  session_add_site (at_once, (Site){ 0.5, 0.25 }, NULL);
  wait (session);
  g_assert_cmpuint (session_get_other_trace (session)->n_events, ==,
                    session_get_other_trace (at_once)->n_events);
  g_assert_cmpint (session_get_other_order (session).kind, ==, ORDER_INPUT);
}

static void
test_compare_cancelled (void)
{
  g_autoptr (Session) session = patient_new (N_LARGE);
  g_autofree char *before = text_of (session);
  g_autofree char *after = NULL;
  const Trace *trace = session_get_trace (session);

  session_compare (session,
                   (const Order[]){ { ORDER_INPUT, 0 }, { ORDER_RANDOM, 3 } });
  g_assert_true (session_give_up (session));
  for (guint i = 0; i < 100; i++) {
    g_main_context_iteration (NULL, FALSE);
    g_usleep (1000);
  }
  after = text_of (session);
  g_assert_cmpstr (after, ==, before);
  g_assert_true (session_get_trace (session) == trace);
  g_assert_cmpint (session_get_exhibit_kind (session), ==, EXHIBIT_LIFTS);
  g_assert_cmpint (session_get_other_order (session).kind, ==, ORDER_INPUT);
  g_assert_false (session_give_up (session));
}

static void
on_give_up (gpointer user)
{
  *(guint *)user += 1;
}

static void
test_chores (void)
{
  g_autoptr (Session) session = session_new ();
  guint n_given_up[2] = { 0, 0 }, changes = 0;
  guint chores[2];

  g_signal_connect (session, "changed", G_CALLBACK (on_changed), &changes);
  for (guint i = 0; i < 2; i++)
    chores[i] = session_begin_chore (session, i == 0 ? "first" : "second",
                                     on_give_up, &n_given_up[i]);
  g_assert_cmpstr (session_get_chore (session), ==, "second");
  session_end_chore (session, chores[1]);
  g_assert_cmpstr (session_get_chore (session), ==, "first");
  g_assert_true (session_give_up (session));
  g_assert_cmpuint (n_given_up[0], ==, 1);
  g_assert_cmpuint (n_given_up[1], ==, 0);
  g_assert_null (session_get_chore (session));
  g_assert_false (session_give_up (session));
  session_end_chore (session, chores[0]);
  g_assert_cmpuint (changes, ==, CHANGED_WORK);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/session-work/the-session-stays-as-it-was-until-then",
                   test_stays);
  g_test_add_func ("/session-work/the-hull-is-the-one-made-at-once", test_same);
  g_test_add_func ("/session-work/the-frame-is-the-one-made-at-once",
                   test_frame);
  g_test_add_func ("/session-work/a-frame-of-two-threads-is-that-of-one",
                   test_pieces);
  g_test_add_func ("/session-work/what-is-given-up-changes-nothing",
                   test_cancel);
  g_test_add_func ("/session-work/what-cannot-be-compared-is-told-at-once",
                   test_range);
  g_test_add_func ("/session-work/small-sets-are-there-at-once", test_small);
  g_test_add_func ("/session-work/edits-are-undone-and-redone", test_edits);
  g_test_add_func ("/session-work/cells-keep-their-hues", test_hues);
  g_test_add_func ("/session-work/an-undo-given-up-is-not-done",
                   test_undo_cancelled);
  g_test_add_func ("/session-work/another-order-comes-later", test_order);
  g_test_add_func ("/session-work/a-drag-ends-where-it-was-let-go", test_drag);
  g_test_add_func ("/session-work/the-last-edit-counts", test_replaced);
  g_test_add_func ("/session-work/a-session-may-go-away", test_left);
  g_test_add_func ("/session-work/the-main-loop-goes-on", test_loop);
  g_test_add_func ("/session-work/two-runs-are-those-made-at-once",
                   test_compare);
  g_test_add_func ("/session-work/a-comparison-given-up-changes-nothing",
                   test_compare_cancelled);
  g_test_add_func ("/session-work/what-others-do-is-told-and-given-up-once",
                   test_chores);
  return g_test_run ();
}
