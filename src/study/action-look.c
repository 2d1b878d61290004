#include "action-private.h"
#include "camera-text.h"
#include "object-name.h"
#include "words.h"

#include <glib/gi18n.h>
#include <string.h>

#define ZOOM_STEP 1.25

static gboolean
refuse (const char *rule,
        const char *word,
        const char *const *names,
        GError **error)
{
  g_autofree char *hint = words_hint (word, names);
  g_autofree char *list = g_strjoinv (", ", (char **)names);

  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER, rule, word,
               *hint != '\0' ? hint : words_comma_hint (word), list);
  return FALSE;
}

static gboolean
refuse_layer (const char *word, GError **error)
{
  const char *names[N_LAYERS + 1] = { NULL };

  for (guint i = 0; i < N_LAYERS; i++)
    names[i] = layer_name ((Layer)(1u << i));
  return refuse (_ ("there is no layer “%s”%s; the layers are %s"), word, names,
                 error);
}

ACTION_RUN (action_show)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const guint layers = session_get_look (session)->layers;
  Layer layer;

  if (!layer_parse (name, &layer))
    return refuse_layer (name, error);
  session_set_layers (session,
                      action->data ? layers | layer : layers & ~(guint)layer);
  return TRUE;
}

ACTION_ENABLED (action_can_toggle_layer)
{
  return (session_get_usable_layers (session) & action->data) != 0;
}

ACTION_RUN (action_toggle_layer)
{
  session_set_layers (session,
                      session_get_look (session)->layers ^ action->data);
  return TRUE;
}

ACTION_RUN (action_focus)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[FOCUS_CONE + 2] = { NULL };
  Focus focus;

  if (focus_parse (name, &focus)) {
    session_set_focus (session, focus);
    return TRUE;
  }
  for (guint i = 0; i <= FOCUS_CONE; i++)
    names[i] = focus_name ((Focus)i);
  return refuse (_ ("nothing called “%s” can be in focus%s; write %s"), name,
                 names, error);
}

/* "random S" has a seed, the others have none. */
static gboolean
read_order (const char *text, Order *order)
{
  const char *seed = strchr (text, ' ');
  g_autofree char *name
      = seed == NULL ? g_strdup (text) : g_strndup (text, seed - text);

  if (!order_kind_parse (name, &order->kind)
      || (seed != NULL) != (order->kind == ORDER_RANDOM))
    return FALSE;
  order->seed = 0;
  return seed == NULL
         || g_ascii_string_to_unsigned (seed + 1, 10, 0, G_MAXUINT64,
                                        &order->seed, NULL);
}

ACTION_RUN (action_order)
{
  const char *text = g_variant_get_string (parameter, NULL);
  const char *names[N_ORDERS + 1] = { NULL };
  Order order;

  if (read_order (text, &order)) {
    session_set_order (session, &order);
    return TRUE;
  }
  for (guint i = 0; i < N_ORDERS; i++)
    names[i] = order_kind_name ((OrderKind)i);
  names[ORDER_RANDOM] = "random S";
  return refuse (_ ("there is no order “%s”%s; write %s"), text, names, error);
}

/* Returns: why @object cannot be selected, translated, or NULL. */
static const char *
object_fault (Session *session, Object object)
{
  const Trace *trace = session_get_trace (session);
  const guint step = session_get_step (session);

  switch (object.kind) {
  case OBJECT_NONE:
    return NULL;
  case OBJECT_SITE:
    return object.number < trace->set->n_sites ? NULL
                                               : _ ("there is no such site");
  case OBJECT_FACET:
  case OBJECT_VERTEX:
    /* Without a simplex, triangles go by their own numbers. */
    if (trace->is_flat)
      return object.number < session_get_frame (session)->counts.triangles
                 ? NULL
                 : _ ("there is no such triangle");
    if (object.number >= trace->n_facets)
      return _ ("there is no such facet");
    return trace->facets[object.number].span.birth <= step
               ? NULL
               : _ ("this facet is not born yet");
  case OBJECT_RIDGE:
    return object.number < trace->n_ridges ? NULL
                                           : _ ("there is no such ridge");
  }
  return NULL;
}

ACTION_RUN (action_select)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *fault;
  Object object;

  if (!object_name_parse (name, &object))
    fault = _ ("write s3 for a site, f12 for a facet, v12 for a Voronoi "
               "vertex, or none");
  else
    fault = object_fault (session, object);
  if (fault == NULL) {
    session_set_selection (session, object);
    return TRUE;
  }
  g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
               _ ("cannot select “%s”: %s"), name, fault);
  return FALSE;
}

ACTION_RUN (action_select_next)
{
  const guint n_sites = session_get_set (session)->n_sites;
  const Object old = session_get_look (session)->selection;
  guint site = action->data ? 0 : n_sites - 1;

  if (n_sites == 0) {
    g_set_error (error, ACTION_ERROR, ACTION_ERROR_DISABLED,
                 _ ("there is no site to select"));
    return FALSE;
  }
  if (old.kind == OBJECT_SITE)
    site = (old.number + (action->data ? 1 : n_sites - 1)) % n_sites;
  session_set_selection (session, (Object){ OBJECT_SITE, site });
  return TRUE;
}

/* Returns: whether there are all these sites. */
static gboolean
check_sites (Session *session, const guint32 *sites, gsize n, GError **error)
{
  const guint n_sites = session_get_set (session)->n_sites;

  for (gsize i = 0; i < n; i++)
    if (sites[i] >= n_sites) {
      g_set_error (error, ACTION_ERROR, ACTION_ERROR_PARAMETER,
                   _ ("there is no site s%u"), sites[i]);
      return FALSE;
    }
  return TRUE;
}

ACTION_RUN (action_select_sites)
{
  gsize n;
  const guint32 *sites
      = g_variant_get_fixed_array (parameter, &n, sizeof *sites);

  if (!check_sites (session, sites, n, error))
    return FALSE;
  session_select_sites (session, sites, (guint)n);
  return TRUE;
}

ACTION_RUN (action_toggle_site)
{
  const guint32 site = g_variant_get_uint32 (parameter);

  if (!check_sites (session, &site, 1, error))
    return FALSE;
  session_toggle_site (session, site);
  return TRUE;
}

ACTION_RUN (action_select_all)
{
  const guint n_sites = session_get_set (session)->n_sites;
  g_autofree guint32 *sites = g_new (guint32, n_sites + 1);

  for (guint i = 0; i < n_sites; i++)
    sites[i] = i;
  session_select_sites (session, sites, n_sites);
  return TRUE;
}

ACTION_RUN (action_select_none)
{
  session_set_selection (session, (Object){ OBJECT_NONE, 0 });
  return TRUE;
}

static void
put_preset (Session *session, CameraPreset preset)
{
  Camera camera;

  camera_init (&camera, preset);
  if (preset == CAMERA_LOOK_UP || preset == CAMERA_LOOK_UP_UNMIRRORED
      || preset == CAMERA_LOOK_DOWN)
    camera_follow_plane (&camera, session_get_plane_camera (session));
  session_set_camera (session, &camera);
}

ACTION_RUN (action_camera)
{
  const char *name = g_variant_get_string (parameter, NULL);
  const char *names[N_CAMERA_PRESETS + 1] = { NULL };
  CameraPreset preset;
  Camera camera;

  if (camera_preset_parse (name, &preset)) {
    put_preset (session, preset);
    return TRUE;
  }
  if (camera_text_read (name, &camera)) {
    session_set_camera (session, &camera);
    return TRUE;
  }
  for (guint i = 0; i < N_CAMERA_PRESETS; i++)
    names[i] = camera_preset_name ((CameraPreset)i);
  return refuse (_ ("there is no camera “%s”%s; the cameras are %s, or "
                    "degrees: AZIMUTH ELEVATION"),
                 name, names, error);
}

ACTION_RUN (action_camera_preset)
{
  put_preset (session, (CameraPreset)action->data);
  return TRUE;
}

ACTION_RUN (action_zoom)
{
  const double factor = action->data & ZOOM_IN ? ZOOM_STEP : 1 / ZOOM_STEP;
  PlaneCamera plane = *session_get_plane_camera (session);
  Camera camera = *session_get_camera (session);

  plane.zoom = CLAMP (plane.zoom * factor, ZOOM_LEAST, ZOOM_MOST);
  camera.zoom = CLAMP (camera.zoom * factor, ZOOM_LEAST, ZOOM_MOST);
  if (action->data & ZOOM_PLANE)
    session_set_plane_camera (session, &plane);
  if (action->data & ZOOM_SPACE)
    session_set_camera (session, &camera);
  return TRUE;
}

ACTION_RUN (action_fit)
{
  session_fit (session);
  return TRUE;
}
