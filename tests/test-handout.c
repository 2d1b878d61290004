/* Handouts of one lesson, in all parts. What poppler reads in them is judged
 * by test-handout-cli.py. */
#include "handout.h"
#include "learner.h"
#include "moment.h"

#include <string.h>

static const char lesson_text[]
    = "# What a site sees\n\nWords & <more> words.\n\n"
      "> Note: Sources: somebody 1996.\n\n"
      "```lesson\nformat 1\n"
      "sites -0.6 -0.5; 0.7 -0.4; 0.1 0.8; 0.0 0.1; 0.3 -0.1\nminutes "
      "4\n```\n\n"
      "## First\n\nA *long* story & its **end**.\n\n"
      "```steps\ngoto round 1 choose\n```\n\n"
      "## Second\n\n```ask\nbefore round 1 see\nclick visible-facets\n```\n\n"
      "> Note: wait.\n\n"
      "## Third\n\n```ask\nbefore round 1 horizon\nnumber horizon\n```\n\n"
      "## Fourth\n\n```ask\nbefore round 1 cone\nchoose one\n"
      "option more if cone = visible + 2\noption fewer if cone < visible\n"
      "```\n\n"
      "## Fifth\n\n```steps\ngoto round 1 cone\n```\n\n"
      "## Sixth\n\n```steps\nsites 0 0; 1 0; 0 1; 1 1.5; 0.5 0.25\n```\n\n"
      "```ask\nbefore round 1\norder phases\n```\n\n"
      "## Seventh\n\n```ask\ncomplete\ndrag s4 until only-upper\n```\n\n"
      "## Eighth\n\n```ask\ncomplete\nalways cone = visible + 2\n```\n";

static GBytes *
write_handout (const HandoutOptions *options)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (Handout) handout = handout_new (session, options);
  g_autoptr (GError) error = NULL;
  GByteArray *bytes = g_byte_array_new ();
  FILE *file = tmpfile ();
  guint8 buffer[4096];
  gsize n;

  g_assert_true (handout_write (handout, file, NULL, &error));
  g_assert_no_error (error);
  rewind (file);
  while ((n = fread (buffer, 1, sizeof buffer, file)) > 0)
    g_byte_array_append (bytes, buffer, (guint)n);
  fclose (file);
  return g_byte_array_free_to_bytes (bytes);
}

static void
test_same_bytes (void)
{
  /* Notes, blanks, steps, key, stops; each of them with and without another. */
  static const guint choices[] = { 0, 1 | 16, 2 | 8 | 16, 4 | 8, 16 };

  for (guint i = 0; i < G_N_ELEMENTS (choices); i++) {
    const guint bits = choices[i];
    HandoutOptions options;
    g_autoptr (GBytes) first = NULL, second = NULL;

    handout_options_init (&options);
    options.has_notes = (bits & 1) != 0;
    options.has_blanks = (bits & 2) != 0;
    options.has_steps = (bits & 4) != 0;
    options.has_key = (bits & 8) != 0;
    options.has_stops = (bits & 16) != 0;
    first = write_handout (&options);
    second = write_handout (&options);
    g_assert_true (g_bytes_equal (first, second));
  }
}

/* Pages are painted for the screen in any order, and have ink. */
static void
test_pages_are_painted_by_themselves (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (Handout) handout = NULL;
  HandoutOptions options;

  handout_options_init (&options);
  options.has_stops = options.has_blanks = options.has_key = TRUE;
  handout = handout_new (session, &options);
  g_assert_cmpuint (handout_count_pages (handout), >, 2);
  for (guint page = handout_count_pages (handout); page-- > 0;) {
    cairo_surface_t *surface
        = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 595, 842);
    cairo_t *cr = cairo_create (surface);
    gsize n_dark = 0;

    handout_paint (handout, page, cr);
    cairo_surface_flush (surface);
    for (gsize i = 0; i < 595 * 842; i++)
      n_dark += ((guint32 *)(gpointer)cairo_image_surface_get_data (surface))[i]
                    % 256
                < 128;
    g_assert_cmpuint (n_dark, >, 1000);
    g_assert_cmpuint (n_dark, <, 595 * 842 / 4);
    g_assert_cmpint (cairo_status (cr), ==, CAIRO_STATUS_SUCCESS);
    cairo_destroy (cr);
    cairo_surface_destroy (surface);
  }
}

/* Returns: (transfer full): the sixth stop's pictures in round 1. */
static cairo_surface_t *
draw_moment (Session *session, MomentFace face, Phase phase)
{
  static const int width = 360, height = 180;
  cairo_surface_t *surface
      = cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height);
  cairo_t *cr = cairo_create (surface);
  Moment moment = { session, 4, face, 0 };
  g_autoptr (Block) block = NULL;
  Appearance appearance;

  session_set_stop (session, moment.stop);
  g_assert_true (
      session_find_step (session, (Place){ 1, phase }, FALSE, &moment.step));
  appearance_init (&appearance);
  block = moment_block (&moment, MOMENT_VIEWS, &appearance, width, height);
  block_paint (block, cr, 0, 0);
  cairo_destroy (cr);
  cairo_surface_flush (surface);
  return surface;
}

static gboolean
looks_the_same (cairo_surface_t *a, cairo_surface_t *b)
{
  const gsize n = (gsize)cairo_image_surface_get_stride (a)
                  * (gsize)cairo_image_surface_get_height (a);
  const gboolean is_same = memcmp (cairo_image_surface_get_data (a),
                                   cairo_image_surface_get_data (b), n)
                           == 0;

  cairo_surface_destroy (a);
  cairo_surface_destroy (b);
  return is_same;
}

/* What a blank asks for cannot be seen in the picture over it: masked, the
 * pictures of a round are the same before and after anything is found. */
static void
test_masked_pictures_tell_nothing (void)
{
  static const Phase phases[] = { PHASE_SEE, PHASE_HORIZON, PHASE_CONE };
  g_autoptr (Session) session = learner_open (lesson_text, NULL);

  for (guint i = 0; i < G_N_ELEMENTS (phases); i++) {
    g_assert_true (
        looks_the_same (draw_moment (session, MOMENT_MASKED, PHASE_CHOOSE),
                        draw_moment (session, MOMENT_MASKED, phases[i])));
    g_assert_false (
        looks_the_same (draw_moment (session, MOMENT_SHOWN, PHASE_CHOOSE),
                        draw_moment (session, MOMENT_SHOWN, phases[i])));
  }
}

static void
test_full_disk (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (GError) error = NULL;
  FILE *file = fopen ("/dev/full", "wb");
  g_autoptr (Handout) handout = NULL;
  HandoutOptions options;

  g_assert_nonnull (file);
  handout_options_init (&options);
  handout = handout_new (session, &options);
  g_assert_false (handout_write (handout, file, NULL, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_NO_SPACE);
  fclose (file);
}

static void
count_changes (Session *session, guint changes, gpointer user)
{
  (void)session;
  (void)changes;
  *(guint *)user += 1;
}

/* Its pages are played while they are painted. */
static void
test_given_up (void)
{
  g_autoptr (Session) session = learner_open (lesson_text, NULL);
  g_autoptr (GCancellable) wanted = g_cancellable_new ();
  g_autoptr (GError) error = NULL;
  g_autoptr (Handout) handout = NULL;
  FILE *file = tmpfile ();
  HandoutOptions options;
  guint n_changes = 0;

  handout_options_init (&options);
  options.has_stops = TRUE;
  handout = handout_new (session, &options);
  g_signal_connect (session, "changed", G_CALLBACK (count_changes), &n_changes);
  g_assert_true (handout_write (handout, file, wanted, &error));
  g_assert_cmpuint (n_changes, >, 0);
  n_changes = 0;
  rewind (file);
  g_cancellable_cancel (wanted);
  g_assert_false (handout_write (handout, file, wanted, &error));
  g_assert_error (error, G_IO_ERROR, G_IO_ERROR_CANCELLED);
  g_assert_cmpuint (n_changes, ==, 0);
  g_assert_cmpint (ftell (file), ==, 0);
  fclose (file);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/handout/the-same-parts-give-the-same-bytes",
                   test_same_bytes);
  g_test_add_func ("/handout/pages-are-painted-by-themselves",
                   test_pages_are_painted_by_themselves);
  g_test_add_func ("/handout/masked-pictures-tell-nothing",
                   test_masked_pictures_tell_nothing);
  g_test_add_func ("/handout/a-full-disk-is-said", test_full_disk);
  g_test_add_func ("/handout/of-what-is-given-up-no-page-is-played",
                   test_given_up);
  return g_test_run ();
}
