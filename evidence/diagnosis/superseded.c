/* An effect that was found first, and that several others replaced. It stays on record: without the
 * evidence for several it would have been the answer. */
#include "evidence/diagnosis/steps_impl.h"

#include <string.h>

#include "base/core/suggestions.h"

static bool same_use(const struct um_model_addition *a, const struct um_model_addition *b)
{
  return a->effect == b->effect && um_core_words_same(a->target, b->target);
}

enum um_status um_diagnosis_superseded_take(struct um_context *context, struct um_diagnosis *d)
{
  if (d->nstep == 0) return UM_OK;
  UM_TRY(um_core_allocate(context, d->nstep, sizeof *d->superseded, &d->superseded));
  d->nsuperseded = d->nstep;
  for (size_t s = 0; s < d->nstep; s++) {
    const struct um_diagnosis_step *step = &d->step[s];
    d->superseded[s] = (struct um_diagnosis_superseded){.addition = step->addition,
                                                        .chi2 = step->chi2,
                                                        .bic = step->alternative[0].bic,
                                                        .alone = s == 0};
    memcpy(d->superseded[s].sigma, step->sigma, sizeof step->sigma);
  }
  return UM_OK;
}

void um_diagnosis_superseded_keep(const struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  size_t kept = 0;
  for (size_t i = 0; i < d->nsuperseded; i++) {
    bool stays = false;
    for (size_t b = state->nnuisance; b < state->nblock; b++)
      stays = stays || same_use(&state->block[b].addition, &d->superseded[i].addition);
    for (size_t s = 0; s < d->nstep; s++)
      stays = stays || same_use(&d->step[s].addition, &d->superseded[i].addition);
    if (!stays) d->superseded[kept++] = d->superseded[i];
  }
  d->nsuperseded = kept;
}
