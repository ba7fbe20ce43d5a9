/* The observation that would tell two explanations apart, among those the scenario has: its bands
 * and places in sunlight, penumbra and umbra of its own window.
 *
 * Both explanations are computed as they were fitted; per row of a channel the expected chi-square
 * between them is the mean of ((M1 - M2) / sigma)^2. Sigma is that of rows of the channel which
 * were measured, else a usual one. */
#include <math.h>
#include <string.h>

#include "compare/segments.h"
#include "core/constants.h"
#include "diagnosis/diagnose_impl.h"

#define USUAL_RELATIVE    0.02  /* of a band that was not measured [1] */
#define USUAL_TEMPERATURE 0.5   /* of a place that was not measured [K] */
#define FAINT             0.01  /* floor of sigma, of the brightest row of the band */
#define WORTH_SAYING      0.025 /* chi-square a row: a thousand rows decide */
#define NEAREST           3     /* rivals that are looked at */

static const enum um_compare_segment light[] = {UM_SEGMENT_SUNLIT, UM_SEGMENT_PENUMBRA,
                                                UM_SEGMENT_UMBRA};

struct separation {
  double worth[UM_SEGMENT_COUNT], sigma[UM_SEGMENT_COUNT]; /* means over the rows */
  size_t count[UM_SEGMENT_COUNT];
};

/* Relative sigma of a band's rows, or sigma of a place's [K]; NaN when not measured. */
static double measured_sigma(const struct um_diagnosis_forward *f, bool temperature, const char *of)
{
  double sum = 0.0, rows = 0.0;
  for (size_t j = 0; j < f->nrow; j++) {
    const struct um_compare_channel *c = &f->measurements->channel[f->channel[j]];
    if ((c->quantity == UM_QUANTITY_TEMPERATURE) != temperature || strcmp(c->of, of) != 0) continue;
    sum += temperature ? f->sigma[j] : f->sigma[j] / fmax(fabs(f->measured[j]), f->sigma[j]);
    rows += 1.0;
  }
  return rows > 0.0 ? sum / rows : NAN;
}

static void collect(struct separation *s, enum um_compare_segment segment, double difference,
                    double sigma)
{
  s->worth[segment] += difference * difference / (sigma * sigma);
  s->sigma[segment] += sigma;
  s->count[segment]++;
}

/* Keep the best of a channel where it beats what is kept. */
static enum um_status offer(struct um_context *context, const struct separation *s,
                            enum um_compare_quantity quantity, const char *of,
                            struct um_diagnosis_next *next)
{
  for (size_t i = 0; i < sizeof light / sizeof light[0]; i++) {
    enum um_compare_segment g = light[i];
    if (s->count[g] == 0) continue;
    double worth = s->worth[g] / (double)s->count[g];
    if (!(worth > next->separation)) continue;
    um_core_free(context, next->of);
    next->of = NULL;
    UM_TRY(um_core_strdup(context, of, &next->of));
    next->quantity = quantity;
    next->segment = g;
    next->separation = worth;
    next->sigma = s->sigma[g] / (double)s->count[g];
  }
  return UM_OK;
}

static enum um_status offer_bands(struct um_context *context, const struct um_diagnosis_forward *f,
                                  const struct um_diagnosis_forward_run run[2],
                                  const enum um_compare_segment *segment,
                                  struct um_diagnosis_next *next)
{
  const struct um_model_result *a = run[0].result, *b = run[1].result;
  for (size_t band = 0; band < a->nband && run[0].model->has_observer; band++) {
    const char *name = run[0].model->band[band].name;
    struct separation s = {0};
    double relative = measured_sigma(f, false, name), peak = 0.0;
    if (isnan(relative)) relative = USUAL_RELATIVE;
    for (size_t k = 0; k < a->nobs; k++)
      if (a->irradiance[k * a->nband + band] > peak) peak = a->irradiance[k * a->nband + band];
    for (size_t k = 0; k < a->nobs; k++) {
      double ea = a->irradiance[k * a->nband + band], eb = b->irradiance[k * b->nband + band];
      if (isnan(ea) || isnan(eb) || !(peak > 0.0)) continue;
      collect(&s, segment[k], ea - eb, hypot(relative * ea, FAINT * peak));
    }
    UM_TRY(offer(context, &s, UM_QUANTITY_BAND_IRRADIANCE, name, next));
  }
  return UM_OK;
}

static enum um_status offer_places(struct um_context *context, const struct um_diagnosis_forward *f,
                                   const struct um_diagnosis_forward_run run[2],
                                   const enum um_compare_segment *segment,
                                   struct um_diagnosis_next *next)
{
  const struct um_model_result *a = run[0].result, *b = run[1].result;
  for (size_t p = 0; p < a->nplace && p < b->nplace; p++) {
    struct separation s = {0};
    double sigma = measured_sigma(f, true, a->place[p].name);
    if (isnan(sigma)) sigma = USUAL_TEMPERATURE;
    for (size_t k = 0; k < a->nobs; k++)
      collect(&s, segment[k], a->place[p].mean[k] - b->place[p].mean[k], sigma);
    UM_TRY(offer(context, &s, UM_QUANTITY_TEMPERATURE, a->place[p].name, next));
  }
  return UM_OK;
}

static enum um_status say(struct um_context *context, struct um_diagnosis_next *next)
{
  if (next->of == NULL || next->separation < WORTH_SAYING) return UM_OK;
  return um_core_asprintf(context, &next->what, "%s of %s, %s",
                          next->quantity == UM_QUANTITY_TEMPERATURE ? "temperature" : "irradiance",
                          next->of, um_compare_segment_name(next->segment));
}

/* Additions of the state, the winner of the step replaced by a rival as it was fitted. */
static void replace(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                    const struct um_diagnosis_step *step, const struct um_diagnosis_rival *rival,
                    struct um_diagnosis_addition *out)
{
  um_diagnosis_state_additions(state, out);
  for (size_t b = 0; b < state->nblock; b++) {
    if (state->block[b].candidate != step->candidate) continue;
    const struct um_diagnosis_candidate *c = &work->candidates->candidate[rival->candidate];
    out[b] = (struct um_diagnosis_addition){.effect = c->effect, .target = c->target};
    memcpy(out[b].value, rival->value, sizeof out[b].value);
  }
}

static enum um_status look(struct um_context *context, const struct um_diagnosis_work *work,
                           const struct um_diagnosis_forward_run run[2],
                           struct um_diagnosis_next *next)
{
  enum um_status status;
  enum um_compare_segment *segment = NULL, *motion = NULL;
  size_t nobs = run[0].trace->nobs;
  struct um_diagnosis_next found = {.from = run[0].trace->t_obs[0],
                                    .to = run[0].trace->t_obs[nobs - 1]};
  UM_CHECK(um_core_allocate(context, nobs, sizeof *segment, &segment));
  UM_CHECK(um_core_allocate(context, nobs, sizeof *motion, &motion));
  UM_CHECK(um_compare_segments_find(context, run[0].model, run[0].trace, segment, motion));
  UM_CHECK(offer_bands(context, work->forward, run, segment, &found));
  UM_CHECK(offer_places(context, work->forward, run, segment, &found));
  /* the rival that is hardest to tell counts */
  if (next->of == NULL || found.separation < next->separation) {
    um_core_free(context, next->of);
    *next = found;
    found.of = NULL;
  }
done:
  um_core_free(context, found.of);
  um_core_free(context, motion);
  um_core_free(context, segment);
  return status;
}

enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_step *step,
                                      struct um_diagnosis_next **out)
{
  enum um_status status;
  struct um_diagnosis_forward_run run[2] = {{0}, {0}};
  struct um_diagnosis_addition *addition = NULL;
  struct um_diagnosis_next *next = NULL;
  size_t looked = 0;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *next, &next));
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *addition, &addition));
  um_diagnosis_state_additions(state, addition);
  UM_CHECK(
      um_diagnosis_forward_run(context, work->forward, addition, state->nblock, true, &run[0]));
  for (size_t i = 1; i < step->nrival && looked < NEAREST; i++) {
    if (!step->rival[i].indistinguishable || !step->rival[i].fitted) continue;
    replace(work, state, step, &step->rival[i], addition);
    UM_CHECK(
        um_diagnosis_forward_run(context, work->forward, addition, state->nblock, true, &run[1]));
    UM_CHECK(look(context, work, run, next));
    um_diagnosis_forward_run_release(context, &run[1]);
    looked++;
  }
  UM_CHECK(say(context, next));
  *out = next;
  next = NULL;
done:
  um_core_free(context, addition);
  um_diagnosis_forward_run_release(context, &run[0]);
  um_diagnosis_forward_run_release(context, &run[1]);
  um_diagnosis_next_destroy(context, &next);
  return status;
}

void um_diagnosis_next_destroy(struct um_context *context, struct um_diagnosis_next **next)
{
  if (next == NULL || *next == NULL) return;
  um_core_free(context, (*next)->what);
  um_core_free(context, (*next)->of);
  um_core_free(context, *next);
  *next = NULL;
}
