/* The names of roles and bodies, for lessons and tests. */
#include "scene.h"

#include <string.h>

static const char *const role_names[N_ROLES] = {
  [ROLE_GROUND] = "ground",
  [ROLE_SHEET] = "sheet",
  [ROLE_RIM] = "rim",
  [ROLE_CELL] = "cell",
  [ROLE_FURTHEST_CELL] = "furthest-cell",
  [ROLE_TANGENT] = "tangent",
  [ROLE_FACET] = "facet",
  [ROLE_LOWER] = "lower",
  [ROLE_UPPER] = "upper",
  [ROLE_VERTICAL] = "vertical",
  [ROLE_SIGN_LEFT] = "sign-left",
  [ROLE_SIGN_ZERO] = "sign-zero",
  [ROLE_SIGN_RIGHT] = "sign-right",
  [ROLE_HULL_AREA] = "hull-area",
  [ROLE_TRIANGLE] = "triangle",
  [ROLE_VISIBLE] = "visible",
  [ROLE_VISIBLE_UPPER] = "visible-upper",
  [ROLE_RETIRED] = "retired",
  [ROLE_CONE] = "cone",
  [ROLE_CONE_UPPER] = "cone-upper",
  [ROLE_SELECTED_FACET] = "selected-facet",
  [ROLE_PREVIEW_TRIANGLE] = "preview-triangle",
  [ROLE_PREVIEW_STOLEN] = "preview-stolen",
  [ROLE_PLANE] = "plane-patch",
  [ROLE_CIRCLE] = "circle",
  [ROLE_CIRCLE_VISIBLE] = "circle-visible",
  [ROLE_CIRCLE_UPPER] = "circle-upper",
  [ROLE_CIRCLE_SELECTED] = "circle-selected",
  [ROLE_ELLIPSE] = "ellipse",
  [ROLE_VORONOI_EDGE] = "voronoi-edge",
  [ROLE_TANGENT_EDGE] = "tangent-edge",
  [ROLE_DELAUNAY_EDGE] = "delaunay-edge",
  [ROLE_FURTHEST_EDGE] = "furthest-edge",
  [ROLE_FURTHEST_VORONOI] = "furthest-voronoi",
  [ROLE_PREVIEW_EDGE] = "preview-edge",
  [ROLE_PREVIEW_CELL] = "preview-cell",
  [ROLE_CONTOUR] = "contour",
  [ROLE_FREE_EDGE] = "free-edge",
  [ROLE_RIDGE] = "ridge",
  [ROLE_HULL_EDGE] = "hull-edge",
  [ROLE_ROUNDED_EDGE] = "rounded-edge",
  [ROLE_SIGN_NODE] = "sign-node",
  [ROLE_EDGE_LINE] = "edge-line",
  [ROLE_VISIBLE_EDGE] = "visible-edge",
  [ROLE_SEEN_EDGE] = "seen-edge",
  [ROLE_CONE_EDGE] = "cone-edge",
  [ROLE_HORIZON] = "horizon",
  [ROLE_HORIZON_UPPER] = "horizon-upper",
  [ROLE_LIFT] = "lift",
  [ROLE_LIFT_APEX] = "lift-apex",
  [ROLE_LIFT_OUTSIDE] = "lift-outside",
  [ROLE_DROP] = "drop",
  [ROLE_GAP] = "gap",
  [ROLE_LIT] = "lit",
  [ROLE_ANSWER_CHOSEN] = "answer-chosen",
  [ROLE_ANSWER_RIGHT] = "answer-right",
  [ROLE_ANSWER_WRONG] = "answer-wrong",
  [ROLE_ANSWER_MISSED] = "answer-missed",
  [ROLE_VORONOI_VERTEX] = "voronoi-vertex",
  [ROLE_VORONOI_VERTEX_TIED] = "voronoi-vertex-tied",
  [ROLE_VORONOI_VERTEX_DYING] = "voronoi-vertex-dying",
  [ROLE_FURTHEST_VERTEX] = "furthest-vertex",
  [ROLE_PREVIEW_SITE] = "preview-site",
  [ROLE_HORIZON_CORNER] = "horizon-corner",
  [ROLE_FOOT] = "foot",
  [ROLE_FOOT_APEX] = "foot-apex",
  [ROLE_SITE] = "site",
  [ROLE_SITE_WAITING] = "site-waiting",
  [ROLE_SITE_OUTSIDE] = "site-outside",
  [ROLE_SITE_APEX] = "site-apex",
  [ROLE_SITE_DUPLICATE] = "site-duplicate",
  [ROLE_SITE_LOST] = "site-lost",
  [ROLE_SITE_IGNORED] = "site-ignored",
  [ROLE_POWER] = "power",
  [ROLE_FACET_NAME] = "facet-name",
  [ROLE_ANSWER_NAME] = "answer-name",
};

static const char *const body_names[N_BODIES] = {
  [BODY_PARABOLOID] = "paraboloid",
  [BODY_HULL] = "hull",
  [BODY_PLANE] = "plane",
};

const char *
role_name (Role role)
{
  return role_names[role];
}

/* Returns: the place of @name among @names, or @n. */
static int
find_name (const char *name, const char *const *names, int n)
{
  int i = 0;

  while (i < n && strcmp (name, names[i]) != 0)
    i++;
  return i;
}

bool
role_parse (const char *name, Role *role)
{
  const int i = find_name (name, role_names, N_ROLES);

  if (i < N_ROLES)
    *role = (Role)i;
  return i < N_ROLES;
}

const char *
body_name (Body body)
{
  return body_names[body];
}

bool
body_parse (const char *name, Body *body)
{
  const int i = find_name (name, body_names, N_BODIES);

  if (i < N_BODIES)
    *body = (Body)i;
  return i < N_BODIES;
}
