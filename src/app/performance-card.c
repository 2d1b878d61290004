#include "performance-card.h"

#include <glib/gi18n.h>

struct _PerformanceCard {
  GtkBox parent_instance;
  GtkLabel *progress, *score, *marks, *sites;
  GtkProgressBar *bar;
  GtkWidget *browse;
};

G_DEFINE_TYPE (PerformanceCard, performance_card, GTK_TYPE_BOX)

static void
set_text (GtkLabel *label, const char *text)
{
  gtk_label_set_text (label, text);
  gtk_widget_set_visible (GTK_WIDGET (label), *text != '\0');
}

static void
show_score (PerformanceCard *card, const Performance *performance)
{
  g_autofree char *score = performance_score_text (performance);
  g_autofree char *told = performance->is_over
                              ? g_strdup_printf (_ ("Graded: %s"), score)
                              : g_strdup (score);
  g_autofree char *marks
      = performance->is_over ? performance_marks (performance) : g_strdup ("");

  set_text (card->score, performance_score (performance).total > 0 ? told : "");
  set_text (card->marks, marks);
  gtk_progress_bar_set_fraction (card->bar, performance_fraction (performance));
}

void
performance_card_show (PerformanceCard *card, Session *session)
{
  const Performance *performance = session_get_performance (session);
  g_autofree char *progress = NULL, *sites = NULL, *told = NULL;

  gtk_widget_set_visible (GTK_WIDGET (card), performance != NULL);
  if (performance == NULL)
    return;
  progress = performance_progress (performance);
  sites = session_performance_sites (session);
  told = *sites == '\0' ? g_strdup ("")
                        : g_strdup_printf (_ ("Sites: %s"), sites);
  set_text (card->progress, progress);
  set_text (card->sites, told);
  show_score (card, performance);
  gtk_widget_set_visible (card->browse, performance->is_over);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, PerformanceCard, name)

static void
performance_card_class_init (PerformanceCardClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/performance-card.ui");
  BIND (progress);
  BIND (bar);
  BIND (score);
  BIND (marks);
  BIND (sites);
  BIND (browse);
}

static void
performance_card_init (PerformanceCard *card)
{
  gtk_widget_init_template (GTK_WIDGET (card));
}
