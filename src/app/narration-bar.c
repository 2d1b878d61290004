#include "narration-bar.h"

#include "announcement.h"
#include "narration-markup.h"

#include <glib/gi18n.h>

struct _NarrationBar {
  GtkBox parent_instance;
  Session *session;
  GtkLabel *sentence;
  GtkLabel *place;
  char *told; /* the sentence that was announced last */
};

G_DEFINE_TYPE (NarrationBar, narration_bar, GTK_TYPE_BOX)

static const char *
phase_text (Phase phase)
{
  switch (phase) {
  case PHASE_START:
    return _ ("start");
  case PHASE_SIMPLEX:
    return _ ("first simplex");
  case PHASE_CHOOSE:
    return _ ("choose");
  case PHASE_SEE:
    return _ ("see");
  case PHASE_HORIZON:
    return _ ("horizon");
  case PHASE_CONE:
    return _ ("cone");
  case PHASE_HAND_OVER:
    return _ ("hand over");
  case PHASE_COMPLETE:
    return _ ("complete");
  }
  return "";
}

/* There the time line has the tick of the round that comes next. */
static gboolean
is_end_of_round (Session *session, guint step, Place place)
{
  guint end;

  return place.phase == PHASE_HAND_OVER
         && session_find_step (session, place, FALSE, &end) && end == step;
}

static char *
place_text (Session *session)
{
  const guint n_events = session_get_n_steps (session);
  const guint step = session_get_step (session);
  const Place place = session_get_place (session);
  const char *phase
      = session_is_retiring (session) ? _ ("retire") : phase_text (place.phase);

  /* What stands still has no time, and where there are no sites there is
   * nothing that could be complete. */
  if (n_events == 0 || session_get_set (session)->n_sites == 0)
    return g_strdup ("");
  if (place.round == 0 || place.phase == PHASE_COMPLETE)
    return g_strdup_printf (_ ("event %u of %u · %s"), step, n_events, phase);
  if (is_end_of_round (session, step, place))
    return g_strdup_printf (_ ("event %u of %u · end of round %u"), step,
                            n_events, place.round);
  return g_strdup_printf (_ ("event %u of %u · round %u, %s"), step, n_events,
                          place.round, phase);
}

/* Each step once. */
static void
tell (NarrationBar *bar, const char *sentence)
{
  if (g_strcmp0 (bar->told, sentence) == 0)
    return;
  g_free (bar->told);
  bar->told = g_strdup (sentence);
  announce (GTK_WIDGET (bar->sentence), sentence);
}

static const Theme *
get_theme (NarrationBar *bar)
{
  return theme_get (session_get_appearance (bar->session)->theme);
}

/* The desktop's theme says what text is read on. */
static Colour
get_background (NarrationBar *bar)
{
  GtkStyleContext *style = gtk_widget_get_style_context (GTK_WIDGET (bar));
  GdkRGBA base;

  if (!gtk_style_context_lookup_color (style, "theme_base_color", &base))
    return get_theme (bar)->background;
  return (Colour){ base.red, base.green, base.blue, 1 };
}

/* The answer to what a person asks, else what has just happened. */
static char *
get_sentence (NarrationBar *bar)
{
  char *answer = session_explain (bar->session);

  return answer != NULL ? answer : session_narrate (bar->session);
}

static void
update (NarrationBar *bar, gboolean is_only_look)
{
  g_autofree char *sentence = get_sentence (bar);
  g_autofree char *markup = NULL;
  g_autofree char *place = NULL;

  /* The pointer moves often, and seldom is there another sentence. */
  if (is_only_look && g_strcmp0 (bar->told, sentence) == 0)
    return;
  markup = narration_to_markup (sentence, session_get_apex (bar->session),
                                get_theme (bar), get_background (bar));
  place = place_text (bar->session);
  gtk_label_set_markup (bar->sentence, markup);
  gtk_label_set_text (bar->place, place);
  tell (bar, sentence);
}

static void
on_changed (Session *session, guint changes, NarrationBar *bar)
{
  (void)session;
  if (changes
      & (CHANGED_SITES | CHANGED_STEP | CHANGED_LESSON | CHANGED_QUESTION
         | CHANGED_APPEARANCE | CHANGED_LOOK))
    update (bar, changes == CHANGED_LOOK);
}

static void
narration_bar_style_updated (GtkWidget *widget)
{
  NarrationBar *bar = HULL2VD_NARRATION_BAR (widget);

  GTK_WIDGET_CLASS (narration_bar_parent_class)->style_updated (widget);
  if (bar->session != NULL)
    update (bar, FALSE);
}

void
narration_bar_set_session (NarrationBar *bar, Session *session)
{
  g_assert (bar->session == NULL);
  bar->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), bar, 0);
  update (bar, FALSE);
}

static void
narration_bar_dispose (GObject *object)
{
  NarrationBar *bar = HULL2VD_NARRATION_BAR (object);

  g_clear_pointer (&bar->told, g_free);
  g_clear_object (&bar->session);
  G_OBJECT_CLASS (narration_bar_parent_class)->dispose (object);
}

static void
narration_bar_class_init (NarrationBarClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = narration_bar_dispose;
  widget_class->style_updated = narration_bar_style_updated;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/narration-bar.ui");
  gtk_widget_class_bind_template_child (widget_class, NarrationBar, sentence);
  gtk_widget_class_bind_template_child (widget_class, NarrationBar, place);
}

static void
narration_bar_init (NarrationBar *bar)
{
  gtk_widget_init_template (GTK_WIDGET (bar));
}
