#include "narration-template.h"
#include "rounding.h"

/* The marker of strings to translate; the caller does it. */
#define N_(text) text

static const char *
step_template (const RoundedHull *hull, const RoundedStep *step)
{
  switch (step->kind) {
  case ROUNDED_TRIANGLE:
    return N_ ("Demonstration of rounding: the first triangle, by signs in "
               "plain doubles.");
  case ROUNDED_INSIDE:
    if (rounded_hull_has_lost (hull, step->site))
      return N_ ("{p} seems to see no edge and is dropped, though it lies "
                 "outside: at {a} {b} the rounded sign is wrong.");
    return N_ ("{p} sees no edge: it lies inside and is dropped.");
  case ROUNDED_STUCK:
    return N_ (
        "{p} seems to see every edge: the walk round the hull never ends, and "
        "the program hangs. At {a} {b} the rounded sign is wrong.");
  case ROUNDED_INSERT:
    if (step->n_wrong > 0 && step->n_seen == 1)
      return N_ ("{p} takes the place of the one edge that it seems to see; "
                 "at {a} {b} the rounded sign is wrong.");
    if (step->n_wrong > 0)
      return N_ ("{p} takes the place of {n} edges that it seems to see; at "
                 "{a} {b} the rounded sign is wrong.");
    return step->n_seen == 1 ? N_ ("{p} sees one edge and takes its place.")
                             : N_ ("{p} sees {n} edges and takes their place.");
  }
  return "";
}

void
rounded_narration_write (const RoundedHull *hull,
                         NarrationTranslate translate,
                         char text[NARRATION_ROOM])
{
  const char *template
      = N_ ("Demonstration of rounding: the hull by insertion, each decision "
            "a sign in plain doubles.");
  NarrationParts parts = { .number = 0 };

  if (hull->n_steps > 0) {
    const RoundedStep *step = &hull->steps[hull->n_steps - 1];

    template = step_template (hull, step);
    parts = (NarrationParts){ .site = step->site,
                              .ridge = { step->wrong[0], step->wrong[1] },
                              .number = step->n_seen };
  }
  narration_fill (translate != NULL ? translate (template) : template, &parts,
                  text);
}

typedef enum Line {
  LINE_TRIANGLE,
  LINE_FOR,
  LINE_FIND,
  LINE_INSIDE,
  LINE_CHAIN,
  LINE_REPLACE,
} Line;

#define N_LINES (LINE_REPLACE + 1)

static const PseudocodeLine lines[N_LINES] = {
  [LINE_TRIANGLE] = { N_ ("start with a first triangle"), 0 },
  [LINE_FOR] = { N_ ("for each other site p"), 0 },
  [LINE_FIND] = { N_ ("find an edge e that p sees"), 1 },
  [LINE_INSIDE] = { N_ ("if there is none, drop p"), 1 },
  [LINE_CHAIN] = { N_ ("go on from e while edges are seen"), 1 },
  [LINE_REPLACE] = { N_ ("put p in their place"), 1 },
};

const PseudocodeLine *
rounded_pseudocode_lines (uint32_t *n_lines)
{
  *n_lines = N_LINES;
  return lines;
}

uint32_t
rounded_pseudocode_line (const RoundedHull *hull)
{
  if (hull->n_steps == 0)
    return INDEX_NONE;
  switch (hull->steps[hull->n_steps - 1].kind) {
  case ROUNDED_TRIANGLE:
    return LINE_TRIANGLE;
  case ROUNDED_INSIDE:
    return LINE_INSIDE;
  case ROUNDED_INSERT:
    return LINE_REPLACE;
  case ROUNDED_STUCK:
    return LINE_CHAIN;
  }
  return INDEX_NONE;
}
