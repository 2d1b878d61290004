#include "scrubber.h"

#include <glib/gi18n.h>
#include <math.h>

/* Room between ticks, and between two labels. */
#define TICK_PX 6.0
#define LABEL_PX 12.0
#define CLEAR_PX 4.0 /* between a label and a bare tick */
#define DOT_REACH_PX 5.0

/* That it needs; it takes what is left. */
#define WIDTH_PX 160

struct _Scrubber {
  GtkScale parent_instance;
  Session *session;
  guint marks_source; /* marks wait to be made for another width */
  int width;          /* the width they were made for */
  double letter_px;   /* and the width of their letters */
};

G_DEFINE_TYPE (Scrubber, scrubber, GTK_TYPE_SCALE)

/* Marks */

/* A mark below the trough. */
typedef struct Tick {
  guint step;
  double px, half_px; /* its place, and half of what its text takes */
  char *text;         /* NULL: bare */
} Tick;

static void
clear_tick (gpointer data)
{
  g_free (((Tick *)data)->text);
}

typedef struct MarkWalk {
  GtkWidget *scale;
  GArray *ticks; /* Tick */
  double px_per_step;
  double tick_px;   /* of the last tick */
  double label_px;  /* where the last label ends */
  double half_px;   /* half of what the last text takes */
  double end_px;    /* where that of the end begins */
  gboolean is_told; /* that the numbers are those of rounds */
} MarkWalk;

/* In the letters of the theme, on a wide screen larger ones. */
static double
get_text_px (GtkWidget *scale, const char *text)
{
  PangoLayout *layout = gtk_widget_create_pango_layout (scale, text);
  int width;

  pango_layout_get_pixel_size (layout, &width, NULL);
  g_object_unref (layout);
  return width;
}

/* A tick, with its label where there is room for it.
 *
 * Returns: whether it has its label. */
static gboolean
add_tick (MarkWalk *walk, guint step, const char *text)
{
  const double px = step * walk->px_per_step;
  const double half_px = get_text_px (walk->scale, text) / 2;
  const gboolean has_label = px - half_px >= walk->label_px + LABEL_PX
                             && px + half_px <= walk->end_px - LABEL_PX;
  const Tick tick = { step, px, half_px, has_label ? g_strdup (text) : NULL };

  walk->half_px = half_px;
  if (px - walk->tick_px < TICK_PX && !has_label)
    return FALSE;
  g_array_append_val (walk->ticks, tick);
  walk->tick_px = px;
  if (has_label)
    walk->label_px = px + half_px;
  return has_label;
}

/* Returns: the first round after @round that begins where there is room. Large
 * sets have many more rounds than there are pixels. */
static guint
next_round (const MarkWalk *walk, Session *session, guint round)
{
  const double px = MIN (walk->tick_px + TICK_PX,
                         walk->label_px + LABEL_PX + walk->half_px);
  const double step = ceil (px / walk->px_per_step);
  guint found, start;

  if (step >= session_get_n_steps (session))
    return G_MAXUINT;
  found = session_get_place_at (session, (guint)step).round;
  if (session_find_step (session, (Place){ found, PHASE_CHOOSE }, TRUE, &start)
      && start < step)
    found++;
  return MAX (found, round + 1);
}

/* A round is named where it begins; the first of their numbers says what they
 * are. */
static void
add_rounds (MarkWalk *walk, Session *session)
{
  guint round = 1, step;

  while (walk->px_per_step > 0
         && session_find_step (session, (Place){ round, PHASE_CHOOSE }, TRUE,
                               &step)) {
    g_autofree char *text = walk->is_told
                                ? g_strdup_printf ("%u", round)
                                : g_strdup_printf (_ ("round %u"), round);

    if (add_tick (walk, step, text))
      walk->is_told = TRUE;
    round = next_round (walk, session, round);
  }
}

/* Where the label after this tick begins. */
static double
next_label_px (const MarkWalk *walk, guint i)
{
  for (; i < walk->ticks->len; i++) {
    const Tick *tick = &g_array_index (walk->ticks, Tick, i);

    if (tick->text != NULL)
      return tick->px - tick->half_px;
  }
  return walk->end_px;
}

/* GtkScale pushes a label aside where a bare tick stands over it, so that it
 * seems to be that of another one: there are none. */
static void
add_marks (const MarkWalk *walk, double label_px)
{
  for (guint i = 0; i < walk->ticks->len; i++) {
    const Tick *tick = &g_array_index (walk->ticks, Tick, i);

    if (tick->text == NULL
        && (tick->px < label_px + CLEAR_PX
            || tick->px > next_label_px (walk, i) - CLEAR_PX))
      continue;
    gtk_scale_add_mark (GTK_SCALE (walk->scale), tick->step, GTK_POS_BOTTOM,
                        tick->text);
    if (tick->text != NULL)
      label_px = tick->px + tick->half_px;
  }
}

/* Stops at one step have one mark: dots over dots look like squares. */
static void
add_stops (Scrubber *scrubber)
{
  const guint n_stops = session_get_n_stops (scrubber->session);
  g_autoptr (GHashTable) steps = g_hash_table_new (NULL, NULL);
  guint step;

  for (guint i = 0; i < n_stops; i++)
    if (session_get_stop_step (scrubber->session, i, &step)
        && g_hash_table_add (steps, GUINT_TO_POINTER (step)))
      gtk_scale_add_mark (GTK_SCALE (scrubber), step, GTK_POS_TOP, NULL);
}

/* Sites on one circle have none in space, nor have three. */
static gboolean
has_hull (Session *session)
{
  switch (session_get_exhibit_kind (session)) {
  case EXHIBIT_LIFTS:
  case EXHIBIT_COMPARE:
    return !session_get_trace (session)->is_flat;
  case EXHIBIT_SIGNS:
    return FALSE;
  case EXHIBIT_PLANAR:
  case EXHIBIT_ROUNDED:
    return TRUE;
  }
  return FALSE;
}

static void
add_ends (MarkWalk *walk, Session *session)
{
  const guint n_steps = MAX (session_get_n_steps (session), 1);
  const char *start
      = session_get_n_rounds (session) == 0 ? _ ("start") : _ ("simplex");
  const char *end = has_hull (session) ? _ ("hull") : _ ("end");

  gtk_scale_add_mark (GTK_SCALE (walk->scale), 0, GTK_POS_BOTTOM, start);
  gtk_scale_add_mark (GTK_SCALE (walk->scale), n_steps, GTK_POS_BOTTOM, end);
  walk->tick_px = 0;
  /* They begin and end where the scale does. */
  walk->label_px = get_text_px (walk->scale, start);
  walk->end_px = n_steps * walk->px_per_step - get_text_px (walk->scale, end);
}

/* Of the trough, along which the steps lie. */
static double
trough_width (Scrubber *scrubber)
{
  GtkStyleContext *style = gtk_widget_get_style_context (GTK_WIDGET (scrubber));
  GtkBorder padding;

  gtk_style_context_get_padding (style, gtk_style_context_get_state (style),
                                 &padding);
  return MAX (scrubber->width - padding.left - padding.right, 0);
}

/* What the marks are that the time line has now.
 *
 * Returns: NULL where it has but its ends. */
static const char *
explain_marks (Session *session)
{
  const gboolean has_rounds = session_get_n_rounds (session) > 0;

  if (session_get_n_stops (session) > 0)
    return has_rounds ? _ ("Dots: stops of the lesson. "
                           "Ticks: where rounds begin.")
                      : _ ("Dots: stops of the lesson.");
  return has_rounds ? _ ("Ticks: where rounds begin.") : NULL;
}

static void
make_marks (Scrubber *scrubber)
{
  Session *session = scrubber->session;
  const guint n_steps = session_get_n_steps (session);
  g_autoptr (GArray) ticks = g_array_new (FALSE, FALSE, sizeof (Tick));
  MarkWalk walk
      = { .scale = GTK_WIDGET (scrubber),
          .ticks = ticks,
          .px_per_step = trough_width (scrubber) / (double)MAX (n_steps, 1) };
  const char *marks;
  double start_px;

  g_array_set_clear_func (ticks, clear_tick);
  gtk_scale_clear_marks (GTK_SCALE (scrubber));
  add_ends (&walk, session);
  start_px = walk.label_px;
  add_rounds (&walk, session);
  add_marks (&walk, start_px);
  add_stops (scrubber);
  marks = explain_marks (session);
  atk_object_set_description (gtk_widget_get_accessible (GTK_WIDGET (scrubber)),
                              marks != NULL ? marks : "");
}

static gboolean
on_marks_due (gpointer user)
{
  Scrubber *scrubber = user;

  scrubber->marks_source = 0;
  make_marks (scrubber);
  return G_SOURCE_REMOVE;
}

static void
queue_marks (Scrubber *scrubber)
{
  if (scrubber->marks_source == 0)
    scrubber->marks_source = g_idle_add (on_marks_due, scrubber);
}

/* Themes have letters of their own. */
static void
scrubber_style_updated (GtkWidget *widget)
{
  Scrubber *scrubber = HULL2VD_SCRUBBER (widget);
  double letter_px;

  GTK_WIDGET_CLASS (scrubber_parent_class)->style_updated (widget);
  letter_px = get_text_px (widget, "x");
  if (scrubber->session == NULL || letter_px == scrubber->letter_px)
    return;
  scrubber->letter_px = letter_px;
  queue_marks (scrubber);
}

/* Marks are put where there is room for them. GtkScale asks for a width that
 * holds them all side by side, for which there would be more marks. */
static void
scrubber_get_preferred_width (GtkWidget *widget, int *minimum, int *natural)
{
  GTK_WIDGET_CLASS (scrubber_parent_class)
      ->get_preferred_width (widget, minimum, natural);
  *minimum = MIN (*minimum, WIDTH_PX);
  *natural = MIN (*natural, WIDTH_PX);
}

/* Not while sizes are being given: marks ask for a new size. */
static void
scrubber_size_allocate (GtkWidget *widget, GtkAllocation *allocation)
{
  Scrubber *scrubber = HULL2VD_SCRUBBER (widget);

  GTK_WIDGET_CLASS (scrubber_parent_class)->size_allocate (widget, allocation);
  if (allocation->width == scrubber->width || scrubber->session == NULL)
    return;
  scrubber->width = allocation->width;
  queue_marks (scrubber);
}

/* Value */

static void
on_value_changed (GtkRange *range, gpointer user)
{
  Scrubber *scrubber = HULL2VD_SCRUBBER (range);

  (void)user;
  if (scrubber->session != NULL)
    session_set_step (scrubber->session,
                      (guint)lround (gtk_range_get_value (range)));
}

static void
update (Scrubber *scrubber)
{
  const guint n_events = session_get_n_steps (scrubber->session);
  const guint step = session_get_step (scrubber->session);
  GtkAdjustment *adjustment = gtk_range_get_adjustment (GTK_RANGE (scrubber));

  /* A shorter trace would clamp the value and so set a step. */
  g_signal_handlers_block_by_func (scrubber, on_value_changed, NULL);
  gtk_adjustment_configure (adjustment, step, 0, MAX (n_events, 1), 1,
                            MAX (n_events / 10, 1), 0);
  g_signal_handlers_unblock_by_func (scrubber, on_value_changed, NULL);
  gtk_widget_set_sensitive (GTK_WIDGET (scrubber), n_events > 0);
}

static void
on_changed (Session *session, guint changes, Scrubber *scrubber)
{
  (void)session;
  if (changes & (CHANGED_SITES | CHANGED_STEP))
    update (scrubber);
  if (changes & (CHANGED_SITES | CHANGED_LESSON))
    make_marks (scrubber);
}

void
scrubber_set_session (Scrubber *scrubber, Session *session)
{
  g_assert (scrubber->session == NULL);
  scrubber->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed),
                           scrubber, 0);
  update (scrubber);
  make_marks (scrubber);
}

/* Tooltip: the stop or the round that is under the pointer, and the marks. */

/* Returns: the stop whose dot is within its reach of @x, or G_MAXUINT. */
static guint
stop_near (Scrubber *scrubber, double x, double px_per_step)
{
  const guint n_stops = session_get_n_stops (scrubber->session);
  guint step;

  for (guint i = 0; i < n_stops; i++)
    if (session_get_stop_step (scrubber->session, i, &step)
        && fabs (step * px_per_step - x) <= DOT_REACH_PX)
      return i;
  return G_MAXUINT;
}

static char *
tooltip_at (Scrubber *scrubber, double x, double px_per_step)
{
  const guint n_steps = session_get_n_steps (scrubber->session);
  const guint stop = stop_near (scrubber, x, px_per_step);
  const guint step = (guint)CLAMP (x / px_per_step, 0, n_steps);
  Place place;

  if (stop != G_MAXUINT)
    return g_strdup_printf (
        _ ("Stop %u: %s"), stop + 1,
        lesson_stop (session_get_lesson (scrubber->session), stop)->title);
  place = session_get_place_at (scrubber->session, step);
  if (place.round == 0)
    return g_strdup_printf (_ ("Event %u"), step);
  return g_strdup_printf (_ ("Event %u, round %u"), step, place.round);
}

/* Where nobody points, the marks alone are told of. */
static char *
tooltip_text (const char *place, const char *marks)
{
  if (place == NULL || marks == NULL)
    return g_strdup (place != NULL ? place : marks);
  return g_strdup_printf ("%s\n%s", place, marks);
}

static gboolean
scrubber_query_tooltip (
    GtkWidget *widget, int x, int y, gboolean is_keyboard, GtkTooltip *tooltip)
{
  Scrubber *scrubber = HULL2VD_SCRUBBER (widget);
  g_autofree char *place = NULL, *text = NULL;
  GdkRectangle trough;
  double px_per_step;

  (void)y;
  if (scrubber->session == NULL)
    return FALSE;
  gtk_range_get_range_rect (GTK_RANGE (scrubber), &trough);
  px_per_step
      = trough.width / (double)MAX (1, session_get_n_steps (scrubber->session));
  if (!is_keyboard)
    place = tooltip_at (scrubber, x - trough.x, px_per_step);
  text = tooltip_text (place, explain_marks (scrubber->session));
  gtk_tooltip_set_text (tooltip, text);
  return text != NULL;
}

/* Life */

static void
scrubber_dispose (GObject *object)
{
  Scrubber *scrubber = HULL2VD_SCRUBBER (object);

  if (scrubber->marks_source != 0)
    g_source_remove (scrubber->marks_source);
  scrubber->marks_source = 0;
  g_clear_object (&scrubber->session);
  G_OBJECT_CLASS (scrubber_parent_class)->dispose (object);
}

static void
scrubber_class_init (ScrubberClass *class)
{
  G_OBJECT_CLASS (class)->dispose = scrubber_dispose;
  GTK_WIDGET_CLASS (class)->get_preferred_width = scrubber_get_preferred_width;
  GTK_WIDGET_CLASS (class)->size_allocate = scrubber_size_allocate;
  GTK_WIDGET_CLASS (class)->style_updated = scrubber_style_updated;
  GTK_WIDGET_CLASS (class)->query_tooltip = scrubber_query_tooltip;
}

static void
scrubber_init (Scrubber *scrubber)
{
  GtkWidget *widget = GTK_WIDGET (scrubber);

  gtk_style_context_add_class (gtk_widget_get_style_context (widget),
                               "scrubber");
  gtk_scale_set_draw_value (GTK_SCALE (scrubber), FALSE);
  gtk_scale_set_has_origin (GTK_SCALE (scrubber), TRUE);
  gtk_range_set_round_digits (GTK_RANGE (scrubber), 0);
  gtk_widget_set_has_tooltip (widget, TRUE);
  atk_object_set_name (gtk_widget_get_accessible (widget), _ ("Step"));
  g_signal_connect (scrubber, "value-changed", G_CALLBACK (on_value_changed),
                    NULL);
}
