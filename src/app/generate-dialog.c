#include "generate-dialog.h"

#include "site-gallery.h"
#include "site-source.h"

#include <glib/gi18n.h>

/* What a rule asks for. */
typedef enum RuleNeeds {
  NEEDS_COUNT = 1,
  NEEDS_SEED = 2,
  NEEDS_SIZE = 4, /* columns and rows */
  NEEDS_SET = 8,  /* one of the shipped sets */
} RuleNeeds;

static const struct {
  const char *name; /* as in lessons */
  const char *text;
  guint needs;
} rules[] = {
  { "random", N_ ("All over the square"), NEEDS_COUNT | NEEDS_SEED },
  { "clusters", N_ ("In clusters"), NEEDS_COUNT | NEEDS_SEED },
  { "grid", N_ ("On a grid"), NEEDS_SIZE },
  { "circle", N_ ("Exactly on a circle"), NEEDS_COUNT },
  { "near-circle", N_ ("Near a circle"), NEEDS_COUNT | NEEDS_SEED },
  { "line", N_ ("Exactly on a line"), NEEDS_COUNT },
  { "spiral", N_ ("On a spiral"), NEEDS_COUNT },
  { "kuzmin", N_ ("Crowded in the middle (Kuzmin)"), NEEDS_COUNT | NEEDS_SEED },
  { "file", N_ ("A set with a surprise"), NEEDS_SET },
};

struct _GenerateDialog {
  GtkDialog parent_instance;
  Session *session;
  Site *sites; /* as they are drawn; NULL: there is no such set */
  guint n_sites;
  GtkComboBoxText *rule, *set;
  GtkSpinButton *count, *columns, *rows, *seed;
  GtkWidget *count_label, *size_label, *seed_label, *set_label;
  GtkWidget *size_box, *seed_box, *another;
  GtkWidget *preview;
  GtkLabel *caption, *line;
};

G_DEFINE_TYPE (GenerateDialog, generate_dialog, GTK_TYPE_DIALOG)

static guint
get_rule (GenerateDialog *self)
{
  return (guint)MAX (0, gtk_combo_box_get_active (GTK_COMBO_BOX (self->rule)));
}

static const GalleryEntry *
get_set (GenerateDialog *self)
{
  guint n;
  const GalleryEntry *entries = site_gallery (&n);
  const int set = gtk_combo_box_get_active (GTK_COMBO_BOX (self->set));

  return &entries[CLAMP (set, 0, (int)n - 1)];
}

/* Returns: (transfer full): what the "sites" line of a lesson says. */
static char *
make_line (GenerateDialog *self)
{
  const guint rule = get_rule (self);
  const int count = gtk_spin_button_get_value_as_int (self->count);
  const int seed = gtk_spin_button_get_value_as_int (self->seed);

  if (rules[rule].needs & NEEDS_SET)
    return g_strdup_printf ("file sites/%s.txt", get_set (self)->name);
  if (rules[rule].needs & NEEDS_SIZE)
    return g_strdup_printf ("%s %d %d", rules[rule].name,
                            gtk_spin_button_get_value_as_int (self->columns),
                            gtk_spin_button_get_value_as_int (self->rows));
  if (rules[rule].needs & NEEDS_SEED)
    return g_strdup_printf ("%s %d seed %d", rules[rule].name, count, seed);
  return g_strdup_printf ("%s %d", rules[rule].name, count);
}

static void
load_set (GenerateDialog *self, GError **error)
{
  SiteSet *set = site_gallery_load (get_set (self)->name, error);

  if (set == NULL)
    return;
  self->n_sites = set->n_sites;
  self->sites = g_new (Site, set->n_sites + 1);
  for (guint i = 0; i < set->n_sites; i++)
    self->sites[i] = site_set_given (set, i);
  site_set_free (set);
}

static void
make_sites (GenerateDialog *self, const char *line, GError **error)
{
  gsize fault;

  g_clear_pointer (&self->sites, g_free);
  if (rules[get_rule (self)].needs & NEEDS_SET)
    load_set (self, error);
  else
    self->sites = site_source_make (line, &self->n_sites, &fault, error);
}

static char *
make_caption (GenerateDialog *self)
{
  if (rules[get_rule (self)].needs & NEEDS_SET)
    return g_strdup (_ (get_set (self)->purpose));
  return g_strdup_printf (ngettext ("%u site", "%u sites", self->n_sites),
                          self->n_sites);
}

static void
update (GenerateDialog *self)
{
  g_autofree char *line = make_line (self);
  g_autofree char *shown = g_strconcat ("sites ", line, NULL);
  g_autofree char *caption = NULL;
  g_autoptr (GError) error = NULL;

  make_sites (self, line, &error);
  caption = error != NULL ? g_strdup (error->message) : make_caption (self);
  gtk_label_set_text (self->caption, caption);
  gtk_label_set_text (self->line, shown);
  gtk_dialog_set_response_sensitive (GTK_DIALOG (self), GTK_RESPONSE_ACCEPT,
                                     self->sites != NULL);
  gtk_widget_queue_draw (self->preview);
}

static void
show_needs (GenerateDialog *self)
{
  const guint needs = rules[get_rule (self)].needs;
  const struct {
    guint need;
    GtkWidget *label, *field;
  } rows[] = {
    { NEEDS_COUNT, self->count_label, GTK_WIDGET (self->count) },
    { NEEDS_SIZE, self->size_label, self->size_box },
    { NEEDS_SEED, self->seed_label, self->seed_box },
    { NEEDS_SET, self->set_label, GTK_WIDGET (self->set) },
  };

  for (guint i = 0; i < G_N_ELEMENTS (rows); i++) {
    gtk_widget_set_visible (rows[i].label, (needs & rows[i].need) != 0);
    gtk_widget_set_visible (rows[i].field, (needs & rows[i].need) != 0);
  }
}

static void
on_rule (GtkComboBox *combo, GenerateDialog *self)
{
  (void)combo;
  show_needs (self);
  update (self);
}

static void
on_value (GtkWidget *field, GenerateDialog *self)
{
  (void)field;
  update (self);
}

static void
on_another (GtkButton *button, GenerateDialog *self)
{
  (void)button;
  gtk_spin_button_spin (self->seed, GTK_SPIN_STEP_FORWARD, 1);
}

/* The preview */

#define MARGIN_PX 14.0
#define DOT_PX 2.5

static gboolean
on_draw (GtkWidget *widget, cairo_t *cr, GenerateDialog *self)
{
  const double width = gtk_widget_get_allocated_width (widget);
  const double height = gtk_widget_get_allocated_height (widget);
  const double scale = MIN (width, height) / 2 - MARGIN_PX;
  GtkStyleContext *style = gtk_widget_get_style_context (widget);
  GdkRGBA colour;

  gtk_render_background (style, cr, 0, 0, width, height);
  gtk_render_frame (style, cr, 0, 0, width, height);
  gtk_style_context_get_color (style, gtk_style_context_get_state (style),
                               &colour);
  gdk_cairo_set_source_rgba (cr, &colour);
  for (guint i = 0; self->sites != NULL && i < self->n_sites; i++) {
    cairo_arc (cr, width / 2 + scale * self->sites[i].x,
               height / 2 - scale * self->sites[i].y,
               self->n_sites > 500 ? DOT_PX / 2 : DOT_PX, 0, 2 * G_PI);
    cairo_fill (cr);
  }
  return GDK_EVENT_STOP;
}

/* The answer */

static void
take_sites (GenerateDialog *self)
{
  g_autofree char *edit = g_strdup_printf (
      ngettext ("generating %u site", "generating %u sites", self->n_sites),
      self->n_sites);

  session_replace_sites (self->session, self->sites, self->n_sites, edit, NULL);
}

static void
generate_dialog_response (GtkDialog *dialog, int response)
{
  GenerateDialog *self = HULL2VD_GENERATE_DIALOG (dialog);

  /* What was typed last counts, though Enter was pressed in the field. */
  gtk_spin_button_update (self->count);
  gtk_spin_button_update (self->columns);
  gtk_spin_button_update (self->rows);
  gtk_spin_button_update (self->seed);
  if (response == GTK_RESPONSE_ACCEPT && self->sites != NULL)
    take_sites (self);
  gtk_widget_hide (GTK_WIDGET (dialog));
}

/* Life */

static void
generate_dialog_dispose (GObject *object)
{
  GenerateDialog *self = HULL2VD_GENERATE_DIALOG (object);

  g_clear_pointer (&self->sites, g_free);
  g_clear_object (&self->session);
  G_OBJECT_CLASS (generate_dialog_parent_class)->dispose (object);
}

#define BIND(name)                                                             \
  gtk_widget_class_bind_template_child (widget_class, GenerateDialog, name)

static void
generate_dialog_class_init (GenerateDialogClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = generate_dialog_dispose;
  GTK_DIALOG_CLASS (class)->response = generate_dialog_response;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/generate-dialog.ui");
  BIND (rule);
  BIND (set);
  BIND (count);
  BIND (columns);
  BIND (rows);
  BIND (seed);
  BIND (count_label);
  BIND (size_label);
  BIND (seed_label);
  BIND (set_label);
  BIND (size_box);
  BIND (seed_box);
  BIND (another);
  BIND (preview);
  BIND (caption);
  BIND (line);
}

static void
fill_lists (GenerateDialog *self)
{
  guint n_entries;
  const GalleryEntry *entries = site_gallery (&n_entries);

  for (guint i = 0; i < G_N_ELEMENTS (rules); i++)
    gtk_combo_box_text_append_text (self->rule, _ (rules[i].text));
  for (guint i = 0; i < n_entries; i++)
    gtk_combo_box_text_append_text (self->set, entries[i].name);
  gtk_combo_box_set_active (GTK_COMBO_BOX (self->set), 0);
}

static void
generate_dialog_init (GenerateDialog *self)
{
  GtkSpinButton *spins[4];

  gtk_widget_init_template (GTK_WIDGET (self));
  spins[0] = self->count;
  spins[1] = self->columns;
  spins[2] = self->rows;
  spins[3] = self->seed;
  fill_lists (self);
  g_signal_connect (self->rule, "changed", G_CALLBACK (on_rule), self);
  g_signal_connect (self->set, "changed", G_CALLBACK (on_value), self);
  for (guint i = 0; i < G_N_ELEMENTS (spins); i++)
    g_signal_connect (spins[i], "value-changed", G_CALLBACK (on_value), self);
  g_signal_connect (self->another, "clicked", G_CALLBACK (on_another), self);
  g_signal_connect (self->preview, "draw", G_CALLBACK (on_draw), self);
  g_signal_connect (self, "delete-event",
                    G_CALLBACK (gtk_widget_hide_on_delete), NULL);
  gtk_combo_box_set_active (GTK_COMBO_BOX (self->rule), 0);
}

GtkWidget *
generate_dialog_new (GtkWindow *parent, Session *session)
{
  GenerateDialog *self = g_object_new (
      GENERATE_DIALOG_TYPE, "transient-for", parent, "destroy-with-parent",
      TRUE, "modal", TRUE, "use-header-bar", TRUE, NULL);

  self->session = g_object_ref (session);
  gtk_dialog_set_default_response (GTK_DIALOG (self), GTK_RESPONSE_ACCEPT);
  return GTK_WIDGET (self);
}
