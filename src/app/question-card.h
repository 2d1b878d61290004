/* The question of the stop as a card: what is asked, how to answer it, what
 * has been answered, and how right it was. The pictures are answered in
 * themselves. */
#ifndef QUESTION_CARD_H
#define QUESTION_CARD_H

#include "session.h"

#include <gtk/gtk.h>

G_BEGIN_DECLS

#define QUESTION_CARD_TYPE (question_card_get_type ())
G_DECLARE_FINAL_TYPE (
    QuestionCard, question_card, HULL2VD, QUESTION_CARD, GtkBox)

/* It is shown while the stop has a question. */
void question_card_set_session (QuestionCard *card, Session *session);

G_END_DECLS

#endif
