/* Touches as a screen would send them, into a picture of the plane. Needs a
 * display: run by tests/headless.sh. */
#include "plane-view.h"

#include <gtk/gtk.h>
#include <math.h>

typedef struct Stage {
  GtkWidget *window, *view;
  Session *session;
} Stage;

static void
settle (void)
{
  const gint64 end = g_get_monotonic_time () + 100 * G_TIME_SPAN_MILLISECOND;

  while (g_get_monotonic_time () < end)
    if (!gtk_main_iteration_do (FALSE))
      g_usleep (2000);
}

static void
stage_init (Stage *stage)
{
  static const Site sites[] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 0.75 } };

  stage->window = gtk_window_new (GTK_WINDOW_TOPLEVEL);
  stage->view = g_object_new (PLANE_VIEW_TYPE, "visible", TRUE, NULL);
  stage->session = session_new ();
  session_set_sites (stage->session, sites, G_N_ELEMENTS (sites), NULL);
  canvas_set_session (HULL2VD_CANVAS (stage->view), stage->session);
  gtk_container_add (GTK_CONTAINER (stage->window), stage->view);
  gtk_window_set_default_size (GTK_WINDOW (stage->window), 600, 600);
  gtk_widget_show (stage->window);
  settle ();
}

static void
stage_clear (Stage *stage)
{
  gtk_widget_destroy (stage->window);
  settle ();
  g_object_unref (stage->session);
}

static void
touch (Stage *stage, GdkEventType type, guint finger, double x, double y)
{
  GdkSeat *seat
      = gdk_display_get_default_seat (gtk_widget_get_display (stage->view));
  GdkDevice *device = gdk_seat_get_pointer (seat);
  GdkEvent *event = gdk_event_new (type);

  event->touch.window = g_object_ref (gtk_widget_get_window (stage->view));
  event->touch.time = (guint32)(g_get_monotonic_time () / 1000);
  event->touch.x = event->touch.x_root = x;
  event->touch.y = event->touch.y_root = y;
  event->touch.sequence = GUINT_TO_POINTER (finger);
  event->touch.emulating_pointer = finger == 1;
  gdk_event_set_device (event, device);
  gdk_event_set_source_device (event, device);
  gtk_main_do_event (event);
  gdk_event_free (event);
}

/* Where the view shows a site. */
static void
locate (Stage *stage, guint site, double at_px[2])
{
  GdkRectangle box;

  g_assert_true (canvas_locate (HULL2VD_CANVAS (stage->view),
                                (Object){ OBJECT_SITE, site }, &box));
  at_px[0] = box.x + box.width / 2.0;
  at_px[1] = box.y + box.height / 2.0;
}

static void
test_a_tap_adds_a_site (void)
{
  Stage stage;

  stage_init (&stage);
  touch (&stage, GDK_TOUCH_BEGIN, 1, 20, 300);
  touch (&stage, GDK_TOUCH_END, 1, 20, 300);
  settle ();
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 5);
  stage_clear (&stage);
}

static void
test_one_finger_drags_a_site (void)
{
  double from[2], to[2];
  Stage stage;

  stage_init (&stage);
  locate (&stage, 2, from);
  touch (&stage, GDK_TOUCH_BEGIN, 1, from[0], from[1]);
  touch (&stage, GDK_TOUCH_UPDATE, 1, from[0] - 30, from[1] + 10);
  touch (&stage, GDK_TOUCH_UPDATE, 1, from[0] - 60, from[1] + 20);
  touch (&stage, GDK_TOUCH_END, 1, from[0] - 60, from[1] + 20);
  settle ();
  locate (&stage, 2, to);
  g_assert_cmpfloat (fabs (to[0] - from[0] + 60), <, 5);
  g_assert_cmpfloat (fabs (to[1] - from[1] - 20), <, 5);
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 4);
  stage_clear (&stage);
}

/* Puts two fingers down and moves them. */
static void
pinch (Stage *stage, const double from[2][2], const double to[2][2])
{
  for (guint finger = 0; finger < 2; finger++)
    touch (stage, GDK_TOUCH_BEGIN, finger + 1, from[finger][0],
           from[finger][1]);
  for (guint part = 1; part <= 4; part++)
    for (guint finger = 0; finger < 2; finger++)
      touch (stage, GDK_TOUCH_UPDATE, finger + 1,
             from[finger][0] + part * (to[finger][0] - from[finger][0]) / 4,
             from[finger][1] + part * (to[finger][1] - from[finger][1]) / 4);
  for (guint finger = 0; finger < 2; finger++)
    touch (stage, GDK_TOUCH_END, finger + 1, to[finger][0], to[finger][1]);
  settle ();
}

static void
test_two_fingers_zoom_about_what_lies_between_them (void)
{
  const double from[2][2] = { { 250, 300 }, { 350, 300 } };
  const double to[2][2] = { { 200, 300 }, { 400, 300 } };
  double before[2], after[2];
  Stage stage;

  stage_init (&stage);
  locate (&stage, 0, before);
  pinch (&stage, from, to);
  locate (&stage, 0, after);
  g_assert_cmpfloat (fabs (session_get_plane_camera (stage.session)->zoom - 2),
                     <, 0.05);
  g_assert_cmpfloat (fabs (after[0] - 300 - 2 * (before[0] - 300)), <, 8);
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 4);
  stage_clear (&stage);
}

static void
test_two_fingers_pan (void)
{
  const double from[2][2] = { { 250, 300 }, { 350, 300 } };
  const double to[2][2] = { { 290, 270 }, { 390, 270 } };
  double before[2], after[2];
  Stage stage;

  stage_init (&stage);
  locate (&stage, 1, before);
  pinch (&stage, from, to);
  locate (&stage, 1, after);
  g_assert_cmpfloat (fabs (after[0] - before[0] - 40), <, 3);
  g_assert_cmpfloat (fabs (after[1] - before[1] + 30), <, 3);
  g_assert_cmpfloat (fabs (session_get_plane_camera (stage.session)->zoom - 1),
                     <, 1e-6);
  stage_clear (&stage);
}

/* The first finger may lie on a site: it is not carried along. */
static void
test_fingers_that_pan_leave_sites_alone (void)
{
  double at[2];
  Stage stage;

  stage_init (&stage);
  locate (&stage, 3, at);
  {
    const double from[2][2] = { { at[0], at[1] }, { at[0] + 90, at[1] } };
    const double to[2][2] = { { at[0] + 40, at[1] }, { at[0] + 130, at[1] } };

    pinch (&stage, from, to);
  }
  g_assert_cmpfloat (site_set_given (session_get_set (stage.session), 3).x, ==,
                     -1);
  g_assert_null (g_strrstr (session_get_undo_label (stage.session), "move"));
  stage_clear (&stage);
}

static gboolean
is_menu (GtkWidget *window)
{
  return gtk_widget_get_visible (window) && GTK_IS_WINDOW (window)
         && GTK_IS_MENU (gtk_bin_get_child (GTK_BIN (window)));
}

static gboolean
has_menu (void)
{
  GList *windows = gtk_window_list_toplevels ();
  gboolean has = FALSE;

  for (GList *node = windows; node != NULL; node = node->next)
    has = has || is_menu (node->data);
  g_list_free (windows);
  return has;
}

static void
test_a_long_press_opens_the_menu_and_adds_nothing (void)
{
  Stage stage;

  stage_init (&stage);
  touch (&stage, GDK_TOUCH_BEGIN, 1, 20, 300);
  for (int i = 0; i < 60 && !has_menu (); i++)
    settle ();
  g_assert_true (has_menu ());
  touch (&stage, GDK_TOUCH_END, 1, 20, 300);
  settle ();
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 4);
  stage_clear (&stage);
}

static void
press (Stage *stage, GdkEventType type, double x, double y)
{
  GdkSeat *seat
      = gdk_display_get_default_seat (gtk_widget_get_display (stage->view));
  GdkDevice *device = gdk_seat_get_pointer (seat);
  GdkEvent *event = gdk_event_new (type);

  event->button.window = g_object_ref (gtk_widget_get_window (stage->view));
  event->button.time = (guint32)(g_get_monotonic_time () / 1000);
  event->button.x = event->button.x_root = x;
  event->button.y = event->button.y_root = y;
  event->button.button = GDK_BUTTON_PRIMARY;
  gdk_event_set_device (event, device);
  gdk_event_set_source_device (event, device);
  gtk_main_do_event (event);
  gdk_event_free (event);
}

/* The screen knows of no button that is down: it is up again, though nobody has
 * told so yet. */
static void
test_a_click_that_ends_unheard_is_no_hold (void)
{
  Stage stage;

  gtk_set_debug_flags (0); /* the pointer is a pointer again */
  stage_init (&stage);
  press (&stage, GDK_BUTTON_PRESS, 20, 300);
  for (int i = 0; i < 8; i++)
    settle ();
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 4);
  press (&stage, GDK_BUTTON_RELEASE, 20, 300);
  settle ();
  g_assert_cmpuint (session_get_set (stage.session)->n_sites, ==, 5);
  stage_clear (&stage);
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/touch/a-tap-adds-a-site", test_a_tap_adds_a_site },
  { "/touch/one-finger-drags-a-site", test_one_finger_drags_a_site },
  { "/touch/two-fingers-zoom-about-what-lies-between-them",
    test_two_fingers_zoom_about_what_lies_between_them },
  { "/touch/two-fingers-pan", test_two_fingers_pan },
  { "/touch/fingers-that-pan-leave-sites-alone",
    test_fingers_that_pan_leave_sites_alone },
  { "/touch/a-long-press-opens-the-menu-and-adds-nothing",
    test_a_long_press_opens_the_menu_and_adds_nothing },
  { "/touch/a-click-that-ends-unheard-is-no-hold",
    test_a_click_that_ends_unheard_is_no_hold },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  gtk_init (&argc, &argv);
  /* There is no touch screen; the pointer does for one. */
  gtk_set_debug_flags (GTK_DEBUG_TOUCHSCREEN);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
