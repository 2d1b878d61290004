/* What names keep off, by place: lines, marks, and names that have their
 * place already.
 *
 *   LabelField *field = label_field_new (&frame);
 *   LabelNear near;
 *
 *   label_field_add_line (field, &line);
 *   label_near_init (&near);
 *   label_field_find (field, &box, &near);
 *   … near.lines->len lines may meet the box …
 */
#ifndef LABEL_FIELD_H
#define LABEL_FIELD_H

#include "box-index.h"
#include "clip.h"

#include <glib.h>

typedef struct FieldLine {
  Pixel ends[2];
  double reach; /* half of its width, px */
  double ink;   /* how bad it is to cover a px of it */
  bool is_heavy;
  bool is_leader; /* of a name that has its place */
} FieldLine;

typedef struct FieldMark {
  Pixel at;
  double radius, reach; /* of its ink; and of the ring round it */
  bool is_named;        /* a name beside it would seem to be its own */
} FieldMark;

typedef struct FieldName {
  PixelBox box;
  bool is_fixed;   /* must not be covered; else it is a pity */
  bool is_centred; /* of no mark */
} FieldName;

/* What has been found near a box. */
typedef struct LabelNear {
  GArray *lines; /* FieldLine */
  GArray *marks; /* FieldMark */
  GArray *names; /* FieldName */
} LabelNear;

typedef struct LabelField LabelField;

/* Nothing outside @frame is ever found but marks, which stay where they
 * are. */
LabelField *label_field_new (const PixelBox *frame);
void label_field_free (LabelField *field);

void label_field_add_line (LabelField *field, const FieldLine *line);
void label_field_add_mark (LabelField *field, const FieldMark *mark);
void label_field_add_name (LabelField *field, const FieldName *name);

void label_near_init (LabelNear *near);
void label_near_clear (LabelNear *near);

/* Finds all that meets @box, and some others, each once. */
void label_field_find (LabelField *field, const PixelBox *box, LabelNear *near);

#endif
