/* The phase of a thermostat's cycle. What a place does in the sun goes back to the instant at which
 * the heater last switched, and the state at the start of a run is not known to a hundredth of a
 * kelvin. So evidence for a heater must not hang on the phase that a scenario happens to end with.
 *
 * An effect is fitted first with the phase not stated. Then phases are scanned, and from the best
 * one all numbers are searched together.
 *
 * - Where the effect leads without, its power and temperatures stand, and phases are scanned with
 *   them alone. The phase stays free where BIC, which counts it as a number, falls by the evidence.
 * - Where another effect leads, other powers and bands are scanned, too, and BIC has to fall. */
#include <math.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

size_t um_diagnosis_phase_of(const struct um_effect *effect)
{
  size_t p = 0;
  while (p < effect->nparameter && !effect->parameters[p].is_phase) p++;
  return p;
}

bool um_diagnosis_phase_is_free(const struct um_sensitivity_candidate *c,
                                const struct um_model_addition *addition)
{
  size_t p = um_diagnosis_phase_of(addition->effect);
  return p < addition->effect->nparameter && addition->value[p] != c->null_value[p];
}

void um_diagnosis_phase_free(struct um_diagnosis_state *state, size_t b)
{
  struct um_diagnosis_block *block = &state->block[b];
  const struct um_effect *effect = block->addition.effect;
  size_t p = um_diagnosis_phase_of(effect), k = block->nfree;
  block->parameter[k] = p;
  block->prior_mean[k] = 0.5;
  block->prior_sigma[k] = INFINITY;
  block->step[k] = UM_DIAGNOSIS_PHASE_STEP;
  block->minimum[k] = UM_DIAGNOSIS_PHASE_STEP;
  block->maximum[k] = 1.0;
  block->nfree++;
  state->nparameter++;
}

/* Powers and widths of the band that phases are scanned with [of the fitted ones]. A fit that the
 * phase was kept from makes many small cycles of one that it cannot place. */
static const double powers[] = {1.0, 0.5, 0.3};
static const double bands[] = {1.0, 1.4, 2.0};
static const double middles[] = {0.0, 0.25}; /* by which the middle lies higher [of the band] */

#define POWERS  (sizeof powers / sizeof powers[0])
#define BANDS   (sizeof bands / sizeof bands[0])
#define MIDDLES (sizeof middles / sizeof middles[0])

/* The addition with power and band scaled, and the middle of the band moved. */
static void scale(const struct um_sensitivity_candidate *c, double power, double band,
                  double middle, struct um_model_addition *addition)
{
  double lower = 0.0;
  addition->value[c->parameter[0]] *= power;
  for (size_t s = 0; s < c->nunidentified; s++) {
    size_t p = c->unidentified[s];
    if (!c->effect->parameters[p].logarithmic) continue;
    lower = (0.5 * (band - 1.0) - middle) * addition->value[p];
    addition->value[p] *= band;
  }
  for (size_t s = 0; s < c->nunidentified; s++)
    if (c->effect->parameters[c->unidentified[s]].is_temperature)
      addition->value[c->unidentified[s]] -= lower;
}

/* Where a scan leads. */
struct start {
  struct um_model_addition addition;
  double chi2; /* of the observations */
};

/* Insert it into the list of the best [UM_DIAGNOSIS_PHASE_STARTS], which is sorted, rising. */
static void offer(struct start best[UM_DIAGNOSIS_PHASE_STARTS], const struct start *of)
{
  if (!(of->chi2 < best[UM_DIAGNOSIS_PHASE_STARTS - 1].chi2)) return;
  size_t to = UM_DIAGNOSIS_PHASE_STARTS - 1;
  for (; to > 0 && of->chi2 < best[to - 1].chi2; to--) best[to] = best[to - 1];
  best[to] = *of;
}

/* The best places of a scan, each of another power and band; chi2 INFINITY: there is none. */
static enum um_status scan(struct um_context *context, const struct um_diagnosis_work *work,
                           const struct um_diagnosis_state *state, size_t b, bool leads,
                           struct start best[UM_DIAGNOSIS_PHASE_STARTS])
{
  enum um_status status;
  struct um_diagnosis_state trial = {0};
  const struct um_sensitivity_candidate *c =
      &work->candidates->candidate[state->block[b].candidate];
  size_t phase = um_diagnosis_phase_of(c->effect);
  for (size_t i = 0; i < UM_DIAGNOSIS_PHASE_STARTS; i++) best[i].chi2 = INFINITY;
  UM_CHECK(um_diagnosis_state_copy(context, state, state->nblock, &trial));
  struct start at = {.chi2 = INFINITY};
  double highest = -INFINITY; /* of the phases with all else as it is */
  for (size_t k = 0; k < (leads ? 1 : POWERS * BANDS); k++) {
    struct start of = {.chi2 = INFINITY};
    for (size_t i = 0; i < (leads ? 1 : MIDDLES) * UM_DIAGNOSIS_PHASES; i++) {
      at.addition = state->block[b].addition;
      scale(c, powers[k / BANDS], bands[k % BANDS], middles[i / UM_DIAGNOSIS_PHASES], &at.addition);
      at.addition.value[phase] = ((double)(i % UM_DIAGNOSIS_PHASES) + 0.5) / UM_DIAGNOSIS_PHASES;
      trial.block[b].addition = at.addition;
      UM_CHECK(um_diagnosis_chi2(context, work, &trial, &at.chi2));
      if (at.chi2 < of.chi2) of = at;
      if (k > 0 || i >= UM_DIAGNOSIS_PHASES) continue;
      highest = fmax(highest, at.chi2);
      if (i + 1 == UM_DIAGNOSIS_PHASES && !(highest - of.chi2 > UM_DIAGNOSIS_BETTER))
        goto done; /* nothing that was measured tells phases apart */
    }
    offer(best, &of);
  }
done:
  um_diagnosis_state_release(context, &trial);
  return status;
}

/* The state with the phase of block b free, searched from there. */
static enum um_status search_from(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state, size_t b,
                                  const struct um_model_addition *from,
                                  struct um_diagnosis_state *out)
{
  UM_TRY(um_diagnosis_state_copy(context, state, state->nblock, out));
  out->block[b].addition = *from;
  um_diagnosis_phase_free(out, b);
  UM_TRY(um_diagnosis_state_fit(context, work, out, NULL, NULL, INFINITY));
  if (!(out->fit->bic < state->fit->bic + UM_DIAGNOSIS_SMALL)) return UM_OK;
  return um_diagnosis_simplex_refine(context, work, out, b);
}

static void swap(struct um_diagnosis_state *a, struct um_diagnosis_state *b)
{
  struct um_diagnosis_state other = *a;
  *a = *b;
  *b = other;
}

/* Another minimum that does nearly as well is as likely a place of the values: sigmas of block b
 * reach it as those of a parabola would (non_smooth.c). */
static void reach(const struct um_diagnosis_state *other, size_t b,
                  const struct um_diagnosis_state *state)
{
  size_t first = 0;
  double higher = other->fit->bic - state->fit->bic;
  for (size_t i = 0; i < b; i++) first += state->block[i].nfree;
  if (!(higher < UM_DIAGNOSIS_VALLEY * UM_DIAGNOSIS_VALLEY)) return;
  for (size_t k = first; k < first + state->block[b].nfree; k++) {
    double away = fabs(other->fit->x[k] - state->fit->x[k]) / sqrt(fmax(higher, 1.0));
    if (!isnan(state->fit->sigma[k])) state->fit->sigma[k] = fmax(state->fit->sigma[k], away);
  }
}

/* Whether a fit that leaves noise with one number more would not lower BIC, or not come to `lead`.
 */
static bool is_vain(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                    double lead)
{
  double n = (double)work->forward->observations.count;
  double gain = state->fit->chi2 - (n - (double)state->nparameter - 1.0) - log(n);
  return !(gain > 0.0 && state->fit->bic - gain < lead + UM_DIAGNOSIS_EVIDENCE);
}

enum um_status um_diagnosis_phase_refine(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         struct um_diagnosis_state *state, size_t b, double lead)
{
  enum um_status status;
  const struct um_sensitivity_candidate *c =
      &work->candidates->candidate[state->block[b].candidate];
  struct um_diagnosis_state trial = {0}, least = {0};
  struct start start[UM_DIAGNOSIS_PHASE_STARTS];
  size_t p = um_diagnosis_phase_of(c->effect);
  bool leads = state->fit->bic < lead;
  double now, cost = log((double)work->forward->observations.count);
  if (p == c->effect->nparameter || c->null_value[p] != c->effect->parameters[p].null_value)
    return UM_OK; /* it has none, or the scenario states it */
  if (um_diagnosis_phase_is_free(c, &state->block[b].addition) ||
      !(state->fit->bic < lead + UM_DIAGNOSIS_FAR_BEHIND) || is_vain(work, state, lead))
    return UM_OK;
  UM_TRY(um_diagnosis_chi2(context, work, state, &now));
  UM_TRY(scan(context, work, state, b, leads, start));
  for (size_t i = 0; i < UM_DIAGNOSIS_PHASE_STARTS; i++) {
    double gain = now - start[i].chi2;
    if (i > 0 && !(start[i].chi2 < start[0].chi2 + UM_DIAGNOSIS_BETTER)) break;
    if (!(gain > -UM_DIAGNOSIS_EVIDENCE &&
          state->fit->bic - gain + cost < lead + UM_DIAGNOSIS_EVIDENCE))
      break;
    UM_CHECK(search_from(context, work, state, b, &start[i].addition, &trial));
    if (least.fit == NULL || trial.fit->bic < least.fit->bic) swap(&trial, &least);
    if (trial.fit != NULL) reach(&trial, b, &least);
    um_diagnosis_state_release(context, &trial);
  }
  if (least.fit != NULL && least.fit->bic < state->fit->bic - (leads ? UM_DIAGNOSIS_EVIDENCE : 0.0))
    swap(state, &least);
done:
  um_diagnosis_state_release(context, &trial);
  um_diagnosis_state_release(context, &least);
  return status;
}
