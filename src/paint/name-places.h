/* Where the names of the picture before stood, so that they stay there while
 * what they name is moved or turned, and do not hop from side to side.
 *
 * Where nothing has moved, names are placed as if nothing had been before: the
 * same step is the same picture, whichever way one came. */
#ifndef NAME_PLACES_H
#define NAME_PLACES_H

#include "camera.h"
#include "label.h"
#include "scene.h"

typedef struct NamePlaces NamePlaces;

NamePlaces *name_places_new (void);
void name_places_free (NamePlaces *places);

/* Forgets all. */
void name_places_forget (NamePlaces *places);

/* A picture of the stock of @scene begins. Places in one of another size, of
 * the other view or of another number of sites are forgotten. */
void name_places_begin (NamePlaces *places,
                        const Scene *scene,
                        const Projection *projection);

/* Tells where the mark of an item is, whose name is to be placed; all names are
 * told, then they are asked for. */
void name_places_tell (NamePlaces *places, const SceneItem *item, Pixel at);

/* Returns: where its name stood, if it may stay there. One whose mark has
 *          jumped may not. */
LabelPlace name_places_find (const NamePlaces *places, const SceneItem *item);

/* Keeps where its name stands now. */
void
name_places_keep (NamePlaces *places, const SceneItem *item, LabelPlace place);

/* Returns: where its name stands in this picture. */
LabelPlace name_places_get (const NamePlaces *places, const SceneItem *item);

#endif
