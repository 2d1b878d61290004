/* Asks in which form the results are to be saved and for what name, then
 * where. */
#ifndef RESULTS_DIALOG_H
#define RESULTS_DIALOG_H

#include "hull2vd-window.h"
#include "progress.h"

G_BEGIN_DECLS

#define RESULTS_DIALOG_TYPE (results_dialog_get_type ())
G_DECLARE_FINAL_TYPE (
    ResultsDialog, results_dialog, HULL2VD, RESULTS_DIALOG, GtkDialog)

void results_dialog_show (Hull2vdWindow *window, Progress *progress);

G_END_DECLS

#endif
