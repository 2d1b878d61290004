#include "position.h"

#include "action.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

typedef struct Position {
  Place place;
  gboolean is_before;
} Position;

static gboolean
refuse (const char *text, GError **error)
{
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("“%s” is not a position; write “[before] round R PHASE” with "
                  "PHASE choose, see, horizon, cone or hand-over, or start, "
                  "simplex, complete"),
               text);
  return FALSE;
}

static gboolean
is_phase_of_round (Phase phase)
{
  return phase >= PHASE_CHOOSE && phase <= PHASE_HAND_OVER;
}

/* "round R [PHASE]" */
static gboolean
parse_round (char **words, Position *position)
{
  guint64 round;

  if (words[1] == NULL || !words_parse_number (words[1], G_MAXUINT32, &round)
      || round == 0)
    return FALSE;
  position->place.round = (guint32)round;
  position->place.phase = position->is_before ? PHASE_CHOOSE : PHASE_HAND_OVER;
  if (words[2] == NULL)
    return TRUE;
  return phase_parse (words[2], &position->place.phase)
         && is_phase_of_round (position->place.phase) && words[3] == NULL;
}

static gboolean
parse (const char *text, Position *position, GError **error)
{
  g_auto (GStrv) all = words_split (text);
  char **words = all;

  position->is_before = words[0] != NULL && g_str_equal (words[0], "before");
  words += position->is_before ? 1 : 0;
  position->place.round = 0;

  if (words[0] == NULL)
    return refuse (text, error);
  if (g_str_equal (words[0], "round"))
    return parse_round (words, position) || refuse (text, error);
  if (words[1] != NULL || !phase_parse (words[0], &position->place.phase)
      || is_phase_of_round (position->place.phase)
      || (position->is_before && position->place.phase == PHASE_START))
    return refuse (text, error);
  return TRUE;
}

gboolean
position_read (const char *text,
               Place *place,
               gboolean *is_before,
               GError **error)
{
  Position position;

  if (!parse (text, &position, error))
    return FALSE;
  *place = position.place;
  *is_before = position.is_before;
  return TRUE;
}

gboolean
position_check (const char *text, GError **error)
{
  Position position;

  return parse (text, &position, error);
}

static void
explain_missing (const Trace *trace, const char *text, GError **error)
{
  if (trace->is_flat)
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION,
                 _ ("there is no “%s”: these sites have no first simplex, so "
                    "there are no rounds"),
                 text);
  else
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_POSITION,
                 _ ("there is no “%s”: the last round is %u"), text,
                 trace->n_rounds);
}

gboolean
position_find (const Trace *trace,
               const char *text,
               guint *step,
               GError **error)
{
  Position position;

  if (!parse (text, &position, error))
    return FALSE;
  if (timeline_find (trace, position.place, position.is_before, step))
    return TRUE;
  explain_missing (trace, text, error);
  return FALSE;
}
