#include "answer-list.h"

#include "words.h"

#include <glib/gi18n.h>

struct _AnswerList {
  GtkBox parent_instance;
  Session *session;
  const Exercise *exercise; /* whose rows there are; borrowed, to compare */
  const Question *question; /* of it: an exercise can be another at one place */
  GPtrArray *rows;          /* of GtkToggleButton or GtkEntry, in order */
  GtkWidget *none;  /* of radio buttons: chosen while no row is; not shown */
  GArray *items;    /* of Object: what the rows mean */
  GtkLabel *chosen; /* NULL: there are rows */
  gboolean is_updating;
};

G_DEFINE_TYPE (AnswerList, answer_list, GTK_TYPE_BOX)

/* A person answers */

static void
on_toggled (GtkToggleButton *button, AnswerList *list)
{
  guint index;

  if (list->is_updating || !g_ptr_array_find (list->rows, button, &index))
    return;
  /* A radio button goes out because another one is chosen. */
  if (GTK_IS_RADIO_BUTTON (button) && !gtk_toggle_button_get_active (button))
    return;
  session_answer_toggle (list->session,
                         g_array_index (list->items, Object, index));
  answer_list_show (list, list->exercise);
}

static void
on_number (GtkEditable *entry, AnswerList *list)
{
  g_autofree char *text = gtk_editable_get_chars (entry, 0, -1);
  guint64 number;
  guint index;

  if (list->is_updating || !g_ptr_array_find (list->rows, entry, &index))
    return;
  g_strstrip (text);
  session_answer_number (list->session, index,
                         words_parse_number (text, G_MAXUINT32, &number)
                             ? (gint64)number
                             : NUMBER_NONE);
}

static void
on_enter (GtkEntry *entry, AnswerList *list)
{
  (void)entry;
  session_check (list->session);
}

/* Rows */

static GtkWidget *
make_button (AnswerList *list, const char *text)
{
  if (!attempt_is_single (list->question))
    return gtk_check_button_new_with_label (text);
  if (list->none == NULL)
    list->none = g_object_ref_sink (gtk_radio_button_new (NULL));
  return gtk_radio_button_new_with_label_from_widget (
      GTK_RADIO_BUTTON (list->none), text);
}

static void
add_button (AnswerList *list, Object item)
{
  g_autofree char *text = question_item_text (list->question, item);
  GtkWidget *button = make_button (list, text);
  GtkWidget *label = gtk_bin_get_child (GTK_BIN (button));

  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_line_wrap_mode (GTK_LABEL (label), PANGO_WRAP_WORD_CHAR);
  gtk_label_set_xalign (GTK_LABEL (label), 0);
  g_signal_connect (button, "toggled", G_CALLBACK (on_toggled), list);
  gtk_container_add (GTK_CONTAINER (list), button);
  g_ptr_array_add (list->rows, button);
  g_array_append_val (list->items, item);
}

static void
add_options (AnswerList *list)
{
  const guint n = list->question->kind == QUESTION_ALWAYS
                      ? 2
                      : list->question->options->len;

  for (guint i = 0; i < n; i++)
    add_button (list, (Object){ OBJECT_NONE, i });
}

static void
add_items (AnswerList *list)
{
  g_autoptr (GArray) items
      = question_items (list->question, &list->exercise->occasion);

  for (guint i = 0; i < items->len; i++)
    add_button (list, g_array_index (items, Object, i));
}

static void
add_number (AnswerList *list, Quantity quantity)
{
  GtkWidget *row = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 10);
  GtkWidget *label = gtk_label_new (quantity_label (quantity));
  GtkWidget *entry = gtk_entry_new ();

  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_label_set_mnemonic_widget (GTK_LABEL (label), entry);
  gtk_widget_set_hexpand (label, TRUE);
  gtk_entry_set_width_chars (GTK_ENTRY (entry), 5);
  gtk_entry_set_max_length (GTK_ENTRY (entry), 9);
  gtk_entry_set_alignment (GTK_ENTRY (entry), 1);
  gtk_entry_set_input_purpose (GTK_ENTRY (entry), GTK_INPUT_PURPOSE_DIGITS);
  atk_object_set_name (gtk_widget_get_accessible (entry),
                       quantity_label (quantity));
  g_signal_connect (entry, "changed", G_CALLBACK (on_number), list);
  g_signal_connect (entry, "activate", G_CALLBACK (on_enter), list);
  gtk_container_add (GTK_CONTAINER (row), label);
  gtk_container_add (GTK_CONTAINER (row), entry);
  gtk_container_add (GTK_CONTAINER (list), row);
  g_ptr_array_add (list->rows, entry);
}

static void
add_chosen (AnswerList *list)
{
  GtkWidget *label = gtk_label_new (NULL);

  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_xalign (GTK_LABEL (label), 0);
  gtk_container_add (GTK_CONTAINER (list), label);
  list->chosen = GTK_LABEL (label);
}

static void
add_rows (AnswerList *list)
{
  switch (list->question->kind) {
  case QUESTION_CHOOSE:
  case QUESTION_ALWAYS:
    add_options (list);
    break;
  case QUESTION_ORDER:
    add_items (list);
    add_chosen (list);
    break;
  case QUESTION_NUMBERS:
    for (guint i = 0; i < list->question->quantities->len; i++)
      add_number (list,
                  g_array_index (list->question->quantities, Quantity, i));
    break;
  case QUESTION_CLICK:
    add_chosen (list);
    break;
  case QUESTION_DRAG:
  case QUESTION_PERFORM:
    break;
  }
}

static void
remove_child (GtkWidget *child, gpointer user)
{
  (void)user;
  gtk_widget_destroy (child);
}

static void
rebuild (AnswerList *list)
{
  g_ptr_array_set_size (list->rows, 0);
  g_array_set_size (list->items, 0);
  list->chosen = NULL;
  g_clear_object (&list->none);
  gtk_container_foreach (GTK_CONTAINER (list), remove_child, NULL);
  if (list->exercise != NULL)
    add_rows (list);
  gtk_widget_show_all (GTK_WIDGET (list));
}

/* As it is now */

/* Ridges by their sites, as the pictures name these; all else as it is
 * called. */
static char *
chosen_text (AnswerList *list, Object object)
{
  const Trace *trace = list->exercise->occasion.trace;

  if (object.kind != OBJECT_RIDGE)
    return question_item_text (list->question, object);
  return g_strdup_printf ("s%u–s%u", trace_ridge (trace, object.number).site[0],
                          trace_ridge (trace, object.number).site[1]);
}

static void
update_chosen (AnswerList *list)
{
  const GArray *objects = list->exercise->attempt->objects;
  const gboolean is_order = list->question->kind == QUESTION_ORDER;
  g_autoptr (GString) text = g_string_new (NULL);

  for (guint i = 0; i < objects->len; i++) {
    g_autofree char *name
        = chosen_text (list, g_array_index (objects, Object, i));

    g_string_append (text, i == 0 ? "" : is_order ? " → " : ", ");
    g_string_append (text, name);
  }
  gtk_label_set_text (list->chosen, text->str);
  gtk_widget_set_visible (GTK_WIDGET (list->chosen), text->len > 0);
}

static void
update_number (GtkEntry *entry, gint64 number)
{
  g_autofree char *text = number == NUMBER_NONE
                              ? g_strdup ("")
                              : g_strdup_printf ("%" G_GINT64_FORMAT, number);
  const char *shown = gtk_entry_get_text (entry);
  guint64 parsed;

  /* What is being typed is not touched while it means the same. */
  if (number == NUMBER_NONE ? words_parse_number (shown, G_MAXUINT32, &parsed)
                            : g_strcmp0 (shown, text) != 0)
    gtk_entry_set_text (entry, text);
}

static void
update_rows (AnswerList *list)
{
  const Attempt *attempt = list->exercise->attempt;

  list->is_updating = TRUE;
  if (list->none != NULL)
    gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (list->none), TRUE);
  for (guint i = 0; i < list->rows->len; i++) {
    GtkWidget *row = g_ptr_array_index (list->rows, i);

    if (GTK_IS_ENTRY (row))
      update_number (GTK_ENTRY (row),
                     g_array_index (attempt->numbers, gint64, i));
    else
      gtk_toggle_button_set_active (
          GTK_TOGGLE_BUTTON (row),
          attempt_has (attempt, g_array_index (list->items, Object, i)));
    gtk_widget_set_sensitive (row, list->exercise->is_open);
  }
  if (list->chosen != NULL)
    update_chosen (list);
  list->is_updating = FALSE;
}

/* What is empty takes no room. */
static gboolean
has_rows (AnswerList *list)
{
  return list->rows->len > 0
         || (list->chosen != NULL
             && gtk_widget_get_visible (GTK_WIDGET (list->chosen)));
}

void
answer_list_show (AnswerList *list, const Exercise *exercise)
{
  const Question *question = exercise == NULL ? NULL : exercise->question;

  if (exercise != list->exercise || question != list->question) {
    list->exercise = exercise;
    list->question = question;
    rebuild (list);
  }
  if (exercise != NULL)
    update_rows (list);
  gtk_widget_set_visible (GTK_WIDGET (list), has_rows (list));
}

void
answer_list_set_session (AnswerList *list, Session *session)
{
  g_assert (list->session == NULL);
  list->session = g_object_ref (session);
}

static void
answer_list_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_ANSWER_LIST (object)->session);
  g_clear_object (&HULL2VD_ANSWER_LIST (object)->none);
  G_OBJECT_CLASS (answer_list_parent_class)->dispose (object);
}

static void
answer_list_finalize (GObject *object)
{
  AnswerList *list = HULL2VD_ANSWER_LIST (object);

  g_ptr_array_unref (list->rows);
  g_array_unref (list->items);
  G_OBJECT_CLASS (answer_list_parent_class)->finalize (object);
}

static void
answer_list_class_init (AnswerListClass *class)
{
  G_OBJECT_CLASS (class)->dispose = answer_list_dispose;
  G_OBJECT_CLASS (class)->finalize = answer_list_finalize;
}

static void
answer_list_init (AnswerList *list)
{
  gtk_orientable_set_orientation (GTK_ORIENTABLE (list),
                                  GTK_ORIENTATION_VERTICAL);
  gtk_box_set_spacing (GTK_BOX (list), 6);
  list->rows = g_ptr_array_new ();
  list->items = g_array_new (FALSE, FALSE, sizeof (Object));
}
