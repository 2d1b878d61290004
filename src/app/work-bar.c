#include "work-bar.h"

#include "session-chore.h"

#include <glib/gi18n.h>

/* What is there at once needs no bar. */
#define PATIENCE_MS 250
#define TICK_MS 100

struct _WorkBar {
  GtkRevealer parent_instance;
  Session *session;
  GtkLabel *label;
  GtkProgressBar *progress;
  guint source; /* of the next tick */
};

G_DEFINE_TYPE (WorkBar, work_bar, GTK_TYPE_REVEALER)

static gboolean
is_working (WorkBar *bar)
{
  return session_is_working (bar->session, NULL)
         || session_get_chore (bar->session) != NULL;
}

/* How far a hull is can be told, of other work that it goes on. */
static gboolean
on_tick (gpointer user)
{
  WorkBar *bar = user;
  double part = 0;

  if (session_is_working (bar->session, &part))
    gtk_progress_bar_set_fraction (bar->progress, CLAMP (part, 0, 1));
  else
    gtk_progress_bar_pulse (bar->progress);
  return G_SOURCE_CONTINUE;
}

static void
say (WorkBar *bar)
{
  const guint n_sites = session_get_n_awaited (bar->session);
  AtkObject *progress = gtk_widget_get_accessible (GTK_WIDGET (bar->progress));
  g_autofree char *text = NULL;

  if (session_is_working (bar->session, NULL))
    text = g_strdup_printf (ngettext ("The hull of %u site is being computed",
                                      "The hull of %u sites is being computed",
                                      n_sites),
                            n_sites);
  else
    text = g_strdup (session_get_chore (bar->session));
  gtk_label_set_text (bar->label, text);
  atk_object_set_name (progress, n_sites > 0 ? _ ("Sites inserted")
                                             : _ ("Work in progress"));
}

static gboolean
on_slow (gpointer user)
{
  WorkBar *bar = user;

  say (bar);
  gtk_revealer_set_reveal_child (GTK_REVEALER (bar), TRUE);
  bar->source = g_timeout_add (TICK_MS, on_tick, bar);
  on_tick (bar);
  return G_SOURCE_REMOVE;
}

static void
stop (WorkBar *bar)
{
  if (bar->source != 0)
    g_source_remove (bar->source);
  bar->source = 0;
}

/* What follows at once upon what was told of is the same wait. */
static gboolean
on_over (gpointer user)
{
  WorkBar *bar = user;

  bar->source = 0;
  gtk_revealer_set_reveal_child (GTK_REVEALER (bar), FALSE);
  return G_SOURCE_REMOVE;
}

static void
on_changed (Session *session, guint changes, WorkBar *bar)
{
  const gboolean is_told = gtk_revealer_get_reveal_child (GTK_REVEALER (bar));

  (void)session;
  if ((changes & CHANGED_WORK) == 0)
    return;
  /* Who waits for one thing after the other waits all the time. */
  if (!is_told && bar->source != 0 && is_working (bar))
    return;
  stop (bar);
  if (!is_working (bar)) {
    if (is_told)
      bar->source = g_timeout_add (TICK_MS, on_over, bar);
  } else if (is_told)
    on_slow (bar);
  else
    bar->source = g_timeout_add (PATIENCE_MS, on_slow, bar);
}

void
work_bar_set_session (WorkBar *bar, Session *session)
{
  bar->session = g_object_ref (session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed), bar, 0);
}

static void
work_bar_dispose (GObject *object)
{
  WorkBar *bar = HULL2VD_WORK_BAR (object);

  stop (bar);
  g_clear_object (&bar->session);
  G_OBJECT_CLASS (work_bar_parent_class)->dispose (object);
}

static void
work_bar_class_init (WorkBarClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = work_bar_dispose;
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/work-bar.ui");
  gtk_widget_class_bind_template_child (widget_class, WorkBar, label);
  gtk_widget_class_bind_template_child (widget_class, WorkBar, progress);
}

static void
work_bar_init (WorkBar *bar)
{
  gtk_widget_init_template (GTK_WIDGET (bar));
}
