/* The observation that would tell an effect from an alternative, among those the scenario has: its
 * bands and places in sunlight, penumbra and umbra of its own window, and of the bands those that
 * lie at high airmass.
 *
 * Both explanations are computed as they were fitted (apart.c). Where none helps, what the effects
 * themselves say tells them apart is said. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/order.h"
#include "environment/airmass.h"
#include "evidence/comparison/segments.h"
#include "evidence/diagnosis/apart_impl.h"
#include "evidence/diagnosis/coming_impl.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

static const enum um_compare_segment light[] = {UM_SEGMENT_SUNLIT, UM_SEGMENT_PENUMBRA,
                                                UM_SEGMENT_UMBRA};

struct chi2_difference {
  double airmass[UM_SEGMENT_COUNT]; /* observations above this airmass; NaN: all */
  double worth[UM_SEGMENT_COUNT], sigma[UM_SEGMENT_COUNT];         /* means over the observations */
  double phase_from[UM_SEGMENT_COUNT], phase_to[UM_SEGMENT_COUNT]; /* [rad] */
  size_t count[UM_SEGMENT_COUNT];
};

static void collect(struct chi2_difference *s, enum um_compare_segment segment, double worth,
                    double sigma, double phase)
{
  s->worth[segment] += worth;
  s->sigma[segment] += sigma;
  if (s->count[segment] == 0) s->phase_from[segment] = s->phase_to[segment] = phase;
  s->phase_from[segment] = fmin(s->phase_from[segment], phase);
  s->phase_to[segment] = fmax(s->phase_to[segment], phase);
  s->count[segment]++;
}

/* Keep the best segment of a channel where it is better than what is kept. */
static enum um_status offer(struct um_context *context, const struct chi2_difference *s,
                            enum um_compare_quantity quantity, const char *of,
                            struct um_diagnosis_next *next)
{
  for (size_t i = 0; i < sizeof light / sizeof light[0]; i++) {
    enum um_compare_segment g = light[i];
    if (s->count[g] == 0) continue;
    double worth = s->worth[g] / (double)s->count[g];
    double least =
        isnan(s->airmass[g]) ? 1.0 : UM_DIAGNOSIS_CLEARER; /* of those that are part of others */
    if (!(worth > least * next->chi2_difference)) continue;
    um_core_free(context, next->of);
    next->of = NULL;
    UM_TRY(um_core_strdup(context, of, &next->of));
    next->quantity = quantity;
    next->airmass = s->airmass[g];
    next->segment = g;
    next->chi2_difference = worth;
    next->sigma = s->sigma[g] / (double)s->count[g];
    next->phase_from = s->phase_from[g];
    next->phase_to = s->phase_to[g];
  }
  return UM_OK;
}

static double airmass_at(const struct um_sensitivity_forward_run *run, size_t k)
{
  const struct um_model_tables *p = run->variant.tables;
  return um_environment_airmass_toward(p->look[k * p->nsub + p->nsub / 2].elevation);
}

/* Angle Sun, satellite, observer in the middle of the exposure [rad]. */
static double phase_at(const struct um_sensitivity_forward_run *run, size_t k)
{
  const struct um_model_tables *p = run->variant.tables;
  const struct um_environment_sample *s = &p->sample[k * p->nsub + p->nsub / 2];
  return um_vec3_angle(s->sun, s->to_observer);
}

/* Airmass above which a third of the observations of a segment lie; NaN: no station, or too little
 * range. */
static enum um_status high_airmass(struct um_context *context,
                                   const struct um_sensitivity_forward_run *run,
                                   const enum um_compare_segment *segment,
                                   enum um_compare_segment which, double *out)
{
  double *airmass = NULL;
  size_t n = 0, nobs = run->variant.tables->nobs;
  *out = NAN;
  if (!run->variant.model->has_observer) return UM_OK;
  UM_TRY(um_core_allocate(context, nobs, sizeof *airmass, &airmass));
  for (size_t k = 0; k < nobs; k++) {
    double x = airmass_at(run, k);
    if (segment[k] == which && isfinite(x)) airmass[n++] = x;
  }
  if (n > 2) {
    qsort(airmass, n, sizeof *airmass, um_core_order_double);
    if (airmass[n - 1] > UM_DIAGNOSIS_RANGE * airmass[0])
      *out = airmass[(size_t)(UM_DIAGNOSIS_HIGH * (double)n)];
  }
  um_core_free(context, airmass);
  return UM_OK;
}

/* A band in the segments, of all observations and of those at high airmass. */
static enum um_status offer_band(struct um_context *context, const struct um_sensitivity_forward *f,
                                 const struct um_sensitivity_forward_run run[2], size_t band,
                                 const double *high, const enum um_compare_segment *segment,
                                 struct um_diagnosis_next *next)
{
  const struct um_model_result *a = run[0].result, *b = run[1].result;
  const char *name = run[0].variant.model->band[band].name;
  struct chi2_difference all = {0}, above = {0};
  for (size_t g = 0; g < UM_SEGMENT_COUNT; g++) {
    all.airmass[g] = NAN;
    above.airmass[g] = high[g];
  }
  const struct um_diagnosis_band_noise noise = um_diagnosis_noise_of_band(f, a, band, name);
  for (size_t k = 0; k < a->nobs; k++) {
    double sigma, worth = um_diagnosis_apart(&noise, a, b, band, k, &sigma);
    double phase = phase_at(&run[0], k);
    if (isnan(worth)) continue;
    collect(&all, segment[k], worth, sigma, phase);
    if (airmass_at(&run[0], k) > high[segment[k]]) collect(&above, segment[k], worth, sigma, phase);
  }
  UM_TRY(offer(context, &all, UM_QUANTITY_BAND_IRRADIANCE, name, next));
  return offer(context, &above, UM_QUANTITY_BAND_IRRADIANCE, name, next);
}

static enum um_status offer_bands(struct um_context *context,
                                  const struct um_sensitivity_forward *f,
                                  const struct um_sensitivity_forward_run run[2],
                                  const enum um_compare_segment *segment,
                                  struct um_diagnosis_next *next)
{
  double high[UM_SEGMENT_COUNT];
  for (size_t g = 0; g < UM_SEGMENT_COUNT; g++)
    UM_TRY(high_airmass(context, &run[0], segment, (enum um_compare_segment)g, &high[g]));
  for (size_t band = 0; band < run[0].result->nband && run[0].variant.model->has_observer; band++)
    UM_TRY(offer_band(context, f, run, band, high, segment, next));
  return UM_OK;
}

static enum um_status offer_places(struct um_context *context,
                                   const struct um_sensitivity_forward *f,
                                   const struct um_sensitivity_forward_run run[2],
                                   const enum um_compare_segment *segment,
                                   struct um_diagnosis_next *next)
{
  const struct um_model_result *a = run[0].result, *b = run[1].result;
  for (size_t p = 0; p < a->nplace && p < b->nplace; p++) {
    struct chi2_difference s = {0};
    for (size_t g = 0; g < UM_SEGMENT_COUNT; g++) s.airmass[g] = NAN;
    double sigma = um_diagnosis_sigma_of(f, true, a->place[p].name);
    for (size_t k = 0; k < a->nobs; k++) {
      double apart = (a->place[p].mean[k] - b->place[p].mean[k]) / sigma;
      collect(&s, segment[k], apart * apart, sigma, NAN);
    }
    UM_TRY(offer(context, &s, UM_QUANTITY_TEMPERATURE, a->place[p].name, next));
  }
  return UM_OK;
}

double um_diagnosis_next_values(const struct um_diagnosis_next *next)
{
  return next->what != NULL ? ceil(UM_INFERENCE_SEPARABLE / next->chi2_difference) : NAN;
}

static enum um_status say(struct um_context *context, struct um_diagnosis_next *next)
{
  char above[48] = "";
  if (next->of == NULL || next->chi2_difference < UM_DIAGNOSIS_WORTH_SAYING) return UM_OK;
  if (!isnan(next->airmass))
    snprintf(above, sizeof above, ", at an airmass above %.2g", next->airmass);
  return um_core_asprintf(context, &next->what, "%s of %s, %s%s",
                          next->quantity == UM_QUANTITY_TEMPERATURE ? "temperature" : "irradiance",
                          next->of, um_compare_segment_name(next->segment), above);
}

/* Additions of the state, the winner of the step replaced by an alternative as it was fitted. */
static void replace(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                    const struct um_diagnosis_step *step,
                    const struct um_diagnosis_alternative *alternative,
                    struct um_model_addition *out)
{
  um_diagnosis_state_additions(state, out);
  for (size_t b = 0; b < state->nblock; b++) {
    if (state->block[b].candidate != step->candidate) continue;
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[alternative->candidate];
    out[b] = (struct um_model_addition){.effect = c->effect, .target = c->target, .off = c->off};
    memcpy(out[b].value, alternative->value, sizeof out[b].value);
  }
}

static enum um_status look(struct um_context *context, const struct um_diagnosis_work *work,
                           const struct um_sensitivity_forward_run run[2],
                           struct um_diagnosis_next *next)
{
  enum um_status status;
  enum um_compare_segment *segment = NULL, *motion = NULL;
  size_t nobs = run[0].variant.tables->nobs;
  next->from = run[0].variant.tables->t_obs[0];
  next->to = run[0].variant.tables->t_obs[nobs - 1];
  UM_CHECK(um_core_allocate(context, nobs, sizeof *segment, &segment));
  UM_CHECK(um_core_allocate(context, nobs, sizeof *motion, &motion));
  UM_CHECK(um_compare_segments_find(context, run[0].variant.model, run[0].variant.tables, segment,
                                    motion));
  UM_CHECK(offer_bands(context, work->forward, run, segment, next));
  UM_CHECK(offer_places(context, work->forward, run, segment, next));
  if (next->of != NULL)
    UM_CHECK(um_diagnosis_cadence_of(context, work->forward,
                                     next->quantity == UM_QUANTITY_TEMPERATURE, next->of,
                                     &next->cadence));
  UM_CHECK(say(context, next));
done:
  UM_FREE(context, motion, segment);
  return status;
}

/* What the effects' descriptors say of telling them apart. The one that names the other is
 * preferred.
 */
static const char *told_apart(const struct um_effect *winner, const struct um_effect *other)
{
  if (winner->separated_by != NULL && strstr(winner->separated_by, other->name) != NULL)
    return winner->separated_by;
  if (other->separated_by != NULL && strstr(other->separated_by, winner->name) != NULL)
    return other->separated_by;
  return winner->separated_by != NULL ? winner->separated_by : other->separated_by;
}

/* With the winner of a step, and with an alternative: over the scenario's window, and over passes
 * to come. */
struct looks {
  struct um_sensitivity_forward_run run[2], ahead[2];
  const struct um_diagnosis_coming *coming;
};

static enum um_status look_with(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_model_addition *addition, size_t n, int which,
                                struct looks *looks)
{
  static const struct um_model_instants window = {.count = 0};
  UM_TRY(
      um_sensitivity_forward_run(context, work->forward, addition, n, &window, &looks->run[which]));
  if (looks->coming->npass == 0 || (which > 0 && looks->ahead[0].result == NULL)) return UM_OK;
  enum um_status status = um_sensitivity_forward_run(
      context, work->forward, addition, n, &looks->coming->instants, &looks->ahead[which]);
  if (status != UM_ERR_INPUT && status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  /* a table of the attitude may end before they come: the verdict stands without them */
  um_core_log(context, UM_LOG_WARNING, "passes to come are not looked at: %s",
              um_core_message(context));
  um_core_message_clear(context);
  return UM_OK;
}

static void release_looks(struct um_context *context, int which, struct looks *looks)
{
  um_sensitivity_forward_run_release(context, &looks->run[which]);
  um_sensitivity_forward_run_release(context, &looks->ahead[which]);
}

/* Find the observation that tells one alternative from the winner, which `looks` has; NULL: only
 * what the descriptors say. */
static enum um_status find_one(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_diagnosis_state *state, struct um_diagnosis *d,
                               size_t s, const struct um_diagnosis_alternative *alternative,
                               struct looks *looks)
{
  enum um_status status = UM_OK;
  const struct um_diagnosis_step *step = &d->step[s];
  struct um_model_addition *addition = NULL;
  UM_TRY(um_core_reallocate(context, d->nnext + 1, sizeof *d->next_of, (void **)&d->next_of));
  struct um_diagnosis_next *next = &d->next_of[d->nnext++];
  *next = (struct um_diagnosis_next){.airmass = NAN,
                                     .phase_from = NAN,
                                     .phase_to = NAN,
                                     .from = NAN,
                                     .to = NAN,
                                     .step = s,
                                     .candidate = alternative->candidate};
  if (looks != NULL) {
    UM_CHECK(um_core_allocate(context, state->nblock, sizeof *addition, &addition));
    replace(work, state, step, alternative, addition);
    UM_CHECK(look_with(context, work, addition, state->nblock, 1, looks));
    UM_CHECK(look(context, work, looks->run, next));
    if (looks->ahead[1].result != NULL)
      UM_CHECK(um_diagnosis_coming_tell(context, work->forward, looks->coming, looks->ahead, next));
  }
  if (next->what == NULL)
    next->told_apart_by = told_apart(step->addition.effect,
                                     work->candidates->candidate[alternative->candidate].effect);
done:
  if (looks != NULL) release_looks(context, 1, looks);
  um_core_free(context, addition);
  return status;
}

static enum um_status find_of_step(struct um_context *context, const struct um_diagnosis_work *work,
                                   const struct um_diagnosis_state *state, struct um_diagnosis *d,
                                   size_t s, const struct um_diagnosis_coming *coming)
{
  enum um_status status = UM_OK;
  struct looks looks = {.coming = coming};
  struct um_model_addition *addition = NULL;
  size_t tied = 0, looked = 0;
  for (size_t i = 1; i < d->step[s].nalternative; i++)
    tied += d->step[s].alternative[i].indistinguishable;
  if (tied == 0) return UM_OK; /* what was not tried has no values to compute with */
  um_core_progress_begin(context, "looking for the next measurement", tied);
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *addition, &addition));
  um_diagnosis_state_additions(state, addition);
  UM_CHECK(look_with(context, work, addition, state->nblock, 0, &looks));
  for (size_t i = 1; i < d->step[s].nalternative; i++) {
    const struct um_diagnosis_alternative *alternative = &d->step[s].alternative[i];
    if (!alternative->indistinguishable) continue;
    UM_CHECK(find_one(context, work, state, d, s, alternative,
                      looked < UM_DIAGNOSIS_NEAREST ? &looks : NULL));
    looked++;
    UM_CHECK(um_core_progress_step(context, 1));
  }
done:
  um_core_progress_end(context);
  um_core_free(context, addition);
  release_looks(context, 0, &looks);
  return status;
}

static enum um_status find_all(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_diagnosis_state *state, struct um_diagnosis *d,
                               const struct um_diagnosis_coming *coming)
{
  for (int small = 0; small < 2 && d->nnext == 0; small++)
    for (size_t s = 0; s < d->nstep; s++)
      if (um_diagnosis_has_group(&d->step[s]) &&
          (d->step[s].confidence == UM_CONFIDENCE_SMALL) == (small == 1))
        UM_TRY(find_of_step(context, work, state, d, s, coming));
  return UM_OK;
}

enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      struct um_diagnosis *d)
{
  enum um_status status = UM_OK;
  struct um_diagnosis_coming coming = {.npass = 0};
  bool ambiguous = false;
  for (size_t s = 0; s < d->nstep; s++)
    ambiguous = ambiguous || um_diagnosis_has_group(&d->step[s]);
  if (ambiguous && work->options->passes > 0)
    UM_CHECK(um_diagnosis_coming_create(context, work->forward, work->options->passes, &coming));
  UM_CHECK(find_all(context, work, state, d, &coming));
  for (size_t i = 0; i < d->nnext; i++) { /* one that was computed counts, the hardest first */
    struct um_diagnosis_next *next = &d->next_of[i];
    if (isnan(next->from)) continue;
    if (d->next == NULL || next->chi2_difference < d->next->chi2_difference) d->next = next;
  }
  if (d->next == NULL && d->nnext > 0) d->next = &d->next_of[0];
done:
  um_diagnosis_coming_release(context, &coming);
  return status;
}
