/* What convinces a sceptic, of the effect that explains most. All of it is linear in observations
 * and costs no run of the model but those of one fit without the effect.
 *
 *   frozen      its values from one half of the time before the other half (frozen.c)
 *   search      the least p among all candidates in draws of noise (base/inference/search_p.c)
 *   influence   its lead with a channel, a row, a prior's width, the noise changed (influence.c)
 *   open set    what would be said, were it not in the catalogue */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/sceptic_impl.h"

void um_diagnosis_keep_rows(const double *column, size_t ncolumn, size_t n, const bool *kept,
                            double *out)
{
  for (size_t i = 0; i < ncolumn * n; i++) out[i] = kept[i % n] ? column[i] : 0.0;
}

static enum um_status own_columns(struct um_context *context, struct um_diagnosis_doubt *s)
{
  const struct um_diagnosis_block *block = &s->state->block[s->b];
  const double *sigma = s->work->forward->observations.sigma;
  size_t first = 0;
  for (size_t i = 0; i < s->b; i++) first += s->state->block[i].nfree;
  s->ncolumn = block->nfree > 0 ? block->nfree : 1;
  UM_TRY(um_core_allocate(context, s->ncolumn * s->n, sizeof *s->column, &s->column));
  for (size_t j = 0; j < s->n && block->nfree == 0; j++)
    s->column[j] = (s->state->fit->value[j] - s->without.fit->value[j]) / sigma[j];
  if (block->nfree > 0)
    memcpy(s->column, s->state->fit->jacobian + first * s->n,
           s->ncolumn * s->n * sizeof *s->column);
  for (size_t k = 0; k < s->ncolumn; k++)
    um_inference_noise_whiten(s->work->noise, s->column + k * s->n);
  return UM_OK;
}

static enum um_status begin(struct um_context *context, struct um_diagnosis_doubt *s)
{
  UM_TRY(um_diagnosis_without(context, s->work, s->state, s->b, &s->without));
  UM_TRY(um_diagnosis_directions_make(context, s->work, &s->without, &s->d));
  UM_TRY(um_core_allocate(context, s->n, sizeof *s->residual, &s->residual));
  um_diagnosis_residual_at_means(s->work, &s->without, s->n, s->residual);
  return own_columns(context, s);
}

static void release(struct um_context *context, struct um_diagnosis_doubt *s)
{
  UM_FREE(context, s->residual, s->column);
  um_diagnosis_directions_release(context, &s->d);
  um_diagnosis_state_release(context, &s->without);
}

/* ---- open set ---- */

/* The best alternative that is another effect; NULL: none was fitted. */
static const struct um_diagnosis_alternative *another(const struct um_diagnosis_step *step)
{
  for (size_t i = 1; i < step->nalternative; i++)
    if (step->alternative[i].fitted && !step->alternative[i].same_effect)
      return &step->alternative[i];
  return NULL;
}

static void open_set(const struct um_diagnosis_step *step, double dof,
                     struct um_diagnosis_sceptic *out)
{
  const struct um_diagnosis_alternative *winner = &step->alternative[0], *next = another(step);
  double without = winner->bic - step->delta_bic;
  if (next == NULL || !(next->bic < without - UM_DIAGNOSIS_EVIDENCE)) return; /* nothing */
  out->else_candidate = next->candidate;
  out->has_else = true;
  out->else_behind = next->bic - winner->bic;
  out->else_reduced = next->chi2 / dof;
}

enum um_status um_diagnosis_sceptic_ask(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d)
{
  enum um_status status = UM_OK;
  struct um_diagnosis_doubt s = {
      .work = work, .state = state, .n = work->forward->observations.count};
  const struct um_diagnosis_step *step = NULL;
  for (size_t i = 0; i < d->nstep && step == NULL; i++)
    if (!d->step[i].removed) step = &d->step[i];
  if (step == NULL || step->nalternative == 0) return UM_OK;
  for (s.b = state->nnuisance; s.b < state->nblock; s.b++)
    if (state->block[s.b].candidate == step->candidate) break;
  if (s.b == state->nblock) return UM_OK;
  UM_CHECK(begin(context, &s));
  d->sceptic = (struct um_diagnosis_sceptic){.asked = true, .step = (size_t)(step - d->step)};
  UM_CHECK(um_diagnosis_frozen(context, &s, &d->sceptic.frozen));
  UM_CHECK(um_inference_search_p(context, s.n, &s.d.nuisance, work->candidates->count,
                                 s.d.direction, step->alternative[0].score.p, UM_DIAGNOSIS_DRAWS, 1,
                                 &d->sceptic.search_p));
  UM_CHECK(um_diagnosis_influence(context, &s, step, &d->sceptic));
  open_set(step, d->dof_after, &d->sceptic);
done:
  release(context, &s);
  return status;
}
