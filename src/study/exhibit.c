#include "exhibit.h"

#include "laws.h"
#include "number.h"
#include "scene-rounding.h"

#include <glib/gi18n.h>
#include <string.h>

/* A record, which never changes. */
typedef struct Planar {
  PlanarTrace *trace;
} Planar;

struct Exhibit {
  ExhibitKind kind;
  Run *run;
  Planar *shared;      /* counts its references; NULL: another kind */
  PlanarTrace *planar; /* its trace */
  PlanarFrame frame;   /* of the step that was asked for last */
  gboolean has_frame;
  RoundedHull hull; /* of that step too */
  gboolean has_hull;
  guint hull_step;
  SignMap *map; /* NULL: these sites have none */
  guint sites[3];
  guint node[2];
  Course course; /* but for the planar one */
};

static const char *const kind_names[N_EXHIBITS] = {
  [EXHIBIT_LIFTS] = "lifts",     [EXHIBIT_COMPARE] = "compare",
  [EXHIBIT_PLANAR] = "planar",   [EXHIBIT_SIGNS] = "signs",
  [EXHIBIT_ROUNDED] = "rounded",
};

const char *
exhibit_kind_name (ExhibitKind kind)
{
  return kind_names[kind];
}

gboolean
exhibit_kind_parse (const char *name, ExhibitKind *kind)
{
  for (ExhibitKind i = 0; i < N_EXHIBITS; i++)
    if (g_str_equal (name, kind_names[i])) {
      *kind = i;
      return TRUE;
    }
  return FALSE;
}

/* Rounding */

/* The turn to look at when none was named: the first that is wrong in the
 * hull by insertion, else that of the first three sites. */
static void
find_turn (const SiteSet *set, guint sites[3])
{
  RoundedHull hull;

  for (guint i = 0; i < 3; i++)
    sites[i] = i;
  rounded_hull_init (&hull, set, G_MAXUINT);
  for (guint i = 0; i < hull.n_steps; i++)
    if (hull.steps[i].n_wrong > 0) {
      sites[0] = hull.steps[i].wrong[0];
      sites[1] = hull.steps[i].wrong[1];
      sites[2] = hull.steps[i].site;
      break;
    }
  rounded_hull_clear (&hull);
}

static void
make_map (Exhibit *exhibit, const ExhibitTurn *turn)
{
  const SiteSet *set = exhibit->run->set;
  Site at[3];

  memcpy (exhibit->sites, turn->sites, sizeof exhibit->sites);
  memcpy (exhibit->node, turn->node, sizeof exhibit->node);
  if (!turn->is_named)
    find_turn (set, exhibit->sites);
  for (guint i = 0; i < 3; i++) {
    if (exhibit->sites[i] >= set->n_sites)
      return;
    at[i] = site_set_given (set, exhibit->sites[i]);
  }
  exhibit->map = g_new (SignMap, 1);
  if (!sign_map_init (exhibit->map, &at[0], &at[1], &at[2]))
    g_clear_pointer (&exhibit->map, g_free);
}

static void
make_course (Exhibit *exhibit)
{
  RoundedHull hull;

  rounded_hull_init (&hull, exhibit->run->set, G_MAXUINT);
  for (guint i = 0; i < hull.n_steps; i++)
    course_add (&exhibit->course,
                (Place){ i, i == 0 ? PHASE_SIMPLEX : PHASE_HAND_OVER });
  rounded_hull_clear (&hull);
}

static void
drop_hull (Exhibit *exhibit)
{
  if (exhibit->has_hull)
    rounded_hull_clear (&exhibit->hull);
  exhibit->has_hull = FALSE;
}

const RoundedHull *
exhibit_rounded_hull (Exhibit *exhibit, guint step)
{
  if (exhibit->has_hull && exhibit->hull_step == step)
    return &exhibit->hull;
  drop_hull (exhibit);
  rounded_hull_init (&exhibit->hull, exhibit->run->set, step);
  exhibit->has_hull = TRUE;
  exhibit->hull_step = step;
  return &exhibit->hull;
}

/* Life */

static void
planar_clear (gpointer planar)
{
  planar_trace_free (((Planar *)planar)->trace);
}

static void
make_planar (Exhibit *exhibit)
{
  exhibit->shared = g_atomic_rc_box_new (Planar);
  exhibit->shared->trace = exhibit->planar
      = planar_trace_record (exhibit->run->set);
}

Exhibit *
exhibit_new (ExhibitKind kind, Run *run, const ExhibitTurn *turn)
{
  Exhibit *exhibit = g_new0 (Exhibit, 1);

  g_assert (kind >= EXHIBIT_PLANAR);
  exhibit->kind = kind;
  exhibit->run = run_ref (run);
  if (kind == EXHIBIT_PLANAR)
    make_planar (exhibit);
  else if (kind == EXHIBIT_SIGNS)
    make_map (exhibit, turn);
  else
    make_course (exhibit);
  return exhibit;
}

Exhibit *
exhibit_share (const Exhibit *exhibit)
{
  Exhibit *other = g_new0 (Exhibit, 1);

  other->kind = exhibit->kind;
  other->run = run_ref (exhibit->run);
  other->planar = exhibit->planar;
  if (exhibit->shared != NULL)
    other->shared = g_atomic_rc_box_acquire (exhibit->shared);
  if (exhibit->map != NULL)
    other->map = g_memdup2 (exhibit->map, sizeof *exhibit->map);
  memcpy (other->sites, exhibit->sites, sizeof other->sites);
  memcpy (other->node, exhibit->node, sizeof other->node);
  return other;
}

static void
drop_frame (Exhibit *exhibit)
{
  if (exhibit->has_frame)
    planar_frame_clear (&exhibit->frame);
  exhibit->has_frame = FALSE;
}

void
exhibit_free (Exhibit *exhibit)
{
  if (exhibit == NULL)
    return;
  drop_frame (exhibit);
  drop_hull (exhibit);
  if (exhibit->shared != NULL)
    g_atomic_rc_box_release_full (exhibit->shared, planar_clear);
  course_clear (&exhibit->course);
  g_free (exhibit->map);
  run_unref (exhibit->run);
  g_free (exhibit);
}

ExhibitKind
exhibit_kind (const Exhibit *exhibit)
{
  return exhibit->kind;
}

Run *
exhibit_run (const Exhibit *exhibit)
{
  return exhibit->run;
}

const Course *
exhibit_course (const Exhibit *exhibit)
{
  return exhibit->planar != NULL ? &exhibit->planar->course : &exhibit->course;
}

const SignMap *
exhibit_map (const Exhibit *exhibit)
{
  return exhibit->map;
}

void
exhibit_set_node (Exhibit *exhibit, const guint node[2])
{
  memcpy (exhibit->node, node, sizeof exhibit->node);
}

/* Words */

static const char *
side_word (int sign)
{
  if (sign == 0)
    return N_ ("no turn");
  return sign > 0 ? N_ ("a left turn") : N_ ("a right turn");
}

static const char *
same (const char *english)
{
  return english;
}

static void
put (GString *text, const char *part, const char *value)
{
  g_string_replace (text, part, value, 0);
}

static void
put_site (GString *text, const char *part, guint site)
{
  char name[16];

  g_snprintf (name, sizeof name, "s%u", site);
  put (text, part, name);
}

/* What the marked node says, its coordinates to the last bit. */
static void
narrate_signs (const Exhibit *exhibit,
               NarrationTranslate translate,
               char text[NARRATION_ROOM])
{
  const SignMap *map = exhibit->map;
  const guint *node = exhibit->node;
  g_autoptr (GString) sentence = g_string_new (translate (
      N_ ("{p} at ({x}, {y}), then {q}, {r}. In plain doubles: {u}. In "
          "truth: {v}.")));
  char x[NUMBER_ROOM], y[NUMBER_ROOM];
  const Site at = sign_map_site (map, node[0], node[1]);

  number_write (at.x, x);
  number_write (at.y, y);
  put_site (sentence, "{p}", exhibit->sites[0]);
  put_site (sentence, "{q}", exhibit->sites[1]);
  put_site (sentence, "{r}", exhibit->sites[2]);
  put (sentence, "{x}", x);
  put (sentence, "{y}", y);
  put (sentence, "{u}", translate (side_word (map->rounded[node[1]][node[0]])));
  put (sentence, "{v}", translate (side_word (map->exact[node[1]][node[0]])));
  g_strlcpy (text, sentence->str, NARRATION_ROOM);
}

void
exhibit_narrate (Exhibit *exhibit,
                 guint step,
                 NarrationTranslate translate,
                 char text[NARRATION_ROOM])
{
  if (translate == NULL)
    translate = same;
  if (exhibit->kind == EXHIBIT_PLANAR)
    planar_narration_write (exhibit->planar, step, translate, text);
  else if (exhibit->kind == EXHIBIT_ROUNDED)
    rounded_narration_write (exhibit_rounded_hull (exhibit, step), translate,
                             text);
  else if (exhibit->map != NULL)
    narrate_signs (exhibit, translate, text);
  else
    g_strlcpy (text,
               translate (N_ ("A sign map needs three sites, and doubles that "
                              "are not too small.")),
               NARRATION_ROOM);
}

const PseudocodeLine *
exhibit_lines (const Exhibit *exhibit, guint *n_lines)
{
  return exhibit->kind == EXHIBIT_PLANAR ? planar_pseudocode_lines (n_lines)
                                         : rounded_pseudocode_lines (n_lines);
}

const char *
exhibit_listing_title (const Exhibit *exhibit)
{
  return exhibit->kind == EXHIBIT_PLANAR ? N_ ("QuickHull in the plane")
                                         : N_ ("Hull, site by site");
}

guint
exhibit_line (Exhibit *exhibit, guint step)
{
  if (exhibit->kind == EXHIBIT_PLANAR)
    return planar_pseudocode_line (exhibit->planar, step);
  return exhibit->kind == EXHIBIT_ROUNDED
             ? rounded_pseudocode_line (exhibit_rounded_hull (exhibit, step))
             : INDEX_NONE;
}

/* Pictures */

const PlanarFrame *
exhibit_planar_frame (Exhibit *exhibit, guint step)
{
  if (exhibit->has_frame && exhibit->frame.step == step)
    return &exhibit->frame;
  drop_frame (exhibit);
  planar_frame_init (&exhibit->frame, exhibit->planar, step);
  exhibit->has_frame = TRUE;
  return &exhibit->frame;
}

void
exhibit_scene (Exhibit *exhibit,
               guint step,
               guint pane,
               Scene *scene,
               const SceneLook *look)
{
  if (exhibit->kind == EXHIBIT_PLANAR)
    scene_planar (scene, exhibit_planar_frame (exhibit, step), look);
  else if (exhibit->kind == EXHIBIT_ROUNDED || exhibit->map == NULL)
    scene_rounded (scene, exhibit_rounded_hull (exhibit, step), pane == 1,
                   look);
  else
    scene_sign_map (scene, exhibit->map, pane == 1, exhibit->node, look);
}
