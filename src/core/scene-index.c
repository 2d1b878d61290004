/* Which items of a scene's stock have an object, so that to light it is no
 * matter of how many others there are: chains of items by a hash of it. */
#include "memory.h"
#include "scene-builder.h"

#include <stdlib.h>
#include <string.h>

static uint32_t *
head_of (const SceneIndex *index, Object object)
{
  const uint32_t hash
      = (object.number * 5 + (uint32_t)object.kind) * 0x9e3779b1U;

  return &index->heads[(hash >> 7) & index->mask];
}

static void
make_room (SceneIndex *index, uint32_t n_items)
{
  uint32_t size = 16;

  while (size < n_items)
    size *= 2;
  if (index->heads == NULL || size - 1 > index->mask) {
    free (index->heads);
    index->heads = memory_new (size, sizeof *index->heads);
    index->mask = size - 1;
  } else {
    memset (index->heads, 0, (index->mask + 1U) * sizeof *index->heads);
  }
  if (n_items > index->next_room)
    index->next = memory_grow (index->next, &index->next_room, n_items,
                               sizeof *index->next);
}

void
scene_index_renew (Scene *scene)
{
  SceneIndex *index = &scene->index;
  const uint32_t n = scene->stock.n_items;
  uint32_t i;

  if (index->edition == scene->stock.edition)
    return;
  index->edition = scene->stock.edition;
  make_room (index, n);
  /* The last first, so that chains ascend. */
  for (i = n; i-- > 0;) {
    uint32_t *head;

    if (scene->items[i].object.kind == OBJECT_NONE)
      continue;
    head = head_of (index, scene->items[i].object);
    index->next[i] = *head;
    *head = i + 1;
  }
}

void
scene_prepare_light (Scene *scene)
{
  scene_index_renew (scene);
}

/* From a link of a chain to the first item of @object. */
static uint32_t
follow (const Scene *scene, uint32_t link, Object object)
{
  while (link != 0 && !object_equal (scene->items[link - 1].object, object))
    link = scene->index.next[link - 1];
  return link == 0 ? INDEX_NONE : link - 1;
}

uint32_t
scene_index_first (const Scene *scene, Object object)
{
  return follow (scene, *head_of (&scene->index, object), object);
}

uint32_t
scene_index_next (const Scene *scene, uint32_t item)
{
  return follow (scene, scene->index.next[item], scene->items[item].object);
}

void
scene_index_clear (SceneIndex *index)
{
  free (index->heads);
  free (index->next);
}
