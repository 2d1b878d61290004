#include "question-card.h"

#include "answer-list.h"
#include "attempt.h"
#include "performance-card.h"
#include "prose.h"
#include "question-search.h"
#include "scroll-to.h"

#include <glib/gi18n.h>

struct _QuestionCard {
  GtkBox parent_instance;
  Session *session;
  const Exercise *exercise; /* that is shown; borrowed, to compare */
  GtkLabel *prompt, *instruction, *hints, *verdict, *reasons;
  AnswerList *answers;
  PerformanceCard *performance;
  GtkWidget *buttons, *check, *hint, *undo, *show, *go_on, *retry, *another;
  GtkWidget *grade, *leave;
};

/* Of the card itself, below its buttons. */
#define BUTTONS_MARGIN 30

G_DEFINE_TYPE (QuestionCard, question_card, GTK_TYPE_BOX)

static void
set_text (GtkLabel *label, const char *text)
{
  gtk_label_set_text (label, text);
  gtk_widget_set_visible (GTK_WIDGET (label), *text != '\0');
}

static void
set_prose (GtkLabel *label, const char *commonmark)
{
  g_autofree char *markup = prose_to_markup (commonmark);

  gtk_label_set_markup (label, markup);
  gtk_widget_set_visible (GTK_WIDGET (label), *markup != '\0');
}

static void
show_hints (QuestionCard *card)
{
  const GPtrArray *hints = card->exercise->question->hints;
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < card->exercise->n_hints; i++)
    g_string_append_printf (text, "%s%s", i == 0 ? "" : "\n\n",
                            (char *)g_ptr_array_index (hints, i));
  set_prose (card->hints, text->str);
}

/* What was right and wrong */

static void
set_class (QuestionCard *card, const char *name, gboolean on)
{
  GtkStyleContext *style = gtk_widget_get_style_context (GTK_WIDGET (card));

  if (on)
    gtk_style_context_add_class (style, name);
  else
    gtk_style_context_remove_class (style, name);
}

/* While it can be tried again nothing is told of what is missing. */
static char *
verdict_text (const Exercise *exercise)
{
  const Verdict *verdict = exercise->verdict;

  if (verdict == NULL)
    return g_strdup (exercise->is_open ? "" : _ ("The answer"));
  if (verdict->is_right)
    return g_strdup (_ ("✓ Right"));
  if (exercise->is_open)
    return g_strdup (verdict->wrong > 0 || verdict->reasons->len > 0
                         ? _ ("✗ Not right")
                         : _ ("Right so far, but not complete"));
  return g_strdup_printf (_ ("✗ %u of %u right"),
                          MIN (verdict->right, verdict->total), verdict->total);
}

static void
append_line (GString *text, const char *line)
{
  g_string_append_printf (text, "%s%s", text->len == 0 ? "" : "\n", line);
}

static void
append_all (GString *text, const GPtrArray *lines)
{
  for (guint i = 0; i < lines->len; i++)
    append_line (text, g_ptr_array_index (lines, i));
}

/* More of them, which say the same of other objects, push the question off. */
#define MOST_MISSED 4

static void
append_missed (GString *text, const GPtrArray *missed)
{
  const guint n_more = missed->len - MIN (missed->len, MOST_MISSED);
  g_autofree char *more = g_strdup_printf (
      ngettext ("and %u more", "and %u more", n_more), n_more);

  for (guint i = 0; i + n_more < missed->len; i++)
    append_line (text, g_ptr_array_index (missed, i));
  if (n_more > 0)
    append_line (text, more);
}

/* Of a law there is nothing that could be missed; sites for which it fails are
 * in the pictures until the lesson goes on. */
static char *
law_text (const Exercise *exercise, const Trace *shown)
{
  g_autoptr (Answer) answer
      = answer_new (exercise->question, &exercise->occasion);
  g_autofree char *yes_or_no = question_item_text (
      exercise->question, (Object){ OBJECT_NONE, answer->is_found ? 1 : 0 });
  g_autofree char *reason
      = answer->is_found
                && question_fails (exercise->question->condition, shown)
            ? g_strdup (_ ("It fails for the sites that are shown."))
            : answer_reason (exercise->question, &exercise->occasion,
                             (Object){ OBJECT_NONE, 0 }, TRUE);

  return g_strdup_printf ("%s. %s", yes_or_no, reason);
}

/* Of a drag whose answer is shown: the picture has a place where it holds,
 * until the lesson goes on. */
static char *
drag_text (const Exercise *exercise, const Trace *shown)
{
  g_autoptr (GString) text = g_string_new (NULL);

  if (exercise->verdict != NULL)
    append_line (text, _ ("It did not hold where you left the site."));
  append_line (text, question_drag_holds (exercise->question,
                                          exercise->occasion.trace, shown)
                         ? _ ("It holds where the site is now.")
                         : _ ("The site is back where it was."));
  return g_string_free (g_steal_pointer (&text), FALSE);
}

static gboolean
is_shown (const Exercise *exercise, QuestionKind kind)
{
  return !exercise->is_open && exercise->question->kind == kind
         && (exercise->verdict == NULL || !exercise->verdict->is_right);
}

/* Whoever looks at the answer without an attempt is told why as well. */
static char *
reasons_text (const Exercise *exercise, const Trace *shown)
{
  g_autoptr (GString) text = g_string_new (NULL);
  const Verdict *verdict = exercise->verdict;
  g_autoptr (Verdict) blank = NULL;

  if (is_shown (exercise, QUESTION_DRAG))
    return drag_text (exercise, shown);
  if (is_shown (exercise, QUESTION_ALWAYS) && verdict == NULL)
    return law_text (exercise, shown);
  if (verdict == NULL && !exercise->is_open)
    verdict = blank = attempt_grade (exercise->attempt, exercise->question,
                                     &exercise->occasion);
  if (verdict != NULL) {
    append_all (text, verdict->reasons);
    if (!exercise->is_open && verdict->missed->len > 0) {
      if (verdict != blank && exercise->question->kind == QUESTION_CLICK)
        append_line (text, _ ("Missed, dotted in the pictures:"));
      append_missed (text, verdict->missed);
    }
  }
  return g_string_free (g_steal_pointer (&text), FALSE);
}

static void
show_verdict (QuestionCard *card)
{
  const Exercise *exercise = card->exercise;
  const Verdict *verdict = exercise->verdict;
  g_autofree char *text = verdict_text (exercise);
  g_autofree char *reasons
      = reasons_text (exercise, session_get_trace (card->session));

  if (verdict == NULL && exercise_holds_now (exercise)) {
    g_free (text);
    text = g_strdup (_ ("✓ It holds here: let go"));
  }
  set_text (card->verdict, text);
  set_text (card->reasons, reasons);
  set_class (card, "right", verdict != NULL && verdict->is_right);
  set_class (card, "wrong", verdict != NULL && !verdict->is_right);
}

/* Long words on a button make it higher, and no picture smaller. */
static void
wrap_labels (GtkWidget *widget, gpointer user)
{
  if (GTK_IS_BUTTON (widget)
      && GTK_IS_LABEL (gtk_bin_get_child (GTK_BIN (widget)))) {
    GtkLabel *label = GTK_LABEL (gtk_bin_get_child (GTK_BIN (widget)));

    gtk_label_set_line_wrap (label, TRUE);
    gtk_label_set_justify (label, GTK_JUSTIFY_CENTER);
  } else if (GTK_IS_CONTAINER (widget)) {
    gtk_container_forall (GTK_CONTAINER (widget), wrap_labels, user);
  }
}

/* Between the tasks of a performance there is only one way to go. */
static void
show_closed_buttons (QuestionCard *card)
{
  const Performance *performance = session_get_performance (card->session);
  const gboolean is_closed = !card->exercise->is_open;
  const gboolean is_over
      = is_closed && (performance == NULL || performance->is_over);

  gtk_widget_set_visible (card->go_on,
                          is_closed && session_can_continue (card->session));
  gtk_widget_set_visible (card->retry, is_over);
  gtk_widget_set_visible (card->another,
                          is_over && session_can_another (card->session));
  gtk_button_set_label (GTK_BUTTON (card->another), performance == NULL
                                                        ? _ ("Try another")
                                                        : _ ("Fresh sites"));
  wrap_labels (card->another, NULL);
}

static void
show_buttons (QuestionCard *card)
{
  const Exercise *exercise = card->exercise;
  const gboolean is_open = exercise->is_open;

  gtk_widget_set_visible (card->check, is_open);
  gtk_widget_set_visible (card->hint,
                          is_open && exercise->question->hints->len > 0);
  gtk_widget_set_visible (card->undo,
                          is_open && exercise->question->kind != QUESTION_DRAG);
  gtk_widget_set_visible (card->show, is_open);
  show_closed_buttons (card);
  gtk_widget_set_visible (card->grade, session_can_grade (card->session));
  gtk_widget_set_visible (
      card->leave, !is_open && session_can_end_performance (card->session)
                       && !session_can_grade (card->session));
  gtk_widget_set_visible (gtk_widget_get_parent (card->check),
                          is_open || gtk_widget_get_visible (card->go_on)
                              || gtk_widget_get_visible (card->another));
  gtk_widget_set_visible (card->buttons,
                          is_open || gtk_widget_get_visible (card->retry)
                              || gtk_widget_get_visible (card->leave));
}

static void
show_question (QuestionCard *card)
{
  const Exercise *exercise = card->exercise;
  g_autofree char *prompt
      = question_prompt (exercise->question, &exercise->occasion);
  g_autofree char *instruction = question_instruction (exercise->question);

  set_prose (card->prompt, prompt);
  set_text (card->instruction, instruction);
}

/* What answers it, below all that there is to read. */
static void
scroll_to_buttons (QuestionCard *card)
{
  scroll_to (gtk_widget_get_visible (card->grade) ? card->grade : card->buttons,
             BUTTONS_MARGIN);
}

static void
update (QuestionCard *card)
{
  const Exercise *shown = card->exercise;

  card->exercise = session_get_exercise (card->session);
  gtk_widget_set_visible (GTK_WIDGET (card), card->exercise != NULL);
  answer_list_show (card->answers, card->exercise);
  if (card->exercise == NULL)
    return;
  performance_card_show (card->performance, card->session);
  show_question (card);
  show_hints (card);
  show_verdict (card);
  show_buttons (card);
  gtk_widget_set_visible (GTK_WIDGET (card->instruction),
                          card->exercise->is_open);
  /* Whoever has pressed one wants to see what came of it; tasks follow each
   * other. */
  if (card->exercise == shown
      || session_get_performance (card->session) != NULL)
    scroll_to_buttons (card);
}

static void
on_changed (Session *session, guint changes, QuestionCard *card)
{
  (void)session;
  if (changes & (CHANGED_QUESTION | CHANGED_LESSON))
    update (card);
  /* Its words speak of the sites that are shown. */
  else if (changes & CHANGED_SITES && card->exercise != NULL
           && !card->exercise->is_open)
    show_verdict (card);
  /* Letters of another size push them out of sight. */
  else if (changes & CHANGED_APPEARANCE && card->exercise != NULL)
    scroll_to_buttons (card);
}

void
question_card_set_session (QuestionCard *card, Session *session)
{
  g_assert (card->session == NULL);
  card->session = g_object_ref (session);
  answer_list_set_session (card->answers, session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), card,
                           0);
  update (card);
}

static void
question_card_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_QUESTION_CARD (object)->session);
  G_OBJECT_CLASS (question_card_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, QuestionCard, name)

static void
question_card_class_init (QuestionCardClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = question_card_dispose;
  g_type_ensure (ANSWER_LIST_TYPE);
  g_type_ensure (PERFORMANCE_CARD_TYPE);
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/question-card.ui");
  BIND (performance);
  BIND (prompt);
  BIND (instruction);
  BIND (answers);
  BIND (hints);
  BIND (verdict);
  BIND (reasons);
  BIND (buttons);
  BIND (check);
  BIND (hint);
  BIND (undo);
  BIND (show);
  BIND (go_on);
  BIND (retry);
  BIND (another);
  BIND (grade);
  BIND (leave);
}

static void
question_card_init (QuestionCard *card)
{
  gtk_widget_init_template (GTK_WIDGET (card));
  wrap_labels (GTK_WIDGET (card), NULL);
}
