#include "canvas-accessible.h"

#include "canvas-child.h"
#include "canvas.h"

#include <glib/gi18n.h>
#include <string.h>

struct _CanvasAccessible {
  GtkWidgetAccessible parent_instance;
  GHashTable *children; /* object key → CanvasChild */
  Object selection;     /* as was told last, */
  GArray *selected;     /* with all that is selected beside it */
  char *name, *description;
};

G_DEFINE_TYPE (CanvasAccessible, canvas_accessible, GTK_TYPE_WIDGET_ACCESSIBLE)

/* Returns: NULL when the widget is gone. */
static Canvas *
get_canvas (AtkObject *object)
{
  GtkWidget *widget = gtk_accessible_get_widget (GTK_ACCESSIBLE (object));

  if (widget == NULL || canvas_get_session (HULL2VD_CANVAS (widget)) == NULL)
    return NULL;
  return HULL2VD_CANVAS (widget);
}

static gpointer
key_of (Object object)
{
  return GSIZE_TO_POINTER (((gsize)object.number << 3) | object.kind);
}

static AtkObject *
get_child (CanvasAccessible *accessible, Canvas *canvas, Object object)
{
  AtkObject *child
      = g_hash_table_lookup (accessible->children, key_of (object));

  if (child == NULL) {
    child = canvas_child_new (canvas, object);
    g_hash_table_insert (accessible->children, key_of (object), child);
  }
  return child;
}

static const char *
canvas_accessible_get_name (AtkObject *object)
{
  CanvasAccessible *accessible = HULL2VD_CANVAS_ACCESSIBLE (object);
  Canvas *canvas = get_canvas (object);

  if (canvas == NULL)
    return NULL;
  g_free (accessible->name);
  accessible->name = session_get_pane_title (canvas_get_session (canvas),
                                             canvas_get_pane (canvas));
  return accessible->name;
}

static guint
count_objects (Canvas *canvas)
{
  return HULL2VD_CANVAS_GET_CLASS (canvas)->count_objects (canvas);
}

/* What there is and what has just happened. */
static char *
describe (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);
  g_autofree char *sentence = session_narrate (session);
  const guint n_sites = session_get_set (session)->n_sites;
  g_autofree char *all = g_strdup_printf (
      ngettext ("%u site. %s", "%u sites. %s", n_sites), n_sites, sentence);

  if (count_objects (canvas) <= CANVAS_LISTED)
    return g_steal_pointer (&all);
  /* Translators: %s are sentences; what a screen reader can list */
  return g_strdup_printf (
      _ ("%s The first %d objects are listed; Tab goes to all of them."), all,
      CANVAS_LISTED);
}

static const char *
canvas_accessible_get_description (AtkObject *object)
{
  CanvasAccessible *accessible = HULL2VD_CANVAS_ACCESSIBLE (object);
  Canvas *canvas = get_canvas (object);

  if (canvas == NULL)
    return NULL;
  g_free (accessible->description);
  accessible->description = describe (canvas);
  return accessible->description;
}

/* Sites come first, and to count all else takes time. */
static int
count_listed (Canvas *canvas)
{
  Session *session = canvas_get_session (canvas);

  if (!session_is_answering (session)
      && session_get_set (session)->n_sites >= CANVAS_LISTED)
    return CANVAS_LISTED;
  return (int)MIN (count_objects (canvas), CANVAS_LISTED);
}

static int
canvas_accessible_get_n_children (AtkObject *object)
{
  Canvas *canvas = get_canvas (object);

  return canvas == NULL ? 0 : count_listed (canvas);
}

/* Most often a site has the place of its number. */
int
canvas_accessible_index (GtkWidget *widget, Object object)
{
  Canvas *canvas = HULL2VD_CANVAS (widget);
  CanvasClass *class = HULL2VD_CANVAS_GET_CLASS (canvas);
  const int n = count_listed (canvas);
  const int likely = (int)MIN (object.number, CANVAS_LISTED);

  if (likely < n
      && object_equal (class->get_object (canvas, (guint)likely), object))
    return likely;
  for (int i = 0; i < n; i++)
    if (object_equal (class->get_object (canvas, (guint)i), object))
      return i;
  return -1;
}

static AtkObject *
canvas_accessible_ref_child (AtkObject *object, int index)
{
  CanvasAccessible *accessible = HULL2VD_CANVAS_ACCESSIBLE (object);
  Canvas *canvas = get_canvas (object);

  if (canvas == NULL || index < 0 || index >= count_listed (canvas))
    return NULL;
  return g_object_ref (get_child (
      accessible, canvas,
      HULL2VD_CANVAS_GET_CLASS (canvas)->get_object (canvas, (guint)index)));
}

static AtkStateSet *
canvas_accessible_ref_state_set (AtkObject *object)
{
  AtkStateSet *states = ATK_OBJECT_CLASS (canvas_accessible_parent_class)
                            ->ref_state_set (object);

  atk_state_set_add_state (states, ATK_STATE_MANAGES_DESCENDANTS);
  atk_state_set_add_state (states, ATK_STATE_MULTISELECTABLE);
  return states;
}

static void
canvas_accessible_initialize (AtkObject *object, gpointer data)
{
  ATK_OBJECT_CLASS (canvas_accessible_parent_class)->initialize (object, data);
  atk_object_set_role (object, ATK_ROLE_CANVAS);
}

/* Weak pointers of so many children would each be looked for among all. */
static void
detach_all (CanvasAccessible *accessible)
{
  GHashTableIter iter;
  gpointer child;

  g_hash_table_iter_init (&iter, accessible->children);
  while (g_hash_table_iter_next (&iter, NULL, &child))
    canvas_child_detach (HULL2VD_CANVAS_CHILD (child), FALSE);
  g_hash_table_remove_all (accessible->children);
}

static void
canvas_accessible_widget_unset (GtkAccessible *accessible)
{
  GtkAccessibleClass *parent
      = GTK_ACCESSIBLE_CLASS (canvas_accessible_parent_class);

  detach_all (HULL2VD_CANVAS_ACCESSIBLE (accessible));
  if (parent->widget_unset != NULL)
    parent->widget_unset (accessible);
}

static void
canvas_accessible_finalize (GObject *object)
{
  CanvasAccessible *accessible = HULL2VD_CANVAS_ACCESSIBLE (object);

  detach_all (accessible);
  g_hash_table_unref (accessible->children);
  g_array_unref (accessible->selected);
  g_free (accessible->name);
  g_free (accessible->description);
  G_OBJECT_CLASS (canvas_accessible_parent_class)->finalize (object);
}

static void
canvas_accessible_class_init (CanvasAccessibleClass *class)
{
  AtkObjectClass *atk_class = ATK_OBJECT_CLASS (class);

  G_OBJECT_CLASS (class)->finalize = canvas_accessible_finalize;
  GTK_ACCESSIBLE_CLASS (class)->widget_unset = canvas_accessible_widget_unset;
  atk_class->initialize = canvas_accessible_initialize;
  atk_class->get_name = canvas_accessible_get_name;
  atk_class->get_description = canvas_accessible_get_description;
  atk_class->get_n_children = canvas_accessible_get_n_children;
  atk_class->ref_child = canvas_accessible_ref_child;
  atk_class->ref_state_set = canvas_accessible_ref_state_set;
}

static void
canvas_accessible_init (CanvasAccessible *accessible)
{
  accessible->selected = g_array_new (FALSE, FALSE, sizeof (guint32));
  accessible->children
      = g_hash_table_new_full (NULL, NULL, NULL, g_object_unref);
}

/* Of more children than these none tells of itself: whoever has asked for so
 * many asks again when the canvas says that what it shows has changed. */
#define MANY_CHILDREN 200

/* Sites keep their numbers and tell where they are now; facets are numbered
 * anew. */
static void
renew_children (CanvasAccessible *accessible, guint n_sites)
{
  const gboolean is_told
      = g_hash_table_size (accessible->children) <= MANY_CHILDREN;
  GHashTableIter iter;
  gpointer child;

  g_hash_table_iter_init (&iter, accessible->children);
  while (g_hash_table_iter_next (&iter, NULL, &child)) {
    const Object object
        = canvas_child_get_object (HULL2VD_CANVAS_CHILD (child));

    if (object.kind == OBJECT_SITE && object.number < n_sites) {
      if (is_told)
        canvas_child_tell_name (HULL2VD_CANVAS_CHILD (child));
      continue;
    }
    canvas_child_detach (HULL2VD_CANVAS_CHILD (child), is_told);
    g_hash_table_iter_remove (&iter);
  }
}

/* Whether nothing else is selected than was told last; then it is told now. */
static gboolean
is_told (CanvasAccessible *accessible, const SceneLook *look)
{
  GArray *selected = accessible->selected;
  const gsize size = look->n_selected * sizeof (guint32);

  if (object_equal (accessible->selection, look->selection)
      && selected->len == look->n_selected
      && (size == 0 || memcmp (selected->data, look->selected, size) == 0))
    return TRUE;
  accessible->selection = look->selection;
  g_array_set_size (selected, 0);
  if (size > 0)
    g_array_append_vals (selected, look->selected, look->n_selected);
  return FALSE;
}

/* The look changes with each motion of the pointer. */
static void
tell_selected (CanvasAccessible *accessible, const SceneLook *look)
{
  GHashTableIter iter;
  gpointer child;

  if (is_told (accessible, look))
    return;
  g_hash_table_iter_init (&iter, accessible->children);
  while (g_hash_table_iter_next (&iter, NULL, &child))
    canvas_child_tell_selected (HULL2VD_CANVAS_CHILD (child));
}

/* Nothing is made for assistive technology that is not there. */
static CanvasAccessible *
peek_accessible (GtkWidget *canvas)
{
  AtkObject *accessible = gtk_widget_get_accessible (canvas);

  return HULL2VD_IS_CANVAS_ACCESSIBLE (accessible)
             ? HULL2VD_CANVAS_ACCESSIBLE (accessible)
             : NULL;
}

void
canvas_accessible_update (GtkWidget *canvas, guint changes)
{
  CanvasAccessible *accessible = peek_accessible (canvas);

  if (accessible == NULL)
    return;
  if (changes & (CHANGED_SITES | CHANGED_LESSON | CHANGED_QUESTION)) {
    Session *session = canvas_get_session (HULL2VD_CANVAS (canvas));

    renew_children (accessible, session_get_set (session)->n_sites);
    g_signal_emit_by_name (accessible, "visible-data-changed");
  }
  if (changes & (CHANGED_SITES | CHANGED_STEP | CHANGED_LESSON))
    g_object_notify (G_OBJECT (accessible), "accessible-description");
  if (changes & (CHANGED_SITES | CHANGED_LOOK))
    tell_selected (accessible, session_get_look (canvas_get_session (
                                   HULL2VD_CANVAS (canvas))));
}

void
canvas_accessible_focus (GtkWidget *canvas, Object cursor)
{
  CanvasAccessible *accessible = peek_accessible (canvas);

  if (accessible == NULL || cursor.kind == OBJECT_NONE)
    return;
  g_signal_emit_by_name (
      accessible, "active-descendant-changed",
      get_child (accessible, HULL2VD_CANVAS (canvas), cursor));
}
