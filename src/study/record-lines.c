#include "record-lines.h"

#include "action.h"
#include "camera-text.h"
#include "command.h"
#include "lesson.h"
#include "number.h"
#include "object-name.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#define MOST_EDITS 3 /* that are told one by one */
#define NEAR 1e-9    /* numbers that no slider tells apart */

typedef struct Telling {
  Session *shadow;
  const StopState *to;
  GPtrArray *lines;
} Telling;

static gboolean tell (Telling *telling, const char *format, ...)
    G_GNUC_PRINTF (2, 3);

/* Adds a command that can be carried out. */
static gboolean
tell (Telling *telling, const char *format, ...)
{
  g_autofree char *line = NULL;
  g_autofree char *verb = NULL;
  g_autoptr (GVariant) parameter = NULL;
  va_list arguments;

  va_start (arguments, format);
  line = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  if (strlen (line) >= LESSON_MAX_LINE
      || !command_parse (line, &verb, &parameter, NULL)
      || !action_run (telling->shadow, verb, parameter, NULL))
    return FALSE;
  g_ptr_array_add (telling->lines, g_steal_pointer (&line));
  return TRUE;
}

/* Sites */

char *
record_sites_text (const Site *sites, guint n_sites)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < n_sites; i++) {
    char x[NUMBER_ROOM], y[NUMBER_ROOM];

    number_write (sites[i].x, x);
    number_write (sites[i].y, y);
    g_string_append_printf (text, "%s%s %s", i == 0 ? "" : "; ", x, y);
  }
  return g_string_free (text, FALSE);
}

static gboolean
is_same_site (Site a, Site b)
{
  return a.x == b.x && a.y == b.y;
}

static void
tell_site (Telling *telling, const char *what, Site site)
{
  char x[NUMBER_ROOM], y[NUMBER_ROOM];

  number_write (site.x, x);
  number_write (site.y, y);
  tell (telling, "%s %s %s", what, x, y);
}

/* One site less, all others as they were.
 *
 * Returns: FALSE: it is another change. */
static gboolean
tell_removal (Telling *telling, const Site *from, const Site *to, guint n_to)
{
  guint gone = 0;

  while (gone < n_to && is_same_site (from[gone], to[gone]))
    gone += 1;
  for (guint i = gone; i < n_to; i++)
    if (!is_same_site (from[i + 1], to[i]))
      return FALSE;
  return tell (telling, "remove site s%u", gone);
}

/* Some sites moved, some more at the end. */
static gboolean
tell_moves (Telling *telling,
            const Site *from,
            guint n_from,
            const Site *to,
            guint n_to)
{
  guint n = n_to - n_from;

  for (guint i = 0; i < n_from; i++)
    n += !is_same_site (from[i], to[i]);
  if (n > MOST_EDITS)
    return FALSE;
  for (guint i = 0; i < n_to; i++) {
    g_autofree char *move = g_strdup_printf ("move site s%u", i);

    if (i >= n_from)
      tell_site (telling, "add site", to[i]);
    else if (!is_same_site (from[i], to[i]))
      tell_site (telling, move, to[i]);
  }
  return TRUE;
}

static void
tell_all_sites (Telling *telling, const Site *sites, guint n_sites)
{
  g_autofree char *text = record_sites_text (sites, n_sites);

  /* No sites at all: the line cannot say so. */
  if (n_sites == 0)
    while (session_get_set (telling->shadow)->n_sites > 0)
      tell (telling, "remove site s0");
  else if (!tell (telling, "sites %s", text))
    g_ptr_array_add (
        telling->lines,
        g_strdup_printf ("# %u sites are too many for a line", n_sites));
}

static void
tell_sites (Telling *telling)
{
  g_autofree Site *to = run_given (telling->to->run);
  const guint n_to = telling->to->run->set->n_sites;
  const SiteSet *set = session_get_set (telling->shadow);
  const guint n_from = set->n_sites;
  g_autofree Site *from = g_new (Site, n_from + 1);

  for (guint i = 0; i < n_from; i++)
    from[i] = site_set_given (set, i);
  if (n_from == n_to
      && (n_to == 0 || memcmp (from, to, n_to * sizeof *to) == 0))
    return;
  if (n_from == n_to + 1 && n_to > 0 && tell_removal (telling, from, to, n_to))
    return;
  if (n_from <= n_to && n_from > 0
      && tell_moves (telling, from, n_from, to, n_to))
    return;
  tell_all_sites (telling, to, n_to);
}

/* What is shown of them */

static gboolean
is_same_order (Order a, Order b)
{
  return a.kind == b.kind && a.seed == b.seed;
}

static void
tell_order (Telling *telling)
{
  const Order order = telling->to->run->trace->order;
  g_autofree char *name = session_order_name (&order);

  if (!is_same_order (order, session_get_order (telling->shadow)))
    tell (telling, "order %s", name);
}

static void
tell_compare (Telling *telling)
{
  const StopState *to = telling->to;
  const Order orders[2] = { to->run->trace->order, to->other_order };
  g_autofree char *left = session_order_name (&orders[0]);
  g_autofree char *right = session_order_name (&orders[1]);

  if (session_get_exhibit_kind (telling->shadow) != EXHIBIT_COMPARE
      || !is_same_order (session_get_order (telling->shadow), orders[0])
      || !is_same_order (session_get_other_order (telling->shadow), orders[1]))
    tell (telling, "compare %s %s", left, right);
  if (session_get_compares_space (telling->shadow) != to->compares_space)
    tell (telling, "compare view %s", to->compares_space ? "space" : "plane");
}

static void
tell_turn (Telling *telling)
{
  const ExhibitTurn *to = &telling->to->turn;
  const ExhibitTurn *now = session_get_turn (telling->shadow);

  if (to->is_named
      && (!now->is_named
          || memcmp (to->sites, now->sites, sizeof to->sites) != 0))
    tell (telling, "turn s%u s%u s%u", to->sites[0], to->sites[1],
          to->sites[2]);
  if (to->node[0] != now->node[0] || to->node[1] != now->node[1])
    tell (telling, "node %u %u", to->node[0], to->node[1]);
}

static void
tell_exhibit (Telling *telling)
{
  const ExhibitKind kind = telling->to->exhibit_kind;

  if (kind == EXHIBIT_COMPARE) {
    tell_compare (telling);
    return;
  }
  tell_order (telling);
  if (kind == EXHIBIT_SIGNS)
    tell_turn (telling);
  if (kind != session_get_exhibit_kind (telling->shadow))
    tell (telling, "view %s", exhibit_kind_name (kind));
}

/* Time */

static char *
place_text (Place place)
{
  if (place.phase == PHASE_START || place.phase == PHASE_SIMPLEX
      || place.phase == PHASE_COMPLETE)
    return g_strdup (phase_name (place.phase));
  return g_strdup_printf ("round %u %s", place.round, phase_name (place.phase));
}

static void
tell_events (Telling *telling, const char *command, guint n)
{
  for (guint i = 0; i < n; i++)
    tell (telling, "%s", command);
}

/* To the end of the phase and back, or to its beginning and on: the shorter
 * way. */
static void
tell_step (Telling *telling, guint step)
{
  Session *shadow = telling->shadow;
  const Place place = session_get_place_at (shadow, step);
  g_autofree char *text = place_text (place);
  guint end = G_MAXUINT, before = G_MAXUINT;

  if (session_find_step (shadow, place, FALSE, &end) && end == step) {
    tell (telling, "goto %s", text);
    return;
  }
  if (place.phase == PHASE_SIMPLEX
      || !session_find_step (shadow, place, TRUE, &before)) {
    tell (telling, "goto start");
    before = 0;
  } else if (end != G_MAXUINT && end > step && end - step < step - before) {
    tell (telling, "goto %s", text);
    tell_events (telling, "back event", end - step);
    return;
  } else {
    tell (telling, "goto before %s", text);
  }
  tell_events (telling, "next event", step - before);
}

static void
tell_time (Telling *telling)
{
  const StopState *to = telling->to;
  const guint step
      = to->exhibit_kind <= EXHIBIT_COMPARE ? to->step : to->exhibit_step;

  if (session_get_step (telling->shadow) != step)
    tell_step (telling, step);
}

/* The look */

static void
tell_layers (Telling *telling)
{
  const guint to = telling->to->look.layers;
  const guint now = session_get_look (telling->shadow)->layers;

  for (guint i = 0; i < N_LAYERS; i++)
    if ((to ^ now) & (1u << i))
      tell (telling, "%s %s", to & (1u << i) ? "show" : "hide",
            layer_name ((Layer)(1u << i)));
}

static void
tell_number (Telling *telling, const char *what, double now, double to)
{
  char text[NUMBER_ROOM];

  if (fabs (now - to) < NEAR)
    return;
  number_write (round (to / NEAR) * NEAR, text);
  tell (telling, "%s %s", what, text);
}

static void
tell_numbers (Telling *telling)
{
  const SceneLook *to = &telling->to->look;
  const SceneLook *now = session_get_look (telling->shadow);

  tell_number (telling, "lift", now->lift, to->lift);
  tell_number (telling, "raise", now->raise, to->raise);
  for (Body body = 0; body < N_BODIES; body++) {
    g_autofree char *what = g_strdup_printf ("opacity %s", body_name (body));

    tell_number (telling, what, 1 - now->body_fade[body],
                 1 - to->body_fade[body]);
  }
  for (Role role = 0; role < N_ROLES; role++) {
    g_autofree char *what = g_strdup_printf ("opacity %s", role_name (role));

    tell_number (telling, what, 1 - now->role_fade[role],
                 1 - to->role_fade[role]);
  }
}

static void
tell_object (Telling *telling, const char *what, Object now, Object to)
{
  char name[OBJECT_NAME_ROOM];

  object_name_write (to, name);
  if (!object_equal (to, now) && !tell (telling, "%s %s", what, name)
      && now.kind != OBJECT_NONE)
    tell (telling, "%s none", what);
}

static void
tell_look (Telling *telling)
{
  const SceneLook *to = &telling->to->look;
  const SceneLook *now = session_get_look (telling->shadow);

  tell_layers (telling);
  if (to->focus != now->focus)
    tell (telling, "focus %s", focus_name (to->focus));
  tell_numbers (telling);
  /* A facet that is not born yet, a site that is there no more: nobody sees
   * them. */
  tell_object (telling, "select", now->selection, to->selection);
  tell_object (telling, "measure", now->measured, to->measured);
}

static void
tell_camera (Telling *telling)
{
  g_autofree char *to = camera_text_write (&telling->to->camera);
  g_autofree char *now
      = camera_text_write (session_get_camera (telling->shadow));

  if (!g_str_equal (to, now))
    tell (telling, "camera %s", to);
}

static void
tell_staging (Telling *telling, ThemeKind theme)
{
  const StopState *to = telling->to;
  Session *shadow = telling->shadow;

  if (to->views != session_get_views (shadow))
    tell (telling, "views %s", views_name (to->views));
  if (to->listing != session_get_listing (shadow))
    tell (telling, "listing %s", listing_name (to->listing));
  if (theme != session_get_appearance (shadow)->theme)
    tell (telling, "theme %s", theme_kind_name (theme));
}

GPtrArray *
record_lines (Session *shadow, const StopState *to, ThemeKind theme)
{
  Telling telling = { shadow, to, g_ptr_array_new_with_free_func (g_free) };

  tell_sites (&telling);
  tell_exhibit (&telling);
  tell_time (&telling);
  tell_look (&telling);
  tell_camera (&telling);
  tell_staging (&telling, theme);
  return telling.lines;
}
