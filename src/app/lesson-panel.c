#include "lesson-panel.h"

#include "prose.h"
#include "question-card.h"

#include <glib/gi18n.h>

struct _LessonPanel {
  GtkBox parent_instance;
  Session *session;
  GtkScrolledWindow *scroll;
  QuestionCard *card;
  GtkLabel *faults;
  GtkTextView *text;
  GtkTextTag *heading;
  GtkTextTag *intro;
};

G_DEFINE_TYPE (LessonPanel, lesson_panel, GTK_TYPE_BOX)

static void
add_heading (LessonPanel *panel, const char *title)
{
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (panel->text);
  GtkTextIter end;

  gtk_text_buffer_get_end_iter (buffer, &end);
  gtk_text_buffer_insert_with_tags (buffer, &end, title, -1, panel->heading,
                                    NULL);
  gtk_text_buffer_insert (buffer, &end, "\n", -1);
}

static void
add_markup (LessonPanel *panel, const char *markup)
{
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (panel->text);
  GtkTextIter end;

  gtk_text_buffer_get_end_iter (buffer, &end);
  gtk_text_buffer_insert_markup (buffer, &end, markup, -1);
}

static void
add_prose (LessonPanel *panel, const char *commonmark)
{
  g_autofree char *markup = prose_to_markup (commonmark);

  add_markup (panel, markup);
}

/* The words before the first stop introduce the lesson; they stand above it. */
static void
add_intro (LessonPanel *panel, const Lesson *lesson)
{
  GtkTextBuffer *buffer = gtk_text_view_get_buffer (panel->text);
  GtkTextIter start, end;

  if (lesson->prose == NULL || *lesson->prose == '\0')
    return;
  add_prose (panel, lesson->prose);
  gtk_text_buffer_get_bounds (buffer, &start, &end);
  gtk_text_buffer_apply_tag (buffer, panel->intro, &start, &end);
  gtk_text_buffer_insert (buffer, &end, "\n\n", -1);
}

static void
show_stop (LessonPanel *panel, const Lesson *lesson, guint index)
{
  const LessonStop *stop = g_ptr_array_index (lesson->stops, index);

  if (index == 0)
    add_intro (panel, lesson);
  add_heading (panel, stop->title);
  add_prose (panel, stop->prose);
}

static void
show_freedom (LessonPanel *panel)
{
  add_heading (panel, _ ("Your own sites"));
  add_markup (
      panel,
      _ ("<b>Click</b> in the plane to add a site; inside a triangle, "
         "<b>double-click</b>. <b>Drag</b> a site to move it: hull, triangles "
         "and cells follow. <b>Right-click</b> for more, as coordinates.\n\n"
         "Click a site, a triangle or a facet to see its counterparts in both "
         "pictures, with <b>Shift</b> several sites. <b>Delete</b> removes "
         "them.\n\n"
         "Then step through QuickHull below, or open a lesson at the top."));
}

static void
update (LessonPanel *panel)
{
  Lesson *lesson = session_get_lesson (panel->session);
  const guint stop = session_get_stop (panel->session);

  gtk_text_buffer_set_text (gtk_text_view_get_buffer (panel->text), "", 0);
  if (lesson != NULL && stop < lesson->stops->len)
    show_stop (panel, lesson, stop);
  else
    show_freedom (panel);
  gtk_adjustment_set_value (gtk_scrolled_window_get_vadjustment (panel->scroll),
                            0);
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
    g_string_append (text, _ ("The lesson runs on as it was before."));
  gtk_label_set_text (panel->faults, text->str);
  gtk_widget_set_visible (GTK_WIDGET (panel->faults), n > 0);
}

static void
on_changed (Session *session, guint changes, LessonPanel *panel)
{
  (void)session;
  if (changes & CHANGED_LESSON)
    update (panel);
}

void
lesson_panel_set_session (LessonPanel *panel, Session *session)
{
  g_assert (panel->session == NULL);
  panel->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), panel,
                           0);
  question_card_set_session (panel->card, session);
  update (panel);
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
  g_type_ensure (QUESTION_CARD_TYPE);
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/lesson-panel.ui");
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, text);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, scroll);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, card);
  gtk_widget_class_bind_template_child (widget_class, LessonPanel, faults);
}

static void
lesson_panel_init (LessonPanel *panel)
{
  GtkTextBuffer *buffer;

  gtk_widget_init_template (GTK_WIDGET (panel));
  buffer = gtk_text_view_get_buffer (panel->text);
  panel->heading = gtk_text_buffer_create_tag (buffer, NULL, "weight",
                                               PANGO_WEIGHT_BOLD, "scale", 1.3,
                                               "pixels-below-lines", 8, NULL);
  panel->intro = gtk_text_buffer_create_tag (buffer, NULL, "style",
                                             PANGO_STYLE_ITALIC, NULL);
}
