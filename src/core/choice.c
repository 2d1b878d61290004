#include "choice.h"

#include <stddef.h>

const HullChoice *
hull_choices_find (const HullChoices *choices,
                   EventKind kind,
                   uint32_t round,
                   uint32_t site)
{
  uint32_t i;

  for (i = 0; choices != NULL && i < choices->n_rows; i++) {
    const HullChoice *row = &choices->rows[i];

    if (row->kind == kind && row->round == round
        && (kind == EVENT_SELECT || row->site == site))
      return row;
  }
  return NULL;
}
