#include "expect.h"

#include "certify.h"
#include "quantity.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

typedef enum ValueKind {
  VALUE_NUMBER,
  VALUE_PHASE, /* a name of timeline.h */
  VALUE_VALID, /* the word "valid" */
  VALUE_TEXT,  /* "contains" and the rest of the line */
} ValueKind;

/* The quantities come first, the counters of exhibits last. */
typedef enum Key {
  KEY_PHASE = N_QUANTITIES,
  KEY_DELAUNAY,
  KEY_NARRATION,
} Key;

#define N_FRAME_KEYS (KEY_NARRATION + 1)

/* Returns: the name of a key. */
static const char *
key_name (guint key)
{
  static const char *const others[]
      = { [KEY_PHASE - N_QUANTITIES] = "phase",
          [KEY_DELAUNAY - N_QUANTITIES] = "delaunay",
          [KEY_NARRATION - N_QUANTITIES] = "narration" };

  if (key >= N_FRAME_KEYS)
    return exhibit_count_names ()[key - N_FRAME_KEYS];
  return key < N_QUANTITIES ? quantity_name ((Quantity)key)
                            : others[key - N_QUANTITIES];
}

static guint
n_keys (void)
{
  return N_FRAME_KEYS + g_strv_length ((char **)exhibit_count_names ());
}

const char *const *
expect_keys (void)
{
  static const char **keys;

  if (keys == NULL) {
    keys = g_new0 (const char *, n_keys () + 1);
    for (guint i = 0; i < n_keys (); i++)
      keys[i] = key_name (i);
  }
  return keys;
}

/* An expectation in parts. The value is what follows the key; of "narration"
 * what follows "contains". */
typedef struct Expect {
  guint key; /* a Quantity or a Key */
  guint64 number;
  Phase phase;
  const char *value; /* points into the text */
} Expect;

static ValueKind
value_kind (guint key)
{
  if (key < N_QUANTITIES || key >= N_FRAME_KEYS)
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

  for (expect->key = 0; expect->key < n_keys (); expect->key++)
    if (strlen (key_name (expect->key)) == length
        && strncmp (key_name (expect->key), text, length) == 0)
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
value_rule (guint key)
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
  g_autofree char *hint = words_hint (word, expect_keys ());

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
  if (value_kind (expect->key) == VALUE_NUMBER && expect->value[0] != '\0'
      && strchr ("=<>!", expect->value[0]) != NULL) {
    g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
                 _ ("expect %s takes only a whole number: comparisons are for "
                    "the conditions of questions"),
                 key_name (expect->key));
    return FALSE;
  }
  g_set_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN,
               _ ("expect %s needs %s"), key_name (expect->key),
               value_rule (expect->key));
  return FALSE;
}

gboolean
expect_parse (const char *text, GError **error)
{
  Expect expect;

  return parse (text, &expect, error);
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
  *actual = session_narrate_in_english (session);
  return strstr (*actual, text) != NULL;
}

static gboolean
check_number (Session *session,
              const char *key,
              guint64 expected,
              char **actual)
{
  guint number;

  if (!session_count (session, key, &number)) {
    *actual = g_strdup ("no such number in what is shown");
    return FALSE;
  }
  *actual = g_strdup_printf ("%u", number);
  return number == expected;
}

gboolean
expect_check (Session *session, const char *text, char **actual)
{
  Expect expect;

  if (!parse (text, &expect, NULL))
    g_return_val_if_reached (FALSE);

  switch (value_kind (expect.key)) {
  case VALUE_NUMBER:
    return check_number (session, key_name (expect.key), expect.number, actual);
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
