/* Question banks as Moodle's GIFT. */
#include "prose.h"
#include "question-bank.h"

#include <glib/gi18n.h>
#include <string.h>

/* Parts of 100 % that Moodle knows go down to a tenth. */
#define MAX_RIGHT 10

/* Appends HTML with the signs of GIFT escaped, on one line. */
static void
append_html (GString *gift, const char *html)
{
  for (const char *byte = html; *byte != '\0'; byte++) {
    if (strchr ("\\~=#{}:", *byte) != NULL)
      g_string_append_c (gift, '\\');
    g_string_append_c (gift, *byte == '\n' || *byte == '\r' ? ' ' : *byte);
  }
}

static void
append_text (GString *gift, const char *text)
{
  g_autofree char *html = g_markup_escape_text (text, -1);

  append_html (gift, html);
}

static void
append_reason (GString *gift, const char *sign, const char *reason)
{
  if (reason == NULL)
    return;
  g_string_append (gift, sign);
  append_text (gift, reason);
}

static void
append_stem (GString *gift, const BankItem *item)
{
  g_autofree char *prompt = prose_to_html (item->prompt);

  append_html (gift, g_strchomp (prompt));
  for (guint i = 0; i < item->given->len; i++) {
    g_autofree char *line = g_markup_printf_escaped (
        "<p>%s</p>", (const char *)g_ptr_array_index (item->given, i));

    append_html (gift, line);
  }
}

static guint
count_right (const BankItem *item)
{
  guint n = 0;

  for (guint i = 0; i < item->options->len; i++)
    n += ((BankOption *)g_ptr_array_index (item->options, i))->is_right;
  return n;
}

/* Whoever chooses one that is wrong has not found all that are right. */
static void
append_several (GString *gift, const BankItem *item)
{
  const double part = 100.0 / count_right (item);

  for (guint i = 0; i < item->options->len; i++) {
    const BankOption *option = g_ptr_array_index (item->options, i);
    char weight[G_ASCII_DTOSTR_BUF_SIZE];

    g_ascii_formatd (weight, sizeof weight, "%.5f",
                     option->is_right ? part : -100.0);
    g_string_append_printf (gift, "~%%%s%%", weight);
    append_text (gift, option->text);
    append_reason (gift, "#", option->reason);
    g_string_append_c (gift, '\n');
  }
}

static void
append_one (GString *gift, const BankItem *item)
{
  for (guint i = 0; i < item->options->len; i++) {
    const BankOption *option = g_ptr_array_index (item->options, i);

    g_string_append_c (gift, option->is_right ? '=' : '~');
    append_text (gift, option->text);
    append_reason (gift, "#", option->reason);
    g_string_append_c (gift, '\n');
  }
}

/* Places are matched with what stands there. */
static void
append_order (GString *gift, const BankItem *item)
{
  for (guint i = 0; i < item->options->len; i++) {
    const BankOption *option = g_ptr_array_index (item->options, i);

    g_string_append_printf (gift, "=%u -> ", i + 1);
    append_text (gift, option->text);
    g_string_append_c (gift, '\n');
  }
}

static void
append_answers (GString *gift, const BankItem *item)
{
  switch (item->form) {
  case BANK_ONE:
    append_one (gift, item);
    break;
  case BANK_SEVERAL:
    append_several (gift, item);
    break;
  case BANK_NUMBER:
    g_string_append_printf (gift, "#=%u:0\n", item->number);
    break;
  case BANK_ORDER:
    append_order (gift, item);
    break;
  }
  append_reason (gift, "####", item->reason);
}

static void
append_item (GString *gift, const BankItem *item)
{
  g_string_append (gift, "::");
  append_text (gift, item->title);
  g_string_append (gift, "::[html]");
  append_stem (gift, item);
  g_string_append (gift, "{\n");
  append_answers (gift, item);
  g_string_append (gift, "}\n\n");
}

/* A slash in the name of a category is written twice. */
static void
append_category (GString *gift, const char *lesson)
{
  g_autoptr (GString) name = g_string_new (lesson);

  g_string_replace (name, "/", "//", 0);
  g_string_append_printf (gift, "$CATEGORY: Hull2VD/%s\n\n", name->str);
}

char *
question_bank_gift (QuestionBank *bank)
{
  GString *gift = g_string_new (NULL);
  const char *lesson = NULL;

  for (guint i = 0; i < bank->items->len; i++) {
    const BankItem *item = g_ptr_array_index (bank->items, i);

    if (item->form == BANK_SEVERAL && count_right (item) > MAX_RIGHT) {
      g_ptr_array_add (bank->left_out,
                       g_strdup_printf (_ ("%s: left out: Moodle has no grade "
                                           "for one of %u right answers"),
                                        item->title, count_right (item)));
      continue;
    }
    if (g_strcmp0 (lesson, item->lesson) != 0)
      append_category (gift, item->lesson);
    lesson = item->lesson;
    append_item (gift, item);
  }
  return g_string_free (gift, FALSE);
}
