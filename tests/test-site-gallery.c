#include "document.h"
#include "site-gallery.h"

#include <string.h>

static void
test_every_set_is_there_and_says_why (void)
{
  guint n;
  const GalleryEntry *entries = site_gallery (&n);

  g_assert_cmpuint (n, >, 10);
  for (guint i = 0; i < n; i++) {
    g_autoptr (GError) error = NULL;
    SiteSet *set = site_gallery_load (entries[i].name, &error);

    g_assert_no_error (error);
    g_assert_cmpuint (set->n_sites, >=, 4);
    g_assert_cmpuint (set->n_distinct, ==, set->n_sites);
    g_assert_cmpuint (strlen (entries[i].purpose), >, 20);
    site_set_free (set);
  }
}

static void
test_a_set_that_is_none_is_named (void)
{
  g_autoptr (GError) error = NULL;

  g_assert_null (site_gallery_load ("no-such-set", &error));
  g_assert_error (error, DOCUMENT_ERROR, DOCUMENT_ERROR_CANNOT_OPEN);
  g_assert_nonnull (strstr (error->message, "no-such-set.txt"));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/site-gallery/every-set-is-there-and-says-why",
                   test_every_set_is_there_and_says_why);
  g_test_add_func ("/site-gallery/a-set-that-is-none-is-named",
                   test_a_set_that_is_none_is_named);
  return g_test_run ();
}
