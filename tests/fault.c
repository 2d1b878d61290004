#include "fault.h"

#include "certify.h"

#include <string.h>

void
fault_swap (uint32_t *a, uint32_t *b)
{
  const uint32_t kept = *a;

  *a = *b;
  *b = kept;
}

bool
fault_has_edge (const uint32_t site[3],
                uint32_t tail,
                uint32_t head,
                uint32_t *third)
{
  for (uint32_t k = 0; k < 3; k += 1) {
    *third = site[(k + 2) % 3];
    if (site[k] == tail && site[(k + 1) % 3] == head)
      return true;
  }
  return false;
}

static void
test_fault_is_found (const void *data)
{
  const Fault *fault = data;
  g_autoptr (Fixture) fixture = fixture_load (fault->sites, ORDER_FURTHEST);
  char why[CERTIFY_ROOM] = "";
  Frame frame;

  frame_init (&frame, fixture->trace, fixture->trace->n_events);
  g_assert_true (certify_frame (&frame, why));
  fault->spoil (&frame);
  g_assert_false (certify_frame (&frame, why));
  g_test_message ("%s", why);
  g_assert_cmpuint (strlen (why), >, 5);
  g_assert_nonnull (strstr (why, fault->words));
  frame_clear (&frame);
}

void
fault_add_tests (const Fault *faults, size_t n)
{
  for (size_t i = 0; i < n; i += 1) {
    g_autofree char *path
        = g_strdup_printf ("/certify/finds/%s", faults[i].name);

    g_test_add_data_func (path, &faults[i], test_fault_is_found);
  }
}
