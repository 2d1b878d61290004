#include "action.h"
#include "cli.h"
#include "command.h"
#include "document.h"
#include "session-picture.h"

#include <glib/gi18n.h>
#include <string.h>

#define SCALE_SMALLEST 0.01
#define SCALE_LARGEST 100.0

typedef struct Options {
  char *view, *event, *round, *stop, *size, *scale, *output;
  gboolean is_transparent;
  char **commands; /* of the lesson language, done first */
  char **paths;
  CliOrder order_options;
  Order order; /* for points; a lesson says its own */
  CliLook look;
  PictureView view_kind;
  PictureFormat format;
  guint number;        /* of the event, round or stop */
  guint width, height; /* 0: as the picture is by itself */
  double factor;
} Options;

static void
options_clear (Options *options)
{
  g_free (options->view);
  g_free (options->event);
  g_free (options->round);
  g_free (options->stop);
  g_free (options->size);
  g_free (options->scale);
  g_free (options->output);
  cli_order_clear (&options->order_options);
  cli_look_clear (&options->look);
  g_strfreev (options->paths);
  g_strfreev (options->commands);
}

static gboolean
parse_view (const CliCommand *command, Options *options)
{
  static const char *const names[] = { "plane", "space", "both" };

  options->view_kind = PICTURE_BOTH;
  for (guint i = 0; options->view != NULL && i < G_N_ELEMENTS (names); i++)
    if (g_str_equal (options->view, names[i])) {
      options->view_kind = (PictureView)i;
      return TRUE;
    }
  if (options->view == NULL)
    return TRUE;
  cli_usage (command, _ ("there is no view “%s”: write plane, space or both"),
             options->view);
  return FALSE;
}

static gboolean
read_size (const CliCommand *command, Options *options)
{
  const char *const option = "--size WxH";
  g_auto (GStrv) parts = g_strsplit (options->size, "x", 3);

  if (g_strv_length (parts) != 2) {
    cli_usage (command, _ ("write the size as WIDTHxHEIGHT"));
    return FALSE;
  }
  return cli_number (command, option, parts[0], &options->width)
         && cli_number (command, option, parts[1], &options->height);
}

static gboolean
parse_size (const CliCommand *command, Options *options)
{
  options->factor = 1;
  return (options->size == NULL || read_size (command, options))
         && (options->scale == NULL
             || cli_decimal (command, "--scale", options->scale, SCALE_SMALLEST,
                             SCALE_LARGEST, &options->factor));
}

static gboolean
set_size (const CliCommand *command, Picture *picture, const Options *options)
{
  if (options->size != NULL) {
    picture->width = options->width;
    picture->height = options->height;
  }
  picture->scale = options->factor;
  if (picture_has_good_size (picture))
    return TRUE;
  cli_usage (command,
             _ ("the size must be between 1x1 and %dx%d, also after scaling"),
             PICTURE_MOST, PICTURE_MOST);
  return FALSE;
}

/* One of --event, --round and --stop at most. */
static gboolean
parse_moment (const CliCommand *command, Options *options)
{
  const char *values[] = { options->event, options->round, options->stop };
  const char *names[] = { "--event", "--round", "--stop" };
  guint n_given = 0;

  for (guint i = 0; i < G_N_ELEMENTS (values); i++) {
    if (values[i] == NULL)
      continue;
    n_given += 1;
    if (!cli_number (command, names[i], values[i], &options->number))
      return FALSE;
  }
  if (n_given > 1)
    cli_usage (command, _ ("use only one of --event, --round and --stop"));
  return n_given <= 1;
}

static gboolean
parse_output (const CliCommand *command, Options *options)
{
  if (options->output == NULL)
    cli_usage (command, _ ("no output file is given: use -o OUT.svg"));
  else if (picture_format_of (options->output, &options->format))
    return TRUE;
  else
    cli_usage (command,
               _ ("%s: the name of a picture must end in .svg, .pdf or .png"),
               options->output);
  return FALSE;
}

/* The session's look where the options say nothing. */
static gboolean
apply_look (const CliCommand *command, Session *session, const Options *options)
{
  Appearance appearance = *session_get_appearance (session);
  Camera camera = *session_get_camera (session);
  guint layers = session_get_look (session)->layers;

  if (!cli_look (command, &options->look, &appearance, &layers, &camera))
    return FALSE;
  session_set_theme (session, appearance.theme);
  session_set_own_appearance (session, &appearance);
  session_set_layers (session, layers);
  session_set_camera (session, &camera);
  return TRUE;
}

/* What is wrong with the look is said before a file is opened. */
static gboolean
parse_look (const CliCommand *command, Options *options)
{
  g_autoptr (Session) scratch = session_new ();

  return apply_look (command, scratch, options);
}

static gboolean
options_parse (Options *options,
               const CliCommand *command,
               int argc,
               char **argv)
{
#define ENTRY(name, letter, kind, field, sentence, value)                      \
  {                                                                            \
    name, letter, 0, G_OPTION_ARG_##kind, &options->field, sentence, value     \
  }
  const GOptionEntry entries[]
      = { ENTRY ("view", 0, STRING, view, N_ ("what to show"),
                 "plane|space|both"),
          ENTRY ("event", 0, STRING, event, N_ ("after event E"), "E"),
          ENTRY ("round", 0, STRING, round,
                 N_ ("after R insertions beyond the first simplex"), "R"),
          ENTRY ("stop", 0, STRING, stop,
                 N_ ("at stop K of the lesson, counted from 1"), "K"),
          ENTRY ("size", 0, STRING, size,
                 N_ ("size: pixels for PNG, points for SVG and PDF"), "WxH"),
          ENTRY ("scale", 0, STRING, scale, N_ ("scale everything by F"), "F"),
          ENTRY ("transparent", 0, NONE, is_transparent,
                 N_ ("without a background"), NULL),
          ENTRY ("do", 0, STRING_ARRAY, commands,
                 N_ ("first run this command, as in a lesson: “view planar”"),
                 "COMMAND"),
          CLI_ORDER_ENTRIES (&options->order_options),
          CLI_LOOK_ENTRIES (&options->look),
          ENTRY ("output", 'o', FILENAME, output,
                 N_ ("write to this picture: .svg, .pdf or .png"), "OUT"),
          G_OPTION_ENTRY_NULL };
#undef ENTRY

  return cli_parse (command, entries, (CliCount){ 1, 1 }, argc, argv,
                    &options->paths)
         && parse_view (command, options) && parse_size (command, options)
         && parse_moment (command, options) && parse_output (command, options)
         && parse_look (command, options)
         && cli_order (command, &options->order_options, &options->order);
}

static gboolean
refuse_moment (const Options *options, const char *name, guint last)
{
  cli_say (_ ("%s: there is no %s %u: the last is %u"), options->paths[0], name,
           options->number, last);
  return FALSE;
}

static gboolean
goto_round (Session *session, const Options *options)
{
  const guint n_rounds = session_get_n_rounds (session);
  guint step;

  if (n_rounds == 0 && session_get_exhibit_kind (session) == EXHIBIT_LIFTS
      && session_get_trace (session)->is_flat) {
    cli_say (_ ("%s: there are no rounds: all lifts lie in one plane, so "
                "there is no first simplex"),
             options->paths[0]);
    return FALSE;
  }
  if (options->number > n_rounds)
    return refuse_moment (options, "round", n_rounds);
  if (session_find_step (session,
                         options->number == 0
                             ? (Place){ 0, PHASE_SIMPLEX }
                             : (Place){ options->number, PHASE_HAND_OVER },
                         FALSE, &step))
    session_set_step (session, step);
  return TRUE;
}

static gboolean
goto_stop (Session *session, const Options *options)
{
  if (session_get_n_stops (session) == 0) {
    cli_say (_ ("%s: points have no stops; only lessons do"),
             options->paths[0]);
    return FALSE;
  }
  return (options->number >= 1
          && session_set_stop (session, options->number - 1))
         || refuse_moment (options, "stop", session_get_n_stops (session));
}

static gboolean
goto_moment (Session *session, const Options *options)
{
  const guint last = session_get_n_steps (session);

  if (options->stop != NULL)
    return goto_stop (session, options);
  if (options->commands == NULL)
    session_last (session);
  if (options->round != NULL)
    return goto_round (session, options);
  if (options->event == NULL)
    return TRUE;
  if (options->number > last)
    return refuse_moment (options, "event", last);
  session_set_step (session, options->number);
  return TRUE;
}

static CliStatus
write_picture (const CliCommand *command,
               Session *session,
               const Options *options)
{
  const Frame *frame = session_get_frame (session);
  g_autofree char *narration = session_narrate (session);
  g_autofree char *name = g_path_get_basename (options->paths[0]);
  const Lesson *lesson = session_get_lesson (session);
  Theme theme;
  Picture picture;
  CliOutput output;

  session_picture (&picture, session, options->view_kind);
  theme_init (&theme, session_get_appearance (session));
  picture.theme = &theme;
  picture.title = lesson == NULL ? name : lesson->title;
  picture.description = narration;
  picture.is_transparent = options->is_transparent;
  if (!set_size (command, &picture, options))
    return CLI_USAGE;
  cli_output_begin (&output);
  if (picture_write (&picture, frame, options->format, output.file))
    return cli_output_end (&output, options->output);
  cli_output_drop (&output);
  cli_say (_ ("%s: cannot write the picture"), options->output);
  return CLI_CANNOT_WRITE;
}

/* A lesson says its own order. */
static gboolean
check_order (Session *session, const Options *options)
{
  if (options->order_options.kind == NULL
      || session_get_lesson (session) == NULL)
    return TRUE;
  cli_say (_ ("%s: --order is for points: a lesson has its own order"),
           options->paths[0]);
  return FALSE;
}

/* One command as lessons have them, but for what they expect. */
static gboolean
do_command (Session *session, const char *text)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GVariant) parameter = NULL;
  g_autofree char *verb = NULL;

  if (command_parse (text, &verb, &parameter, &error)
      && action_run (session, verb, parameter, &error))
    return TRUE;
  cli_say (_ ("--do “%s”: %s"), text, error->message);
  return FALSE;
}

static gboolean
do_commands (Session *session, const Options *options)
{
  for (char **command = options->commands; command != NULL && *command != NULL;
       command++)
    if (!do_command (session, *command))
      return FALSE;
  return TRUE;
}

CliStatus
cli_export (const CliCommand *command, int argc, char **argv)
{
  g_autoptr (Session) session = session_new ();
  Options options = { .view = NULL };
  CliStatus status = CLI_USAGE;
  GError *error = NULL;

  if (options_parse (&options, command, argc, argv)) {
    session_set_order (session, &options.order);
    if (!document_open (session, options.paths[0], &error))
      status = cli_fail (error);
    else if (check_order (session, &options) && do_commands (session, &options)
             && goto_moment (session, &options)
             && apply_look (command, session, &options))
      status = write_picture (command, session, &options);
    else
      status = CLI_REFUSED;
  }
  options_clear (&options);
  return status;
}
