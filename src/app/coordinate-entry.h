/* An entry for the coordinates of a site, as strict as point files: to add
 * one, or to move one. What is typed is never changed. */
#ifndef COORDINATE_ENTRY_H
#define COORDINATE_ENTRY_H

#include "plane-view.h"

G_BEGIN_DECLS

#define COORDINATE_ENTRY_TYPE (coordinate_entry_get_type ())
G_DECLARE_FINAL_TYPE (
    CoordinateEntry, coordinate_entry, HULL2VD, COORDINATE_ENTRY, GtkPopover)

/* Returns: (transfer full): an entry that belongs to a view; destroy it with
 *          the view. */
CoordinateEntry *coordinate_entry_new (PlaneView *view);

/* Opens it to add sites, one after another. */
void coordinate_entry_add (CoordinateEntry *entry);

/* Opens it to move @site, whose coordinates it shows. */
void coordinate_entry_move (CoordinateEntry *entry, guint site);

G_END_DECLS

#endif
