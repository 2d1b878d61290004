/* hull2vd-cli: one file for each command, this table of them, and what they
 * share: exit statuses, messages, outputs that are whole or absent. */
#ifndef CLI_H
#define CLI_H

#include "appearance.h"
#include "camera.h"
#include "order.h"
#include "session.h"

#include <glib.h>
#include <stdio.h>

G_BEGIN_DECLS

typedef enum CliStatus {
  CLI_DONE = 0,
  CLI_REFUSED = 1, /* input refused, an expectation or --verify failed */
  CLI_BROKEN = 2,  /* a broken lesson */
  CLI_USAGE = 64,
  CLI_CANNOT_OPEN = 66,
  CLI_CANNOT_WRITE = 73,
} CliStatus;

typedef struct CliCommand {
  const char *name;
  const char *arguments; /* for the usage line: "POINTS" */
  const char *sentence;  /* marked for translation */
  /* argv[0] is the name of the command. */
  CliStatus (*run) (const struct CliCommand *command, int argc, char **argv);
} CliCommand;

CliStatus cli_compute (const CliCommand *command, int argc, char **argv);
CliStatus cli_count (const CliCommand *command, int argc, char **argv);
CliStatus cli_trace (const CliCommand *command, int argc, char **argv);
CliStatus cli_lint (const CliCommand *command, int argc, char **argv);
CliStatus cli_words (const CliCommand *command, int argc, char **argv);
CliStatus cli_replay (const CliCommand *command, int argc, char **argv);
CliStatus cli_export (const CliCommand *command, int argc, char **argv);
CliStatus cli_storyboard (const CliCommand *command, int argc, char **argv);
CliStatus cli_handout (const CliCommand *command, int argc, char **argv);
CliStatus cli_questions (const CliCommand *command, int argc, char **argv);
CliStatus cli_results (const CliCommand *command, int argc, char **argv);
CliStatus cli_actions (const CliCommand *command, int argc, char **argv);

/* Reads the options of a command; what is left is in *@arguments (transfer
 * full), of which there must be @least … @most.
 *
 * Returns: FALSE after the reason and the usage line are on stderr. */
typedef struct CliCount {
  guint least, most;
} CliCount;

gboolean cli_parse (const CliCommand *command,
                    const GOptionEntry *options,
                    CliCount count,
                    int argc,
                    char **argv,
                    char ***arguments);

/* Says that an option's value is wrong, with the usage line. */
CliStatus cli_usage (const CliCommand *command, const char *format, ...)
    G_GNUC_PRINTF (2, 3);

/* Whether a PDF file may be written to @path, what -o says or NULL: not where
 * the name is that of another picture. If not, it has been said. */
gboolean cli_pdf (const CliCommand *command, const char *path);

/* Opens what a command reads that is for lessons: "-" is a lesson here.
 *
 * Errors: as document_open(). */
gboolean cli_open_lesson (Session *session, const char *path, GError **error);

/* Reads an option's whole number; NULL is no number.
 *
 * Returns: FALSE after the reason and the usage line are on stderr. */
gboolean cli_number (const CliCommand *command,
                     const char *option,
                     const char *value,
                     guint *number);

/* The options --order and --seed as they were given. */
typedef struct CliOrder {
  char *kind, *seed;
} CliOrder;

void cli_order_clear (CliOrder *options);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (CliOrder, cli_order_clear)

#define CLI_ORDER_ENTRIES(options)                                             \
  { "order",                                                                   \
    0,                                                                         \
    0,                                                                         \
    G_OPTION_ARG_STRING,                                                       \
    &(options)->kind,                                                          \
    N_ ("which site comes next: furthest, input, random, seeded or hilbert"),  \
    "ORDER" },                                                                 \
  {                                                                            \
    "seed", 0, 0, G_OPTION_ARG_STRING, &(options)->seed,                       \
        N_ ("seed of the random order"), "S"                                   \
  }

/* Reads them.
 *
 * Returns: FALSE after the reason and the usage line are on stderr. */
gboolean
cli_order (const CliCommand *command, const CliOrder *options, Order *order);

/* The options that say how pictures look, as they were given. */
typedef struct CliLook {
  char *theme, *line_scale, *mark_scale, *text_scale, *layers, *camera;
} CliLook;

void cli_look_clear (CliLook *options);

/* Reads an option's decimal number within bounds.
 *
 * Returns: FALSE after the reason and the usage line are on stderr. */
gboolean cli_decimal (const CliCommand *command,
                      const char *option,
                      const char *value,
                      double least,
                      double most,
                      double *number);

/* Lets @appearance, @layers and @camera be what the options say; what they do
 * not say is left as it is.
 *
 * Returns: FALSE after the reason and the usage line are on stderr. */
gboolean cli_look (const CliCommand *command,
                   const CliLook *options,
                   Appearance *appearance,
                   guint *layers,
                   Camera *camera);

/* Those of the theme and the sizes. */
#define CLI_APPEARANCE_ENTRIES(options)                                        \
  { "theme",                                                                   \
    0,                                                                         \
    0,                                                                         \
    G_OPTION_ARG_STRING,                                                       \
    &(options)->theme,                                                         \
    N_ ("light, paper, projector, dark, print or contrast"),                   \
    "THEME" },                                                                 \
      { "line-scale",                                                          \
        0,                                                                     \
        0,                                                                     \
        G_OPTION_ARG_STRING,                                                   \
        &(options)->line_scale,                                                \
        N_ ("weight of lines: 0.5 to 3, normally 1"),                          \
        "L" },                                                                 \
      { "mark-scale",                                                          \
        0,                                                                     \
        0,                                                                     \
        G_OPTION_ARG_STRING,                                                   \
        &(options)->mark_scale,                                                \
        N_ ("size of marks: 0.5 to 3, normally 1"),                            \
        "M" },                                                                 \
  {                                                                            \
    "text-scale", 0, 0, G_OPTION_ARG_STRING, &(options)->text_scale,           \
        N_ ("size of names: 0.5 to 3, normally 1"), "T"                        \
  }

/* All of them. */
#define CLI_LOOK_ENTRIES(options)                                              \
  CLI_APPEARANCE_ENTRIES (options),                                            \
      { "layers",                                                              \
        0,                                                                     \
        0,                                                                     \
        G_OPTION_ARG_STRING,                                                   \
        &(options)->layers,                                                    \
        N_ ("show only these layers; +LAYER adds one, -LAYER hides one"),      \
        "hull,-lifts…" },                                                      \
  {                                                                            \
    "camera", 0, 0, G_OPTION_ARG_STRING, &(options)->camera,                   \
        N_ ("home, look-up, look-down, side, or degrees: AZIMUTH,ELEVATION"    \
            "[,ZOOM]"),                                                        \
        "CAMERA"                                                               \
  }

/* Puts a line on stderr, without control characters. */
void cli_say (const char *format, ...) G_GNUC_PRINTF (1, 2);

/* Puts the reason on stderr, and returns: the status it stands for. Takes
 * @error. */
CliStatus cli_fail (GError *error);

/* An output gathered in memory, to appear whole or not at all. */
typedef struct CliOutput {
  FILE *file; /* write here */
  char *bytes;
  size_t length;
} CliOutput;

void cli_output_begin (CliOutput *output);
void cli_output_drop (CliOutput *output);

/* Drops it and says why there is nothing to put at @path. Takes @error. */
CliStatus cli_output_fail (CliOutput *output, const char *path, GError *error);

/* Puts the output at @path, or on stdout when it is NULL. */
CliStatus cli_output_end (CliOutput *output, const char *path);

G_END_DECLS

#endif
