#include "direction.h"

static void
keep_one (GtkWidget *widget, gpointer user)
{
  (void)user;
  direction_keep (widget);
}

void
direction_keep (GtkWidget *widget)
{
  gtk_widget_set_direction (widget, GTK_TEXT_DIR_LTR);
  if (GTK_IS_CONTAINER (widget))
    gtk_container_forall (GTK_CONTAINER (widget), keep_one, NULL);
}
