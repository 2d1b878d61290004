#include "announcement.h"

void
announce (GtkWidget *widget, const char *sentence)
{
  AtkObject *accessible = gtk_widget_get_accessible (widget);

  if (g_signal_lookup ("announcement", G_OBJECT_TYPE (accessible)) != 0)
    g_signal_emit_by_name (accessible, "announcement", sentence);
}
