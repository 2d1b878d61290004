#include "expect.h"
#include "lesson-copy.h"
#include "lesson-text.h"
#include "lesson.h"
#include "question-click.h"
#include "scene.h"

#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static Lesson *
parse (const char *text)
{
  g_autoptr (GError) error = NULL;
  Lesson *lesson = lesson_parse (text, strlen (text), "l.md", &error);

  g_assert_no_error (error);
  return lesson;
}

static void
test_a_lesson_is_read (void)
{
  g_autoptr (Lesson) lesson = parse (
      "# The *horizon* `f(x)`\n\nIntro **bold**.\n\n> Note: for me.\n\n"
      "```lesson\n# a comment\nformat 1\n\nsites 0 0; 1 0; 0 1; 1 1.5\n```\n\n"
      "## First & last\n\nText one.\n\nText two.\n\n```steps\n"
      "  goto simplex  \n# nothing\n\nexpect facets 4\n```\n\n"
      "> Note: one.\n\n> A quotation.\n\n> Note: two.\n>\n> Three.\n\n"
      "## Second\n");
  const LessonStop *stop = lesson_stop (lesson, 0);
  const LessonCommand *command = g_ptr_array_index (stop->commands, 0);

  g_assert_cmpstr (lesson->title, ==, "The horizon f(x)");
  g_assert_cmpstr (lesson->prose, ==, "Intro **bold**.\n");
  g_assert_cmpstr (lesson->note, ==, "for me.\n");
  g_assert_cmpuint (lesson->n_sites, ==, 4);
  g_assert_cmpuint (lesson->stops->len, ==, 2);
  g_assert_cmpstr (stop->title, ==, "First & last");
  g_assert_cmpstr (stop->prose, ==,
                   "Text one.\n\nText two.\n\n> A quotation.\n");
  g_assert_cmpstr (stop->note, ==, "one.\n\ntwo.\n\nThree.\n");
  g_assert_cmpuint (stop->line, ==, 14);
  g_assert_cmpuint (stop->commands->len, ==, 2);
  g_assert_cmpstr (command->text, ==, "goto simplex");
  g_assert_cmpuint (command->line, ==, 21);
  g_assert_cmpuint (command->column, ==, 3);
  g_assert_cmpuint (lesson_stop (lesson, 1)->commands->len, ==, 0);
  g_assert_cmpuint (stop->step, ==, lesson_stop (lesson, 1)->step);
}

static void
test_line_ends_and_marks_do_not_matter (void)
{
  g_autoptr (Lesson) plain = parse (STEPS ("goto simplex"));
  g_auto (GStrv) lines = g_strsplit (STEPS ("goto simplex"), "\n", -1);
  g_autofree char *crlf = g_strjoinv ("\r\n", lines);
  g_autofree char *marked = g_strconcat ("\xEF\xBB\xBF", crlf, NULL);
  g_autoptr (Lesson) other = parse (marked);

  g_assert_cmpstr (other->title, ==, plain->title);
  g_assert_cmpuint (lesson_stop (other, 0)->step, ==,
                    lesson_stop (plain, 0)->step);
}

static void
test_every_verb_is_carried_out (void)
{
  g_autoptr (Lesson) lesson = parse (
      STEPS ("goto before round 1 see\nnext event\nnext-event\nnext phase\n"
             "next round\ngoto complete\nback round\nback phase\nback event\n"
             "show circumcircles\nhide labels\ncamera look-up\nfocus horizon\n"
             "select s3\nadd site 0 0.25\nmove site s5 0.25 0.25\n"
             "move-site 5 0.25 0.5\nremove site s5\nsites grid 3 3\n"
             "sites 0 0; 1 0; 0 1; 0.25 0.25\ngoto complete\n"
             "expect sites 4"));
  const LessonStop *stop = lesson_stop (lesson, 0);

  g_assert_cmpuint (stop->commands->len, ==, 22);
  g_assert_cmpuint (stop->step, >, 0);
}

/* A folder with files to name, removed afterwards. */
static char *
make_folder (void)
{
  char *folder = g_dir_make_tmp ("hull2vd-XXXXXX", NULL);
  g_autofree char *below = g_build_filename (folder, "sites", NULL);

  g_assert_cmpint (g_mkdir (below, 0700), ==, 0);
  return folder;
}

static void
put_file (const char *folder, const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);

  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static void
remove_folder (char *folder)
{
  const char *const argv[] = { "rm", "-rf", folder, NULL };

  g_assert_true (g_spawn_sync (NULL, (char **)argv, NULL, G_SPAWN_SEARCH_PATH,
                               NULL, NULL, NULL, NULL, NULL, NULL));
  g_free (folder);
}

static Lesson *
load_with_sites (const char *folder, const char *name, GError **error)
{
  g_autofree char *text
      = g_strdup_printf ("# T\n\n```lesson\nformat 1\nsites file %s\n```\n\n"
                         "## S\n",
                         name);
  g_autofree char *path = g_build_filename (folder, "l.md", NULL);

  put_file (folder, "l.md", text);
  return lesson_load (path, error);
}

static void
test_files_of_sites_are_read_below_the_lesson (void)
{
  char *folder = make_folder ();
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = NULL;

  put_file (folder, "sites/three.txt", "# three\n0 0\n1,0\n0;1\n");
  lesson = load_with_sites (folder, "sites/three.txt", &error);
  g_assert_no_error (error);
  g_assert_cmpuint (lesson->n_sites, ==, 3);
  remove_folder (folder);
}

static void
test_a_bad_file_of_sites_is_named_by_line (void)
{
  char *folder = make_folder ();
  g_autoptr (GError) error = NULL;

  put_file (folder, "sites/bad.txt", "0 0\n1 x\n");
  g_assert_null (load_with_sites (folder, "sites/bad.txt", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_SITES);
  g_assert_nonnull (strstr (error->message, "sites/bad.txt:2: "));
  remove_folder (folder);
}

static void
test_links_pipes_and_folders_are_no_files_of_sites (void)
{
  static const char *const names[]
      = { "sites/out.txt", "sites/pipe", "sites", "sites/zero", "." };
  char *folder = make_folder ();
  g_autofree char *out = g_build_filename (folder, "sites/out.txt", NULL);
  g_autofree char *zero = g_build_filename (folder, "sites/zero", NULL);
  g_autofree char *pipe = g_build_filename (folder, "sites/pipe", NULL);

  g_assert_cmpint (symlink ("/etc/passwd", out), ==, 0);
  g_assert_cmpint (symlink ("/dev/zero", zero), ==, 0);
  g_assert_cmpint (mkfifo (pipe, 0600), ==, 0);
  for (guint i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autoptr (GError) error = NULL;

    g_assert_null (load_with_sites (folder, names[i], &error));
    g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
    g_assert_nonnull (strstr (error->message, "l.md:5:12: "));
  }
  remove_folder (folder);
}

static void
test_links_inside_the_folder_are_followed (void)
{
  char *folder = make_folder ();
  g_autofree char *link = g_build_filename (folder, "sites/link.txt", NULL);
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = NULL;

  put_file (folder, "sites/one.txt", "0 0\n");
  g_assert_cmpint (symlink ("one.txt", link), ==, 0);
  lesson = load_with_sites (folder, "sites/link.txt", &error);
  g_assert_no_error (error);
  remove_folder (folder);
}

/* Plays a lesson in a thread of its own. */
static gpointer
play (gpointer lesson)
{
  GError *error = NULL;

  lesson_play (lesson, &error);
  return error;
}

static GError *
play_apart (const char *text, Lesson **lesson)
{
  g_autoptr (GError) error = NULL;

  *lesson = lesson_parse_unplayed (text, strlen (text), "l.md", &error);
  g_assert_no_error (error);
  g_assert_null (lesson_stop (*lesson, 0)->state);
  return g_thread_join (g_thread_new ("play", play, *lesson));
}

static void
test_a_thread_plays_what_would_be_played_at_once (void)
{
  const char *text = STEPS ("sites random 50 seed 3\n"
                            "goto before round 9 see\nselect s3");
  g_autoptr (Lesson) lesson = parse (text);
  g_autoptr (Lesson) other = NULL;
  g_autoptr (GError) error = play_apart (text, &other);

  g_assert_no_error (error);
  g_assert_cmpuint (lesson->stops->len, ==, other->stops->len);
  for (guint i = 0; i < lesson->stops->len; i++) {
    g_assert_cmpuint (lesson_stop (other, i)->step, >, 0);
    g_assert_cmpuint (lesson_stop (lesson, i)->step, ==,
                      lesson_stop (other, i)->step);
    g_assert_nonnull (lesson_stop (other, i)->state);
  }
}

static void
test_a_thread_says_what_cannot_be_played (void)
{
  const char *text = STEPS ("goto round 99");
  g_autoptr (GError) at_once = NULL, apart = NULL;
  g_autoptr (Lesson) lesson = NULL;

  g_assert_null (lesson_parse (text, strlen (text), "l.md", &at_once));
  apart = play_apart (text, &lesson);
  g_assert_error (apart, LESSON_ERROR, LESSON_ERROR_BROKEN);
  g_assert_cmpstr (apart->message, ==, at_once->message);
}

static void
test_a_lesson_that_is_not_there_cannot_be_opened (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_load ("/no/such/lesson.md", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN);
  g_clear_error (&error);
  g_assert_null (lesson_load ("/tmp", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_CANNOT_OPEN);
}

/* A copy is a lesson of its own: nothing that is there is written over. */
static void
test_a_copy_takes_a_free_name (void)
{
  char *folder = make_folder ();
  g_autofree char *mine = g_build_filename (folder, "mine", NULL);
  g_autofree char *second = g_build_filename (mine, "l-2.md", NULL);
  g_autoptr (GError) error = NULL;
  g_autoptr (Lesson) lesson = NULL;

  put_file (folder, "sites/three.txt", "0 0\n1 0\n0 1\n");
  lesson = load_with_sites (folder, "sites/three.txt", &error);
  g_assert_no_error (error);
  /* Its path, for messages, is that of the file. */
  for (guint i = 0; i < 2; i++) {
    g_autofree char *path = lesson_copy (lesson, mine, &error);
    g_autoptr (Lesson) copy = NULL;

    g_assert_no_error (error);
    copy = lesson_load (path, &error);
    g_assert_no_error (error);
    g_assert_cmpuint (copy->n_sites, ==, 3);
    g_assert_cmpint (g_str_equal (path, second), ==, i == 1);
  }
  remove_folder (folder);
}

static void
test_names_cannot_steer_a_terminal (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_parse ("", 0, "a\n\x1B[2Jb.md", &error));
  g_assert_null (strchr (error->message, '\x1B'));
  g_assert_null (strchr (error->message, '\n'));
}

static void
test_an_endless_file_is_refused (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (lesson_load ("/dev/zero", &error));
  g_assert_error (error, LESSON_ERROR, LESSON_ERROR_BROKEN);
}

/* Whatever can be written in a lesson is in the reference. */
static void
test_the_reference_names_every_key (void)
{
  g_autofree char *path = g_build_filename (g_getenv ("HULL2VD_SOURCE"),
                                            "lessons", "README.md", NULL);
  g_autofree char *reference = NULL;

  g_assert_true (g_file_get_contents (path, &reference, NULL, NULL));
  for (const char *const *key = expect_keys (); *key != NULL; key++) {
    g_autofree char *quoted = g_strdup_printf ("`%s`", *key);

    g_assert_nonnull (strstr (reference, quoted));
  }
  for (const char *const *word = condition_words (); *word != NULL; word++)
    g_assert_nonnull (strstr (reference, *word));
  for (const char *const *kind = click_kind_names (); *kind != NULL; kind++) {
    g_autofree char *line = g_strdup_printf ("`click %s", *kind);

    g_assert_nonnull (strstr (reference, line));
  }
  for (guint i = 0; i < N_LAYERS; i++) {
    g_autofree char *quoted
        = g_strdup_printf ("`%s`", layer_name ((Layer)(1u << i)));

    g_assert_nonnull (strstr (reference, quoted));
  }
}

static const struct {
  const char *name;
  GTestFunc run;
} tests[] = {
  { "/lesson/a-lesson-is-read", test_a_lesson_is_read },
  { "/lesson/line-ends-and-marks-do-not-matter",
    test_line_ends_and_marks_do_not_matter },
  { "/lesson/every-verb-is-carried-out", test_every_verb_is_carried_out },
  { "/lesson/files-of-sites-are-read-below-the-lesson",
    test_files_of_sites_are_read_below_the_lesson },
  { "/lesson/a-bad-file-of-sites-is-named-by-line",
    test_a_bad_file_of_sites_is_named_by_line },
  { "/lesson/links-pipes-and-folders-are-no-files-of-sites",
    test_links_pipes_and_folders_are_no_files_of_sites },
  { "/lesson/links-inside-the-folder-are-followed",
    test_links_inside_the_folder_are_followed },
  { "/lesson/a-thread-plays-what-would-be-played-at-once",
    test_a_thread_plays_what_would_be_played_at_once },
  { "/lesson/a-thread-says-what-cannot-be-played",
    test_a_thread_says_what_cannot_be_played },
  { "/lesson/a-lesson-that-is-not-there-cannot-be-opened",
    test_a_lesson_that_is_not_there_cannot_be_opened },
  { "/lesson/a-copy-takes-a-free-name", test_a_copy_takes_a_free_name },
  { "/lesson/names-cannot-steer-a-terminal",
    test_names_cannot_steer_a_terminal },
  { "/lesson/an-endless-file-is-refused", test_an_endless_file_is_refused },
  { "/lesson/the-reference-names-every-key",
    test_the_reference_names_every_key },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (guint i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add_func (tests[i].name, tests[i].run);
  return g_test_run ();
}
