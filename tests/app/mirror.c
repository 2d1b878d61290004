/* Lets a program of GTK be laid out from right to left, as it is where GTK
 * speaks Arabic: GTK_MODULES=…/mirror.so PROGRAM */
#include <gtk/gtk.h>

void gtk_module_init (const int *argc, char ***argv);

void
gtk_module_init (const int *argc, char ***argv)
{
  (void)argc;
  (void)argv;
  gtk_widget_set_default_direction (GTK_TEXT_DIR_RTL);
}
