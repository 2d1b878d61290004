/* Anything that a person might do in the window, at random. */
#ifndef ANYTHING_H
#define ANYTHING_H

#include "session.h"

/* Steps, edits sites, changes what is shown and how, undoes. */
void do_anything (Session *session, GRand *random);

/* Changes layers, focus, selection or a slider. */
void look_anyhow (Session *session, GRand *random);

#endif
