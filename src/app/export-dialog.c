#include "export-dialog.h"

#include "picture-task.h"
#include "session-picture.h"

#include <glib/gi18n.h>
#include <string.h>

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
  PictureTask *task;      /* draws the sample of a large set; or NULL */
  cairo_surface_t *drawn; /* by such a task; or NULL: not yet */
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
is_large (ExportDialog *dialog)
{
  return session_is_large (dialog->session, TRUE);
}

static void
paint_drawn (ExportDialog *dialog, const Picture *picture, cairo_t *cr)
{
  if (dialog->drawn == NULL)
    return;
  cairo_scale (
      cr, picture->width / cairo_image_surface_get_width (dialog->drawn),
      picture->height / cairo_image_surface_get_height (dialog->drawn));
  cairo_set_source_surface (cr, dialog->drawn, 0, 0);
  cairo_paint (cr);
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
  if (is_large (dialog))
    paint_drawn (dialog, &picture, cr);
  else
    picture_paint (&picture, session_get_frame (dialog->session), cr);
  return TRUE;
}

/* Large sets */

/* What is left to be read of a PNG. */
typedef struct Reader {
  const guint8 *data;
  gsize length;
} Reader;

static cairo_status_t
read_more (void *user, unsigned char *data, unsigned int length)
{
  Reader *reader = user;

  if (length > reader->length)
    return CAIRO_STATUS_READ_ERROR;
  memcpy (data, reader->data, length);
  reader->data += length;
  reader->length -= length;
  return CAIRO_STATUS_SUCCESS;
}

static void
drop_drawn (ExportDialog *dialog)
{
  g_clear_pointer (&dialog->drawn, cairo_surface_destroy);
}

static void
on_drawn (PictureFile files[N_PICTURE_FILES],
          const GError *error,
          gpointer user)
{
  ExportDialog *dialog = user;
  Reader reader = { NULL, 0 };

  if (error != NULL)
    return;
  reader.data = g_bytes_get_data (files[0].bytes, &reader.length);
  drop_drawn (dialog);
  dialog->drawn
      = cairo_image_surface_create_from_png_stream (read_more, &reader);
  gtk_widget_queue_draw (dialog->sample);
}

static void
on_task_over (gpointer user)
{
  ExportDialog *dialog = user;

  dialog->task = NULL;
  g_object_unref (dialog);
}

static void
drop_task (ExportDialog *dialog)
{
  if (dialog->task != NULL)
    picture_task_give_up (dialog->task);
}

/* A thread draws the sample; the one before stays until then. */
static void
draw_later (ExportDialog *dialog, const Picture *picture)
{
  const int fine = gtk_widget_get_scale_factor (dialog->sample);
  const PictureFile file = {
    PICTURE_PNG,
    fine * MIN (SAMPLE_WIDTH / picture->width, SAMPLE_HEIGHT / picture->height),
    NULL, NULL
  };

  drop_task (dialog);
  dialog->task
      = picture_task_begin (dialog->session, picture, &file, 1, on_drawn,
                            g_object_ref (dialog), on_task_over);
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
  if (is_good && is_large (dialog))
    draw_later (dialog, &picture);
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
  /* The sample itself is work. */
  if ((changes & ~(guint)CHANGED_WORK) != 0)
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
  ExportDialog *dialog = HULL2VD_EXPORT_DIALOG (object);

  drop_task (dialog);
  drop_drawn (dialog);
  g_clear_object (&dialog->session);
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
