/* count-events POINTS: how many events of each kind QuickHull tells. */
#include "example.h"

static void
count (const Event *event, void *user)
{
  unsigned int *n = user;

  n[event->kind] += 1;
}

int
main (int argc, char **argv)
{
  SiteSet *set = example_read (argc, argv);
  unsigned int n[N_EVENT_KINDS] = { 0 };
  const HullHook hook = { count, n };

  hull_build (set, &(Order){ ORDER_FURTHEST, 0 }, &hook);
  for (EventKind kind = 0; kind < N_EVENT_KINDS; kind += 1)
    printf ("%s %u\n", event_kind_name (kind), n[kind]);
  site_set_free (set);
  return 0;
}
