#include "handout-dialog.h"

#include "chore-task.h"

#include <glib/gi18n.h>

/* px of the sample; a page of either paper fits in. */
#define SAMPLE_WIDTH 340
#define SAMPLE_HEIGHT 470

/* Pages are set anew when choices have come to rest. */
#define REST_MS 120

struct _HandoutDialog {
  GtkDialog parent_instance;
  Session *session; /* whose chore the pages are */
  Lesson *lesson;
  Handout *handout; /* what the dialog says; NULL: not yet */
  ChoreTask *task;  /* sets the pages; NULL: none is under way */
  guint rest;       /* source that will set the pages */
  GtkComboBox *contents, *theme, *paper;
  GtkToggleButton *steps, *key;
  GtkSpinButton *page;
  GtkLabel *n_pages;
  GtkWidget *sample, *export_button;
};

G_DEFINE_TYPE (HandoutDialog, handout_dialog, GTK_TYPE_DIALOG)

static gboolean
has_contents (HandoutDialog *dialog, const char *id)
{
  return g_strcmp0 (gtk_combo_box_get_active_id (dialog->contents), id) == 0;
}

void
handout_dialog_fill (HandoutDialog *dialog, HandoutOptions *options)
{
  handout_options_init (options);
  options->has_notes = has_contents (dialog, "notes");
  options->has_blanks = has_contents (dialog, "blanks");
  options->has_stops = options->has_notes || options->has_blanks
                       || has_contents (dialog, "full");
  options->has_steps
      = has_contents (dialog, "steps")
        || (options->has_stops && gtk_toggle_button_get_active (dialog->steps));
  options->has_key
      = has_contents (dialog, "key")
        || (options->has_stops && gtk_toggle_button_get_active (dialog->key));
  options->paper = paper_find (gtk_combo_box_get_active_id (dialog->paper));
  theme_kind_parse (gtk_combo_box_get_active_id (dialog->theme),
                    &options->appearance.theme);
}

/* Sample */

static guint
get_page (HandoutDialog *dialog)
{
  return (guint)gtk_spin_button_get_value_as_int (dialog->page) - 1;
}

static gboolean
on_draw_sample (GtkWidget *widget, cairo_t *cr, HandoutDialog *dialog)
{
  const double room[2] = { gtk_widget_get_allocated_width (widget),
                           gtk_widget_get_allocated_height (widget) };
  HandoutOptions options;
  double factor;

  if (dialog->handout == NULL)
    return TRUE;
  handout_dialog_fill (dialog, &options);
  factor
      = MIN (room[0] / options.paper->width, room[1] / options.paper->height);
  cairo_translate (cr, (room[0] - factor * options.paper->width) / 2, 0);
  cairo_scale (cr, factor, factor);
  cairo_rectangle (cr, 0, 0, options.paper->width, options.paper->height);
  cairo_clip (cr);
  handout_paint (dialog->handout, get_page (dialog), cr);
  return TRUE;
}

static void
show_pages (HandoutDialog *dialog)
{
  const guint n_pages = handout_count_pages (dialog->handout);
  /* Translators: after the number of the page that is shown. */
  g_autofree char *text = g_strdup_printf (_ ("of %u"), n_pages);

  gtk_spin_button_set_range (dialog->page, 1, n_pages);
  gtk_widget_set_sensitive (GTK_WIDGET (dialog->page), n_pages > 1);
  gtk_label_set_text (dialog->n_pages, text);
  gtk_widget_queue_draw (dialog->sample);
}

/* What a thread sets: a session of its own plays the lesson. */
typedef struct Pages {
  HandoutDialog *dialog;
  Lesson *lesson;
  HandoutOptions options;
  Handout *handout;
  ChoreTask *task;
} Pages;

static void
pages_free (gpointer data)
{
  Pages *pages = data;

  if (pages->dialog->task == pages->task)
    pages->dialog->task = NULL;
  g_object_unref (pages->dialog);
  lesson_unref (pages->lesson);
  g_clear_pointer (&pages->handout, handout_free);
  g_free (pages);
}

static gboolean
set_pages (ChoreTask *task, gpointer data, GError **error)
{
  Pages *pages = data;
  g_autoptr (Session) session = session_new ();

  (void)task;
  (void)error;
  session_set_lesson (session, pages->lesson);
  pages->handout = handout_new (session, &pages->options);
  return TRUE;
}

static void
on_pages (gpointer data, const GError *error)
{
  Pages *pages = data;
  HandoutDialog *dialog = pages->dialog;

  (void)error;
  g_clear_pointer (&dialog->handout, handout_free);
  dialog->handout = g_steal_pointer (&pages->handout);
  show_pages (dialog);
}

static void
drop_task (HandoutDialog *dialog)
{
  if (dialog->task != NULL)
    chore_task_give_up (dialog->task);
  dialog->task = NULL;
}

/* The pages before stay until the new ones are set. */
static gboolean
on_rest (gpointer user)
{
  HandoutDialog *dialog = user;
  Pages *pages = g_new0 (Pages, 1);

  dialog->rest = 0;
  pages->dialog = g_object_ref (dialog);
  pages->lesson = lesson_ref (dialog->lesson);
  handout_dialog_fill (dialog, &pages->options);
  drop_task (dialog);
  pages->task = dialog->task
      = chore_task_begin (dialog->session, _ ("The pages are being set"),
                          set_pages, on_pages, pages, pages_free);
  return G_SOURCE_REMOVE;
}

/* What can be added to stops has no meaning without them. */
static void
on_changed (HandoutDialog *dialog)
{
  HandoutOptions options;

  handout_dialog_fill (dialog, &options);
  gtk_widget_set_sensitive (GTK_WIDGET (dialog->steps), options.has_stops);
  gtk_widget_set_sensitive (GTK_WIDGET (dialog->key), options.has_stops);
  if (dialog->rest != 0)
    g_source_remove (dialog->rest);
  dialog->rest = g_timeout_add (REST_MS, on_rest, dialog);
}

/* Life */

static void
connect_controls (HandoutDialog *dialog)
{
  GtkComboBox *boxes[] = { dialog->contents, dialog->theme, dialog->paper };
  GtkToggleButton *buttons[] = { dialog->steps, dialog->key };

  for (guint i = 0; i < G_N_ELEMENTS (boxes); i++)
    g_signal_connect_swapped (boxes[i], "changed", G_CALLBACK (on_changed),
                              dialog);
  for (guint i = 0; i < G_N_ELEMENTS (buttons); i++)
    g_signal_connect_swapped (buttons[i], "toggled", G_CALLBACK (on_changed),
                              dialog);
  g_signal_connect_swapped (dialog->page, "value-changed",
                            G_CALLBACK (gtk_widget_queue_draw), dialog->sample);
  g_signal_connect (dialog->sample, "draw", G_CALLBACK (on_draw_sample),
                    dialog);
}

HandoutDialog *
handout_dialog_new (GtkWindow *parent, Session *session, Lesson *lesson)
{
  HandoutDialog *dialog = g_object_new (
      HANDOUT_DIALOG_TYPE, "transient-for", parent, "modal", TRUE,
      "destroy-with-parent", TRUE, "use-header-bar", 1, NULL);

  dialog->session = g_object_ref (session);
  dialog->lesson = lesson_ref (lesson);
  connect_controls (dialog);
  on_changed (dialog);
  return dialog;
}

static void
handout_dialog_dispose (GObject *object)
{
  HandoutDialog *dialog = HULL2VD_HANDOUT_DIALOG (object);

  if (dialog->rest != 0)
    g_source_remove (dialog->rest);
  dialog->rest = 0;
  drop_task (dialog);
  g_clear_pointer (&dialog->handout, handout_free);
  g_clear_pointer (&dialog->lesson, lesson_unref);
  g_clear_object (&dialog->session);
  G_OBJECT_CLASS (handout_dialog_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, HandoutDialog, name)

static void
handout_dialog_class_init (HandoutDialogClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = handout_dialog_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/handout-dialog.ui");
  BIND (contents);
  BIND (theme);
  BIND (paper);
  BIND (steps);
  BIND (key);
  BIND (page);
  BIND (n_pages);
  BIND (sample);
  BIND (export_button);
}

/* Labels beside them are not found by all readers. */
static void
name_controls (HandoutDialog *dialog)
{
  const struct {
    gpointer control;
    const char *name;
  } rows[] = {
    { dialog->contents, _ ("Contents") },
    { dialog->theme, _ ("Theme") },
    { dialog->paper, _ ("Paper") },
    { dialog->page, _ ("Page shown") },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    atk_object_set_name (gtk_widget_get_accessible (rows[i].control),
                         rows[i].name);
}

static void
handout_dialog_init (HandoutDialog *dialog)
{
  const gboolean is_letter
      = g_str_equal (gtk_paper_size_get_default (), GTK_PAPER_NAME_LETTER);

  gtk_widget_init_template (GTK_WIDGET (dialog));
  gtk_combo_box_set_active_id (dialog->contents, "page");
  gtk_combo_box_set_active_id (dialog->theme, "print");
  gtk_combo_box_set_active_id (dialog->paper, is_letter ? "letter" : "a4");
  name_controls (dialog);
  gtk_widget_set_size_request (dialog->sample, SAMPLE_WIDTH, SAMPLE_HEIGHT);
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
}
