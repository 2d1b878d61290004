/* A person at a lesson, whose progress is kept in a folder from one start of
 * the program to the next. */
#ifndef LEARNER_H
#define LEARNER_H

#include "lesson-text.h"
#include "session.h"

/* Stops with a question each. */
#define LEARNER_WHICH                                                          \
  "## Which?\n\n```ask\nbefore round 1 see\nclick visible-facets\n"            \
  "hint one\nretry 1\n```\n\n"
#define LEARNER_NUMBERS                                                        \
  "## Numbers, \"and\" more\n\n```ask\nbefore round 2 see\n"                   \
  "number visible cone\n```\n\n"
#define LEARNER_DRAG                                                           \
  "## Drag\n\n```ask\ncomplete\ndrag s7 until unbounded s7\n```\n\n"

#define LEARNER_LESSON                                                         \
  LECTURE "## Start\n\n```steps\ngoto start\n```\n\n" LEARNER_WHICH            \
      LEARNER_NUMBERS LEARNER_DRAG

/* Starts the program with what is in the file, and opens a lesson. */
Session *learner_start (const char *text);

/* The same with a progress that is given; NULL: none is kept. */
Session *learner_open (const char *text, Progress *progress);

/* Ends it: the file is written. */
void learner_end (Session *session);

void learner_act (Session *session, const char *name, GVariant *parameter);

/* Chooses objects, "f0 f1", and checks. */
void learner_answer (Session *session, const char *objects);

/* Answers the questions of LEARNER_LESSON: at once, shown, shown. */
void learner_answer_all (Session *session);

/* What is known of the question of a stop; it must be known. */
const QuestionRecord *learner_record (Session *session, guint stop);

/* Files of the folder, whose name "progress.json" is the progress. */
char *learner_file (const char *name); /* its path */
char *learner_read (const char *name); /* NULL: there is none */

void learner_clear_folder (void);

typedef struct LearnerTest {
  const char *name;
  void (*run) (void);
} LearnerTest;

/* Adds tests, each of which finds the folder empty. */
void learner_add_tests (const LearnerTest *tests, guint n_tests);

/* g_test_run() while there is such a folder. */
int learner_test_run (void);

#endif
