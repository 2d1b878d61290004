/* Question banks: the questions of lessons as a test on paper or a learning
 * platform can ask them, without pictures. What is right is computed as it is
 * in the window; what the pictures would show is said in words.
 *
 *   QuestionBank *bank = question_bank_new ();
 *
 *   question_bank_add (bank, lesson);
 *   text = question_bank_gift (bank);
 */
#ifndef QUESTION_BANK_H
#define QUESTION_BANK_H

#include "lesson.h"

G_BEGIN_DECLS

typedef enum BankForm {
  BANK_ONE,     /* choose one; each of those that are right is enough */
  BANK_SEVERAL, /* choose all that are right */
  BANK_NUMBER,  /* a whole number */
  BANK_ORDER,   /* put the options in order; only one order is right */
} BankForm;

typedef struct BankOption {
  char *text;
  gboolean is_right;
  char *reason; /* why it is right, or is not; or NULL */
} BankOption;

typedef struct BankItem {
  char *name;       /* unique, an XML name: "lesson1-stop3-1" */
  char *lesson;     /* its title */
  char *title;      /* of the stop */
  guint line;       /* of the question, in the lesson's file */
  char *prompt;     /* CommonMark */
  GPtrArray *given; /* of char *: what the pictures show, in words */
  BankForm form;
  GPtrArray *options; /* of BankOption; of BANK_ORDER in the right order */
  guint number;       /* of BANK_NUMBER */
  char *reason;       /* why that is right, on the whole; or NULL */
} BankItem;

typedef struct QuestionBank {
  GPtrArray *items;    /* of BankItem */
  GPtrArray *left_out; /* of char *: "FILE:LINE: left out: reason" */
  guint n_lessons;
} QuestionBank;

/* More than this are not read on paper. */
#define BANK_MAX_OPTIONS 30
#define BANK_MAX_SITES 40

QuestionBank *question_bank_new (void);
void question_bank_free (QuestionBank *bank);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QuestionBank, question_bank_free)

/* Adds the questions of a lesson; one that needs the pictures is left out,
 * and its line says why. */
void question_bank_add (QuestionBank *bank, const Lesson *lesson);

/* Lines that say what the pictures show where @question is asked: the sites,
 * which of them are on the hull, which one comes next, the corners of the
 * facets that the question names.
 *
 * Returns: (transfer full) (element-type utf8) */
GPtrArray *question_given (const Question *question, const Occasion *occasion);

/* Returns: (transfer full): an object by the sites that make it: "f3 (s0 s1
 *          s4, lower)", "s0–s4"; its facing is not told when that is asked. */
char *question_object_text (const Question *question,
                            const Frame *frame,
                            Object object);

/* Returns: (transfer full): the bank as Moodle reads it. What its grades
 *          cannot say is left out, with a line in left_out.
 * Source:  docs.moodle.org/en/GIFT_format. */
char *question_bank_gift (QuestionBank *bank);

/* A file of a package. */
typedef struct BankFile {
  char *name, *text;
} BankFile;

/* Returns: (transfer full) (element-type BankFile): the files of a QTI 2.1
 *          content package: its manifest, a test with a section for each
 *          lesson, and its items.
 * Source:  IMS Question and Test Interoperability 2.1, 2012. */
GPtrArray *question_bank_qti (const QuestionBank *bank);

G_END_DECLS

#endif
