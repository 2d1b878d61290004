/* Handouts: a lesson on paper.
 *
 *   Handout *handout = handout_new (session, &options);
 *
 *   handout_write (handout, file, NULL, &error);
 *   handout_free (handout);
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

typedef struct Handout Handout;

/* Sets the pages of the session's lesson; it must have one. The session is
 * played, now and while pages are painted, so it should be one of its own. */
Handout *handout_new (Session *session, const HandoutOptions *options);
void handout_free (Handout *handout);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (Handout, handout_free)

guint handout_count_pages (const Handout *handout);

/* Paints a page, from 0, on white. Units: pt. */
void handout_paint (const Handout *handout, guint page, cairo_t *cr);

/* Writes it as PDF, page by page while @cancellable, unless NULL, wants it.
 *
 * Returns: FALSE with @error set when writing failed, or nobody wants it. */
gboolean handout_write (const Handout *handout,
                        FILE *file,
                        GCancellable *cancellable,
                        GError **error);

G_END_DECLS

#endif
