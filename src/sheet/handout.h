/* Handouts: a lesson on paper, as PDF.
 *
 * Without options one page: the idea, pictures, terms and facts, questions in
 * short, sources. With options any of these parts, in this order:
 *
 *   stops   every stop with its pictures, text, line of the code and sentence
 *   steps   four panels for each insertion
 *   key     the questions with their answers and why they are right
 *
 * Everything comes from the session that plays the lesson; the same lesson
 * gives the same bytes.
 */
#ifndef HANDOUT_H
#define HANDOUT_H

#include "appearance.h"
#include "pdf.h"
#include "session.h"

#include <stdio.h>

G_BEGIN_DECLS

typedef struct HandoutOptions {
  const Paper *paper;
  Appearance appearance; /* of the pictures */
  gboolean has_stops;
  gboolean has_steps;
  gboolean has_key;
  gboolean has_notes;  /* of stops: the lecturer's notes, and a timetable */
  gboolean has_blanks; /* of stops: questions are open, with room to answer, and
                          nothing that the engine shows answers them */
} HandoutOptions;

/* One page on A4, in the theme for print. */
void handout_options_init (HandoutOptions *options);

/* Writes the handout of the session's lesson; it must have one. Plays it, so
 * the session stands anywhere afterwards.
 *
 * Returns: FALSE with @error set when writing failed. */
gboolean handout_write (Session *session,
                        const HandoutOptions *options,
                        FILE *file,
                        GError **error);

G_END_DECLS

#endif
