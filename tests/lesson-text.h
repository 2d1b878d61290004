/* Texts of lessons for tests. */
#ifndef LESSON_TEXT_H
#define LESSON_TEXT_H

#define HEAD                                                                   \
  "# T\n\n```lesson\nformat 1\nsites -1 -0.5; 1 -0.8125; 0.75 0.8125; "        \
  "-0.9375 0.5625; 0.1875 -0.1875\n```\n\n"

/* The eight sites of the lecture, six lines. */
#define LECTURE                                                                \
  "# T\n\n```lesson\nformat 1\nsites -1 -0.5; 1 -0.8125; 0.75 0.8125; "        \
  "-0.9375 0.5625; 0.1875 -0.1875; 0.5 -0.1875; -0.0625 -0.4375; "             \
  "0 0.25\n```\n\n"

/* A lesson with one question, whose lines begin in line 11. */
#define ASK(lines) LECTURE "## S\n\n```ask\n" lines "\n```\n"

/* Up to line 9: a stop without commands. */
#define STOP HEAD "## S\n\n"

/* A lesson with one stop, whose steps begin in line 11. */
#define STEPS(lines) STOP "```steps\n" lines "\n```\n"

/* A lesson whose sites are in line 5. */
#define SITES(words)                                                           \
  "# T\n\n```lesson\nformat 1\nsites " words "\n```\n\n## S\n"

#endif
