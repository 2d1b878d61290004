/* The curated sets that are shipped, each with what it is good for. Their
 * files lie in sites/ of the folder of the lessons. */
#ifndef SITE_GALLERY_H
#define SITE_GALLERY_H

#include "site.h"

#include <glib.h>

G_BEGIN_DECLS

typedef struct GalleryEntry {
  const char *name;    /* of its file, without .txt */
  const char *purpose; /* a sentence; marked for translation */
} GalleryEntry;

const GalleryEntry *site_gallery (guint *n_entries);

/* Returns: (transfer full): the sites of a set, free with site_set_free(), or
 *          NULL with @error (DOCUMENT_ERROR) set. */
SiteSet *site_gallery_load (const char *name, GError **error);

G_END_DECLS

#endif
