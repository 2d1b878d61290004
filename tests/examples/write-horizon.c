/* write-horizon POINTS: the horizon of every round as text, a line a round:
 * which site sees how many facets, and the loop of sites around them. */
#include "example.h"

#include <stdbool.h>

typedef struct Writer {
  unsigned int round, n_visible;
  bool is_on_horizon; /* its line has begun */
} Writer;

static void
write_event (const Event *event, void *user)
{
  Writer *writer = user;

  switch (event->kind) {
  case EVENT_SELECT:
    writer->round += 1;
    writer->n_visible = 0;
    printf ("round %u: s%u", writer->round, event->site);
    break;
  case EVENT_VISIBLE:
    writer->n_visible += 1;
    break;
  case EVENT_HORIZON:
    if (!writer->is_on_horizon)
      printf (" sees %u, horizon", writer->n_visible);
    writer->is_on_horizon = true;
    printf (" s%u", event->ridge[0]);
    break;
  case EVENT_CONE:
    if (writer->is_on_horizon)
      printf ("\n");
    writer->is_on_horizon = false;
    break;
  case EVENT_DUPLICATE:
  case EVENT_FLAT:
  case EVENT_SIMPLEX:
  case EVENT_CLAIM:
  case EVENT_RETIRE:
  case EVENT_COMPLETE:
    break;
  }
}

int
main (int argc, char **argv)
{
  SiteSet *set = example_read (argc, argv);
  Writer writer = { 0, 0, false };
  const HullHook hook = { write_event, &writer };

  hull_build (set, &(Order){ ORDER_FURTHEST, 0 }, &hook);
  site_set_free (set);
  return 0;
}
