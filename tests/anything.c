#include "anything.h"

#include "action.h"

static double
number (GRand *random)
{
  return g_rand_int_range (random, -64, 65) / 64.0;
}

static void
edit (Session *session, GRand *random)
{
  const guint n = session_get_set (session)->n_sites;
  const Site site = { number (random), number (random) };
  const guint which = n == 0 ? 0 : g_rand_int (random) % n;

  switch (g_rand_int_range (random, 0, 7)) {
  case 0:
  case 1:
    session_add_site (session, site, NULL);
    break;
  case 2:
  case 3:
    session_move_site (session, which, site, NULL);
    break;
  case 4:
    session_remove_site (session, which, NULL);
    break;
  case 5:
    session_undo (session);
    break;
  default:
    session_redo (session);
    break;
  }
}

static void
turn_space (Session *session, GRand *random)
{
  Camera camera = *session_get_camera (session);
  const double size[2] = { 600, 600 };
  const double from[2] = { 300, 300 };
  const double to[2] = { g_rand_double_range (random, 0, 600),
                         g_rand_double_range (random, 0, 600) };

  camera_roll (&camera, from, to, size);
  session_set_camera (session, &camera);
}

/* One of the words of an action; those that cannot be done now are not. */
static void
try_word (Session *session,
          GRand *random,
          const char *name,
          const char *const *words)
{
  const guint n = g_strv_length ((char **)words);

  action_run (session, name,
              g_variant_new_string (words[g_rand_int (random) % n]), NULL);
}

#define TRY(name, ...)                                                         \
  try_word (session, random, name, (const char *const[]){ __VA_ARGS__, NULL })

void
look_anyhow (Session *session, GRand *random)
{
  switch (g_rand_int_range (random, 0, 9)) {
  case 0:
    TRY ("show", "circumcircles", "lifts", "why", "furthest", "tangents");
    break;
  case 1:
    TRY ("hide", "hull", "voronoi", "delaunay", "lifts", "circumcircles");
    break;
  case 2:
    TRY ("focus", "active", "none", "visible", "horizon", "cone");
    break;
  case 3:
    TRY ("select", "s0", "s3", "f0", "f5", "v1", "r2", "none");
    break;
  case 4:
    session_set_lift (session, g_rand_double (random));
    break;
  case 5:
    session_set_role_opacity (session, ROLE_UPPER, g_rand_double (random));
    break;
  case 6:
    session_set_body_opacity (session, BODY_HULL, g_rand_double (random));
    break;
  case 7:
    TRY ("measure", "s1", "s2", "none");
    break;
  default:
    session_set_raise (session, 2 * g_rand_double (random));
    break;
  }
}

static void
stage (Session *session, GRand *random)
{
  switch (g_rand_int_range (random, 0, 8)) {
  case 0:
    TRY ("views", "both", "plane", "space");
    break;
  case 1:
    TRY ("listing", "quickhull", "hull-2004", "diagrams-corrected");
    break;
  case 2:
    TRY ("theme", "light", "dark", "projector", "print");
    break;
  case 3:
    TRY ("camera", "home", "look-up", "side", "look-up-unmirrored");
    break;
  case 4:
    turn_space (session, random);
    break;
  case 5:
    TRY ("order", "input", "furthest", "random 7");
    break;
  case 6:
    TRY ("view", "lifts", "planar", "signs", "rounded", "lifts");
    break;
  default:
    TRY ("compare", "furthest input", "random 3 furthest", "none", "none");
    break;
  }
}

static void
step (Session *session, GRand *random)
{
  static const char *const steps[]
      = { "next-event", "next-phase", "next-round",
          "back-event", "back-phase", "back-round" };

  if (g_rand_int_range (random, 0, 4) > 0)
    action_run (session, steps[g_rand_int (random) % 6], NULL, NULL);
  else
    session_set_step (session, g_rand_int (random)
                                   % (session_get_n_steps (session) + 1));
}

void
do_anything (Session *session, GRand *random)
{
  switch (g_rand_int_range (random, 0, 8)) {
  case 0:
  case 1:
    edit (session, random);
    break;
  case 2:
  case 3:
    look_anyhow (session, random);
    break;
  case 4:
    stage (session, random);
    break;
  case 5:
    if (g_rand_int_range (random, 0, 6) == 0)
      TRY ("sites", "grid 3 3", "circle 7", "random 9 seed 2", "line 4");
    break;
  default:
    step (session, random);
    break;
  }
}
