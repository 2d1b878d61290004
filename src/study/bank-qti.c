/* Question banks as QTI 2.1 content packages. */
#include "prose.h"
#include "question-bank.h"

#include <stdarg.h>

#define QTI "http://www.imsglobal.org/xsd/imsqti_v2p1"
#define XSI "http://www.w3.org/2001/XMLSchema-instance"
#define CP "http://www.imsglobal.org/xsd/imscp_v1p1"
#define HEAD "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"

/* Names of things and files inside a package. */
#define TEST_FILE "assessment.xml"

static void put (GString *xml, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* Appends markup with its arguments escaped. */
static void
put (GString *xml, const char *format, ...)
{
  g_autofree char *text = NULL;
  va_list arguments;

  va_start (arguments, format);
  text = g_markup_vprintf_escaped (format, arguments);
  va_end (arguments);
  g_string_append (xml, text);
}

/* What is right */

static const char *
cardinality_of (const BankItem *item)
{
  switch (item->form) {
  case BANK_ONE:
  case BANK_NUMBER:
    break;
  case BANK_SEVERAL:
    return "multiple";
  case BANK_ORDER:
    return "ordered";
  }
  return "single";
}

/* One right answer is the correct one; what else is as right is mapped. */
static void
put_correct (GString *xml, const BankItem *item)
{
  guint n = 0;

  put (xml, "    <correctResponse>\n");
  if (item->form == BANK_NUMBER)
    put (xml, "      <value>%u</value>\n", item->number);
  for (guint i = 0; i < item->options->len; i++) {
    const BankOption *option = g_ptr_array_index (item->options, i);

    if (!option->is_right || (item->form == BANK_ONE && n > 0))
      continue;
    put (xml, "      <value>A%u</value>\n", i);
    n += 1;
  }
  put (xml, "    </correctResponse>\n");
}

static void
put_mapping (GString *xml, const BankItem *item)
{
  if (item->form != BANK_ONE)
    return;
  put (xml, "    <mapping defaultValue=\"0\">\n");
  for (guint i = 0; i < item->options->len; i++)
    if (((BankOption *)g_ptr_array_index (item->options, i))->is_right)
      put (xml, "      <mapEntry mapKey=\"A%u\" mappedValue=\"1\"/>\n", i);
  put (xml, "    </mapping>\n");
}

static void
put_declarations (GString *xml, const BankItem *item)
{
  put (xml,
       "  <responseDeclaration identifier=\"RESPONSE\" cardinality=\"%s\" "
       "baseType=\"%s\">\n",
       cardinality_of (item),
       item->form == BANK_NUMBER ? "integer" : "identifier");
  put_correct (xml, item);
  put_mapping (xml, item);
  put (xml,
       "  </responseDeclaration>\n"
       "  <outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" "
       "baseType=\"float\">\n"
       "    <defaultValue>\n      <value>0</value>\n    </defaultValue>\n"
       "  </outcomeDeclaration>\n"
       "  <outcomeDeclaration identifier=\"FEEDBACK\" cardinality=\"%s\" "
       "baseType=\"identifier\"/>\n",
       item->form == BANK_SEVERAL ? "multiple" : "single");
}

/* What is asked */

static void
put_choice (GString *xml, const BankItem *item)
{
  put (xml,
       "    <choiceInteraction responseIdentifier=\"RESPONSE\" "
       "shuffle=\"false\" maxChoices=\"%u\">\n",
       item->form == BANK_ONE ? 1 : 0);
  for (guint i = 0; i < item->options->len; i++) {
    const BankOption *option = g_ptr_array_index (item->options, i);

    put (xml, "      <simpleChoice identifier=\"A%u\">%s", i, option->text);
    if (option->reason != NULL)
      put (xml,
           " <feedbackInline outcomeIdentifier=\"FEEDBACK\" "
           "identifier=\"A%u\" showHide=\"show\">%s</feedbackInline>",
           i, option->reason);
    put (xml, "</simpleChoice>\n");
  }
  put (xml, "    </choiceInteraction>\n");
}

static void
put_order (GString *xml, const BankItem *item)
{
  put (xml, "    <orderInteraction responseIdentifier=\"RESPONSE\" "
            "shuffle=\"true\">\n");
  for (guint i = 0; i < item->options->len; i++)
    put (xml, "      <simpleChoice identifier=\"A%u\">%s</simpleChoice>\n", i,
         ((BankOption *)g_ptr_array_index (item->options, i))->text);
  put (xml, "    </orderInteraction>\n");
}

static void
put_body (GString *xml, const BankItem *item)
{
  g_autofree char *prompt = prose_to_html (item->prompt);

  put (xml, "  <itemBody>\n");
  g_string_append (xml, prompt);
  for (guint i = 0; i < item->given->len; i++)
    put (xml, "    <p>%s</p>\n",
         (const char *)g_ptr_array_index (item->given, i));
  switch (item->form) {
  case BANK_ONE:
  case BANK_SEVERAL:
    put_choice (xml, item);
    break;
  case BANK_NUMBER:
    put (xml, "    <p><textEntryInteraction responseIdentifier=\"RESPONSE\" "
              "expectedLength=\"5\"/></p>\n");
    break;
  case BANK_ORDER:
    put_order (xml, item);
    break;
  }
  put (xml, "  </itemBody>\n");
}

/* How it is graded: all or nothing, as in the window */

static void
put_processing (GString *xml, const BankItem *item)
{
  const gboolean tells_each
      = item->form == BANK_ONE || item->form == BANK_SEVERAL;

  put (xml, "  <responseProcessing>\n");
  if (item->form == BANK_ONE)
    put (xml, "    <responseCondition><responseIf>\n"
              "      <not><isNull><variable identifier=\"RESPONSE\"/></isNull>"
              "</not>\n"
              "      <setOutcomeValue identifier=\"SCORE\"><mapResponse "
              "identifier=\"RESPONSE\"/></setOutcomeValue>\n"
              "    </responseIf></responseCondition>\n");
  else
    put (xml, "    <responseCondition><responseIf>\n"
              "      <match><variable identifier=\"RESPONSE\"/><correct "
              "identifier=\"RESPONSE\"/></match>\n"
              "      <setOutcomeValue identifier=\"SCORE\"><baseValue "
              "baseType=\"float\">1</baseValue></setOutcomeValue>\n"
              "    </responseIf></responseCondition>\n");
  put (xml, "    <setOutcomeValue identifier=\"FEEDBACK\">");
  if (tells_each)
    put (xml, "<variable identifier=\"RESPONSE\"/>");
  else
    put (xml, "<baseValue baseType=\"identifier\">WHY</baseValue>");
  put (xml, "</setOutcomeValue>\n  </responseProcessing>\n");
  if (item->reason != NULL)
    put (xml,
         "  <modalFeedback outcomeIdentifier=\"FEEDBACK\" identifier=\"WHY\" "
         "showHide=\"show\">%s</modalFeedback>\n",
         item->reason);
}

static char *
write_item (const BankItem *item)
{
  GString *xml = g_string_new (HEAD);

  put (xml,
       "<assessmentItem xmlns=\"" QTI "\" xmlns:xsi=\"" XSI "\"\n"
       "  xsi:schemaLocation=\"" QTI " "
       "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd\"\n"
       "  identifier=\"%s\" title=\"%s: %s\" adaptive=\"false\" "
       "timeDependent=\"false\">\n",
       item->name, item->lesson, item->title);
  put_declarations (xml, item);
  put_body (xml, item);
  put_processing (xml, item);
  put (xml, "</assessmentItem>\n");
  return g_string_free (xml, FALSE);
}

/* The package */

static void
put_section (GString *xml, const QuestionBank *bank, guint first)
{
  const BankItem *head = g_ptr_array_index (bank->items, first);

  put (xml,
       "    <assessmentSection identifier=\"section-%s\" title=\"%s\" "
       "visible=\"true\">\n",
       head->name, head->lesson);
  for (guint i = first; i < bank->items->len; i++) {
    const BankItem *item = g_ptr_array_index (bank->items, i);

    if (!g_str_equal (item->lesson, head->lesson))
      break;
    put (xml,
         "      <assessmentItemRef identifier=\"%s\" "
         "href=\"items/%s.xml\"/>\n",
         item->name, item->name);
  }
  put (xml, "    </assessmentSection>\n");
}

static char *
write_test (const QuestionBank *bank)
{
  GString *xml = g_string_new (HEAD);
  const char *lesson = NULL;

  put (xml, "<assessmentTest xmlns=\"" QTI "\" identifier=\"hull2vd\" "
            "title=\"Hull2VD\">\n"
            "  <testPart identifier=\"part\" navigationMode=\"nonlinear\" "
            "submissionMode=\"individual\">\n");
  for (guint i = 0; i < bank->items->len; i++) {
    const BankItem *item = g_ptr_array_index (bank->items, i);

    if (g_strcmp0 (lesson, item->lesson) != 0)
      put_section (xml, bank, i);
    lesson = item->lesson;
  }
  put (xml, "  </testPart>\n</assessmentTest>\n");
  return g_string_free (xml, FALSE);
}

static char *
write_manifest (const QuestionBank *bank)
{
  GString *xml = g_string_new (HEAD);

  put (xml, "<manifest xmlns=\"" CP "\" identifier=\"hull2vd-questions\">\n"
            "  <metadata>\n    <schema>QTIv2.1 Package</schema>\n"
            "    <schemaversion>1.0.0</schemaversion>\n  </metadata>\n"
            "  <organizations/>\n  <resources>\n"
            "    <resource identifier=\"test\" type=\"imsqti_test_xmlv2p1\" "
            "href=\"" TEST_FILE "\">\n"
            "      <file href=\"" TEST_FILE "\"/>\n");
  for (guint i = 0; i < bank->items->len; i++)
    put (xml, "      <dependency identifierref=\"%s\"/>\n",
         ((BankItem *)g_ptr_array_index (bank->items, i))->name);
  put (xml, "    </resource>\n");
  for (guint i = 0; i < bank->items->len; i++) {
    const BankItem *item = g_ptr_array_index (bank->items, i);

    put (xml,
         "    <resource identifier=\"%s\" type=\"imsqti_item_xmlv2p1\" "
         "href=\"items/%s.xml\">\n"
         "      <file href=\"items/%s.xml\"/>\n    </resource>\n",
         item->name, item->name, item->name);
  }
  put (xml, "  </resources>\n</manifest>\n");
  return g_string_free (xml, FALSE);
}

static void
free_file (gpointer data)
{
  BankFile *file = data;

  g_free (file->name);
  g_free (file->text);
  g_free (file);
}

/* Takes both. */
static void
add_file (GPtrArray *files, char *name, char *text)
{
  BankFile *file = g_new0 (BankFile, 1);

  file->name = name;
  file->text = text;
  g_ptr_array_add (files, file);
}

GPtrArray *
question_bank_qti (const QuestionBank *bank)
{
  GPtrArray *files = g_ptr_array_new_with_free_func (free_file);

  add_file (files, g_strdup ("imsmanifest.xml"), write_manifest (bank));
  add_file (files, g_strdup (TEST_FILE), write_test (bank));
  for (guint i = 0; i < bank->items->len; i++) {
    const BankItem *item = g_ptr_array_index (bank->items, i);

    add_file (files, g_strdup_printf ("items/%s.xml", item->name),
              write_item (item));
  }
  return files;
}
