#include "window-recent.h"

#include "document.h"

#include <glib/gi18n.h>
#include <gtk/gtk.h>

#define MOST 8

void
window_recent_add (const char *path)
{
  g_autoptr (GFile) file = g_file_new_for_path (path);
  g_autofree char *uri = g_file_get_uri (file);
  GtkRecentData data = { 0 };

  data.mime_type
      = (char *)(document_is_lesson (path) ? "text/markdown" : "text/plain");
  data.app_name = (char *)g_get_application_name ();
  data.app_exec = (char *)"hull2vd %f";
  gtk_recent_manager_add_full (gtk_recent_manager_get_default (), uri, &data);
}

static int
compare_ages (const void *left, const void *right)
{
  const time_t a = gtk_recent_info_get_modified ((GtkRecentInfo *)left);
  const time_t b = gtk_recent_info_get_modified ((GtkRecentInfo *)right);

  return a > b ? -1 : a < b;
}

static gboolean
is_ours (GtkRecentInfo *info)
{
  return gtk_recent_info_has_application (info, g_get_application_name ())
         && gtk_recent_info_is_local (info) && gtk_recent_info_exists (info);
}

static void
append (GMenu *menu, GtkRecentInfo *info)
{
  g_autofree char *path
      = g_filename_from_uri (gtk_recent_info_get_uri (info), NULL, NULL);
  g_autofree char *name = NULL;
  g_auto (GStrv) parts = NULL;
  g_autofree char *text = NULL;
  g_autoptr (GMenuItem) item = NULL;

  if (path == NULL || !g_utf8_validate (path, -1, NULL))
    return;
  name = g_path_get_basename (path);
  /* An underscore would mark a letter to press. */
  parts = g_strsplit (name, "_", -1);
  text = g_strjoinv ("__", parts);
  item = g_menu_item_new (text, NULL);
  g_menu_item_set_action_and_target (item, "win.open-file", "s", path);
  g_menu_append_item (menu, item);
}

void
window_recent_fill (GMenu *menu)
{
  GList *infos
      = gtk_recent_manager_get_items (gtk_recent_manager_get_default ());
  guint n = 0;

  g_menu_remove_all (menu);
  infos = g_list_sort (infos, compare_ages);
  for (GList *node = infos; node != NULL && n < MOST; node = node->next)
    if (is_ours (node->data)) {
      append (menu, node->data);
      n += 1;
    }
  g_list_free_full (infos, (GDestroyNotify)gtk_recent_info_unref);
}
