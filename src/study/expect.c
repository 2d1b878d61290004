#include "expect.h"

#include "certify.h"
#include "narration.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

typedef enum ValueKind {
  VALUE_NUMBER,
  VALUE_PHASE, /* a name of timeline.h */
  VALUE_VALID, /* the word "valid" */
  VALUE_TEXT,  /* "contains" and the rest of the line */
} ValueKind;

typedef enum Key {
  KEY_SITES,
  KEY_INSERTED,
  KEY_WAITING,
  KEY_OUTSIDE_SETS,
  KEY_ROUND,
  KEY_STEP,
  KEY_FACETS,
  KEY_LOWER,
  KEY_UPPER,
  KEY_VERTICAL,
  KEY_VISIBLE,
  KEY_HORIZON,
  KEY_CONE,
  KEY_RETIRED,
  KEY_TRIANGLES,
  KEY_DELAUNAY_EDGES,
  KEY_VORONOI_VERTICES,
  KEY_VORONOI_EDGES, /* with two ends */
  KEY_RAYS,          /* with one end */
  KEY_VORONOI_LINES, /* with none */
  N_NUMBER_KEYS,
  KEY_PHASE = N_NUMBER_KEYS,
  KEY_DELAUNAY,
  KEY_NARRATION,
  N_KEYS,
} Key;

static const char *const keys[N_KEYS + 1] = {
  [KEY_SITES] = "sites",
  [KEY_INSERTED] = "inserted",
  [KEY_WAITING] = "waiting",
  [KEY_OUTSIDE_SETS] = "outside-sets",
  [KEY_ROUND] = "round",
  [KEY_STEP] = "step",
  [KEY_FACETS] = "facets",
  [KEY_LOWER] = "lower",
  [KEY_UPPER] = "upper",
  [KEY_VERTICAL] = "vertical",
  [KEY_VISIBLE] = "visible",
  [KEY_HORIZON] = "horizon",
  [KEY_CONE] = "cone",
  [KEY_RETIRED] = "retired",
  [KEY_TRIANGLES] = "triangles",
  [KEY_DELAUNAY_EDGES] = "delaunay-edges",
  [KEY_VORONOI_VERTICES] = "voronoi-vertices",
  [KEY_VORONOI_EDGES] = "voronoi-edges",
  [KEY_RAYS] = "rays",
  [KEY_VORONOI_LINES] = "voronoi-lines",
  [KEY_PHASE] = "phase",
  [KEY_DELAUNAY] = "delaunay",
  [KEY_NARRATION] = "narration",
};

const char *const *
expect_keys (void)
{
  return keys;
}

/* An expectation in parts. The value is what follows the key; of "narration"
 * what follows "contains". */
typedef struct Expect {
  Key key;
  guint64 number;
  Phase phase;
  const char *value; /* points into the text */
} Expect;

static ValueKind
value_kind (Key key)
{
  if (key < N_NUMBER_KEYS)
    return VALUE_NUMBER;
  if (key == KEY_PHASE)
    return VALUE_PHASE;
  return key == KEY_DELAUNAY ? VALUE_VALID : VALUE_TEXT;
}

/* Returns: what follows the first word of @text. */
static const char *
after_word (const char *text)
{
  text += strcspn (text, " \t");
  return text + strspn (text, " \t");
}

static gboolean
parse_key (const char *text, Expect *expect)
{
  const gsize length = strcspn (text, " \t");

  for (expect->key = 0; expect->key < N_KEYS; expect->key++)
    if (strlen (keys[expect->key]) == length
        && strncmp (keys[expect->key], text, length) == 0)
      return TRUE;
  return FALSE;
}

static gboolean
parse_value (Expect *expect)
{
  switch (value_kind (expect->key)) {
  case VALUE_NUMBER:
    return words_parse_number (expect->value, G_MAXUINT32, &expect->number);
  case VALUE_PHASE:
    return phase_parse (expect->value, &expect->phase);
  case VALUE_VALID:
    return g_str_equal (expect->value, "valid");
  case VALUE_TEXT:
    if (strcspn (expect->value, " \t") != strlen ("contains")
        || !g_str_has_prefix (expect->value, "contains"))
      return FALSE;
    expect->value = after_word (expect->value);
    return expect->value[0] != '\0';
  }
  return FALSE;
}

static const char *
value_rule (Key key)
{
  switch (value_kind (key)) {
  case VALUE_NUMBER:
    return _ ("a whole number");
  case VALUE_PHASE:
    return _ ("a phase: start, simplex, choose, see, horizon, cone, "
              "hand-over or complete");
  case VALUE_VALID:
    return _ ("the word valid");
  case VALUE_TEXT:
    return _ ("contains TEXT");
  }
  return "";
}

static gboolean
refuse_key (const char *text, GError **error)
{
  g_autofree char *word = g_strndup (text, strcspn (text, " \t"));
  g_autofree char *hint = words_hint (word, keys);

  if (word[0] == '\0')
    g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
                 _ ("expect needs a key and a value: expect KEY VALUE"));
  else
    g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
                 _ ("nothing called “%s” can be expected%s"), word, hint);
  return FALSE;
}

static gboolean
parse (const char *text, Expect *expect, GError **error)
{
  if (!parse_key (text, expect))
    return refuse_key (text, error);
  expect->value = after_word (text);
  if (parse_value (expect))
    return TRUE;
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
               _ ("expect %s needs %s"), keys[expect->key],
               value_rule (expect->key));
  return FALSE;
}

gboolean
expect_parse (const char *text, GError **error)
{
  Expect expect;

  return parse (text, &expect, error);
}

/* Sites on a line have a diagram of lines alone. */
static guint
count_lines (const Frame *frame)
{
  return frame->delaunay.dimension == 1 ? frame->counts.voronoi_edges : 0;
}

static guint
actual_number (Session *session, Key key)
{
  const Frame *frame = session_get_frame (session);
  const FrameCounts *counts = &frame->counts;
  const guint numbers[N_NUMBER_KEYS] = {
    [KEY_SITES] = session_get_set (session)->n_sites,
    [KEY_INSERTED] = counts->n_inserted,
    [KEY_WAITING] = counts->waiting,
    [KEY_OUTSIDE_SETS] = counts->outside_sets,
    [KEY_ROUND] = session_get_place (session).round,
    [KEY_STEP] = session_get_step (session),
    [KEY_FACETS] = counts->facets,
    [KEY_LOWER] = counts->lower,
    [KEY_UPPER] = counts->upper,
    [KEY_VERTICAL] = counts->vertical,
    [KEY_VISIBLE] = counts->visible,
    [KEY_HORIZON] = counts->horizon,
    [KEY_CONE] = counts->cone,
    [KEY_RETIRED] = counts->retired,
    [KEY_TRIANGLES] = counts->triangles,
    [KEY_DELAUNAY_EDGES] = counts->delaunay_edges,
    [KEY_VORONOI_VERTICES] = counts->voronoi_vertices,
    [KEY_VORONOI_EDGES]
    = counts->voronoi_edges - counts->rays - count_lines (frame),
    [KEY_RAYS] = counts->rays,
    [KEY_VORONOI_LINES] = count_lines (frame),
  };

  return numbers[key];
}

static gboolean
check_valid (Session *session, char **actual)
{
  char why[CERTIFY_ROOM];
  const gboolean holds = certify_frame (session_get_frame (session), why);

  *actual = g_strdup (holds ? "valid" : why);
  return holds;
}

/* The sentence in English, whatever the language of the interface. */
static gboolean
check_narration (Session *session, const char *text, char **actual)
{
  char sentence[NARRATION_ROOM];

  narration_write (session_get_trace (session), session_get_step (session),
                   NULL, sentence);
  *actual = g_strdup (sentence);
  return strstr (sentence, text) != NULL;
}

gboolean
expect_check (Session *session, const char *text, char **actual)
{
  Expect expect;

  if (!parse (text, &expect, NULL))
    g_return_val_if_reached (FALSE);

  switch (value_kind (expect.key)) {
  case VALUE_NUMBER:
    *actual = g_strdup_printf ("%u", actual_number (session, expect.key));
    return actual_number (session, expect.key) == expect.number;
  case VALUE_PHASE:
    *actual = g_strdup (phase_name (session_get_place (session).phase));
    return session_get_place (session).phase == expect.phase;
  case VALUE_VALID:
    return check_valid (session, actual);
  case VALUE_TEXT:
    return check_narration (session, expect.value, actual);
  }
  return FALSE;
}
