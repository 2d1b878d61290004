#include "canvas-name.h"

#include "number.h"
#include "object-name.h"

#include <glib/gi18n.h>

char *
canvas_name_place (Session *session, guint site)
{
  const Site given = site_set_given (session_get_set (session), site);
  char x[NUMBER_ROOM], y[NUMBER_ROOM];

  number_write (given.x, x);
  number_write (given.y, y);
  return g_strdup_printf ("s%u (%s, %s)", site, x, y);
}

static const char *
site_state_text (SiteState state)
{
  switch (state) {
  case SITE_WAITING:
    return _ ("waiting");
  case SITE_OUTSIDE:
    return _ ("in the current outside set");
  case SITE_APEX:
    return _ ("the new site");
  case SITE_INSERTED:
    return _ ("on the hull");
  case SITE_DUPLICATE:
    return _ ("a duplicate");
  case SITE_IGNORED:
    return _ ("inside, ignored");
  }
  return "";
}

static char *
name_site (Session *session, guint site)
{
  g_autofree char *place = canvas_name_place (session, site);

  /* The state would answer a question. */
  if (session_is_asking (session))
    return g_steal_pointer (&place);
  /* Translators: a site with its coordinates, and its state: s3 (0.5, 1), on
     the hull */
  return g_strdup_printf (
      _ ("%s, %s"), place,
      site_state_text (session_get_site_state (session, 0, site)));
}

static char *
name_facet (Session *session, guint facet)
{
  const Frame *frame = session_get_frame (session);
  const guint roles = frame_facet_roles (frame, facet);
  const FacetRow *row;

  if (frame->trace->is_flat || facet >= frame->trace->n_facets)
    return g_strdup_printf (_ ("triangle %u"), facet);
  row = &frame->trace->facets[facet];
  if (session_is_asking (session))
    return g_strdup_printf ("f%u: s%u s%u s%u", facet, row->site[0],
                            row->site[1], row->site[2]);
  return g_strdup_printf ("f%u: s%u s%u s%u, %s%s%s", facet, row->site[0],
                          row->site[1], row->site[2], facing_name (row->facing),
                          roles & FACET_VISIBLE ? _ (", visible") : "",
                          roles & FACET_CONE ? _ (", in the cone") : "");
}

static char *
name_ridge (Session *session, guint ridge)
{
  const Trace *trace = session_get_trace (session);

  if (ridge >= trace->n_ridges)
    return g_strdup ("");
  return g_strdup_printf (_ ("ridge s%u s%u"),
                          trace_ridge (trace, ridge).site[0],
                          trace_ridge (trace, ridge).site[1]);
}

static char *
name_plain (Session *session, Object object)
{
  char name[OBJECT_NAME_ROOM];

  switch (object.kind) {
  case OBJECT_SITE:
    return name_site (session, object.number);
  case OBJECT_FACET:
    return name_facet (session, object.number);
  case OBJECT_RIDGE:
    return name_ridge (session, object.number);
  case OBJECT_VERTEX:
  case OBJECT_NONE:
    break;
  }
  object_name_write (object, name);
  return g_strdup (name);
}

char *
canvas_name_object (Session *session, Object object)
{
  const Exercise *exercise = session_get_exercise (session);
  g_autofree char *name = name_plain (session, object);

  if (exercise == NULL || !session_is_answering (session)
      || !attempt_has (exercise->attempt, object))
    return g_steal_pointer (&name);
  return g_strdup_printf (_ ("%s, chosen"), name);
}
