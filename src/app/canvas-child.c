#include "canvas-child.h"

#include "answer-objects.h"
#include "canvas-accessible.h"
#include "canvas-menu.h"
#include "canvas-name.h"

#include <glib/gi18n.h>
#include <string.h>

struct _CanvasChild {
  AtkObject parent_instance;
  Canvas *canvas; /* borrowed: NULL once detached */
  Object object;
  gboolean was_selected; /* as was told last */
  char *name;
};

static void canvas_child_action_init (AtkActionIface *interface);
static void canvas_child_component_init (AtkComponentIface *interface);

G_DEFINE_TYPE_WITH_CODE (
    CanvasChild,
    canvas_child,
    ATK_TYPE_OBJECT,
    G_IMPLEMENT_INTERFACE (ATK_TYPE_ACTION, canvas_child_action_init)
        G_IMPLEMENT_INTERFACE (ATK_TYPE_COMPONENT, canvas_child_component_init))

static const char *
canvas_child_get_name (AtkObject *object)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (object);

  if (child->canvas == NULL)
    return NULL;
  g_free (child->name);
  child->name
      = canvas_name_object (canvas_get_session (child->canvas), child->object);
  return child->name;
}

/* Place in the tree */

static AtkObject *
canvas_child_get_parent (AtkObject *object)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (object);

  if (child->canvas == NULL)
    return NULL;
  return gtk_widget_get_accessible (GTK_WIDGET (child->canvas));
}

static int
canvas_child_get_index (AtkObject *object)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (object);

  return child->canvas == NULL ? -1
                               : canvas_accessible_index (
                                   GTK_WIDGET (child->canvas), child->object);
}

static gboolean
is_selected (CanvasChild *child)
{
  const SceneLook *look = session_get_look (canvas_get_session (child->canvas));

  return object_equal (look->selection, child->object)
         || (child->object.kind == OBJECT_SITE
             && scene_is_selected (look, child->object.number));
}

static AtkStateSet *
canvas_child_ref_state_set (AtkObject *object)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (object);
  AtkStateSet *states = atk_state_set_new ();

  if (child->canvas == NULL) {
    atk_state_set_add_state (states, ATK_STATE_DEFUNCT);
    return states;
  }
  atk_state_set_add_state (states, ATK_STATE_TRANSIENT);
  atk_state_set_add_state (states, ATK_STATE_ENABLED);
  atk_state_set_add_state (states, ATK_STATE_SENSITIVE);
  atk_state_set_add_state (states, ATK_STATE_VISIBLE);
  atk_state_set_add_state (states, ATK_STATE_SHOWING);
  atk_state_set_add_state (states, ATK_STATE_SELECTABLE);
  atk_state_set_add_state (states, ATK_STATE_FOCUSABLE);
  if (is_selected (child))
    atk_state_set_add_state (states, ATK_STATE_SELECTED);
  if (gtk_widget_has_focus (GTK_WIDGET (child->canvas))
      && object_equal (canvas_get_cursor (child->canvas), child->object))
    atk_state_set_add_state (states, ATK_STATE_FOCUSED);
  return states;
}

/* Where it is */

static void
canvas_child_get_extents (AtkComponent *component,
                          int *x,
                          int *y,
                          int *width,
                          int *height,
                          AtkCoordType coordinates)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (component);
  GdkRectangle box = { 0, 0, 0, 0 };
  int left = 0, top = 0;

  *x = *y = *width = *height = 0;
  if (child->canvas == NULL
      || !canvas_locate (child->canvas, child->object, &box))
    return;
  atk_component_get_extents (
      ATK_COMPONENT (gtk_widget_get_accessible (GTK_WIDGET (child->canvas))),
      &left, &top, width, height, coordinates);
  *x = left + box.x;
  *y = top + box.y;
  *width = box.width;
  *height = box.height;
}

static gboolean
canvas_child_grab_focus (AtkComponent *component)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (component);

  if (child->canvas == NULL)
    return FALSE;
  gtk_widget_grab_focus (GTK_WIDGET (child->canvas));
  canvas_set_cursor (child->canvas, child->object);
  return TRUE;
}

static void
canvas_child_component_init (AtkComponentIface *interface)
{
  interface->get_extents = canvas_child_get_extents;
  interface->grab_focus = canvas_child_grab_focus;
}

/* Actions */

static void
do_select (Canvas *canvas, Object object)
{
  Session *session = canvas_get_session (canvas);

  /* While a question is open it is an answer, as a click is. */
  if (session_is_answering (session))
    canvas_answer (canvas, object);
  else
    session_set_selection (session, object);
}

static void
do_menu (Canvas *canvas, Object object)
{
  canvas_set_cursor (canvas, object);
  canvas_menu_popup_at_cursor (canvas);
}

static void
do_join (Canvas *canvas, Object object)
{
  session_toggle_site (canvas_get_session (canvas), object.number);
}

static void
do_delete (Canvas *canvas, Object object)
{
  g_autoptr (GError) error = NULL;

  if (!session_remove_site (canvas_get_session (canvas), object.number, &error))
    canvas_fail (canvas, error);
}

static const struct {
  const char *name, *sentence;
  void (*run) (Canvas *canvas, Object object);
} actions[] = {
  { "select", N_ ("Select it"), do_select },
  { "menu", N_ ("Show what can be done with it"), do_menu },
  /* From here on: sites alone. */
  { "join", N_ ("Add it to the selection, or remove it"), do_join },
  { "delete", N_ ("Delete it"), do_delete },
};

static int
canvas_child_get_n_actions (AtkAction *action)
{
  return HULL2VD_CANVAS_CHILD (action)->object.kind == OBJECT_SITE
             ? (int)G_N_ELEMENTS (actions)
             : 2;
}

static gboolean
has_action (AtkAction *action, int i)
{
  return i >= 0 && i < canvas_child_get_n_actions (action);
}

static gboolean
canvas_child_do_action (AtkAction *action, int i)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (action);

  if (child->canvas == NULL || !has_action (action, i))
    return FALSE;
  actions[i].run (child->canvas, child->object);
  return TRUE;
}

static const char *
canvas_child_get_action_name (AtkAction *action, int i)
{
  return has_action (action, i) ? actions[i].name : NULL;
}

static const char *
canvas_child_get_action_description (AtkAction *action, int i)
{
  return has_action (action, i) ? _ (actions[i].sentence) : NULL;
}

static void
canvas_child_action_init (AtkActionIface *interface)
{
  interface->do_action = canvas_child_do_action;
  interface->get_n_actions = canvas_child_get_n_actions;
  interface->get_name = canvas_child_get_action_name;
  interface->get_description = canvas_child_get_action_description;
}

/* News */

Object
canvas_child_get_object (CanvasChild *child)
{
  return child->object;
}

void
canvas_child_tell_selected (CanvasChild *child)
{
  if (child->canvas == NULL || is_selected (child) == child->was_selected)
    return;
  child->was_selected = !child->was_selected;
  atk_object_notify_state_change (ATK_OBJECT (child), ATK_STATE_SELECTED,
                                  child->was_selected);
}

void
canvas_child_tell_name (CanvasChild *child)
{
  g_autofree char *name = NULL;

  if (child->canvas == NULL)
    return;
  name = canvas_name_object (canvas_get_session (child->canvas), child->object);
  if (g_strcmp0 (name, child->name) != 0)
    g_object_notify (G_OBJECT (child), "accessible-name");
}

/* Life */

AtkObject *
canvas_child_new (Canvas *canvas, Object object)
{
  CanvasChild *child = g_object_new (CANVAS_CHILD_TYPE, NULL);

  child->canvas = canvas;
  child->object = object;
  child->was_selected = is_selected (child);
  atk_object_set_role (ATK_OBJECT (child), object.kind == OBJECT_SITE
                                               ? ATK_ROLE_ICON
                                               : ATK_ROLE_IMAGE);
  return ATK_OBJECT (child);
}

void
canvas_child_detach (CanvasChild *child, gboolean is_told)
{
  child->canvas = NULL;
  if (is_told)
    atk_object_notify_state_change (ATK_OBJECT (child), ATK_STATE_DEFUNCT,
                                    TRUE);
}

static void
canvas_child_finalize (GObject *object)
{
  CanvasChild *child = HULL2VD_CANVAS_CHILD (object);

  g_free (child->name);
  G_OBJECT_CLASS (canvas_child_parent_class)->finalize (object);
}

static void
canvas_child_class_init (CanvasChildClass *class)
{
  AtkObjectClass *atk_class = ATK_OBJECT_CLASS (class);

  G_OBJECT_CLASS (class)->finalize = canvas_child_finalize;
  atk_class->get_name = canvas_child_get_name;
  atk_class->get_parent = canvas_child_get_parent;
  atk_class->get_index_in_parent = canvas_child_get_index;
  atk_class->ref_state_set = canvas_child_ref_state_set;
}

static void
canvas_child_init (CanvasChild *child)
{
  (void)child;
}
