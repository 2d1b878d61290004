/* Questions and lesson blocks that must be refused, each by its line and
 * column. */
#include "lesson-text.h"
#include "lesson.h"

#include <string.h>

typedef struct Row {
  const char *text;    /* of the lesson */
  const char *message; /* how it begins */
} Row;

static void
check_rows (gconstpointer data)
{
  for (const Row *row = data; row->text != NULL; row++) {
    g_autoptr (GError) error = NULL;
    g_autoptr (Lesson) lesson
        = lesson_parse (row->text, strlen (row->text), "l.md", &error);

    g_assert_true ((lesson == NULL) == (error != NULL));
    if (error != NULL && g_str_has_prefix (error->message, row->message))
      continue;
    g_test_message ("expected %s…, found %s", row->message,
                    error == NULL ? "nothing wrong" : error->message);
    g_test_fail ();
  }
}

static const Row heads[] = {
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nviews bth\n```\n\n## S\n",
    "l.md:6:7: “bth” is not known here (did you mean “both”?)" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nstep-size x\n```\n\n## S\n",
    "l.md:6:11: “x” is not known here; write beat, phase, event" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\ntheme darc\n```\n\n## S\n",
    "l.md:6:7: “darc” is not known here (did you mean “dark”?)" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nlevels viewing x\n```\n\n## S\n",
    "l.md:6:16: “x” is not known here" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nminutes 0\n```\n\n## S\n",
    "l.md:6:9: “minutes” takes a whole number" },
  { "# T\n\n```lesson\nformat 1\nsites 0 0\nauthor\n```\n\n## S\n",
    "l.md:6:7: “author” takes a name" },
  { NULL, NULL },
};

static const Row questions[] = {
  { ASK ("before round 1 see"), "l.md:10:1: what is asked?" },
  { ASK ("click horizon"), "l.md:10:1: where is it asked?" },
  { ASK ("before round 1 sea\nclick horizon"),
    "l.md:11:1: “before round 1 sea” is not a position" },
  { ASK ("before round 9 see\nclick horizon"),
    "l.md:10:1: there is no “before round 9 see”: the last round is 4" },
  { ASK ("complete\nclick horizon"),
    "l.md:10:1: there is no round here to ask about" },
  { ASK ("before round 1 see\nclick horizn"),
    "l.md:12:7: nothing called “horizn” can be clicked (did you mean "
    "“horizon”?)" },
  { ASK ("before round 1 see\nclick horizon f0"),
    "l.md:12:15: nothing follows" },
  { ASK ("simplex\nclick outside-set"), "l.md:12:18: of which facet?" },
  { ASK ("simplex\nclick outside-set s1"), "l.md:12:19: of which facet?" },
  { ASK ("simplex\nclick outside-set f3"), "l.md:10:1: the answer is empty" },
  { ASK ("simplex\nclick outside-set f9"),
    "l.md:10:1: f9 is not a facet of the hull at this place" },
  { ASK ("simplex\nclick outside-set f999"),
    "l.md:10:1: there is no facet f999" },
  { ASK ("simplex\nclick facets-seen-by s9"),
    "l.md:10:1: there is no site s9" },
  { ASK ("before round 1 see\nclick horizon\nnumber cone"),
    "l.md:13:1: a second question" },
  { ASK ("before round 1 see\nround 1\nclick horizon"),
    "l.md:12:1: a second position" },
  { ASK ("before round 1 see\nclick horizon\nprompt"),
    "l.md:13:7: the prompt has no words" },
  { ASK ("before round 1 see\nclick horizon\nretry -1"),
    "l.md:13:7: “retry” takes a whole number" },
  { ASK ("before round 1 see\nclick horizon\nhnt x"),
    "l.md:13:1: an ask block has no “hnt” (did you mean “hint”?)" },
  { ASK ("before round 1 see\nclick horizon\noption a if tie"),
    "l.md:10:1: options belong to choose" },
  { ASK ("before round 1 see\nnumber"), "l.md:12:7: which number?" },
  { ASK ("before round 1 see\nnumber cone visble"),
    "l.md:12:13: nothing called “visble” can be counted (did you mean "
    "“visible”?)" },
  { ASK ("before round 1 see\ndelta 3"), "l.md:12:7: “delta” takes nothing" },
  { ASK ("before round 1 see\nchoose\noption a if tie\noption b if not tie"),
    "l.md:12:7: write choose one, or choose several" },
  { ASK ("before round 1 see\nchoose one\noption a if tie"),
    "l.md:10:1: there must be at least two options" },
  { ASK ("before round 1 see\nchoose one\noption a\noption b if tie"),
    "l.md:13:8: an option says when it is right" },
  { ASK ("complete\nchoose one\noption a if flip\noption b if tie"),
    "l.md:13:13: this condition is about a site that is dragged" },
  { ASK ("complete\nchoose one\noption a if tie\noption b if tie"),
    "l.md:10:1: none of the options is right" },
  { ASK ("complete\nchoose one\noption a if sees s9 f0\noption b if tie"),
    "l.md:10:1: “sees s9 f0”: there is no such site" },
  { ASK ("complete\norder sites"), "l.md:10:1: there is no round here" },
  { ASK ("complete\norder sits"), "l.md:12:7: the order of what?" },
  { ASK ("before round 4\norder sites"),
    "l.md:10:1: there is nothing to put in order here" },
  { ASK ("complete\ndrag f3 until flip"), "l.md:12:6: which site?" },
  { ASK ("complete\ndrag s3 flip"), "l.md:12:9: until what?" },
  { ASK ("complete\ndrag s3 until flop"),
    "l.md:12:15: a condition cannot use “flop” (did you mean “flip”?)" },
  { ASK ("complete\ndrag s30 until flip"), "l.md:10:1: there is no site s30" },
  { ASK ("complete\ndrag s3 until unbounded s3"),
    "l.md:10:1: “unbounded s3” holds before anything is moved" },
  { ASK ("complete\nalways flip"),
    "l.md:12:8: this condition is about a site that is dragged" },
  { ASK ("complete\nalways cone = visible +"), "l.md:12:8: " },
  { ASK ("complete\nalways cone = 2 visible"),
    "l.md:12:8: “visible” is out of place in this sum" },
  { ASK ("complete\nalways neighbours s1"),
    "l.md:12:8: “neighbours” takes two sites" },
  { ASK ("complete\ngenerate horizon"),
    "l.md:12:10: write generate KIND seed S; without a seed" },
  { ASK ("complete\ngenerate horizn seed 1"),
    "l.md:12:10: no question “horizn” can be generated (did you mean "
    "“horizon”?)" },
  { LECTURE "```ask\nround 1\n```\n\n## S\n",
    "l.md:8:1: an ask block belongs to a stop" },
  { ASK ("complete\ndrag s7 until tie") "\n```ask\n```\n",
    "l.md:15:1: a second question in this stop; the first is on line 10" },
  { LECTURE "## S\n\n> ```ask\n> complete\n> ```\n",
    "l.md:10:1: a ask block stands by itself" },
  { ASK ("start\nperform"), "l.md:12:8: how many insertions?" },
  { ASK ("start\nperform 0"), "l.md:12:9: how many insertions?" },
  { ASK ("start\nperform 21"), "l.md:12:9: how many insertions?" },
  { ASK ("start\nperform 5"),
    "l.md:10:1: there are only 4 insertions to perform here" },
  { ASK ("round 3\nperform 2"),
    "l.md:10:1: there is only 1 insertion to perform here" },
  { ASK ("before round 1 see\nperform 1"),
    "l.md:10:1: a performance begins before a round" },
  { ASK ("start\nperform 1\nfresh grid 3 3"),
    "l.md:13:7: these sites are always the same" },
  { ASK ("start\nperform 1\nfresh randm 7 seed 1"),
    "l.md:13:7: “randm” makes no sites (did you mean “random”?)" },
  { ASK ("start\nperform 1\nfresh random 201 seed 1"),
    "l.md:13:7: more than 200 sites" },
  { ASK ("start\nclick horizon\nfresh random 7 seed 1"),
    "l.md:10:1: fresh sites belong to perform" },
  { ASK ("start\nperform 1\nhint x"),
    "l.md:10:1: a performance has its own prompts" },
  { NULL, NULL },
};

/* What the lesson has shown it must not ask any more. */
static const Row leaks[] = {
  { LECTURE "## S\n\n```steps\ngoto round 1\n```\n\n## T\n\n"
            "```ask\nstart\nperform 1\n```\n",
    "l.md:16:1: this gives the answer away" },
  { ASK ("before round 1 cone\nclick visible-facets"),
    "l.md:10:1: this gives the answer away: it is shown already; ask before "
    "round 1 see" },
  { ASK ("round 1 see\nnumber visible"),
    "l.md:10:1: this gives the answer away" },
  { ASK ("before round 1 cone\nchoose one\noption a if horizon = 4\noption b "
         "if horizon = 5"),
    "l.md:10:1: this gives the answer away" },
  { LECTURE "## S\n\n```steps\ngoto round 1 see\n```\n\n## T\n\n"
            "```ask\nbefore round 1 see\nclick visible-facets\n```\n",
    "l.md:16:1: this gives the answer away: the stop on line 8 has shown these "
    "sites beyond “before round 1 see”" },
  { LECTURE "## S\n\n```steps\ngoto complete\n```\n\n"
            "## T\n\n```steps\ngoto start\n```\n\n"
            "```ask\nbefore round 2 choose\nclick furthest-site\n```\n",
    "l.md:20:1: this gives the answer away" },
  { LECTURE "## S\n\n```ask\nbefore round 1 see\ndelta\n```\n\n## T\n\n"
            "```ask\nbefore round 1 horizon\nclick horizon\n```\n",
    "l.md:17:1: this gives the answer away" },
  { NULL, NULL },
};

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_data_func ("/question/unknown-words-of-lesson-blocks-are-refused",
                        heads, check_rows);
  g_test_add_data_func ("/question/broken-questions-are-refused-by-line",
                        questions, check_rows);
  g_test_add_data_func ("/question/what-has-been-shown-cannot-be-asked", leaks,
                        check_rows);
  return g_test_run ();
}
