/* Pictures as other programs show them: librsvg reads the SVG, poppler the
 * PDF, and both show what is in the PNG. */
#include "look-case.h"

#include <glib/gstdio.h>

/* In points. At few pixels to a point poppler puts the strokes of a hatch on
 * whole pixels. */
#define SIZE "--size=200x160"
#define SCALE "--scale=4"
#define DPI "288"

typedef struct Case {
  const char *name;
  const char *lesson;
  const char *options[5];
  const char *word; /* a name in the picture */
} Case;

static const Case cases[] = {
  { "hatches",
    "08-one-insertion-outside.md",
    { "--stop=9", "--theme=print", "--view=both" },
    "s7" },
  { "mat",
    "07-one-insertion-inside.md",
    { "--stop=11", "--theme=paper", "--view=space" },
    "s4" },
  { "layers",
    "04-why-it-works.md",
    { "--stop=4", "--theme=dark", "--view=both",
      "--layers=+circumcircles,+furthest,+why", "--camera=home" },
    "f1" },
};

static char *folder;

static char *
path_of (const char *name, const char *ending)
{
  g_autofree char *file = g_strconcat (name, ending, NULL);

  return g_build_filename (folder, file, NULL);
}

/* Returns: (transfer full): what the program says. */
static char *
run (const char *const *arguments)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *faults = NULL;
  char *words = NULL;
  int status;

  g_spawn_sync (NULL, (char **)arguments, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL,
                &words, &faults, &status, &error);
  g_assert_no_error (error);
  if (status != 0)
    g_error ("%s: %s", arguments[0], faults);
  return words;
}

static void export(const Case *what, const char *ending)
{
  g_autofree char *lesson = g_build_filename (g_getenv ("HULL2VD_SOURCE"),
                                              "lessons", what->lesson, NULL);
  g_autofree char *out = path_of (what->name, ending);
  const gboolean is_png = g_str_equal (ending, ".png");
  const char *arguments[16]
      = { g_getenv ("HULL2VD_CLI"), "export", lesson, SIZE, "-o", out };
  guint n = 6;

  for (guint i = 0; i < G_N_ELEMENTS (what->options); i++)
    if (what->options[i] != NULL)
      arguments[n++] = what->options[i];
  if (is_png)
    arguments[n++] = SCALE;
  g_free (run (arguments));
}

static cairo_surface_t *
load (const char *path)
{
  cairo_surface_t *surface = cairo_image_surface_create_from_png (path);

  g_assert_cmpint (cairo_surface_status (surface), ==, CAIRO_STATUS_SUCCESS);
  return surface;
}

static void
check (const Case *what, const char *reader, const char *read)
{
  g_autofree char *name = g_strdup_printf ("%s-by-%s", what->name, reader);
  g_autofree char *path = path_of (what->name, ".png");
  cairo_surface_t *ours = load (path), *theirs = load (read);

  look_check (name, theirs, ours, LOOK_ALIKE);
  cairo_surface_destroy (ours);
  cairo_surface_destroy (theirs);
}

static void
check_svg (const Case *what)
{
  g_autofree char *svg = path_of (what->name, ".svg");
  g_autofree char *png = path_of (what->name, "-rsvg.png");

  export(what, ".svg");
  g_free (run ((const char *const[]){ "rsvg-convert", "-d", DPI, "-p", DPI,
                                      "-o", png, svg, NULL }));
  check (what, "rsvg", png);
}

static void
check_pdf (const Case *what)
{
  g_autofree char *pdf = path_of (what->name, ".pdf");
  g_autofree char *stem = path_of (what->name, "-poppler");
  g_autofree char *png = g_strconcat (stem, ".png", NULL);
  g_autofree char *words = NULL;

  export(what, ".pdf");
  g_free (run ((const char *const[]){ "pdftoppm", "-png", "-singlefile", "-r",
                                      DPI, pdf, stem, NULL }));
  check (what, "poppler", png);
  words = run ((const char *const[]){ "pdftotext", pdf, "-", NULL });
  if (strstr (words, what->word) == NULL)
    g_error ("%s: %s is no text of it", what->name, what->word);
}

static void
test_readers_show_the_same (gconstpointer data)
{
  export(data, ".png");
  check_svg (data);
  check_pdf (data);
}

static void
remove_folder (void)
{
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  const char *name;

  while ((name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL);

    g_unlink (path);
  }
  g_rmdir (folder);
  g_free (folder);
}

int
main (int argc, char **argv)
{
  int status;

  g_test_init (&argc, &argv, NULL);
  folder = g_dir_make_tmp ("pictures-XXXXXX", NULL);
  for (guint i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *name = g_strdup_printf (
        "/picture-readers/%s-are-shown-alike-by-others", cases[i].name);

    g_test_add_data_func (name, &cases[i], test_readers_show_the_same);
  }
  status = g_test_run ();
  remove_folder ();
  return status;
}
