/* Blocks and pages. */
#include "block-prose.h"
#include "form.h"
#include "page.h"

#include <string.h>

#define WIDTH 300.0

/* Where each drawing was painted. */
typedef struct Painted {
  GArray *y;     /* of double, on its page */
  GArray *pages; /* of guint */
  guint page;
} Painted;

typedef struct Thing {
  Painted *painted;
  double height;
} Thing;

static void
draw (cairo_t *cr, double width, double height, gpointer data)
{
  Thing *thing = data;
  double x = 0, y = 0;

  cairo_user_to_device (cr, &x, &y);
  cairo_rectangle (cr, 0, 0, width, height);
  cairo_stroke (cr);
  g_assert_cmpfloat (height, ==, thing->height);
  /* A page begins again at the top. */
  if (thing->painted->y->len > 0
      && y <= g_array_index (thing->painted->y, double,
                             thing->painted->y->len - 1))
    thing->painted->page += 1;
  g_array_append_val (thing->painted->y, y);
  g_array_append_val (thing->painted->pages, thing->painted->page);
}

static Block *
thing_new (Painted *painted, double height)
{
  Thing *thing = g_new (Thing, 1);

  *thing = (Thing){ painted, height };
  return block_drawing (WIDTH, height, draw, thing, g_free);
}

static void
painted_init (Painted *painted)
{
  painted->y = g_array_new (FALSE, FALSE, sizeof (double));
  painted->pages = g_array_new (FALSE, FALSE, sizeof (guint));
  painted->page = 0;
}

static void
painted_clear (Painted *painted)
{
  g_array_unref (painted->y);
  g_array_unref (painted->pages);
}

static void
write_pages (Pages *pages)
{
  const PdfWords words = { .title = "Title" };
  g_autoptr (GError) error = NULL;
  g_auto (Press) press = { NULL, 1 };
  FILE *file = tmpfile ();

  press_init (&press);
  g_assert_true (pages_write (pages, &press, &words, file, NULL, &error));
  g_assert_no_error (error);
  fclose (file);
}

/* Random heights: what fits on a page is whole on one, below what came
 * before, and pages are not begun in vain. */
static void
test_no_block_is_torn (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (1);

  for (guint turn = 0; turn < 50; turn++) {
    g_autoptr (Pages) pages = pages_new (paper_find ("a4"));
    g_autofree double *heights = g_new (double, 40);
    const double room = pages_height (pages);
    Painted painted;

    painted_init (&painted);
    for (guint i = 0; i < 40; i++) {
      heights[i] = g_rand_double_range (random, 10, room);
      pages_add (pages, thing_new (&painted, heights[i]), 10);
    }
    write_pages (pages);
    g_assert_cmpuint (painted.y->len, ==, 40);
    for (guint i = 1; i < 40; i++) {
      const double before = g_array_index (painted.y, double, i - 1);
      const double y = g_array_index (painted.y, double, i);
      const double top = g_array_index (painted.y, double, 0);

      if (g_array_index (painted.pages, guint, i)
          == g_array_index (painted.pages, guint, i - 1))
        g_assert_cmpfloat (y, >=, before + heights[i - 1] + 10 - 1e-6);
      else
        g_assert_cmpfloat (heights[i - 1] + 10 + heights[i] + before - top, >,
                           room - 1e-6);
      g_assert_cmpfloat (y + heights[i] - top, <=, room + 1e-6);
    }
    painted_clear (&painted);
  }
}

static void
test_what_is_kept_stays_with_the_next (void)
{
  Painted painted;

  painted_init (&painted);
  for (double filled = 500; filled < 730; filled += 10) {
    g_autoptr (Pages) pages = pages_new (paper_find ("a4"));
    Block *heading = thing_new (&painted, 20);

    g_array_set_size (painted.y, 0);
    g_array_set_size (painted.pages, 0);
    painted.page = 0;
    heading->keeps = TRUE;
    pages_add (pages, thing_new (&painted, filled), 0);
    pages_add (pages, heading, 0);
    pages_add (pages, thing_new (&painted, 100), 0);
    write_pages (pages);
    g_assert_cmpuint (g_array_index (painted.pages, guint, 1), ==,
                      g_array_index (painted.pages, guint, 2));
  }
  painted_clear (&painted);
}

static char *
long_text (guint n_words)
{
  GString *text = g_string_new (NULL);

  for (guint i = 0; i < n_words; i++)
    g_string_append_printf (text, "word%u ", i);
  return g_string_free (text, FALSE);
}

/* Cut where it may be, a text loses no line, and no piece is too high. */
static void
test_a_long_text_is_parted_between_lines (void)
{
  g_autofree char *text = long_text (2000);
  g_auto (Press) press = { NULL, 1 };

  press_init (&press);
  for (double height = 30; height < 400; height += 17) {
    g_autoptr (Block) whole = block_text (&press, TEXT_BODY, WIDTH, text);
    const int n_lines = whole->last;
    Block *piece = whole, *rest;
    GPtrArray *rests = g_ptr_array_new ();
    int n_seen = 0;

    while ((rest = piece->height > height ? block_split (piece, height) : NULL)
           != NULL) {
      g_assert_cmpfloat (piece->height, <=, height);
      g_assert_cmpint (piece->last - piece->first, >=, 2);
      g_assert_cmpint (rest->first, ==, piece->last);
      n_seen += piece->last - piece->first;
      g_ptr_array_add (rests, rest);
      piece = rest;
    }
    n_seen += piece->last - piece->first;
    g_assert_cmpint (n_seen, ==, n_lines);
    g_ptr_array_foreach (rests, (GFunc)(GCallback)block_free, NULL);
    g_ptr_array_unref (rests);
  }
}

/* Columns that no page can hold go on below each other. */
static void
test_columns_too_high_for_a_page_stand (void)
{
  g_autoptr (Pages) pages = pages_new (paper_find ("letter"));
  const double room = pages_height (pages);
  Block *stack = block_stack (WIDTH);
  Block *columns = block_columns (10);
  Painted painted;

  painted_init (&painted);
  for (guint side = 0; side < 2; side++) {
    Block *column = block_stack (WIDTH);

    for (guint i = 0; i < 5; i++)
      block_add (column, thing_new (&painted, room / 4));
    block_add (columns, column);
  }
  block_add (stack, columns);
  pages_add (pages, stack, 0);
  g_assert_cmpuint (pages_count (pages), ==, 3);
  write_pages (pages);
  g_assert_cmpuint (painted.y->len, ==, 10);
  painted_clear (&painted);
}

static void
test_frames_and_columns_measure_their_parts (void)
{
  g_auto (Press) press = { NULL, 1 };
  g_autoptr (Block) frame = block_frame (WIDTH, 6);
  Block *columns = block_columns (10);

  press_init (&press);
  block_add (columns, block_drawing (100, 40, NULL, NULL, NULL));
  block_add (columns, block_drawing (50, 70, NULL, NULL, NULL));
  g_assert_cmpfloat (columns->width, ==, 160);
  g_assert_cmpfloat (columns->height, ==, 70);
  block_add (frame, columns);
  block_add_below (frame, form_lines (50, 2), 5);
  g_assert_cmpfloat (block_inner_width (frame), ==, WIDTH - 12);
  g_assert_cmpfloat (frame->height, ==, 12 + 70 + 5 + 2 * 19);
}

static void
test_prose_hangs_on_its_markers (void)
{
  g_auto (Press) press = { NULL, 1 };
  g_autoptr (Block) prose = NULL;

  press_init (&press);
  prose = block_prose (&press, TEXT_BODY, WIDTH, "one\n\n- two\n- three\n");
  g_assert_cmpuint (prose->parts->len, ==, 3);
  g_assert_cmpint (((Block *)prose->parts->pdata[0])->kind, ==, BLOCK_TEXT);
  g_assert_cmpint (((Block *)prose->parts->pdata[1])->kind, ==, BLOCK_COLUMNS);
  g_assert_cmpfloat (((Block *)prose->parts->pdata[2])->width, ==, WIDTH);
}

static void
test_papers_have_names (void)
{
  g_assert_nonnull (paper_find (paper_names ()[0]));
  g_assert_cmpstr (paper_names ()[0], ==, "a4");
  g_assert_null (paper_find ("a5"));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/page/no-block-is-torn-that-fits-on-a-page",
                   test_no_block_is_torn);
  g_test_add_func ("/page/what-is-kept-stays-with-the-next",
                   test_what_is_kept_stays_with_the_next);
  g_test_add_func ("/page/a-long-text-is-parted-between-lines",
                   test_a_long_text_is_parted_between_lines);
  g_test_add_func ("/page/columns-too-high-for-a-page-stand",
                   test_columns_too_high_for_a_page_stand);
  g_test_add_func ("/page/frames-and-columns-measure-their-parts",
                   test_frames_and_columns_measure_their_parts);
  g_test_add_func ("/page/prose-hangs-on-its-markers",
                   test_prose_hangs_on_its_markers);
  g_test_add_func ("/page/papers-have-names", test_papers_have_names);
  return g_test_run ();
}
