#include "site-readout.h"

#include "canvas-name.h"

#include <glib/gi18n.h>

static char *
make_text (Session *session)
{
  const SceneLook *look = session_get_look (session);
  guint n_selected;

  if (look->hover.kind == OBJECT_SITE)
    return canvas_name_place (session, look->hover.number);
  session_get_selected_sites (session, &n_selected);
  if (n_selected > 1)
    return g_strdup_printf (
        ngettext ("%u site selected", "%u sites selected", n_selected),
        n_selected);
  if (look->selection.kind == OBJECT_SITE)
    return canvas_name_place (session, look->selection.number);
  return g_strdup ("");
}

static void
on_changed (Session *session, guint changes, GtkLabel *label)
{
  g_autofree char *text = NULL;

  if ((changes & (CHANGED_SITES | CHANGED_LOOK)) == 0)
    return;
  text = make_text (session);
  gtk_label_set_text (label, text);
  /* Longer numbers than fit are read whole in the tooltip. */
  gtk_widget_set_tooltip_text (GTK_WIDGET (label), *text == '\0' ? NULL : text);
}

void
site_readout_attach (GtkLabel *label, Session *session)
{
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), label,
                           0);
}
