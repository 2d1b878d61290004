#include "same-session.h"

#include "action.h"
#include "object-name.h"

#include <math.h>

static void
assert_same_sites (Session *a, Session *b)
{
  const SiteSet *left = session_get_set (a), *right = session_get_set (b);

  g_assert_cmpuint (left->n_sites, ==, right->n_sites);
  for (guint i = 0; i < left->n_sites; i++) {
    const Site p = site_set_given (left, i), q = site_set_given (right, i);

    g_assert_true (p.x == q.x && p.y == q.y);
  }
}

void
assert_same_camera (const Camera *a, const Camera *b)
{
  static const Point3 points[]
      = { { 0, 0, 0 }, { 1, 0, 1 }, { 0, 1, 0.5 }, { -1, -1, 2 } };
  const Projection left = camera_projection (a, 1000, 1000);
  const Projection right = camera_projection (b, 1000, 1000);

  for (guint i = 0; i < G_N_ELEMENTS (points); i++) {
    const Point3 p = projection_apply (&left, points[i]);
    const Point3 q = projection_apply (&right, points[i]);

    /* Within what the zoom makes of a hundredth of a degree. */
    g_assert_cmpfloat (hypot (p.x - q.x, p.y - q.y), <, 2 * (1 + a->zoom));
  }
}

static void
assert_same_look (const SceneLook *a, const SceneLook *b)
{
  g_assert_cmpuint (a->layers, ==, b->layers);
  g_assert_cmpint (a->focus, ==, b->focus);
  g_assert_cmpfloat_with_epsilon (a->lift, b->lift, 1e-6);
  g_assert_cmpfloat_with_epsilon (a->raise, b->raise, 1e-6);
  for (guint i = 0; i < N_BODIES; i++)
    g_assert_cmpfloat_with_epsilon (a->body_fade[i], b->body_fade[i], 1e-6);
  for (guint i = 0; i < N_ROLES; i++)
    g_assert_cmpfloat_with_epsilon (a->role_fade[i], b->role_fade[i], 1e-6);
}

/* What is not born yet when the person steps back, and a site that is there no
 * more, show nothing. */
static void
assert_same_object (Session *session,
                    const char *action,
                    Object object,
                    Object other)
{
  char name[OBJECT_NAME_ROOM];

  object_name_write (object, name);
  if (action_run (session, action, g_variant_new_string (name), NULL))
    g_assert_true (object_equal (object, other));
  else
    g_assert_true (object_equal (object, other) || other.kind == OBJECT_NONE);
}

void
assert_same_session (Session *a, Session *b)
{
  g_autofree char *left = session_narrate_in_english (a);
  g_autofree char *right = session_narrate_in_english (b);

  assert_same_sites (a, b);
  g_assert_cmpint (session_get_exhibit_kind (a), ==,
                   session_get_exhibit_kind (b));
  g_assert_cmpuint (session_get_step (a), ==, session_get_step (b));
  g_assert_cmpstr (left, ==, right);
  if (session_get_exhibit_kind (a) <= EXHIBIT_COMPARE)
    g_assert_true (frame_hash (session_get_frame (a))
                   == frame_hash (session_get_frame (b)));
  assert_same_look (session_get_look (a), session_get_look (b));
  assert_same_object (a, "select", session_get_look (a)->selection,
                      session_get_look (b)->selection);
  assert_same_object (a, "measure", session_get_look (a)->measured,
                      session_get_look (b)->measured);
  assert_same_camera (session_get_camera (a), session_get_camera (b));
  g_assert_cmpint (session_get_views (a), ==, session_get_views (b));
  g_assert_cmpint (session_get_listing (a), ==, session_get_listing (b));
  g_assert_cmpint (session_get_appearance (a)->theme, ==,
                   session_get_appearance (b)->theme);
}
