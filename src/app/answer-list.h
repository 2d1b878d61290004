/* What is answered beside the pictures: options, numbers, things in order;
 * and what has been chosen in the pictures, by name. */
#ifndef ANSWER_LIST_H
#define ANSWER_LIST_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define ANSWER_LIST_TYPE (answer_list_get_type ())
G_DECLARE_FINAL_TYPE (AnswerList, answer_list, HULL2VD, ANSWER_LIST, GtkBox)

void answer_list_set_session (AnswerList *list, Session *session);

/* Shows the attempt of @exercise as it is now; NULL: nothing. */
void answer_list_show (AnswerList *list, const Exercise *exercise);

G_END_DECLS

#endif
