#include "hull2vd-application.h"
#include "locate.h"
#include "memory.h"

#include <locale.h>
#include <signal.h>

int
main (int argc, char **argv)
{
  g_autoptr (Hull2vdApplication) application = NULL;

  memory_keep ();
  signal (SIGXFSZ, SIG_IGN); /* what cannot be written is told */
  setlocale (LC_ALL, "");
  locate_translations ();
  application = hull2vd_application_new ();
  return g_application_run (G_APPLICATION (application), argc, argv);
}
