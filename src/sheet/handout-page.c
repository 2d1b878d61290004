/* A lesson on one page. What there is of it is set large at first, then
 * smaller, then less of it, until it fits. */
#include "handout-private.h"

#include "form.h"
#include "gist.h"
#include "prose-block.h"
#include "stop-state.h"

#include <glib/gi18n.h>

#define MOST_PICTURES 4
#define ITEM_GAP 4.0

/* How much there is on the page, and how large. */
typedef struct Fit {
  double scale; /* of letters */
  guint n_pictures, n_facts, n_questions;
} Fit;

static const Fit fits[] = {
  { 1.0, 4, 99, 99 },  { 0.95, 4, 99, 99 }, { 0.9, 4, 99, 99 },
  { 0.9, 4, 12, 12 },  { 0.87, 4, 10, 10 }, { 0.87, 4, 8, 8 },
  { 0.87, 2, 12, 12 }, { 0.87, 2, 8, 8 },   { 0.87, 2, 5, 5 },
  { 0.8, 2, 3, 3 },    { 0.8, 0, 3, 3 },    { 0.7, 0, 0, 0 },
};

typedef struct Sheet {
  Handout *handout;
  GPtrArray *facts; /* of markup */
  GArray *pictures; /* of guint: stops */
  GArray *listings; /* of guint: stops that show one */
} Sheet;

/* What is worth a picture */

static gboolean
looks_like (const LessonStop *a, const LessonStop *b)
{
  const StopState *p = a->state, *q = b->state;

  return p->run == q->run && p->step == q->step
         && p->exhibit_kind == q->exhibit_kind
         && p->exhibit_step == q->exhibit_step
         && p->look.layers == q->look.layers;
}

static gboolean
is_among_stops (const GArray *stops, guint stop)
{
  for (guint i = 0; i < stops->len; i++)
    if (g_array_index (stops, guint, i) == stop)
      return TRUE;
  return FALSE;
}

static gboolean
is_like_another (const Lesson *lesson, guint stop, const GArray *stops)
{
  for (guint i = 0; i < stops->len; i++)
    if (looks_like (lesson_stop (lesson, stop),
                    lesson_stop (lesson, g_array_index (stops, guint, i))))
      return TRUE;
  return FALSE;
}

/* A stop that asks nothing and at which something has happened. */
static gboolean
has_picture (const LessonStop *stop)
{
  return stop->question == NULL
         && (stop->state->step > 0
             || stop->state->exhibit_kind != EXHIBIT_LIFTS);
}

/* Leaves so many of them, evenly spread. */
static void
thin_out (GArray *stops, guint most)
{
  const guint n = stops->len;

  if (n <= most)
    return;
  for (guint i = 0; i < most; i++)
    g_array_index (stops, guint, i)
        = g_array_index (stops, guint, (2 * i + 1) * n / (2 * most));
  g_array_set_size (stops, most);
}

static int
compare_stops (gconstpointer a, gconstpointer b)
{
  const guint p = *(const guint *)a, q = *(const guint *)b;

  return p < q ? -1 : p > q;
}

/* Pictures that differ; and where they do not fill their rows, one that
 * differs in what is loud, or in where it is seen from. */
static GArray *
find_pictures (const Lesson *lesson)
{
  GArray *stops = g_array_new (FALSE, FALSE, sizeof (guint));

  for (guint i = 0; i < lesson->stops->len; i++)
    if (has_picture (lesson_stop (lesson, i))
        && !is_like_another (lesson, i, stops))
      g_array_append_val (stops, i);
  thin_out (stops, MOST_PICTURES);
  for (guint i = lesson->stops->len; i-- > 0 && stops->len % 2 != 0;)
    if (lesson_stop (lesson, i)->question == NULL && !is_among_stops (stops, i))
      g_array_append_val (stops, i);
  g_array_sort (stops, compare_stops);
  return stops;
}

/* The stops that show a listing for the first time. */
static GArray *
find_listings (const Lesson *lesson)
{
  GArray *stops = g_array_new (FALSE, FALSE, sizeof (guint));
  guint seen = 1u << LISTING_QUICKHULL;

  for (guint i = 0; i < lesson->stops->len && stops->len < 2; i++) {
    const Listing listing = lesson_stop (lesson, i)->state->listing;

    if ((seen & 1u << listing) == 0)
      g_array_append_val (stops, i);
    seen |= 1u << listing;
  }
  return stops;
}

static GPtrArray *
find_facts (const Lesson *lesson)
{
  GPtrArray *facts = g_ptr_array_new_with_free_func (g_free);

  for (guint i = 0; i < lesson->stops->len; i++) {
    const char *prose = lesson_stop (lesson, i)->prose;
    g_autoptr (GPtrArray) found = gist_facts (prose != NULL ? prose : "");

    for (guint k = 0; k < found->len; k++)
      g_ptr_array_add (facts, g_strdup (g_ptr_array_index (found, k)));
  }
  return facts;
}

static int
compare_lengths (gconstpointer a, gconstpointer b)
{
  const glong n = g_utf8_strlen (*(const char *const *)a, -1);
  const glong m = g_utf8_strlen (*(const char *const *)b, -1);

  return n < m ? 1 : n > m ? -1 : 0;
}

/* Where there is no room for all the longest stay: what a term means takes
 * more words than what happens once.
 *
 * Returns: (transfer full): the set of the @n longest. */
static GHashTable *
longest (const GPtrArray *facts, guint n)
{
  GHashTable *kept = g_hash_table_new (NULL, NULL);
  g_autofree gpointer *sorted
      = g_memdup2 (facts->pdata, facts->len * sizeof (gpointer));

  if (facts->len > 0)
    qsort (sorted, facts->len, sizeof (gpointer), compare_lengths);
  for (guint i = 0; i < MIN (facts->len, n); i++)
    g_hash_table_add (kept, sorted[i]);
  return kept;
}

/* Parts of the page */

static Block *
captioned (const Handout *handout, guint stop, double width)
{
  Block *stack = block_stack (width);
  g_autofree char *title = g_strdup_printf (
      "%u  %s", stop + 1, lesson_stop (handout->lesson, stop)->title);

  block_add (stack, handout_picture (handout, stop, MOMENT_SHOWN, width));
  block_add_below (stack, handout_words (handout, TEXT_SMALL, width, title), 3);
  return stack;
}

static Block *
listed (const Handout *handout, guint stop, double width)
{
  moment_enter (&(Moment){ handout->session, stop, MOMENT_SHOWN, MOMENT_NONE });
  return handout_listing (handout, width);
}

typedef Block *(*MakeCell) (const Handout *handout, guint stop, double width);

/* Two in a row; one alone is as wide as the page. */
static void
add_grid (const Sheet *sheet,
          Block *stack,
          const GArray *stops,
          guint n,
          MakeCell make)
{
  const double full = sheet->handout->width;
  const double width = stops->len == 1 ? full : (full - COLUMN_GAP) / 2;

  for (guint i = 0; i < MIN (stops->len, n); i += 2) {
    Block *columns = block_columns (COLUMN_GAP);

    for (guint k = i; k < MIN (MIN (stops->len, n), i + 2); k++)
      block_add (columns,
                 make (sheet->handout, g_array_index (stops, guint, k), width));
    block_add_below (stack, columns, i == 0 ? 12 : 8);
  }
}

static void
add_item (const Sheet *sheet, Block *stack, const char *markup, FormMark mark)
{
  block_add_below (
      stack, form_choice (&sheet->handout->press, stack->width, markup, mark),
      ITEM_GAP);
}

static Block *
facts_column (const Sheet *sheet, guint n, double width)
{
  Block *stack = block_stack (width);
  g_autoptr (GHashTable) kept = longest (sheet->facts, n);

  block_add (stack, handout_words (sheet->handout, TEXT_LABEL, width,
                                   _ ("Terms and facts")));
  for (guint i = 0; i < sheet->facts->len; i++)
    if (g_hash_table_contains (kept, g_ptr_array_index (sheet->facts, i)))
      add_item (sheet, stack, g_ptr_array_index (sheet->facts, i), FORM_SOLID);
  return stack;
}

static char *
number_labels (const Question *question)
{
  g_autoptr (GString) labels = g_string_new (NULL);

  for (guint i = 0; i < question->quantities->len; i++)
    g_string_append_printf (
        labels, "%s%s", i == 0 ? "" : ", ",
        quantity_label (g_array_index (question->quantities, Quantity, i)));
  /* Translators: what is to be predicted: triangles that go, new ones … */
  return g_markup_printf_escaped (_ ("Predict: %s."), labels->str);
}

/* The first paragraph of what a stop asks; of numbers, which ones. */
static char *
short_question (const LessonStop *stop)
{
  g_autofree char *prompt = question_prompt (stop->question, &stop->occasion);
  g_autoptr (GPtrArray) blocks = prose_to_blocks (prompt);

  if (stop->question->prompt == NULL
      && stop->question->kind == QUESTION_NUMBERS)
    return number_labels (stop->question);
  return g_strdup (blocks->len > 0
                       ? ((ProseBlock *)g_ptr_array_index (blocks, 0))->markup
                       : "");
}

static Block *
questions_column (const Sheet *sheet, guint n, double width)
{
  const Handout *handout = sheet->handout;
  Block *stack = block_stack (width);
  guint n_added = 0;

  block_add (stack,
             handout_words (handout, TEXT_LABEL, width, _ ("Questions")));
  for (guint i = 0; i < handout->lesson->stops->len && n_added < n; i++) {
    g_autofree char *markup = NULL;

    if (!handout_asks (handout, i))
      continue;
    markup = short_question (lesson_stop (handout->lesson, i));
    add_item (sheet, stack, markup, FORM_EMPTY);
    n_added += 1;
  }
  return stack;
}

/* Side by side; where there are none of one kind the others have the page. */
static void
add_words (const Sheet *sheet, Block *stack, const Fit *fit)
{
  const Handout *handout = sheet->handout;
  const gboolean has_facts = sheet->facts->len > 0;
  const gboolean has_questions = handout_count_questions (handout) > 0;
  const double width = has_facts && has_questions
                           ? (handout->width - COLUMN_GAP) / 2
                           : handout->width;
  Block *columns = block_columns (COLUMN_GAP);

  if (has_facts)
    block_add (columns, facts_column (sheet, fit->n_facts, width));
  if (has_questions)
    block_add (columns, questions_column (sheet, fit->n_questions, width));
  block_add_below (stack, columns, 12);
}

static Block *
compose (Sheet *sheet, const Fit *fit)
{
  Handout *handout = sheet->handout;
  const guint n_pictures
      = sheet->listings->len > 0 ? MIN (fit->n_pictures, 2) : fit->n_pictures;
  g_autofree char *under = handout_measures (handout, FALSE);
  Block *stack = block_stack (handout->width);
  Block *sources;

  handout->press.scale = fit->scale;
  handout_head (handout, stack, under);
  add_grid (sheet, stack, sheet->pictures, n_pictures, captioned);
  add_grid (sheet, stack, sheet->listings, fit->n_pictures, listed);
  add_words (sheet, stack, fit);
  sources = handout_sources (handout);
  if (sources != NULL)
    block_add_below (stack, sources, 10);
  return stack;
}

/* What does not fit even then is left out. */
static Block *
compose_one_page (Sheet *sheet)
{
  const double most = pages_height (sheet->handout->pages);
  Block *page = NULL, *rest;

  for (guint i = 0; i < G_N_ELEMENTS (fits); i++) {
    if (page != NULL)
      block_free (page);
    page = compose (sheet, &fits[i]);
    if (page->height <= most)
      return page;
  }
  rest = block_split (page, most);
  if (rest != NULL)
    block_free (rest);
  return page;
}

void
handout_add_page (Handout *handout)
{
  Sheet sheet = { .handout = handout,
                  .facts = find_facts (handout->lesson),
                  .pictures = find_pictures (handout->lesson),
                  .listings = find_listings (handout->lesson) };
  Block *page = compose_one_page (&sheet);

  page->title = g_strdup (handout->lesson->title);
  page->level = 1;
  pages_add (handout->pages, page, 0);
  handout->press.scale = 1;
  handout_add_lines (handout);
  g_ptr_array_unref (sheet.facts);
  g_array_unref (sheet.pictures);
  g_array_unref (sheet.listings);
}
