#include "space-note.h"

#include <glib/gi18n.h>

/* NULL: there is nothing to say. */
static const char *
text_for (const Camera *camera)
{
  if (camera_is_from_below (camera))
    return camera->is_mirrored
               ? _ ("Seen from below, left and right as in the plane")
               : _ ("Seen from below, through the plane: mirrored");
  return camera->is_mirrored ? _ ("Mirrored, left and right") : NULL;
}

static void
update (Session *session, GtkLabel *label)
{
  const char *text = text_for (session_get_camera (session));

  gtk_label_set_text (label, text == NULL ? "" : text);
  gtk_widget_set_visible (GTK_WIDGET (label), text != NULL);
}

static void
on_changed (Session *session, guint changes, GtkLabel *label)
{
  if (changes & CHANGED_CAMERA)
    update (session, label);
}

void
space_note_attach (GtkOverlay *overlay, Session *session)
{
  GtkWidget *label = gtk_label_new (NULL);

  gtk_widget_set_halign (label, GTK_ALIGN_CENTER);
  gtk_widget_set_valign (label, GTK_ALIGN_END);
  gtk_widget_set_margin_bottom (label, 8);
  gtk_label_set_line_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_justify (GTK_LABEL (label), GTK_JUSTIFY_CENTER);
  gtk_style_context_add_class (gtk_widget_get_style_context (label), "note");
  gtk_overlay_add_overlay (overlay, label);
  gtk_overlay_set_overlay_pass_through (overlay, label, TRUE);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), label,
                           0);
  update (session, GTK_LABEL (label));
}
