#include "handout-private.h"

#include "block-prose.h"
#include "form.h"
#include "gist.h"
#include "legend-block.h"
#include "legend.h"

#include <glib/gi18n.h>

/* Room that is left is for the learner's own notes, when it is worth it. */
#define LEAST_LINES 3
#define LINES_HEAD 30.0 /* of their heading */

void
handout_options_init (HandoutOptions *options)
{
  *options = (HandoutOptions){ .paper = paper_find ("a4") };
  appearance_init (&options->appearance);
  options->appearance.theme = THEME_PRINT;
}

/* What the parts share */

char *
handout_stop_name (guint stop)
{
  return g_strdup_printf ("stop-%u", stop + 1);
}

char *
handout_key_name (guint stop)
{
  return g_strdup_printf ("key-%u", stop + 1);
}

Block *
handout_words (const Handout *handout,
               TextStyle style,
               double width,
               const char *words)
{
  g_autofree char *markup = g_markup_escape_text (words, -1);

  return block_text (&handout->press, style, width, markup);
}

Block *
handout_picture (const Handout *handout,
                 guint stop,
                 MomentFace face,
                 double width)
{
  const Moment moment = { handout->session, stop, face, MOMENT_NONE };

  return moment_block (&moment, MOMENT_VIEWS, &handout->options.appearance,
                       width, width / PICTURE_RATIO);
}

/* The legend */

void
handout_tell_of (Handout *handout,
                 Session *session,
                 MomentFace face,
                 MomentView view)
{
  LegendMarks marks = { 0 };
  Theme theme;

  theme_init (&theme, &handout->options.appearance);
  moment_add_marks (session, face, view, &marks);
  legend_gather (handout->legend, session, &marks, &theme);
}

static void
add_legend (Handout *handout)
{
  Block *stack = block_stack (handout->width);

  block_add (stack, form_rule (handout->width));
  block_add_below (
      stack, handout_words (handout, TEXT_LABEL, handout->width, _ ("Legend")),
      PART_GAP);
  block_add_below (stack,
                   legend_block (handout->legend, &handout->press,
                                 &handout->options.appearance, handout->width),
                   PART_GAP);
  stack->title = g_strdup (_ ("Legend"));
  stack->level = 1;
  pages_add (handout->pages, stack, STOP_GAP);
}

static char *
minutes_of (const Lesson *lesson)
{
  return lesson->minutes == 0
             ? g_strdup ("")
             : g_strdup_printf (
                 ngettext ("%u minute", "%u minutes", lesson->minutes),
                 lesson->minutes);
}

guint
handout_count_questions (const Handout *handout)
{
  guint n = 0;

  for (guint i = 0; i < handout->lesson->stops->len; i++)
    n += handout_asks (handout, i);
  return n;
}

/* Adds a part to what stands under a title: "a · b". */
static void
append (GString *text, const char *part)
{
  if (part[0] == '\0')
    return;
  g_string_append (text, text->len > 0 ? " · " : "");
  g_string_append (text, part);
}

char *
handout_measures (const Handout *handout, gboolean counts)
{
  const Lesson *lesson = handout->lesson;
  const guint n_stops = lesson->stops->len;
  const guint n_questions = handout_count_questions (handout);
  g_autofree char *minutes = minutes_of (lesson);
  g_autofree char *stops
      = g_strdup_printf (ngettext ("%u stop", "%u stops", n_stops), n_stops);
  g_autofree char *questions = g_strdup_printf (
      ngettext ("%u question", "%u questions", n_questions), n_questions);
  GString *text = g_string_new (lesson->author);

  append (text, minutes);
  append (text, counts ? stops : "");
  append (text, counts && n_questions > 0 ? questions : "");
  return g_string_free (text, FALSE);
}

void
handout_head (const Handout *handout, Block *stack, const char *under)
{
  const Lesson *lesson = handout->lesson;
  Block *title
      = handout_words (handout, TEXT_TITLE, handout->width, lesson->title);

  title->tag = "H1";
  block_add (stack, title);
  if (under[0] != '\0')
    block_add_below (
        stack, handout_words (handout, TEXT_SMALL, handout->width, under), 2);
  if (lesson->prose != NULL && lesson->prose[0] != '\0')
    block_add_below (
        stack,
        block_prose (&handout->press, TEXT_BODY, handout->width, lesson->prose),
        8);
}

/* Title, measures and introduction. */
static void
add_title (Handout *handout)
{
  const Lesson *lesson = handout->lesson;
  g_autofree char *under = handout_measures (handout, TRUE);
  Block *stack = block_stack (handout->width);

  stack->title = g_strdup (lesson->title);
  stack->level = 1;
  stack->keeps = TRUE;
  handout_head (handout, stack, under);
  pages_add (handout->pages, stack, 0);
}

void
handout_add_part (Handout *handout, const char *title)
{
  Block *block = handout_words (handout, TEXT_TITLE, handout->width, title);

  block->tag = "H1";
  block->title = g_strdup (title);
  block->level = 1;
  block->keeps = TRUE;
  if (handout->has_part)
    pages_break (handout->pages);
  pages_add (handout->pages, block, STOP_GAP);
  handout->has_part = TRUE;
}

Block *
handout_sources (const Handout *handout)
{
  g_autofree char *sources = gist_sources (handout->lesson);
  Block *stack;

  if (sources[0] == '\0')
    return NULL;
  stack = block_stack (handout->width);
  block_add (stack, form_rule (handout->width));
  block_add_below (
      stack, handout_words (handout, TEXT_LABEL, handout->width, _ ("Sources")),
      PART_GAP);
  block_add_below (
      stack, block_prose (&handout->press, TEXT_SMALL, handout->width, sources),
      2);
  stack->title = g_strdup (_ ("Sources"));
  stack->level = 1;
  return stack;
}

void
handout_add_lines (Handout *handout)
{
  const guint n_lines
      = form_lines_in (pages_room (handout->pages) - LINES_HEAD);
  Block *stack;

  if (n_lines < LEAST_LINES)
    return;
  stack = block_stack (handout->width);
  block_add (stack, handout_words (handout, TEXT_LABEL, handout->width,
                                   _ ("My notes")));
  block_add (stack, form_lines (handout->width, n_lines));
  pages_add (handout->pages, stack, STOP_GAP);
}

/* Writing */

static void
add_parts (Handout *handout)
{
  const HandoutOptions *options = &handout->options;
  Block *sources;

  if (!options->has_stops && !options->has_steps && !options->has_key) {
    handout_add_page (handout);
    return;
  }
  add_title (handout);
  if (options->has_stops)
    handout_add_stops (handout);
  if (options->has_steps)
    handout_add_steps (handout);
  if (options->has_key)
    handout_add_key (handout);
  if (handout->legend->len > 0)
    add_legend (handout);
  sources = handout_sources (handout);
  if (sources != NULL)
    pages_add (handout->pages, sources, STOP_GAP);
  if (options->has_blanks)
    handout_add_lines (handout);
}

Handout *
handout_new (Session *session, const HandoutOptions *options)
{
  Handout *handout = g_new0 (Handout, 1);

  g_assert (session_get_lesson (session) != NULL);
  handout->session = g_object_ref (session);
  handout->lesson = lesson_ref (session_get_lesson (session));
  handout->options = *options;
  handout->pages = pages_new (options->paper);
  handout->width = pages_width (handout->pages);
  press_init (&handout->press);
  handout->legend = legend_new ();
  add_parts (handout);
  pages_count (handout->pages);
  return handout;
}

void
handout_free (Handout *handout)
{
  pages_free (handout->pages);
  g_ptr_array_unref (handout->legend);
  press_clear (&handout->press);
  lesson_unref (handout->lesson);
  g_object_unref (handout->session);
  g_free (handout);
}

guint
handout_count_pages (const Handout *handout)
{
  return pages_count (handout->pages);
}

static PdfWords
words_of (const Handout *handout)
{
  return (PdfWords){ .title = handout->lesson->title,
                     .author = handout->lesson->author,
                     .subject = _ ("A lesson of Hull2VD") };
}

void
handout_paint (const Handout *handout, guint page, cairo_t *cr)
{
  const PdfWords words = words_of (handout);

  pages_paint (handout->pages, page, &handout->press, &words, cr);
}

gboolean
handout_write (const Handout *handout,
               FILE *file,
               GCancellable *cancellable,
               GError **error)
{
  const PdfWords words = words_of (handout);

  return pages_write (handout->pages, &handout->press, &words, file,
                      cancellable, error);
}
