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
    return _ ("in the outside set in hand");
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

  /* Translators: a site with its coordinates, and its state: s3 (0.5, 1), on
     the hull */
  return g_strdup_printf (
      _ ("%s, %s"), place,
      site_state_text (session_get_site_state (session, site)));
}

static const char *
facing_text (Facing facing)
{
  switch (facing) {
  case FACING_LOWER:
    return _ ("lower");
  case FACING_VERTICAL:
    return _ ("vertical");
  case FACING_UPPER:
    return _ ("upper");
  }
  return "";
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
  return g_strdup_printf ("f%u: s%u s%u s%u, %s%s%s", facet, row->site[0],
                          row->site[1], row->site[2], facing_text (row->facing),
                          roles & FACET_VISIBLE ? _ (", visible") : "",
                          roles & FACET_CONE ? _ (", in the cone") : "");
}

char *
canvas_name_object (Session *session, Object object)
{
  char name[OBJECT_NAME_ROOM];

  if (object.kind == OBJECT_SITE)
    return name_site (session, object.number);
  if (object.kind == OBJECT_FACET)
    return name_facet (session, object.number);
  object_name_write (object, name);
  return g_strdup (name);
}
