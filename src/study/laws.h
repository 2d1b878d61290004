/* The counters of a frame as laws: not "10 facets" but "10 = 2·7 − 4". */
#ifndef LAWS_H
#define LAWS_H

#include "frame.h"

#include <glib.h>

G_BEGIN_DECLS

typedef struct Law {
  char *key;   /* "facets": also the name that expect uses */
  char *name;  /* translated: "facets" */
  char *value; /* "10 = 2·7 − 4" */
} Law;

/* Returns: (transfer full) (element-type Law): the laws to show, in order;
 *          those of a round only while there is a current one. */
GPtrArray *laws_of (const Frame *frame);

/* Puts a question mark in place of what would answer a question: all numbers
 * but that of the sites. */
void laws_hide (GPtrArray *laws);

/* For laws of other things than frames: an empty array, and a row more. */
GPtrArray *laws_new (void);
void laws_add (GPtrArray *laws,
               const char *key,
               const char *name,
               const char *format,
               ...) G_GNUC_PRINTF (4, 5);

G_END_DECLS

#endif
