#include "name-places.h"

#include <glib.h>
#include <math.h>

/* A mark that goes further than this from one picture to the next is another
 * one, and where half of them do, all are; px. */
#define JUMP_PX 40.0

typedef struct KnownPlace {
  uint64_t picture; /* that it was last told in */
  Pixel at;
  LabelPlace here; /* in that picture, */
  LabelPlace last; /* and in the one before */
} KnownPlace;

struct NamePlaces {
  GHashTable *places; /* what is named → KnownPlace */
  uint64_t picture;   /* the number of the one in hand */
  uint64_t edition;   /* of its scene's stock */
  double width, height;
  bool is_space;
  uint32_t n_sites;
  uint32_t n_told,
      n_jumps;   /* names in this picture, and of those that jumped */
  bool may_stay; /* something has moved, or it is the same scene */
};

static const LabelPlace nowhere = { LABEL_NOWHERE, 0, false };

NamePlaces *
name_places_new (void)
{
  NamePlaces *places = g_new0 (NamePlaces, 1);

  places->places
      = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, g_free);
  return places;
}

void
name_places_free (NamePlaces *places)
{
  g_hash_table_unref (places->places);
  g_free (places);
}

void
name_places_forget (NamePlaces *places)
{
  g_hash_table_remove_all (places->places);
}

static gboolean
is_old (gpointer name, gpointer place, gpointer places)
{
  (void)name;
  return ((const KnownPlace *)place)->picture
         < ((const NamePlaces *)places)->picture;
}

void
name_places_begin (NamePlaces *places,
                   const Scene *scene,
                   const Projection *projection)
{
  if (places->is_space != scene->is_space
      || places->n_sites != scene->stock.n_sites
      || projection->width < places->width || projection->width > places->width
      || projection->height < places->height
      || projection->height > places->height)
    name_places_forget (places);
  /* Those that the picture before did not have. */
  g_hash_table_foreach_remove (places->places, is_old, places);
  places->picture++;
  places->may_stay = places->edition == scene->stock.edition;
  places->edition = scene->stock.edition;
  places->is_space = scene->is_space;
  places->n_sites = scene->stock.n_sites;
  places->n_told = places->n_jumps = 0;
  places->width = projection->width;
  places->height = projection->height;
}

#define KEY_ROOM (LABEL_ROOM + 24)

/* Signs of answers are the same at several objects. */
static void
write_key (const SceneItem *item, char key[KEY_ROOM])
{
  g_snprintf (key, KEY_ROOM, "%s %u %u", item->label, item->object.kind,
              item->object.number);
}

static KnownPlace *
find (const NamePlaces *places, const SceneItem *item)
{
  char key[KEY_ROOM];

  write_key (item, key);
  return g_hash_table_lookup (places->places, key);
}

void
name_places_tell (NamePlaces *places, const SceneItem *item, Pixel at)
{
  KnownPlace *place = find (places, item);
  double way;

  if (place == NULL) {
    place = g_new0 (KnownPlace, 1);
    place->here = nowhere;
    place->at = at;
    char key[KEY_ROOM];

    write_key (item, key);
    g_hash_table_insert (places->places, g_strdup (key), place);
  }
  way = hypot (at.x - place->at.x, at.y - place->at.y);
  places->may_stay = places->may_stay || way > 0;
  places->n_told++;
  places->n_jumps += way > JUMP_PX;
  place->picture = places->picture;
  place->last = way > JUMP_PX ? nowhere : place->here;
  place->here = nowhere;
  place->at = at;
}

LabelPlace
name_places_find (const NamePlaces *places, const SceneItem *item)
{
  const KnownPlace *place = find (places, item);

  return place == NULL || !places->may_stay
                 || 2 * places->n_jumps > places->n_told
             ? nowhere
             : place->last;
}

void
name_places_keep (NamePlaces *places, const SceneItem *item, LabelPlace where)
{
  KnownPlace *place = find (places, item);

  if (place != NULL)
    place->here = where;
}

LabelPlace
name_places_get (const NamePlaces *places, const SceneItem *item)
{
  const KnownPlace *place = find (places, item);

  return place == NULL || place->picture < places->picture ? nowhere
                                                           : place->here;
}
