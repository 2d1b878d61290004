/* Whether two sessions show the same, told from what a person can see. */
#ifndef SAME_SESSION_H
#define SAME_SESSION_H

#include "session.h"

/* Sites, view, time and sentence, look, selection, cameras, staging, theme.
 * The selection of @a is made anew. */
void assert_same_session (Session *a, Session *b);

/* Within what a hundredth of a degree is in a picture. */
void assert_same_camera (const Camera *a, const Camera *b);

#endif
