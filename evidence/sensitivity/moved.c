/* Moves whose heat is known: kept, found, released. */
#include "evidence/sensitivity/moved_impl.h"

#include <string.h>

#include "base/core/suggestions.h"

void um_sensitivity_moves_destroy(struct um_context *context, struct um_sensitivity_moves **moves)
{
  struct um_sensitivity_moves *m = *moves;
  if (m == NULL) return;
  for (size_t i = 0; i < m->nrun; i++) {
    um_model_light_sensitivity_destroy(context, &m->run[i].light);
    um_model_thermal_sensitivity_destroy(context, &m->run[i].thermal);
  }
  UM_FREE(context, m->moved, m->run, m);
  *moves = NULL;
}

const struct um_sensitivity_moved *um_sensitivity_moves_of(const struct um_sensitivity_moves *moves,
                                                           const struct um_sensitivity_move *move)
{
  for (size_t i = 0; moves != NULL && move != NULL && i < moves->count; i++) {
    const struct um_sensitivity_moved *m = &moves->moved[i];
    if (m->sensitivity != NULL && m->move.effect == move->effect &&
        m->move.parameter == move->parameter && um_core_words_same(m->move.target, move->target) &&
        memcmp(m->move.at, move->at, move->effect->nparameter * sizeof *move->at) == 0)
      return m;
  }
  return NULL;
}
