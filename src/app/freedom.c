#include "freedom.h"

#include <glib/gi18n.h>

const char *
freedom_title (Session *session)
{
  if (session_get_performance (session) != NULL)
    return _ ("You be QuickHull");
  switch (session_get_exhibit_kind (session)) {
  case EXHIBIT_LIFTS:
  case EXHIBIT_PLANAR:
    return _ ("Your own sites");
  case EXHIBIT_COMPARE:
    return _ ("Your own sites in two orders");
  case EXHIBIT_SIGNS:
    return _ ("The sign of a turn");
  case EXHIBIT_ROUNDED:
    return _ ("Your own sites, rounded");
  }
  return "";
}

static const char *
lifts_text (gboolean right_button_adds)
{
  if (right_button_adds)
    return _ ("**Right-click** in the plane to add a site. **Drag** a site to "
              "move it: hull, triangles and cells follow.\n\nClick a site, a "
              "triangle or a facet to see its counterparts in both pictures; "
              "**Shift**+click selects several sites. **Delete** removes "
              "them.\n\nThen step through QuickHull below, or open a lesson "
              "at the top.");
  return _ ("**Click** in the plane to add a site; inside a triangle, "
            "**double-click**. **Drag** a site to move it: hull, triangles "
            "and cells follow. **Right-click** for more, such as "
            "coordinates.\n\nClick a site, a triangle or a facet to see "
            "its counterparts in both pictures; **Shift**+click selects "
            "several sites. **Delete** removes them.\n\nThen step through "
            "QuickHull below, or open a lesson at the top.");
}

static const char *
planar_text (gboolean right_button_adds)
{
  if (right_button_adds)
    return _ ("The hull of the sites in the plane, without their "
              "lifts.\n\n**Right-click** to add a site. **Drag** a site to "
              "move it: the hull follows. **Delete** removes a selected "
              "one.\n\nThen step through QuickHull below.");
  return _ ("The hull of the sites in the plane, without their "
            "lifts.\n\n**Click** to add a site. **Drag** a site to move it: "
            "the hull follows. **Delete** removes a selected one.\n\nThen "
            "step through QuickHull below.");
}

static const char *
compare_text (Session *session)
{
  if (session_get_compares_space (session))
    return _ ("Two runs insert the same sites, each in its own order, which "
              "stands over its picture.\n\nStep below, **round by round**, and "
              "compare what the runs have cost: it stands under the "
              "pictures.\n\nTurning one picture turns both.");
  return _ ("Two runs insert the same sites, each in its own order, which "
            "stands over its picture.\n\nStep below, **round by round**, and "
            "compare what the runs have cost: it stands under the "
            "pictures.\n\n**Drag** a site to change both runs.");
}

static const char *
signs_text (void)
{
  return _ ("Each node of the grid is a place for one site, one double apart "
            "from the next. It shows on which side of a line through "
            "two other sites that place lies: on the left as plain doubles "
            "have it, on the right as it is.\n\n**Point** at a node to read "
            "both signs, or walk with the **arrow keys**; **Shift** takes "
            "longer steps.");
}

static const char *
rounded_text (void)
{
  return _ ("On the left a hull is built by signs in **plain doubles**, which "
            "can be wrong; on the right is the true one.\n\nStep below, site "
            "by site. Where a sign is wrong, the sentence says so.\n\n**Drag** "
            "a site, or open sites that lie almost on one line: with others "
            "signs are rarely wrong.");
}

const char *
freedom_text (Session *session, gboolean right_button_adds)
{
  if (session_get_performance (session) != NULL)
    return _ ("Do what QuickHull does, task by task: **click** in either "
              "picture what the task asks for, then **Check**.");
  switch (session_get_exhibit_kind (session)) {
  case EXHIBIT_LIFTS:
    return lifts_text (right_button_adds);
  case EXHIBIT_PLANAR:
    return planar_text (right_button_adds);
  case EXHIBIT_COMPARE:
    return compare_text (session);
  case EXHIBIT_SIGNS:
    return signs_text ();
  case EXHIBIT_ROUNDED:
    return rounded_text ();
  }
  return "";
}
