#include "export-dialog.h"

#include "session-picture.h"

#include <glib/gi18n.h>

/* Sides of the sample, px. */
#define SAMPLE_WIDTH 400.0
#define SAMPLE_HEIGHT 220.0
#define SQUARE_PX 8 /* of the chequered ground of what is transparent */

struct _ExportDialog {
  GtkDialog parent_instance;
  Session *session;
  GtkComboBox *view, *format, *theme;
  GtkSpinButton *width, *height, *scale;
  GtkToggleButton *transparent;
  GtkLabel *size;
  GtkWidget *sample, *export_button;
};

G_DEFINE_TYPE (ExportDialog, export_dialog, GTK_TYPE_DIALOG)

static PictureView
get_view (ExportDialog *dialog)
{
  return (PictureView)gtk_combo_box_get_active (dialog->view);
}

PictureFormat
export_dialog_get_format (ExportDialog *dialog)
{
  return (PictureFormat)gtk_combo_box_get_active (dialog->format);
}

void
export_dialog_fill (ExportDialog *dialog, Picture *picture, Theme *theme)
{
  Session *session = dialog->session;
  Appearance appearance = *session_get_appearance (session);
  const char *name = gtk_combo_box_get_active_id (dialog->theme);

  picture_init (picture, get_view (dialog), session_get_frame (session));
  session_picture_take (picture, session);
  picture->width = gtk_spin_button_get_value (dialog->width);
  picture->height = gtk_spin_button_get_value (dialog->height);
  picture->scale = gtk_spin_button_get_value (dialog->scale);
  picture->is_transparent = gtk_toggle_button_get_active (dialog->transparent);
  /* Any other name is that of the theme on the screen. */
  theme_kind_parse (name, &appearance.theme);
  theme_init (theme, &appearance);
  picture->theme = theme;
}

/* Sample */

static void
draw_chequers (cairo_t *cr, double width, double height)
{
  cairo_set_source_rgb (cr, 0.8, 0.8, 0.8);
  cairo_paint (cr);
  cairo_set_source_rgb (cr, 0.95, 0.95, 0.95);
  for (int y = 0; y * SQUARE_PX < height; y++)
    for (int x = y % 2; x * SQUARE_PX < width; x += 2)
      cairo_rectangle (cr, x * SQUARE_PX, y * SQUARE_PX, SQUARE_PX, SQUARE_PX);
  cairo_fill (cr);
}

static gboolean
on_draw_sample (GtkWidget *widget, cairo_t *cr, ExportDialog *dialog)
{
  const double room[2] = { gtk_widget_get_allocated_width (widget),
                           gtk_widget_get_allocated_height (widget) };
  Picture picture;
  Theme theme;
  double factor;

  export_dialog_fill (dialog, &picture, &theme);
  factor = MIN (room[0] / picture.width, room[1] / picture.height);
  cairo_translate (cr, (room[0] - factor * picture.width) / 2,
                   (room[1] - factor * picture.height) / 2);
  cairo_rectangle (cr, 0, 0, factor * picture.width, factor * picture.height);
  cairo_clip (cr);
  draw_chequers (cr, room[0], room[1]);
  cairo_scale (cr, factor, factor);
  picture_paint (&picture, session_get_frame (dialog->session), cr);
  return TRUE;
}

/* What the numbers make of the picture. */
static void
update (ExportDialog *dialog)
{
  const gboolean is_png = export_dialog_get_format (dialog) == PICTURE_PNG;
  g_autofree char *text = NULL;
  Picture picture;
  Theme theme;
  gboolean is_good;

  export_dialog_fill (dialog, &picture, &theme);
  is_good = picture_has_good_size (&picture);
  text = is_good ? g_strdup_printf (
             is_png ? _ ("%.0f × %.0f pixels") : _ ("%.0f × %.0f points"),
             picture.width * picture.scale, picture.height * picture.scale)
                 : g_strdup_printf (_ ("At most %d × %d"), PICTURE_MOST,
                                    PICTURE_MOST);
  gtk_label_set_text (dialog->size, text);
  gtk_widget_set_sensitive (dialog->export_button, is_good);
  gtk_widget_queue_draw (dialog->sample);
}

/* Both views are twice as wide as one. */
static void
on_view_changed (ExportDialog *dialog)
{
  const double height = gtk_spin_button_get_value (dialog->height);

  gtk_spin_button_set_value (
      dialog->width, get_view (dialog) == PICTURE_BOTH ? 2 * height : height);
  update (dialog);
}

static void
connect_controls (ExportDialog *dialog)
{
  GtkWidget *controls[]
      = { GTK_WIDGET (dialog->format), GTK_WIDGET (dialog->theme) };
  GtkSpinButton *numbers[] = { dialog->width, dialog->height, dialog->scale };

  g_signal_connect_swapped (dialog->view, "changed",
                            G_CALLBACK (on_view_changed), dialog);
  for (guint i = 0; i < G_N_ELEMENTS (controls); i++)
    g_signal_connect_swapped (controls[i], "changed", G_CALLBACK (update),
                              dialog);
  for (guint i = 0; i < G_N_ELEMENTS (numbers); i++)
    g_signal_connect_swapped (numbers[i], "value-changed", G_CALLBACK (update),
                              dialog);
  g_signal_connect_swapped (dialog->transparent, "toggled", G_CALLBACK (update),
                            dialog);
  g_signal_connect (dialog->sample, "draw", G_CALLBACK (on_draw_sample),
                    dialog);
}

static void
on_changed (Session *session, guint changes, ExportDialog *dialog)
{
  (void)session;
  (void)changes;
  update (dialog);
}

ExportDialog *
export_dialog_new (GtkWindow *parent, Session *session)
{
  ExportDialog *dialog = g_object_new (
      EXPORT_DIALOG_TYPE, "transient-for", parent, "modal", TRUE,
      "destroy-with-parent", TRUE, "use-header-bar", 1, NULL);

  dialog->session = g_object_ref (session);
  connect_controls (dialog);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), dialog,
                           0);
  update (dialog);
  return dialog;
}

/* Life */

static void
export_dialog_dispose (GObject *object)
{
  g_clear_object (&HULL2VD_EXPORT_DIALOG (object)->session);
  G_OBJECT_CLASS (export_dialog_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, ExportDialog, name)

static void
export_dialog_class_init (ExportDialogClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = export_dialog_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/export-dialog.ui");
  BIND (view);
  BIND (format);
  BIND (theme);
  BIND (width);
  BIND (height);
  BIND (scale);
  BIND (transparent);
  BIND (size);
  BIND (sample);
  BIND (export_button);
}

/* Labels beside them are not found by all readers. */
static void
name_controls (ExportDialog *dialog)
{
  const struct {
    gpointer control;
    const char *name;
  } rows[] = {
    { dialog->view, _ ("View") },     { dialog->format, _ ("Format") },
    { dialog->theme, _ ("Theme") },   { dialog->width, _ ("Width") },
    { dialog->height, _ ("Height") }, { dialog->scale, _ ("Scale") },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++)
    atk_object_set_name (gtk_widget_get_accessible (rows[i].control),
                         rows[i].name);
}

static void
export_dialog_init (ExportDialog *dialog)
{
  gtk_widget_init_template (GTK_WIDGET (dialog));
  gtk_combo_box_set_active (dialog->view, PICTURE_BOTH);
  gtk_combo_box_set_active (dialog->format, PICTURE_PNG);
  gtk_combo_box_set_active (dialog->theme, 0);
  name_controls (dialog);
  gtk_widget_set_size_request (dialog->sample, (int)SAMPLE_WIDTH,
                               (int)SAMPLE_HEIGHT);
  gtk_dialog_set_default_response (GTK_DIALOG (dialog), GTK_RESPONSE_ACCEPT);
}
