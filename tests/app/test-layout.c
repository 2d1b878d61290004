/* The window in one language: nothing that must be read is cut off, whatever
 * its words are. Needs a display: run by tests/headless.sh.
 * The language is that of LC_ALL and LANGUAGE. */
#include "code-panel.h"
#include "document.h"
#include "hull2vd-application.h"
#include "hull2vd-window.h"
#include "locate.h"
#include "plane-view.h"

#include <locale.h>
#include <string.h>

#define MAX_FAULTS 20

typedef struct Stage {
  Hull2vdApplication *application;
  Hull2vdWindow *window;
  Session *session;
} Stage;

/* What is wrong with one layout. */
typedef struct Inspection {
  GtkWidget *top;
  const char *where; /* "1024 × 768, 07-….md, stop 3" */
  GPtrArray *faults; /* of char* */
} Inspection;

/* Lays out what has changed, and what follows from that; painting would take
 * its time. */
static void
settle (GtkWidget *top)
{
  for (int i = 0; i < 3; i++) {
    gtk_container_check_resize (GTK_CONTAINER (top));
    for (int n = 0; n < 100 && gtk_events_pending (); n++)
      gtk_main_iteration ();
  }
}

static void
wait_ms (GtkWidget *top, int ms)
{
  const gint64 end = g_get_monotonic_time () + ms * G_TIME_SPAN_MILLISECOND;

  while (g_get_monotonic_time () < end) {
    settle (top);
    g_usleep (2000);
  }
}

static void
blame (Inspection *inspection, GtkWidget *widget, const char *fault)
{
  const char *text = GTK_IS_LABEL (widget)
                         ? gtk_label_get_text (GTK_LABEL (widget))
                         : gtk_widget_get_name (widget);
  char *line = g_strdup_printf ("%s: %s: “%s”", inspection->where, fault, text);

  if (g_ptr_array_find_with_equal_func (inspection->faults, line, g_str_equal,
                                        NULL))
    g_free (line);
  else
    g_ptr_array_add (inspection->faults, line);
}

static gboolean
is_pseudo (void)
{
  return g_strcmp0 (g_getenv ("HULL2VD_LANGUAGE"), "pseudo") == 0;
}

/* GTK cuts the title rather than buttons, which is right where words are longer
 * than those of any language. */
static gboolean
may_be_cut (GtkWidget *label)
{
  GtkWidget *bar = gtk_widget_get_ancestor (label, GTK_TYPE_HEADER_BAR);

  return is_pseudo () && bar != NULL
         && gtk_widget_get_ancestor (label, GTK_TYPE_BUTTON) == NULL;
}

static void
inspect_label (Inspection *inspection, GtkWidget *label)
{
  PangoLayout *layout = gtk_label_get_layout (GTK_LABEL (label));
  int width, height;

  if (may_be_cut (label))
    return;
  pango_layout_get_pixel_size (layout, &width, &height);
  if (pango_layout_is_ellipsized (layout))
    blame (inspection, label, "its end is cut off");
  else if (width > gtk_widget_get_allocated_width (label))
    blame (inspection, label, "it is wider than its place");
  else if (height > gtk_widget_get_allocated_height (label))
    blame (inspection, label, "it is higher than its place");
}

/* What is in a scrolled window may be below or above its frame. */
static void
inspect_place (Inspection *inspection, GtkWidget *widget)
{
  const int top_width = gtk_widget_get_allocated_width (inspection->top);
  const int top_height = gtk_widget_get_allocated_height (inspection->top);
  const int width = gtk_widget_get_allocated_width (widget);
  const int height = gtk_widget_get_allocated_height (widget);
  int x, y;

  if (!gtk_widget_translate_coordinates (widget, inspection->top, 0, 0, &x, &y))
    return;
  if (x < 0 || x + width > top_width)
    blame (inspection, widget, "it is not within the width of the window");
  if (gtk_widget_get_ancestor (widget, GTK_TYPE_SCROLLED_WINDOW) == NULL
      && (y < 0 || y + height > top_height))
    blame (inspection, widget, "it is not within the height of the window");
}

static void
inspect (GtkWidget *widget, gpointer user)
{
  Inspection *inspection = user;

  if (!gtk_widget_get_mapped (widget))
    return;
  if (GTK_IS_LABEL (widget))
    inspect_label (inspection, widget);
  if (GTK_IS_LABEL (widget) || GTK_IS_BUTTON (widget) || GTK_IS_ENTRY (widget))
    inspect_place (inspection, widget);
  if (GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), inspect, inspection);
}

static void
inspect_top (GtkWidget *top, const char *where, GPtrArray *faults)
{
  Inspection inspection = { top, where, faults };

  gtk_container_forall (GTK_CONTAINER (top), inspect, &inspection);
}

/* Fails with all faults, each once. */
static void
report (GPtrArray *faults)
{
  for (guint i = 0; i < faults->len && i < MAX_FAULTS; i++)
    g_test_message ("%s", (const char *)g_ptr_array_index (faults, i));
  if (faults->len > 0)
    g_test_fail ();
  g_ptr_array_unref (faults);
}

/* The window is made once: it takes a while. */
static Stage stage;

static void
stage_init (void)
{
  stage.application = hull2vd_application_new ();
  g_assert_true (
      g_application_register (G_APPLICATION (stage.application), NULL, NULL));
  g_application_activate (G_APPLICATION (stage.application));
  stage.window = HULL2VD_WINDOW (
      gtk_application_get_active_window (GTK_APPLICATION (stage.application)));
  settle (GTK_WIDGET (stage.window));
  stage.session = hull2vd_window_get_session (stage.window);
}

static void
resize (int width, int height)
{
  int real_width, real_height;

  gtk_window_resize (GTK_WINDOW (stage.window), width, height);
  for (int i = 0; i < 300; i++) {
    wait_ms (GTK_WIDGET (stage.window), 100);
    gtk_window_get_size (GTK_WINDOW (stage.window), &real_width, &real_height);
    if (real_width == width && real_height == height)
      break;
  }
  wait_ms (GTK_WIDGET (stage.window), 500);
}

static void
test_the_window_is_no_larger_than_a_small_screen (void)
{
  int width, height;

  resize (1024, 768);
  gtk_widget_get_preferred_width (GTK_WIDGET (stage.window), &width, NULL);
  gtk_widget_get_preferred_height (GTK_WIDGET (stage.window), &height, NULL);
  g_assert_cmpint (width, <=, 1024);
  g_assert_cmpint (height, <=, 768);
}

/* One of @n stops, for they differ in their texts alone. */
static void
inspect_lesson (const char *path, guint n, int width, GPtrArray *faults)
{
  g_autofree char *name = g_path_get_basename (path);

  g_assert_true (document_open (stage.session, path, NULL));
  for (guint stop = 0; stop < session_get_n_stops (stage.session); stop += n) {
    g_autofree char *where
        = g_strdup_printf ("%d px, %s, stop %u", width, name, stop + 1);

    session_set_stop (stage.session, stop);
    settle (GTK_WIDGET (stage.window));
    inspect_top (GTK_WIDGET (stage.window), where, faults);
  }
}

static gboolean
is_soak (void)
{
  return g_getenv ("HULL2VD_SOAK") != NULL;
}

/* The pseudo language is longer than any: one lesson in two; of others one in
 * five will do, but in ./dev soak. */
static guint
lesson_stride (void)
{
  if (is_soak ())
    return 1;
  return is_pseudo () ? 2 : 5;
}

/* One of @n stops. */
static void
inspect_lessons (guint n, int width, int height)
{
  GPtrArray *faults = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  resize (width, height);
  for (guint i = 0; i < paths->len; i += lesson_stride ())
    inspect_lesson (g_ptr_array_index (paths, i), is_soak () ? 1 : n, width,
                    faults);
  report (faults);
}

static void
test_nothing_is_cut_off_in_a_large_window (void)
{
  inspect_lessons (8, 1440, 900);
}

static void
test_nothing_is_cut_off_in_a_small_window (void)
{
  inspect_lessons (4, 1024, 768);
}

/* What stays where it is */

typedef struct Search {
  GType type;
  GtkWidget *found;
} Search;

static void
search (GtkWidget *widget, gpointer user)
{
  Search *wanted = user;

  if (wanted->found == NULL && gtk_widget_get_mapped (widget)
      && g_type_is_a (G_OBJECT_TYPE (widget), wanted->type))
    wanted->found = widget;
  if (wanted->found == NULL && GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), search, wanted);
}

/* Returns: (transfer none): the first of its kind that is seen below @top. */
static GtkWidget *
find_widget (GtkWidget *top, GType type)
{
  Search wanted = { type, NULL };

  search (top, &wanted);
  g_assert_nonnull (wanted.found);
  return wanted.found;
}

/* In the largest letters. */
static void
open_large (guint lesson, int width, int height)
{
  g_autoptr (GPtrArray) paths = locate_lesson_files ();

  resize (width, height);
  g_assert_true (
      document_open (stage.session, g_ptr_array_index (paths, lesson), NULL));
  session_set_theme (stage.session, THEME_PROJECTOR);
  wait_ms (GTK_WIDGET (stage.window), 500);
}

static void
assert_same_place (GtkWidget *widget, const GtkAllocation *place)
{
  GtkAllocation now;

  settle (GTK_WIDGET (stage.window));
  gtk_widget_get_allocation (widget, &now);
  /* A word of a legend may cost a pixel, which nobody sees. */
  g_assert_cmpint (ABS (now.x - place->x), <=, 1);
  g_assert_cmpint (ABS (now.width - place->width), <=, 1);
  g_assert_cmpint (now.height, ==, place->height);
}

/* Sentences are of one line or two, and buttons come and go. */
static void
assert_kept_place (int width, int height)
{
  GtkWidget *plane;
  GtkAllocation place;

  open_large (7, width, height);
  plane = find_widget (GTK_WIDGET (stage.window), PLANE_VIEW_TYPE);
  gtk_widget_get_allocation (plane, &place);
  for (guint step = 0; step <= session_get_n_steps (stage.session); step++) {
    session_set_step (stage.session, step);
    assert_same_place (plane, &place);
  }
  g_assert_true (session_perform (stage.session, "", NULL));
  assert_same_place (plane, &place);
  g_assert_true (session_grade (stage.session));
  assert_same_place (plane, &place);
  session_end_performance (stage.session);
}

static void
test_pictures_keep_their_place (void)
{
  assert_kept_place (1024, 768);
  assert_kept_place (1440, 900);
}

static void
assert_no_line_is_cut (void)
{
  GtkWidget *lines
      = find_widget (find_widget (GTK_WIDGET (stage.window), CODE_PANEL_TYPE),
                     GTK_TYPE_LIST_BOX);
  GtkWidget *view = gtk_widget_get_ancestor (lines, GTK_TYPE_VIEWPORT);
  g_autoptr (GList) rows = gtk_container_get_children (GTK_CONTAINER (lines));

  for (GList *node = rows; node != NULL; node = node->next) {
    const int height = gtk_widget_get_allocated_height (node->data);
    int x, y;

    gtk_widget_translate_coordinates (node->data, view, 0, 0, &x, &y);
    g_assert_true (y >= 0 || y + height <= 0);
    /* Of the one at the bottom nothing is painted. */
    g_assert_true (
        (gtk_widget_get_opacity (node->data) > 0.5)
        == (y >= 0 && y + height <= gtk_widget_get_allocated_height (view)));
    if (gtk_style_context_has_class (gtk_widget_get_style_context (node->data),
                                     "current"))
      g_assert_cmpint (y + height, <=, gtk_widget_get_allocated_height (view));
  }
}

static void
test_lines_of_code_are_seen_whole (void)
{
  guint step;

  open_large (7, 1024, 768);
  for (Phase phase = PHASE_CHOOSE; phase <= PHASE_COMPLETE; phase++) {
    g_assert_true (session_find_step (
        stage.session, (Place){ phase == PHASE_COMPLETE ? 0 : 2, phase }, FALSE,
        &step));
    session_set_step (stage.session, step);
    wait_ms (GTK_WIDGET (stage.window), 150);
    assert_no_line_is_cut ();
  }
}

/* Dialogs */

/* Returns: (transfer none): a window beside the main one, or NULL. */
static GtkWidget *
find_dialog (void)
{
  g_autoptr (GList) tops = gtk_window_list_toplevels ();

  for (GList *node = tops; node != NULL; node = node->next)
    if (node->data != (gpointer)stage.window
        && gtk_widget_get_mapped (node->data)
        && gtk_window_get_window_type (node->data) == GTK_WINDOW_TOPLEVEL)
      return node->data;
  return NULL;
}

/* Of the screen, which is higher than a small one, a title bar and a panel take
 * their part. */
#define SMALL_HEIGHT (768 - 57)
#define SMALL_WIDTH 1024

static void
inspect_size (GtkWidget *dialog, const char *action, GPtrArray *faults)
{
  int height;

  gtk_widget_get_preferred_height (dialog, &height, NULL);
  if (height > SMALL_HEIGHT)
    g_ptr_array_add (faults,
                     g_strdup_printf ("%s: it is %d px high", action, height));
  if (gtk_widget_get_allocated_width (dialog) > SMALL_WIDTH)
    g_ptr_array_add (faults,
                     g_strdup_printf ("%s: it is %d px wide", action,
                                      gtk_widget_get_allocated_width (dialog)));
}

static void
inspect_dialog (const char *action, GPtrArray *faults)
{
  GtkWidget *dialog = NULL;

  g_action_group_activate_action (G_ACTION_GROUP (stage.window), action, NULL);
  for (int i = 0; i < 300 && dialog == NULL; i++) {
    wait_ms (GTK_WIDGET (stage.window), 100);
    dialog = find_dialog ();
  }
  if (dialog == NULL)
    g_error ("no dialog: %s", action);
  wait_ms (dialog, 300);
  inspect_top (dialog, action, faults);
  inspect_size (dialog, action, faults);
  gtk_window_close (GTK_WINDOW (dialog));
  wait_ms (GTK_WIDGET (stage.window), 100);
}

static void
test_nothing_is_cut_off_in_dialogs (void)
{
  static const char *const actions[]
      = { "generate", "export-picture", "handout", "export-results",
          "record",   "shortcuts",      "about" };
  GPtrArray *faults = g_ptr_array_new_with_free_func (g_free);

  for (guint i = 0; i < G_N_ELEMENTS (actions); i++)
    inspect_dialog (actions[i], faults);
  report (faults);
}

/* The words of the language are shown, or the tests would say nothing. */
static void
test_the_window_speaks_the_language (void)
{
  const char *word;
  g_autoptr (GPtrArray) paths = locate_lesson_files ();
  g_autoptr (Lesson) lesson = lesson_load (g_ptr_array_index (paths, 1), NULL);

  g_assert_true (
      document_open (stage.session, g_ptr_array_index (paths, 1), NULL));
  settle (GTK_WIDGET (stage.window));
  word = gtk_header_bar_get_title (
      GTK_HEADER_BAR (gtk_window_get_titlebar (GTK_WINDOW (stage.window))));
  g_assert_cmpstr (word, !=, lesson->title);
}

int
main (int argc, char **argv)
{
  int status;

  setlocale (LC_ALL, "");
  locate_translations ();
  gtk_test_init (&argc, &argv, NULL);
  setlocale (LC_ALL, "");
  stage_init ();
  g_test_add_func ("/layout/the-window-speaks-the-language",
                   test_the_window_speaks_the_language);
  g_test_add_func ("/layout/the-window-is-no-larger-than-a-small-screen",
                   test_the_window_is_no_larger_than_a_small_screen);
  g_test_add_func ("/layout/nothing-is-cut-off-in-a-large-window",
                   test_nothing_is_cut_off_in_a_large_window);
  g_test_add_func ("/layout/nothing-is-cut-off-in-a-small-window",
                   test_nothing_is_cut_off_in_a_small_window);
  g_test_add_func ("/layout/pictures-keep-their-place",
                   test_pictures_keep_their_place);
  g_test_add_func ("/layout/lines-of-code-are-seen-whole",
                   test_lines_of_code_are_seen_whole);
  g_test_add_func ("/layout/nothing-is-cut-off-in-dialogs",
                   test_nothing_is_cut_off_in_dialogs);
  status = g_test_run ();
  gtk_widget_destroy (GTK_WIDGET (stage.window));
  g_object_unref (stage.application);
  return status;
}
