#include "window-private.h"

#include "action.h"
#include "lesson-list.h"
#include "look-popover.h"
#include "progress-keeper.h"
#include "window-recent.h"

#include <glib/gi18n.h>

/* In the place of an action: the files that were used last. */
#define RECENT "recent"

/* Menu items; the empty name ends a section, NULL the menu. */
typedef struct MenuRow {
  const char *text;
  const char *action;
} MenuRow;

static const MenuRow main_rows[] = {
  { N_ ("_New Sites"), "new" },
  { N_ ("_Open…"), "open" },
  { N_ ("Open _Recent"), RECENT },
  { N_ ("_Save Sites"), "save" },
  { N_ ("Save Sites _As…"), "save-as" },
  { N_ ("Make a _Copy of the Lesson"), "adapt-lesson" },
  { N_ ("_Record as Lesson Text"), "record" },
  { N_ ("You Be _QuickHull"), "perform::" },
  { NULL, "" },
  { N_ ("_Generate Sites…"), "generate" },
  { N_ ("A_dd Site at Coordinates…"), "add-site-at" },
  { N_ ("Select A_ll Sites"), "select-all" },
  { N_ ("_Copy Sites"), "copy" },
  { N_ ("_Paste Sites"), "paste" },
  { N_ ("Copy P_icture"), "copy-picture" },
  { N_ ("Snap to G_rid"), "snap" },
  { N_ ("Paper’s _Mouse Buttons"), "paper-bindings" },
  { NULL, "" },
  { N_ ("_Export Picture…"), "export-picture" },
  { N_ ("Export Story_board…"), "storyboard" },
  { N_ ("Export _Handout…"), "handout" },
  { N_ ("Export _Results…"), "export-results" },
  { N_ ("_Forget Progress"), "clear-progress" },
  { NULL, "" },
  { N_ ("_Keyboard Shortcuts"), "shortcuts" },
  { N_ ("Change Ke_ys…"), "change-keys" },
  { N_ ("_About Hull2VD"), "about" },
  { N_ ("_Quit"), "quit" },
  { NULL, NULL },
};

static const MenuRow view_rows[] = {
  { N_ ("_Hull"), "layer-hull" },
  { N_ ("_Paraboloid"), "layer-paraboloid" },
  { N_ ("_Delaunay Triangulation"), "layer-delaunay" },
  { N_ ("_Voronoi Diagram"), "layer-voronoi" },
  { N_ ("All _Circumcircles"), "layer-circumcircles" },
  { N_ ("L_ift Vectors"), "layer-lifts" },
  { N_ ("_Names"), "layer-labels" },
  { N_ ("F_urthest-Site Diagrams"), "layer-furthest" },
  { N_ ("Tangent Pl_anes"), "layer-tangents" },
  { N_ ("_Why It Works"), "layer-why" },
  { N_ ("Pre_view of a Click"), "layer-preview" },
  { NULL, "" },
  { N_ ("Look _Up, Unmirrored"), "camera-look-up-unmirrored" },
  { N_ ("_Fit Both Pictures"), "fit" },
  { N_ ("_Space in a Separate Window"), "detach-space" },
  { N_ ("Full _Screen"), "fullscreen" },
  { N_ ("_Black Screen"), "blank" },
  { N_ ("_All Stops"), "overview" },
  { N_ ("F_reeze What the Class Sees"), "freeze" },
  { N_ ("_Lecturer’s Window"), "lecturer" },
  { NULL, NULL },
};

static const MenuRow exhibit_rows[] = {
  { N_ ("Hull of the _Lifts"), "view::lifts" },
  { N_ ("Hull in the _Plane"), "view::planar" },
  { N_ ("_Two Orders in the Plane"), "view::compare" },
  { N_ ("Rounding: _Signs"), "view::signs" },
  { N_ ("Rounding: _Hull"), "view::rounded" },
  { NULL, NULL },
};

static const MenuRow panel_rows[] = {
  { N_ ("_Lesson"), "panel-lesson" },
  { N_ ("Pseudo-c_ode"), "panel-code" },
  { N_ ("Coun_ters"), "panel-counters" },
  { N_ ("Le_gend"), "panel-legend" },
  { N_ ("N_arration"), "panel-narration" },
  { NULL, NULL },
};

static const MenuRow picture_rows[] = {
  { N_ ("_Both Pictures"), "views::both" },
  { N_ ("_Plane Alone"), "views::plane" },
  { N_ ("_Space Alone"), "views::space" },
  { NULL, NULL },
};

static const MenuRow listing_rows[] = {
  { N_ ("_QuickHull"), "listing::quickhull" },
  { N_ ("_Hull, as Printed in 2004"), "listing::hull-2004" },
  { N_ ("Hull, _Corrected"), "listing::hull-corrected" },
  { N_ ("_Diagrams, as Printed in 2004"), "listing::diagrams-2004" },
  { N_ ("Diagrams, C_orrected"), "listing::diagrams-corrected" },
  { NULL, NULL },
};

static const MenuRow theme_rows[] = {
  { N_ ("_Light"), "theme::light" },
  { N_ ("_Paper of 2004"), "theme::paper" },
  { N_ ("P_rojector"), "theme::projector" },
  { N_ ("_Dark"), "theme::dark" },
  { N_ ("Pri_nt"), "theme::print" },
  { N_ ("High _Contrast"), "theme::contrast" },
  { NULL, NULL },
};

/* Scales that can be told apart; D-Bus takes any. */
static const MenuRow scale_rows[] = {
  { N_ ("Half"), "0.5" },   { N_ ("Three Quarters"), "0.75" },
  { N_ ("Normal"), "1.0" }, { N_ ("One and a Half"), "1.5" },
  { N_ ("Double"), "2.0" }, { N_ ("Triple"), "3.0" },
  { NULL, NULL },
};

static GMenuModel *
make_menu (const MenuRow *rows, GMenu *recent)
{
  GMenu *menu = g_menu_new ();
  g_autoptr (GMenu) section = g_menu_new ();

  for (; rows->action != NULL; rows++) {
    g_autofree char *action = g_strconcat ("win.", rows->action, NULL);

    if (g_str_equal (rows->action, RECENT)) {
      g_menu_append_submenu (section, _ (rows->text), G_MENU_MODEL (recent));
      continue;
    }
    if (rows->text != NULL) {
      g_menu_append (section, _ (rows->text), action);
      continue;
    }
    g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
    g_object_unref (section);
    section = g_menu_new ();
  }
  g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
  return G_MENU_MODEL (menu);
}

static GMenuModel *
make_scale_menu (const char *name)
{
  GMenu *menu = g_menu_new ();

  for (const MenuRow *row = scale_rows; row->action != NULL; row++) {
    g_autofree char *action = g_strdup_printf ("win.%s(%s)", name, row->action);

    g_menu_append (menu, _ (row->text), action);
  }
  return G_MENU_MODEL (menu);
}

/* Menus within the menu, so that all of it fits on a small screen. */
static void
append_looks (GMenu *menu)
{
  static const struct {
    const char *text;
    const MenuRow *rows;
  } submenus[] = {
    { N_ ("What Is Sho_wn"), exhibit_rows }, { N_ ("Pic_tures"), picture_rows },
    { N_ ("Pane_ls"), panel_rows },          { N_ ("Listin_g"), listing_rows },
    { N_ ("The_me"), theme_rows },
  };
  static const MenuRow scales[] = { { N_ ("Weight of L_ines"), "line-scale" },
                                    { N_ ("Size of Mar_ks"), "mark-scale" },
                                    { N_ ("Si_ze of Names"), "text-scale" } };
  g_autoptr (GMenu) section = g_menu_new ();

  for (guint i = 0; i < G_N_ELEMENTS (submenus); i++) {
    g_autoptr (GMenuModel) submenu = make_menu (submenus[i].rows, NULL);

    g_menu_append_submenu (section, _ (submenus[i].text), submenu);
  }
  for (guint i = 0; i < G_N_ELEMENTS (scales); i++) {
    g_autoptr (GMenuModel) submenu = make_scale_menu (scales[i].action);

    g_menu_append_submenu (section, _ (scales[i].text), submenu);
  }
  g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
}

static void
append_lesson (GMenu *menu, const LessonEntry *entry)
{
  const guint number = lesson_list_number (entry->path);
  /* As wide as a digit. */
  const char *blank = number < 10 ? "\u2007" : "";
  g_autofree char *done
      = lesson_list_progress (progress_keeper_get (), entry->path);
  g_autofree char *title
      = done == NULL ? g_strdup (entry->title)
                     : g_strdup_printf ("%s   (%s)", entry->title, done);
  g_autofree char *text
      = number > 0 ? g_strdup_printf ("%s%u   %s", blank, number, title)
                   : g_strdup (title);
  g_autoptr (GMenuItem) item = g_menu_item_new (text, NULL);

  g_menu_item_set_action_and_target (item, "win.open-file", "s", entry->path);
  g_menu_append_item (menu, item);
}

/* Lessons are read when the menu is wanted for the first time. */
static void
on_lessons_wanted (GtkToggleButton *button, GMenu *menu)
{
  static GPtrArray *lessons;

  if (!gtk_toggle_button_get_active (button))
    return;
  if (lessons == NULL)
    lessons = lesson_list_new ();
  g_menu_remove_all (menu);
  for (guint i = 0; i < lessons->len; i++)
    append_lesson (menu, g_ptr_array_index (lessons, i));
}

static void
add_preset (Hull2vdWindow *window, const char *name)
{
  GtkWidget *button = gtk_button_new ();
  g_autofree char *action = g_strconcat ("win.camera-", name, NULL);
  g_autofree char *icon = g_strconcat ("hull2vd-", name, "-symbolic", NULL);

  gtk_container_add (GTK_CONTAINER (button),
                     gtk_image_new_from_icon_name (icon, GTK_ICON_SIZE_BUTTON));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), action);
  gtk_widget_set_focus_on_click (button, FALSE);
  gtk_widget_set_valign (button, GTK_ALIGN_CENTER);
  gtk_style_context_add_class (gtk_widget_get_style_context (button), "flat");
  gtk_widget_show_all (button);
  gtk_container_add (GTK_CONTAINER (window->space_buttons), button);
}

/* The files may have become others since the menu was open last. */
static void
on_main_wanted (GtkToggleButton *button, GMenu *recent)
{
  if (gtk_toggle_button_get_active (button))
    window_recent_fill (recent);
}

/* Why some layers cannot be chosen, or NULL: all of them can. */
static const char *
missing_layers (Session *session)
{
  switch (session_get_exhibit_kind (session)) {
  case EXHIBIT_LIFTS:
    return NULL;
  case EXHIBIT_COMPARE:
    return session_get_compares_space (session)
               ? NULL
               : _ ("Two planes: nothing in space");
  case EXHIBIT_PLANAR:
  case EXHIBIT_ROUNDED:
    return _ ("In the plane: names only");
  case EXHIBIT_SIGNS:
    return _ ("A sign map has no layers");
  }
  return NULL;
}

/* The layers are the first section. */
static void
on_exhibit (Session *session, guint changes, GMenu *view_menu)
{
  g_autoptr (GMenuModel) layers = NULL;
  g_autoptr (GMenuItem) item = NULL;

  if ((changes & CHANGED_EXHIBIT) == 0)
    return;
  layers = g_menu_model_get_item_link (G_MENU_MODEL (view_menu), 0,
                                       G_MENU_LINK_SECTION);
  item = g_menu_item_new_section (missing_layers (session), layers);
  g_menu_remove (view_menu, 0);
  g_menu_insert_item (view_menu, 0, item);
}

void
window_menus_init (Hull2vdWindow *window)
{
  g_autoptr (GMenu) recent = g_menu_new ();
  g_autoptr (GMenuModel) main_menu = make_menu (main_rows, recent);
  g_autoptr (GMenuModel) view_menu = make_menu (view_rows, NULL);
  g_autoptr (GMenu) lessons = g_menu_new ();

  append_looks (G_MENU (view_menu));
  g_signal_connect_object (window->session, "changed", G_CALLBACK (on_exhibit),
                           view_menu, 0);
  gtk_menu_button_set_menu_model (window->main_button, main_menu);
  gtk_menu_button_set_menu_model (window->view_button, view_menu);
  gtk_menu_button_set_menu_model (window->lessons_button,
                                  G_MENU_MODEL (lessons));
  g_signal_connect_data (window->lessons_button, "toggled",
                         G_CALLBACK (on_lessons_wanted),
                         g_steal_pointer (&lessons),
                         (GClosureNotify)(void (*) (void))g_object_unref, 0);
  g_signal_connect_data (window->main_button, "toggled",
                         G_CALLBACK (on_main_wanted), g_steal_pointer (&recent),
                         (GClosureNotify)(void (*) (void))g_object_unref, 0);
  for (CameraPreset preset = 0; preset <= CAMERA_SIDE; preset++)
    add_preset (window, camera_preset_name (preset));
  gtk_container_add (GTK_CONTAINER (window->space_buttons),
                     look_popover_button_new (window->session));
}
