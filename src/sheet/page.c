#include "page.h"

#include <cairo-pdf.h>
#include <glib/gi18n.h>

#define MARGIN_SIDE 50.0 /* to be punched */
#define MARGIN_TOP 54.0
#define MARGIN_BOTTOM 54.0
#define HEAD_Y 30.0 /* of the running heading */
#define FOOT_Y 34.0 /* of the page number, from below */

/* A reader that follows an entry of the outline shows so much above it. */
#define OUTLINE_ABOVE 8.0

/* What of a block that will be parted should stand under its heading. */
#define BEGINNING 80.0

/* A page is filled by so much more space between blocks, at most. */
#define MOST_STRETCH 20.0

typedef struct Entry {
  Block *block;
  gboolean begins_page; /* wanted */
  guint page;           /* from 0 */
  double y;
} Entry;

struct Pages {
  const Paper *paper;
  GPtrArray *entries;
  gboolean has_break; /* before the next entry */
  gboolean is_laid_out;
  guint n_pages;
};

static void
entry_free (gpointer data)
{
  Entry *entry = data;

  block_free (entry->block);
  g_free (entry);
}

Pages *
pages_new (const Paper *paper)
{
  Pages *pages = g_new0 (Pages, 1);

  pages->paper = paper;
  pages->entries = g_ptr_array_new_with_free_func (entry_free);
  return pages;
}

void
pages_free (Pages *pages)
{
  g_ptr_array_unref (pages->entries);
  g_free (pages);
}

double
pages_width (const Pages *pages)
{
  return pages->paper->width - 2 * MARGIN_SIDE;
}

double
pages_height (const Pages *pages)
{
  return pages->paper->height - MARGIN_TOP - MARGIN_BOTTOM;
}

static Entry *
entry_new (Block *block, gboolean begins_page)
{
  Entry *entry = g_new0 (Entry, 1);

  entry->block = block;
  entry->begins_page = begins_page;
  return entry;
}

void
pages_add (Pages *pages, Block *block, double above)
{
  block->above = above;
  g_ptr_array_add (pages->entries, entry_new (block, pages->has_break));
  pages->has_break = FALSE;
  pages->is_laid_out = FALSE;
}

void
pages_break (Pages *pages)
{
  pages->has_break = pages->entries->len > 0;
}

/* Laying out */

static Entry *
get_entry (const Pages *pages, guint index)
{
  return g_ptr_array_index (pages->entries, index);
}

/* The height of an entry and of those that it is kept with: of one that will
 * be parted, of its beginning. */
static double
height_of_chain (const Pages *pages, guint index)
{
  double height = get_entry (pages, index)->block->height;

  while (get_entry (pages, index)->block->keeps
         && index + 1 < pages->entries->len) {
    const Block *next = get_entry (pages, ++index)->block;

    height
        += next->above
           + (next->height > pages_height (pages) ? BEGINNING : next->height);
  }
  return height;
}

/* Puts what does not fit into @room into an entry of its own. */
static void
part (Pages *pages, guint index, double room)
{
  Entry *entry = get_entry (pages, index);
  Block *rest;

  block_unfold (entry->block, pages_height (pages));
  if (entry->block->height <= room)
    return;
  rest = block_split (entry->block, room);
  if (rest != NULL)
    g_ptr_array_insert (pages->entries, (int)index + 1,
                        entry_new (rest, FALSE));
}

/* Where an entry goes, below @y of the current page. */
static void
place (Pages *pages, guint index, guint *page, double *y)
{
  const double most = pages_height (pages);
  Entry *entry = get_entry (pages, index);
  const double room = most - *y - entry->block->above;

  if (*y > 0 && entry->block->height > most)
    part (pages, index, room);
  if (*y > 0 && (entry->begins_page || height_of_chain (pages, index) > room)) {
    *page += 1;
    *y = 0;
  }
  if (*y == 0)
    part (pages, index, most);
  entry->page = *page;
  entry->y = *y == 0 ? 0 : *y + entry->block->above;
  *y = entry->y + entry->block->height;
}

/* Whether there may be more space over an entry than is wanted. */
static gboolean
is_loose (const Pages *pages, guint index)
{
  return !get_entry (pages, index - 1)->block->keeps;
}

/* Fills a page, of which the entries @first … @last - 1 are. */
static void
stretch (Pages *pages, guint first, guint last)
{
  const Entry *end = get_entry (pages, last - 1);
  const double left = pages_height (pages) - end->y - end->block->height;
  double more, added = 0;
  guint n_loose = 0;

  for (guint i = first + 1; i < last; i++)
    n_loose += is_loose (pages, i);
  more = MIN (left / MAX (n_loose, 1), MOST_STRETCH);
  for (guint i = first + 1; i < last; i++) {
    added += is_loose (pages, i) ? more : 0;
    get_entry (pages, i)->y += added;
  }
}

/* The last page, and one after which a new one was wanted, end where they
 * end. */
static void
stretch_pages (Pages *pages)
{
  guint first = 0;

  for (guint i = 1; i < pages->entries->len; i++) {
    if (get_entry (pages, i)->page == get_entry (pages, first)->page)
      continue;
    if (!get_entry (pages, i)->begins_page)
      stretch (pages, first, i);
    first = i;
  }
}

guint
pages_count (Pages *pages)
{
  guint page = 0;
  double y = 0;

  if (pages->is_laid_out)
    return pages->n_pages;
  for (guint i = 0; i < pages->entries->len; i++)
    place (pages, i, &page, &y);
  stretch_pages (pages);
  pages->n_pages = page + 1;
  pages->is_laid_out = TRUE;
  return pages->n_pages;
}

double
pages_room (Pages *pages)
{
  const guint n = pages->entries->len;
  const Entry *last;

  pages_count (pages);
  if (n == 0)
    return pages_height (pages);
  last = get_entry (pages, n - 1);
  return pages_height (pages) - last->y - last->block->height;
}

/* Painting */

static void
paint_margins (const Pages *pages,
               guint page,
               const Press *press,
               const char *title,
               cairo_t *cr)
{
  const double right = MARGIN_SIDE + pages_width (pages);
  const double foot = pages->paper->height - FOOT_Y;
  g_autofree char *markup = g_markup_escape_text (title, -1);
  /* Translators: page number and number of pages, at the foot of a page. */
  g_autofree char *number
      = g_strdup_printf (_ ("Page %u of %u"), page + 1, pages->n_pages);
  g_autoptr (Block) head
      = block_text (press, TEXT_SMALL, pages_width (pages), markup);
  g_autoptr (Block) count = block_word (press, TEXT_SMALL, number);
  g_autoptr (Block) maker = block_word (press, TEXT_SMALL, "Hull2VD");

  /* The heading of a long title is its first line. */
  head->last = 1;
  head->tag = count->tag = maker->tag = NULL;
  if (page > 0)
    block_paint (head, cr, MARGIN_SIDE, HEAD_Y);
  block_paint (maker, cr, MARGIN_SIDE, foot);
  block_paint (count, cr, right - count->width, foot);
}

/* The first entry of a page. */
static guint
first_of (const Pages *pages, guint page)
{
  guint i = 0;

  while (i < pages->entries->len && get_entry (pages, i)->page < page)
    i += 1;
  return i;
}

static void
paint_entries (const Pages *pages, guint page, cairo_t *cr)
{
  for (guint i = first_of (pages, page);
       i < pages->entries->len && get_entry (pages, i)->page == page; i++)
    block_paint (get_entry (pages, i)->block, cr, MARGIN_SIDE,
                 MARGIN_TOP + get_entry (pages, i)->y);
}

void
pages_paint (Pages *pages,
             guint page,
             const Press *press,
             const PdfWords *words,
             cairo_t *cr)
{
  const guint n = pages_count (pages);

  g_assert (page < n);
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_rectangle (cr, 0, 0, pages->paper->width, pages->paper->height);
  cairo_fill (cr);
  cairo_set_source_rgb (cr, 0, 0, 0);
  paint_margins (pages, page, press, words->title, cr);
  paint_entries (pages, page, cr);
}

/* Writing */

/* The entries of the outline that the page has, by level. */
typedef struct Outline {
  int entries[4];
} Outline;

static void
add_outline (Pdf *pdf, Outline *outline, const Entry *entry)
{
  const Block *block = entry->block;
  int added;

  if (block->title == NULL || block->level >= G_N_ELEMENTS (outline->entries))
    return;
  added
      = pdf_add_outline (pdf, outline->entries[block->level - 1], block->title,
                         MARGIN_SIDE, MARGIN_TOP + entry->y - OUTLINE_ABOVE);
  for (guint i = block->level; i < G_N_ELEMENTS (outline->entries); i++)
    outline->entries[i] = added;
}

gboolean
pages_write (Pages *pages,
             const Press *press,
             const PdfWords *words,
             FILE *file,
             GCancellable *cancellable,
             GError **error)
{
  const guint n_pages = pages_count (pages);
  Outline outline = { { CAIRO_PDF_OUTLINE_ROOT } };
  guint next = 0;
  Pdf pdf;

  pdf_begin (&pdf, pages->paper, words);
  pdf.cancellable = cancellable;
  cairo_tag_begin (pdf.cr, "Document", NULL);
  for (guint page = 0;
       page < n_pages && !g_cancellable_is_cancelled (cancellable); page++) {
    paint_margins (pages, page, press, words->title, pdf.cr);
    for (; next < first_of (pages, page + 1); next++)
      add_outline (&pdf, &outline, get_entry (pages, next));
    paint_entries (pages, page, pdf.cr);
    pdf_end_page (&pdf);
  }
  cairo_tag_end (pdf.cr, "Document");
  return pdf_end (&pdf, file, error);
}
