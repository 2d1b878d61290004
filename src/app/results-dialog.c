#include "results-dialog.h"

#include "document.h"
#include "file-dialogs.h"
#include "results.h"
#include "window-message.h"

#include <glib/gi18n.h>
#include <string.h>

struct _ResultsDialog {
  GtkDialog parent_instance;
  GtkComboBox *format;
  GtkEntry *name;
  GtkLabel *summary;
};

G_DEFINE_TYPE (ResultsDialog, results_dialog, GTK_TYPE_DIALOG)

/* What waits for a place on the disk. */
typedef struct Waiting {
  Hull2vdWindow *window;
  char *text;
} Waiting;

static void
free_waiting (gpointer data)
{
  Waiting *waiting = data;

  g_object_unref (waiting->window);
  g_free (waiting->text);
  g_free (waiting);
}

static void
on_chosen (const char *path, gpointer user)
{
  const Waiting *waiting = user;
  g_autoptr (GError) error = NULL;

  if (!document_write (path, waiting->text, strlen (waiting->text), &error))
    window_message_say (waiting->window, "export-results", error->message);
  else
    window_message_settle (waiting->window, "export-results");
}

static void
ask_where (ResultsDialog *dialog, Hull2vdWindow *window, Progress *progress)
{
  const gboolean is_csv = gtk_combo_box_get_active (dialog->format) == 0;
  const char *name = gtk_entry_get_text (dialog->name);
  Waiting *waiting = g_new0 (Waiting, 1);

  waiting->window = g_object_ref (window);
  waiting->text = (is_csv ? results_csv : results_xapi) (progress, name);
  file_dialog_save_with (GTK_WINDOW (window), _ ("Save the Results"),
                         is_csv ? _ ("results.csv") : _ ("results.jsonl"),
                         on_chosen, waiting, free_waiting);
}

static void
on_response (GtkDialog *dialog, int response, Progress *progress)
{
  GtkWindow *window = gtk_window_get_transient_for (GTK_WINDOW (dialog));

  if (response == GTK_RESPONSE_ACCEPT)
    ask_where (HULL2VD_RESULTS_DIALOG (dialog), HULL2VD_WINDOW (window),
               progress);
  gtk_widget_destroy (GTK_WIDGET (dialog));
}

/* What will be in the file. */
static void
tell (ResultsDialog *dialog, const Progress *progress)
{
  guint n_answered = 0, n_lessons = 0;
  g_autofree char *text = NULL;

  for (guint i = 0; i < progress->lessons->len; i++) {
    const LessonRecord *lesson = g_ptr_array_index (progress->lessons, i);
    const guint n
        = lesson->questions->len - lesson_record_count (lesson, OUTCOME_OPEN);

    n_answered += n;
    n_lessons += n > 0;
  }
  text = g_strdup_printf (
      ngettext ("%u answer, from %u lesson. Nothing is sent anywhere: you "
                "choose where the file is saved.",
                "%u answers; lessons: %u. Nothing is sent anywhere: you choose "
                "where the file is saved.",
                n_answered),
      n_answered, n_lessons);
  gtk_label_set_text (dialog->summary, text);
}

void
results_dialog_show (Hull2vdWindow *window, Progress *progress)
{
  ResultsDialog *dialog = g_object_new (
      RESULTS_DIALOG_TYPE, "transient-for", window, "modal", TRUE,
      "destroy-with-parent", TRUE, "use-header-bar", 1, NULL);

  tell (dialog, progress);
  g_signal_connect (dialog, "response", G_CALLBACK (on_response), progress);
  gtk_window_present (GTK_WINDOW (dialog));
}

static void
results_dialog_class_init (ResultsDialogClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/results-dialog.ui");
  gtk_widget_class_bind_template_child (widget_class, ResultsDialog, format);
  gtk_widget_class_bind_template_child (widget_class, ResultsDialog, name);
  gtk_widget_class_bind_template_child (widget_class, ResultsDialog, summary);
}

static void
results_dialog_init (ResultsDialog *dialog)
{
  gtk_widget_init_template (GTK_WIDGET (dialog));
  gtk_combo_box_set_active (dialog->format, 0);
  atk_object_set_name (gtk_widget_get_accessible (GTK_WIDGET (dialog->format)),
                       _ ("Format"));
  atk_object_set_name (gtk_widget_get_accessible (GTK_WIDGET (dialog->name)),
                       _ ("Name"));
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
}
