#include "exhibit.h"

#include "laws.h"

#include <glib/gi18n.h>

struct Exhibit {
  ExhibitKind kind;
  Run *run;
  PlanarTrace *planar;
  PlanarFrame frame; /* of the step that was asked for last */
  gboolean has_frame;
};

static const char *const kind_names[N_EXHIBITS] = {
  [EXHIBIT_LIFTS] = "lifts",
  [EXHIBIT_PLANAR] = "planar",
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

Exhibit *
exhibit_new (ExhibitKind kind, Run *run)
{
  Exhibit *exhibit = g_new0 (Exhibit, 1);

  g_assert (kind == EXHIBIT_PLANAR);
  exhibit->kind = kind;
  exhibit->run = run_ref (run);
  exhibit->planar = planar_trace_record (run->set);
  return exhibit;
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
  planar_trace_free (exhibit->planar);
  run_unref (exhibit->run);
  g_free (exhibit);
}

ExhibitKind
exhibit_kind (const Exhibit *exhibit)
{
  return exhibit->kind;
}

const Course *
exhibit_course (const Exhibit *exhibit)
{
  return &exhibit->planar->course;
}

void
exhibit_narrate (const Exhibit *exhibit,
                 guint step,
                 NarrationTranslate translate,
                 char text[NARRATION_ROOM])
{
  planar_narration_write (exhibit->planar, step, translate, text);
}

const PseudocodeLine *
exhibit_lines (const Exhibit *exhibit, guint *n_lines)
{
  (void)exhibit;
  return planar_pseudocode_lines (n_lines);
}

guint
exhibit_line (const Exhibit *exhibit, guint step)
{
  return planar_pseudocode_line (exhibit->planar, step);
}

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
               Scene *scene,
               const SceneLook *look)
{
  scene_planar (scene, exhibit_planar_frame (exhibit, step), look);
}

/* Counters */

/* Whether the hull shown is that of all sites decided so far. */
static gboolean
is_whole (const PlanarFrame *frame)
{
  return frame->base == frame->step && frame->step >= frame->trace->start_end;
}

static GPtrArray *
planar_laws (const PlanarFrame *frame)
{
  const PlanarCounts *counts = &frame->counts;
  const guint n_distinct = frame->trace->set->n_distinct;
  GPtrArray *laws = laws_new ();

  laws_add (laws, "sites", _ ("sites"), "%u", n_distinct);
  if (frame->n_sites > n_distinct)
    laws_add (laws, "duplicates", _ ("duplicates"), "%u",
              frame->n_sites - n_distinct);
  laws_add (laws, "hull-vertices", _ ("corners of the hull"), "%u",
            counts->corners);
  laws_add (laws, "ignored", _ ("inside, ignored"), "%u", counts->inside);
  if (counts->waiting > 0 && is_whole (frame))
    laws_add (laws, "waiting", _ ("still to decide"), "%u = %u − %u − %u",
              counts->waiting, n_distinct, counts->corners, counts->inside);
  else if (counts->waiting > 0)
    laws_add (laws, "waiting", _ ("still to decide"), "%u", counts->waiting);
  if (frame->is_round_in_hand) {
    laws_add (laws, "visible", _ ("visible edges"), "%u", counts->visible);
    if (counts->horizon > 0)
      laws_add (laws, "horizon", _ ("horizon corners"), "%u", counts->horizon);
    if (counts->cone > 0)
      laws_add (laws, "cone", _ ("new edges"), "%u", counts->cone);
    if (counts->retired > 0)
      laws_add (laws, "retired", _ ("retired"), "%u", counts->retired);
  }
  if (counts->outside_sets > 0)
    laws_add (laws, "outside-sets", _ ("outside sets"), "%u",
              counts->outside_sets);
  return laws;
}

GPtrArray *
exhibit_laws (Exhibit *exhibit, guint step)
{
  return planar_laws (exhibit_planar_frame (exhibit, step));
}

const char *const *
exhibit_count_names (void)
{
  static const char *const names[] = { "hull-vertices", "ignored", NULL };

  return names;
}

gboolean
exhibit_count (Exhibit *exhibit, guint step, const char *key, guint *count)
{
  const PlanarCounts *counts = &exhibit_planar_frame (exhibit, step)->counts;
  const struct {
    const char *key;
    guint count;
  } rows[] = {
    { "hull-vertices", counts->corners },
    { "ignored", counts->inside },
    { "waiting", counts->waiting },
    { "outside-sets", counts->outside_sets },
    { "visible", counts->visible },
    { "horizon", counts->horizon },
    { "cone", counts->cone },
    { "retired", counts->retired },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    if (g_str_equal (key, rows[i].key)) {
      *count = rows[i].count;
      return TRUE;
    }
  return FALSE;
}
