/* What a question can ask to be clicked. */
#ifndef QUESTION_CLICK_H
#define QUESTION_CLICK_H

#include "question.h"

G_BEGIN_DECLS

struct ClickKind {
  const char *name;   /* "visible-facets" */
  char argument;      /* 's', 'f', or 0: none */
  ObjectKind target;  /* what is clicked */
  gboolean is_any;    /* one of the answers is enough: they tie */
  Phase event;        /* of its round, whose events give it away; START:
                         the step itself is asked about */
  guint mask;         /* SceneMask bits */
  const char *item;   /* English: what one is called by its number, %u; NULL:
                         its name */
  const char *prompt; /* English; {p} current site, {f} its facet, {a}
                         argument */
  void (*collect) (const Question *question,
                   const Occasion *occasion,
                   const Frame *frame,
                   GArray *objects);
  /* Says why @object is right, or is not. */
  char *(*why) (const Question *question,
                const Occasion *occasion,
                const Frame *frame,
                Object object);
};

const ClickKind *click_kind_find (const char *name);

/* Returns: the names, ending with NULL. */
const char *const *click_kind_names (void);

G_END_DECLS

#endif
