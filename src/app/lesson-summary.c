#include "lesson-summary.h"

#include "lesson-list.h"
#include "scroll-to.h"
#include "tooltips.h"

#include <glib/gi18n.h>

/* Of the next lesson’s button: below it the panel fades. */
#define NEXT_MARGIN 30

struct _LessonSummary {
  GtkBox parent_instance;
  Session *session;
  const Lesson *lesson; /* whose next one is told; to compare */
  GtkLabel *counts;
  GtkBox *rows;
  GtkWidget *next;
  GtkLabel *next_title;
};

G_DEFINE_TYPE (LessonSummary, lesson_summary, GTK_TYPE_BOX)

static Outcome
outcome_at (LessonSummary *summary, guint stop)
{
  const QuestionRecord *record = session_get_record_of (summary->session, stop);

  return record == NULL ? OUTCOME_OPEN : record->outcome;
}

static const char *
outcome_sign (Outcome outcome)
{
  switch (outcome) {
  case OUTCOME_AT_ONCE:
  case OUTCOME_AFTER_HELP:
    return "✓";
  case OUTCOME_SHOWN:
    return "–";
  case OUTCOME_OPEN:
    break;
  }
  return "?";
}

static const char *
outcome_text (Outcome outcome)
{
  switch (outcome) {
  case OUTCOME_AT_ONCE:
    return _ ("right first time");
  case OUTCOME_AFTER_HELP:
    return _ ("right with help");
  case OUTCOME_SHOWN:
    return _ ("shown");
  case OUTCOME_OPEN:
    break;
  }
  return _ ("left open");
}

/* Rows: a question is a button that leads to it */

static GtkWidget *
make_label (const char *text, gboolean is_title)
{
  GtkWidget *label = gtk_label_new (text);

  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_line_wrap_mode (GTK_LABEL (label), PANGO_WRAP_WORD_CHAR);
  if (!is_title)
    gtk_style_context_add_class (gtk_widget_get_style_context (label),
                                 "outcome");
  return label;
}

/* Two lines, so that the column need not grow. */
static GtkWidget *
make_row (Outcome outcome, const char *title)
{
  GtkWidget *row = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 10);
  GtkWidget *words = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  GtkWidget *sign = gtk_label_new (outcome_sign (outcome));

  gtk_widget_set_valign (sign, GTK_ALIGN_START);
  gtk_label_set_width_chars (GTK_LABEL (sign), 2);
  gtk_container_add (GTK_CONTAINER (words), make_label (title, TRUE));
  gtk_container_add (GTK_CONTAINER (words),
                     make_label (outcome_text (outcome), FALSE));
  gtk_container_add (GTK_CONTAINER (row), sign);
  gtk_container_add (GTK_CONTAINER (row), words);
  return row;
}

static void
add_row (LessonSummary *summary, guint stop, const char *title)
{
  const Outcome outcome = outcome_at (summary, stop);
  GtkWidget *button = gtk_button_new ();
  g_autofree char *name = g_strdup_printf (_ ("Stop %u, %s: %s"), stop + 1,
                                           title, outcome_text (outcome));

  gtk_container_add (GTK_CONTAINER (button), make_row (outcome, title));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.stop");
  gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "u", stop + 1);
  gtk_style_context_add_class (gtk_widget_get_style_context (button), "flat");
  atk_object_set_name (gtk_widget_get_accessible (button), name);
  gtk_container_add (GTK_CONTAINER (summary->rows), button);
}

static void
remove_child (GtkWidget *child, gpointer user)
{
  (void)user;
  gtk_widget_destroy (child);
}

/* "3 right at once · 1 shown", without those of which there are none. */
static char *
counts_text (const guint counts[N_OUTCOMES])
{
  static const Outcome order[]
      = { OUTCOME_AT_ONCE, OUTCOME_AFTER_HELP, OUTCOME_SHOWN, OUTCOME_OPEN };
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < G_N_ELEMENTS (order); i++)
    if (counts[order[i]] > 0)
      g_string_append_printf (text, "%s%u %s", text->len == 0 ? "" : " · ",
                              counts[order[i]], outcome_text (order[i]));
  if (text->len == 0)
    g_string_append (text, _ ("It has no questions."));
  return g_string_free (g_steal_pointer (&text), FALSE);
}

static void
show_questions (LessonSummary *summary, const Lesson *lesson)
{
  guint counts[N_OUTCOMES] = { 0 };
  g_autofree char *text = NULL;

  gtk_container_foreach (GTK_CONTAINER (summary->rows), remove_child, NULL);
  for (guint i = 0; i < lesson->stops->len; i++) {
    const LessonStop *stop = lesson_stop (lesson, i);

    if (stop->question == NULL)
      continue;
    counts[outcome_at (summary, i)] += 1;
    add_row (summary, i, stop->title);
  }
  text = counts_text (counts);
  gtk_label_set_text (summary->counts, text);
  gtk_widget_show_all (GTK_WIDGET (summary->rows));
}

/* Reading the next lesson takes a moment; it is read once. */
static void
show_next (LessonSummary *summary, const Lesson *lesson)
{
  g_autofree char *path = NULL, *title = NULL, *text = NULL;

  if (summary->lesson == lesson)
    return;
  summary->lesson = lesson;
  path = lesson_list_next (lesson->path);
  title = path == NULL ? NULL : lesson_list_title (path);
  gtk_widget_set_visible (summary->next, title != NULL);
  if (title == NULL)
    return;
  text = g_strdup_printf (_ ("Next lesson: %s"), title);
  gtk_label_set_text (summary->next_title, text);
  tooltips_set (summary->next, "next-lesson", text);
}

static gboolean
is_over (LessonSummary *summary, const Lesson *lesson)
{
  Session *session = summary->session;
  const Exercise *exercise;

  if (lesson == NULL || session_get_stop (session) + 1 < lesson->stops->len)
    return FALSE;
  exercise = session_get_exercise_of (session, session_get_stop (session));
  return exercise == NULL || !exercise->is_open;
}

static void
update (LessonSummary *summary)
{
  const Lesson *lesson = session_get_lesson (summary->session);
  const gboolean shows = is_over (summary, lesson);

  gtk_widget_set_visible (GTK_WIDGET (summary), shows);
  if (!shows)
    return;
  show_questions (summary, lesson);
  show_next (summary, lesson);
}

static void
on_changed (Session *session, guint changes, LessonSummary *summary)
{
  (void)session;
  if (changes & CHANGED_LESSON)
    summary->lesson = NULL;
  if (changes & (CHANGED_LESSON | CHANGED_QUESTION))
    update (summary);
}

void
lesson_summary_set_session (LessonSummary *summary, Session *session)
{
  g_assert (summary->session == NULL);
  summary->session = g_object_ref (session);
  /* After the session has written down what has changed. */
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), summary,
                           G_CONNECT_AFTER);
  update (summary);
}

gboolean
lesson_summary_show_next (LessonSummary *summary)
{
  if (!gtk_widget_is_visible (summary->next))
    return FALSE;
  gtk_widget_grab_focus (summary->next);
  scroll_to (summary->next, NEXT_MARGIN);
  return TRUE;
}

static void
lesson_summary_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_LESSON_SUMMARY (object)->session);
  G_OBJECT_CLASS (lesson_summary_parent_class)->dispose (object);
}

static void
lesson_summary_class_init (LessonSummaryClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = lesson_summary_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/lesson-summary.ui");
  gtk_widget_class_bind_template_child (widget_class, LessonSummary, counts);
  gtk_widget_class_bind_template_child (widget_class, LessonSummary, rows);
  gtk_widget_class_bind_template_child (widget_class, LessonSummary, next);
  gtk_widget_class_bind_template_child (widget_class, LessonSummary,
                                        next_title);
}

static void
lesson_summary_init (LessonSummary *summary)
{
  gtk_widget_init_template (GTK_WIDGET (summary));
}
