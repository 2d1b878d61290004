#include "lecturer-window.h"

#include "lecture-clock.h"
#include "prose.h"
#include "small-picture.h"
#include "timetable.h"

#include <glib/gi18n.h>

#define NONE G_MAXUINT

/* Nobody is late by less. */
#define LATE_S 30

struct _LecturerWindow {
  GtkWindow parent_instance;
  Session *session;
  Session *ahead;   /* plays the same lesson, a stop further */
  Lesson *lesson;   /* that it plays */
  guint stop;       /* of the session, the last time; NONE: no lesson */
  guint idle, tick; /* sources */
  LectureClock clock;
  SmallPicture *now, *next;
  GtkLabel *now_title, *next_title, *cover, *note;
  GtkLabel *elapsed, *schedule, *place, *time;
  GtkScrolledWindow *scroll;
};

G_DEFINE_TYPE (LecturerWindow, lecturer_window, GTK_TYPE_WINDOW)

static guint
get_stop (LecturerWindow *window)
{
  return session_get_lesson (window->session) != NULL
             ? session_get_stop (window->session)
             : NONE;
}

/* Clock */

static void
set_text (GtkLabel *label, char *text)
{
  gtk_label_set_text (label, text);
  g_free (text);
}

static char *
minutes_text (guint seconds)
{
  return g_strdup_printf ("%u:%02u", seconds / 60, seconds % 60);
}

/* A lecture is late when its stop should be over, and early when it should
 * not have begun. */
static char *
schedule_text (const Lesson *lesson, guint stop, guint seconds)
{
  const guint begin = timetable_begin (lesson, stop);
  const guint end = timetable_begin (lesson, stop + 1);
  const guint off = seconds > end     ? seconds - end
                    : seconds < begin ? begin - seconds
                                      : 0;
  g_autofree char *planned = timetable_text (lesson, stop);
  g_autofree char *difference = minutes_text (off);

  if (off < LATE_S)
    return g_strdup_printf (_ ("planned %s"), planned);
  if (seconds > end)
    return g_strdup_printf (_ ("planned %s: %s late"), planned, difference);
  return g_strdup_printf (_ ("planned %s: %s early"), planned, difference);
}

static void
update_clock (LecturerWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);
  const guint seconds = lecture_clock_get_seconds (&window->clock);
  g_autoptr (GDateTime) now = g_date_time_new_now_local ();

  set_text (window->elapsed, minutes_text (seconds));
  set_text (window->time, g_date_time_format (now, "%H:%M"));
  set_text (window->schedule,
            lesson != NULL && lesson->minutes > 0 ? schedule_text (
                lesson, session_get_stop (window->session), seconds)
                                                  : g_strdup (""));
}

static gboolean
on_tick (gpointer user)
{
  update_clock (user);
  return G_SOURCE_CONTINUE;
}

gboolean
lecturer_window_is_running (LecturerWindow *window)
{
  return lecture_clock_is_running (&window->clock);
}

void
lecturer_window_set_running (LecturerWindow *window, gboolean is_running)
{
  lecture_clock_set_running (&window->clock, is_running);
  update_clock (window);
}

void
lecturer_window_reset_clock (LecturerWindow *window)
{
  lecture_clock_reset (&window->clock);
  update_clock (window);
}

/* Notes */

static void
add_hints (GString *note, const Question *question)
{
  if (question == NULL || question->hints->len == 0)
    return;
  g_string_append_printf (note, "\n\n**%s**\n\n", _ ("Hints"));
  for (guint i = 0; i < question->hints->len; i++)
    g_string_append_printf (
        note, "- %s\n", (const char *)g_ptr_array_index (question->hints, i));
}

static void
add_note (GString *whole, const char *note)
{
  g_autofree char *words = note != NULL ? prose_capitalize (note) : NULL;

  if (words != NULL)
    g_string_append_printf (whole, "%s\n\n", words);
}

/* The notes on the whole lesson stand above those on its first stop. */
static char *
note_of (const Lesson *lesson, guint stop)
{
  const LessonStop *row = lesson_stop (lesson, stop);
  GString *note = g_string_new (NULL);

  if (stop == 0)
    add_note (note, lesson->note);
  add_note (note, row->note);
  add_hints (note, row->question);
  return g_string_free (note, FALSE);
}

static void
update_note (LecturerWindow *window)
{
  const Lesson *lesson = session_get_lesson (window->session);
  g_autofree char *note
      = lesson != NULL ? note_of (lesson, window->stop) : g_strdup ("");
  g_autofree char *markup = prose_to_markup (note);

  if (lesson == NULL)
    gtk_label_set_text (window->note,
                        _ ("No lesson is open. The lecturer’s notes of a "
                           "lesson stand here."));
  else if (*markup == '\0')
    gtk_label_set_text (window->note, _ ("No notes on this stop."));
  else
    gtk_label_set_markup (window->note, markup);
  gtk_adjustment_set_value (
      gtk_scrolled_window_get_vadjustment (window->scroll), 0);
}

/* Pictures */

/* The lesson may have been read again. */
static void
follow_lesson (LecturerWindow *window)
{
  Lesson *lesson = session_get_lesson (window->session);

  if (lesson == window->lesson)
    return;
  g_clear_object (&window->ahead);
  g_clear_pointer (&window->lesson, lesson_unref);
  if (lesson == NULL)
    return;
  window->lesson = lesson_ref (lesson);
  window->ahead = session_new ();
  session_set_lesson (window->ahead, lesson);
}

static void
update_next (LecturerWindow *window)
{
  const Lesson *lesson = window->lesson;
  const guint next = window->stop + 1;

  if (lesson == NULL || next >= lesson->stops->len) {
    small_picture_set_session (window->next, NULL, 0, NULL);
    gtk_label_set_text (window->next_title,
                        lesson != NULL ? _ ("Next: the end of the lesson")
                                       : _ ("Next"));
    return;
  }
  small_picture_set_session (window->next, window->ahead, next,
                             window->session);
  set_text (
      window->next_title,
      g_strdup_printf (_ ("Next: %s"), lesson_stop (lesson, next)->title));
}

static void
update_titles (LecturerWindow *window)
{
  const Lesson *lesson = window->lesson;

  if (lesson == NULL) {
    gtk_label_set_text (window->now_title, _ ("Now"));
    gtk_label_set_text (window->place, "");
    return;
  }
  set_text (window->now_title,
            g_strdup_printf (_ ("Now: %s"),
                             lesson_stop (lesson, window->stop)->title));
  set_text (window->place,
            g_strdup_printf (_ ("Stop %u of %u"), window->stop + 1,
                             lesson->stops->len));
}

static void
update_stop (LecturerWindow *window)
{
  window->stop = get_stop (window);
  follow_lesson (window);
  update_titles (window);
  update_next (window);
  update_note (window);
  update_clock (window);
}

/* Many changes are one picture. */
static gboolean
on_idle (gpointer user)
{
  LecturerWindow *window = user;

  window->idle = 0;
  small_picture_changed (window->now);
  return G_SOURCE_REMOVE;
}

static void
on_changed (Session *session, guint changes, LecturerWindow *window)
{
  const gboolean goes_on
      = window->stop != NONE && get_stop (window) != window->stop;

  (void)session;
  if (changes & CHANGED_APPEARANCE)
    small_picture_changed (window->next);
  if (window->idle == 0)
    window->idle = g_idle_add (on_idle, window);
  if ((changes & CHANGED_LESSON) == 0)
    return;
  if (goes_on && window->lesson == session_get_lesson (session))
    lecture_clock_set_running (&window->clock, TRUE);
  update_stop (window);
}

void
lecturer_window_set_cover (LecturerWindow *window, const char *text)
{
  gtk_label_set_text (window->cover, text != NULL ? text : "");
  gtk_widget_set_visible (GTK_WIDGET (window->cover), text != NULL);
}

/* Life */

LecturerWindow *
lecturer_window_new (GtkApplicationWindow *parent, Session *session)
{
  LecturerWindow *window = g_object_new (LECTURER_WINDOW_TYPE, NULL);

  window->session = g_object_ref (session);
  gtk_widget_insert_action_group (GTK_WIDGET (window), "win",
                                  G_ACTION_GROUP (parent));
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), window,
                           0);
  small_picture_set_session (window->now, session, SMALL_PICTURE_NOW, session);
  update_stop (window);
  window->tick = g_timeout_add_seconds (1, on_tick, window);
  return window;
}

static void
lecturer_window_dispose (GObject *object)
{
  LecturerWindow *window = HULL2VD_LECTURER_WINDOW (object);

  g_clear_handle_id (&window->idle, g_source_remove);
  g_clear_handle_id (&window->tick, g_source_remove);
  g_clear_pointer (&window->lesson, lesson_unref);
  g_clear_object (&window->ahead);
  g_clear_object (&window->session);
  G_OBJECT_CLASS (lecturer_window_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, LecturerWindow, name)

static void
lecturer_window_class_init (LecturerWindowClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = lecturer_window_dispose;
  g_type_ensure (SMALL_PICTURE_TYPE);
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/lecturer-window.ui");
  BIND (now);
  BIND (next);
  BIND (now_title);
  BIND (next_title);
  BIND (cover);
  BIND (note);
  BIND (elapsed);
  BIND (schedule);
  BIND (place);
  BIND (time);
  BIND (scroll);
}

static void
lecturer_window_init (LecturerWindow *window)
{
  gtk_widget_init_template (GTK_WIDGET (window));
  window->stop = NONE;
}
