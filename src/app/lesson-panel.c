#include "lesson-panel.h"

#include "freedom.h"
#include "lesson-summary.h"
#include "prose.h"
#include "question-card.h"
#include "tooltips.h"

#include <glib/gi18n.h>

struct _LessonPanel {
  GtkBox parent_instance;
  Session *session;
  GtkScrolledWindow *scroll;
  GtkWidget *content; /* that scrolls */
  GtkWidget *resume;
  GtkLabel *resume_title;
  QuestionCard *card;
  LessonSummary *summary;
  GtkWidget *faults_scroll;
  GtkLabel *faults;
  GtkLabel *intro, *title, *text;
  gboolean right_button_adds;
};

G_DEFINE_TYPE (LessonPanel, lesson_panel, GTK_TYPE_BOX)

/* Paragraphs with air between their lines. */
static void
set_prose (GtkLabel *label, const char *commonmark)
{
  g_autofree char *markup = prose_to_markup (commonmark);
  g_autofree char *airy
      = g_strdup_printf ("<span line_height=\"1.2\">%s</span>", markup);

  gtk_label_set_markup (label, airy);
  gtk_widget_set_visible (GTK_WIDGET (label), *markup != '\0');
}

/* The words before the first stop introduce the lesson; they stand above it. */
static void
show_stop (LessonPanel *panel, const Lesson *lesson, guint index)
{
  const LessonStop *stop = g_ptr_array_index (lesson->stops, index);

  set_prose (panel->intro,
             index == 0 && lesson->prose != NULL ? lesson->prose : "");
  gtk_label_set_text (panel->title, stop->title);
  set_prose (panel->text, stop->prose);
}

static void
show_freedom (LessonPanel *panel)
{
  set_prose (panel->intro, "");
  gtk_label_set_text (panel->title, freedom_title (panel->session));
  set_prose (panel->text,
             freedom_text (panel->session, panel->right_button_adds));
}

/* Where the person was another time is offered, not gone to. */
static void
show_resume (LessonPanel *panel)
{
  const Lesson *lesson = session_get_lesson (panel->session);
  g_autofree char *text = NULL;
  guint stop;

  gtk_widget_set_visible (panel->resume,
                          session_can_resume (panel->session, &stop));
  if (!session_can_resume (panel->session, &stop))
    return;
  text = g_strdup_printf (_ ("Resume at stop %u: %s"), stop + 1,
                          lesson_stop (lesson, stop)->title);
  gtk_label_set_text (panel->resume_title, text);
  tooltips_set (panel->resume, "resume", text);
}

static void
update (LessonPanel *panel)
{
  Lesson *lesson = session_get_lesson (panel->session);
  const guint stop = session_get_stop (panel->session);

  if (lesson != NULL && stop < lesson->stops->len)
    show_stop (panel, lesson, stop);
  else
    show_freedom (panel);
  show_resume (panel);
  gtk_adjustment_set_value (gtk_scrolled_window_get_vadjustment (panel->scroll),
                            0);
}

void
lesson_panel_set_right_button_adds (LessonPanel *panel, gboolean adds)
{
  panel->right_button_adds = adds;
  update (panel);
}

/* More of them would push the text away. */
#define MOST_FAULTS 6

void
lesson_panel_set_faults (LessonPanel *panel, const LessonFaults *faults)
{
  const guint n = faults == NULL ? 0 : faults->errors->len;
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < MIN (n, MOST_FAULTS); i++)
    g_string_append_printf (
        text, "%s\n",
        ((const GError *)g_ptr_array_index (faults->errors, i))->message);
  if (n > MOST_FAULTS)
    g_string_append_printf (text, _ ("and %u more\n"), n - MOST_FAULTS);
  if (n > 0)
    g_string_append (text, _ ("The lesson continues as it was before."));
  gtk_label_set_text (panel->faults, text->str);
  gtk_widget_set_visible (panel->faults_scroll, n > 0);
}

static void
on_changed (Session *session, guint changes, LessonPanel *panel)
{
  if (changes & CHANGED_LESSON)
    update (panel);
  else if (session_get_lesson (session) == NULL
           && changes & (CHANGED_EXHIBIT | CHANGED_STAGING | CHANGED_QUESTION))
    show_freedom (panel);
}

void
lesson_panel_set_session (LessonPanel *panel, Session *session)
{
  g_assert (panel->session == NULL);
  panel->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), panel,
                           0);
  question_card_set_session (panel->card, session);
  lesson_summary_set_session (panel->summary, session);
  update (panel);
}

/* As high as all that there is to read: scrolled windows would not tell. */
static void
lesson_panel_get_preferred_height_for_width (GtkWidget *widget,
                                             int width,
                                             int *minimum,
                                             int *natural)
{
  LessonPanel *panel = HULL2VD_LESSON_PANEL (widget);
  GtkWidget *bar = gtk_scrolled_window_get_vscrollbar (panel->scroll);
  int bar_width, faults = 0, content;

  GTK_WIDGET_CLASS (lesson_panel_parent_class)
      ->get_preferred_height_for_width (widget, width, minimum, natural);
  gtk_widget_get_preferred_width (bar, &bar_width, NULL);
  gtk_widget_get_preferred_height_for_width (
      panel->content, MAX (1, width - bar_width), NULL, &content);
  if (gtk_widget_get_visible (panel->faults_scroll))
    gtk_widget_get_preferred_height (panel->faults_scroll, NULL, &faults);
  *natural = MAX (*minimum, content + faults);
}

gboolean
lesson_panel_show_next_lesson (LessonPanel *panel)
{
  return lesson_summary_show_next (panel->summary);
}

static void
lesson_panel_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_LESSON_PANEL (object)->session);
  G_OBJECT_CLASS (lesson_panel_parent_class)->dispose (object);
}

static void
lesson_panel_class_init (LessonPanelClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = lesson_panel_dispose;
  widget_class->get_preferred_height_for_width
      = lesson_panel_get_preferred_height_for_width;
  g_type_ensure (QUESTION_CARD_TYPE);
  g_type_ensure (LESSON_SUMMARY_TYPE);
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/lesson-panel.ui");
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, intro);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, title);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, text);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, scroll);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, content);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, card);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, faults);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel,
                                        faults_scroll);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, resume);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel,
                                        resume_title);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, summary);
}

static void
lesson_panel_init (LessonPanel *panel)
{
  gtk_widget_init_template (GTK_WIDGET (panel));
}
