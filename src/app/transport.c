#include "transport.h"

#include "direction.h"
#include "scrubber.h"

#include <glib/gi18n.h>

struct _Transport {
  GtkBox parent_instance;
  Session *session;
  GtkBox *buttons;
  GtkButton *play_button;
  GtkImage *play_image;
  Scrubber *scrubber;
  GtkMenuButton *speed_button;
  GtkLabel *speed_label;
  guint clock_source; /* ticks while the session plays */
  guint clock_ms;
};

G_DEFINE_TYPE (Transport, transport, GTK_TYPE_BOX)

static const double speeds[] = { 0.25, 0.5, 1, 2, 4 };

static char *
speed_text (double speed)
{
  char text[G_ASCII_DTOSTR_BUF_SIZE];

  return g_strdup_printf ("%s×",
                          g_ascii_formatd (text, sizeof text, "%g", speed));
}

/* The clock */

static gboolean
on_tick (gpointer user)
{
  Transport *transport = user;

  session_tick (transport->session);
  return G_SOURCE_CONTINUE;
}

static void
update_clock (Transport *transport)
{
  const gboolean plays = session_get_playing (transport->session);
  const guint ms = session_get_tick_ms (transport->session);

  if (transport->clock_source != 0 && (!plays || transport->clock_ms != ms)) {
    g_source_remove (transport->clock_source);
    transport->clock_source = 0;
  }
  if (plays && transport->clock_source == 0) {
    transport->clock_ms = ms;
    transport->clock_source = g_timeout_add (ms, on_tick, transport);
  }
}

/* The buttons */

static void
update (Transport *transport)
{
  const gboolean plays = session_get_playing (transport->session);
  GtkStyleContext *style
      = gtk_widget_get_style_context (GTK_WIDGET (transport->play_button));
  g_autofree char *speed = speed_text (session_get_speed (transport->session));

  gtk_image_set_from_icon_name (transport->play_image,
                                plays ? "media-playback-pause-symbolic"
                                      : "media-playback-start-symbolic",
                                GTK_ICON_SIZE_BUTTON);
  if (plays)
    gtk_style_context_add_class (style, "playing");
  else
    gtk_style_context_remove_class (style, "playing");
  atk_object_set_name (
      gtk_widget_get_accessible (GTK_WIDGET (transport->play_button)),
      plays ? _ ("Pause") : _ ("Play"));
  gtk_label_set_text (transport->speed_label, speed);
}

static void
on_changed (Session *session, guint changes, Transport *transport)
{
  (void)session;
  if ((changes & CHANGED_PLAY) == 0)
    return;
  update (transport);
  update_clock (transport);
}

static GMenuModel *
make_speed_menu (void)
{
  GMenu *menu = g_menu_new ();

  for (guint i = 0; i < G_N_ELEMENTS (speeds); i++) {
    g_autofree char *text = speed_text (speeds[i]);
    g_autoptr (GMenuItem) item = g_menu_item_new (text, NULL);

    g_menu_item_set_action_and_target (item, "win.speed", "d", speeds[i]);
    g_menu_append_item (menu, item);
  }
  return G_MENU_MODEL (menu);
}

void
transport_set_session (Transport *transport, Session *session)
{
  g_assert (transport->session == NULL);
  transport->session = g_object_ref (session);
  scrubber_set_session (transport->scrubber, session);
  g_signal_connect_object (session, "changed", G_CALLBACK (on_changed),
                           transport, 0);
  update (transport);
}

/* Life */

static void
transport_dispose (GObject *object)
{
  Transport *transport = HULL2VD_TRANSPORT (object);

  if (transport->clock_source != 0)
    g_source_remove (transport->clock_source);
  transport->clock_source = 0;
  g_clear_object (&transport->session);
  G_OBJECT_CLASS (transport_parent_class)->dispose (object);
}

static void
transport_class_init (TransportClass *class)
{
  GtkWidgetClass *widget_class = GTK_WIDGET_CLASS (class);

  G_OBJECT_CLASS (class)->dispose = transport_dispose;
  g_type_ensure (SCRUBBER_TYPE);
  gtk_widget_class_set_template_from_resource (
      widget_class, "/io/github/hull2vd/Hull2VD/transport.ui");
  gtk_widget_class_bind_template_child (widget_class, Transport, buttons);
  gtk_widget_class_bind_template_child (widget_class, Transport, play_button);
  gtk_widget_class_bind_template_child (widget_class, Transport, play_image);
  gtk_widget_class_bind_template_child (widget_class, Transport, scrubber);
  gtk_widget_class_bind_template_child (widget_class, Transport, speed_button);
  gtk_widget_class_bind_template_child (widget_class, Transport, speed_label);
}

static void
transport_init (Transport *transport)
{
  g_autoptr (GMenuModel) menu = make_speed_menu ();

  gtk_widget_init_template (GTK_WIDGET (transport));
  /* Time runs one way; it is not mirrored with the text. */
  direction_keep (GTK_WIDGET (transport));
  gtk_menu_button_set_menu_model (transport->speed_button, menu);
}
