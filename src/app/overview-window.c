#include "overview-window.h"

#include "small-picture.h"

#include <glib/gi18n.h>

#define PICTURE_WIDTH 260
#define PICTURE_HEIGHT 150
#define TITLE_CHARACTERS 28

static GtkWidget *
make_title (const Lesson *lesson, guint stop)
{
  const LessonStop *row = lesson_stop (lesson, stop);
  g_autofree char *text = g_strdup_printf ("%u  %s%s", stop + 1, row->title,
                                           row->question != NULL ? " (?)" : "");
  GtkWidget *title = gtk_label_new (text);

  gtk_label_set_ellipsize (GTK_LABEL (title), PANGO_ELLIPSIZE_END);
  gtk_label_set_max_width_chars (GTK_LABEL (title), TITLE_CHARACTERS);
  gtk_label_set_xalign (GTK_LABEL (title), 0);
  return title;
}

static GtkWidget *
make_stop (Session *player, Session *session, guint stop)
{
  const Lesson *lesson = session_get_lesson (session);
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 4);
  GtkWidget *picture = g_object_new (SMALL_PICTURE_TYPE, NULL);
  GtkWidget *child = gtk_flow_box_child_new ();

  gtk_widget_set_size_request (picture, PICTURE_WIDTH, PICTURE_HEIGHT);
  small_picture_set_session (HULL2VD_SMALL_PICTURE (picture), player, stop,
                             session);
  gtk_container_add (GTK_CONTAINER (box), picture);
  gtk_container_add (GTK_CONTAINER (box), make_title (lesson, stop));
  gtk_container_add (GTK_CONTAINER (child), box);
  atk_object_set_name (gtk_widget_get_accessible (child),
                       lesson_stop (lesson, stop)->title);
  return child;
}

static void
on_activated (GtkFlowBox *box, GtkFlowBoxChild *child, GtkWindow *window)
{
  GActionGroup *actions
      = gtk_widget_get_action_group (GTK_WIDGET (window), "win");
  const guint stop = (guint)gtk_flow_box_child_get_index (child) + 1;

  (void)box;
  g_action_group_activate_action (actions, "stop", g_variant_new_uint32 (stop));
  gtk_window_close (window);
}

static gboolean
on_key (GtkWidget *widget, GdkEventKey *event)
{
  if (event->keyval != GDK_KEY_Escape)
    return FALSE;
  gtk_window_close (GTK_WINDOW (widget));
  return TRUE;
}

/* The stop where the lesson is has the focus. */
static void
add_stops (GtkFlowBox *box, Session *session)
{
  Lesson *lesson = session_get_lesson (session);
  g_autoptr (Session) player = session_new ();
  GtkFlowBoxChild *now;

  session_set_lesson (player, lesson);
  for (guint stop = 0; stop < lesson->stops->len; stop++)
    gtk_container_add (GTK_CONTAINER (box), make_stop (player, session, stop));
  gtk_widget_show_all (GTK_WIDGET (box));
  now = gtk_flow_box_get_child_at_index (box, (int)session_get_stop (session));
  gtk_flow_box_select_child (box, now);
  gtk_widget_grab_focus (GTK_WIDGET (now));
}

void
overview_window_show (GtkWindow *parent,
                      GActionGroup *actions,
                      Session *session)
{
  g_autoptr (GtkBuilder) builder = gtk_builder_new_from_resource (
      "/io/github/hull2vd/Hull2VD/overview-window.ui");
  GtkWidget *window = GTK_WIDGET (gtk_builder_get_object (builder, "window"));
  GtkFlowBox *box = GTK_FLOW_BOX (gtk_builder_get_object (builder, "stops"));

  gtk_window_set_transient_for (GTK_WINDOW (window), parent);
  gtk_widget_insert_action_group (window, "win", actions);
  g_signal_connect (window, "key-press-event", G_CALLBACK (on_key), NULL);
  g_signal_connect (box, "child-activated", G_CALLBACK (on_activated), window);
  add_stops (box, session);
  gtk_window_present (GTK_WINDOW (window));
}
