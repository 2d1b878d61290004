/* Certify takes linear time: for each site no more signs are asked for,
 * however many there are, and nothing is sorted by comparing. The linker
 * passes certify's calls through here. */
#include "certify.h"
#include "rbox.h"

#include <stdlib.h>

static guint n_signs, n_sorts;

int __real_orient (const Site *a, const Site *b, const Site *c);
int __wrap_orient (const Site *a, const Site *b, const Site *c);
int
__real_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d);
int
__wrap_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d);
Facing __real_facing (const Site *a, const Site *b, const Site *c);
Facing __wrap_facing (const Site *a, const Site *b, const Site *c);
typedef int (*Comparison) (const void *a, const void *b);
void __real_qsort (void *rows, size_t n, size_t size, Comparison compare);
void __wrap_qsort (void *rows, size_t n, size_t size, Comparison compare);

int
__wrap_orient (const Site *a, const Site *b, const Site *c)
{
  n_signs += 1;
  return __real_orient (a, b, c);
}

int
__wrap_lift_orient (const Site *a, const Site *b, const Site *c, const Site *d)
{
  n_signs += 1;
  return __real_lift_orient (a, b, c, d);
}

Facing
__wrap_facing (const Site *a, const Site *b, const Site *c)
{
  n_signs += 1;
  return __real_facing (a, b, c);
}

void
__wrap_qsort (void *rows, size_t n, size_t size, Comparison compare)
{
  n_sorts += 1;
  __real_qsort (rows, n, size, compare);
}

/* Returns: the signs that certifying a result of @n sites asks for. */
static guint
signs_for (Rbox kind, guint n)
{
  SiteSet *set = rbox_new (kind, 1, n);
  char why[CERTIFY_ROOM];
  Result result;
  Merged merged;

  result_init_batch (&result, set, &(Order){ ORDER_HILBERT, 0 });
  merged_init (&merged, &result);
  n_signs = n_sorts = 0;
  g_assert_true (certify_result (&result, why));
  g_assert_true (certify_merged (&merged, &result, why));
  g_assert_cmpuint (n_sorts, ==, 0);
  merged_clear (&merged);
  result_clear (&result);
  site_set_free (set);
  return n_signs;
}

static guint
signs_of_frame (guint n)
{
  SiteSet *set = rbox_new (RBOX_CUBE, 1, n);
  Trace *trace = trace_record (set, &(Order){ ORDER_FURTHEST, 0 });
  char why[CERTIFY_ROOM];
  Frame frame;

  frame_init (&frame, trace, trace->n_events);
  n_signs = n_sorts = 0;
  g_assert_true (certify_frame (&frame, why));
  g_assert_cmpuint (n_sorts, ==, 0);
  frame_clear (&frame);
  trace_free (trace);
  site_set_free (set);
  return n_signs;
}

static void
test_signs_are_linear_in_the_sites (void)
{
  static const Rbox kinds[]
      = { RBOX_CUBE, RBOX_MESH, RBOX_SPHERE, RBOX_SPIRAL, RBOX_CLUSTERS };

  for (guint i = 0; i < G_N_ELEMENTS (kinds); i++)
    for (guint n = 500; n <= 8000; n *= 4) {
      const guint signs = signs_for (kinds[i], n);

      g_assert_cmpuint (signs, >, 10 * n);
      g_assert_cmpuint (signs, <, 80 * n);
    }
}

static void
test_signs_of_a_frame_are_linear_in_the_sites (void)
{
  for (guint n = 500; n <= 8000; n *= 4) {
    const guint signs = signs_of_frame (n);

    g_assert_cmpuint (signs, >, 10 * n);
    g_assert_cmpuint (signs, <, 80 * n);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/certify/signs-are-linear-in-the-sites",
                   test_signs_are_linear_in_the_sites);
  g_test_add_func ("/certify/signs-of-a-frame-are-linear-in-the-sites",
                   test_signs_of_a_frame_are_linear_in_the_sites);
  return g_test_run ();
}
