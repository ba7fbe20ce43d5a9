/* One set of measurements before the diagnosis, and what it says of them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/core/suggestions.h"
#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/request.h"
#include "tests/lab/lab.h"

/* Time that this process computed [s]: others on the machine do not count. */
static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void append_number(char *list, size_t size, double value)
{
  char text[32];
  snprintf(text, sizeof text, "%.9g", value);
  lab_append(list, size, text);
}

/* Root of the mean square of a channel's residuals, in sigmas; the worst channel. */
static double worst_rms(const struct um_sensitivity_forward *f, const double *value)
{
  double worst = NAN;
  for (size_t c = 0; c < f->measurements->nchannel; c++) {
    double sum = 0.0;
    size_t n = 0;
    for (size_t j = 0; j < f->observations.count; j++) {
      if (f->observations.channel[j] != c) continue;
      double r = (f->observations.measured[j] - value[j]) / f->observations.sigma[j];
      sum += r * r;
      n++;
    }
    if (n > 0 && !(sqrt(sum / (double)n) <= worst)) worst = sqrt(sum / (double)n);
  }
  return worst;
}

static bool is_hidden(const struct lab_hidden *hidden, const char *effect, const char *target)
{
  return strcmp(hidden->effect, effect) == 0 && um_core_words_same(hidden->target, target);
}

/* The hidden effect as it was fitted: with what stayed, else as an alternative of the first step.
 */
static void describe_fit(const struct um_diagnosis *d, const struct lab_hidden *hidden,
                         struct lab_row *row)
{
  double value = NAN, sigma = NAN;
  for (size_t i = 0; d->nstep > 0 && i < d->step[0].nalternative; i++) {
    const struct um_diagnosis_alternative *r = &d->step[0].alternative[i];
    const struct um_sensitivity_candidate *c = &d->candidates->candidate[r->candidate];
    if (!r->fitted || !is_hidden(hidden, c->effect->name, c->target)) continue;
    value = r->value[hidden->parameter];
    sigma = r->sigma[hidden->parameter];
  }
  for (size_t i = 0; i < d->naddition; i++) {
    if (!is_hidden(hidden, d->addition[i].effect->name, d->addition[i].target)) continue;
    value = d->addition[i].value[hidden->parameter];
    sigma = d->addition_sigma[i][hidden->parameter];
  }
  append_number(row->fitted, sizeof row->fitted, value);
  append_number(row->sigma, sizeof row->sigma, sigma);
}

static void describe(const struct um_diagnosis *d, const struct lab_case *c, struct lab_row *row)
{
  const struct um_sensitivity_candidate *candidate = d->candidates->candidate;
  snprintf(row->verdict, sizeof row->verdict, "%s", um_diagnosis_verdict_name(d->verdict));
  row->group[0] = row->found[0] = row->fitted[0] = row->sigma[0] = '\0';
  if (d->nstep > 0) {
    const struct um_diagnosis_step *step = &d->step[0];
    snprintf(row->first, sizeof row->first, "%s", candidate[step->candidate].name);
    for (size_t i = 0; i < step->nalternative; i++)
      if (i == 0 || step->alternative[i].indistinguishable)
        lab_append(row->group, sizeof row->group, candidate[step->alternative[i].candidate].name);
    if (step->by_prior) snprintf(row->note, sizeof row->note, "told apart by priors");
  }
  for (size_t s = 0; s < d->nstep; s++)
    if (!d->step[s].removed)
      lab_append(row->found, sizeof row->found, candidate[d->step[s].candidate].name);
  for (size_t i = 0; i < c->nhidden; i++) describe_fit(d, &c->hidden[i], row);
  row->chi2_before = d->chi2_reduced;
  row->chi2_after = d->chi2_reduced_after;
  row->rms_before = worst_rms(d->forward, d->value_before);
  row->rms_after = worst_rms(d->forward, d->value_after);
}

/* Heat is found where the first of the histories says; times are those of the satellite. */
static void describe_pulse(const struct um_diagnosis *d, const struct lab_case *c, double start,
                           struct lab_row *row)
{
  const struct um_missing_heat_unexplained *u = d->unexplained;
  row->found[0] = row->fitted[0] = row->sigma[0] = '\0';
  if (u == NULL || !u->found || u->nheat == 0) return;
  const struct um_missing_heat *h = &u->heat[0];
  snprintf(row->found, sizeof row->found, "%s:%s", um_thermal_course_name(h->course.shape),
           h->place);
  append_number(row->fitted, sizeof row->fitted, h->energy);
  append_number(row->fitted, sizeof row->fitted, h->course.start - start);
  append_number(row->sigma, sizeof row->sigma, h->energy_sigma);
  append_number(row->sigma, sizeof row->sigma, h->start_sigma);
  row->start_error_s = h->course.start - (start + c->pulse->from_s);
}

static void dash(char *text, size_t size)
{
  if (text[0] == '\0') snprintf(text, size, "-");
}

static enum um_status diagnose(struct um_context *context, const struct lab_desk *desk,
                               const struct lab_truth *truth, const struct lab_case *c,
                               struct lab_row *row)
{
  enum um_status status;
  struct um_compare_measurements *measurements = NULL;
  struct um_sensitivity_forward *forward = NULL;
  struct um_diagnosis_request request = {0};
  struct um_diagnosis *d = NULL;
  UM_CHECK(lab_truth_measure(context, truth, c, &measurements));
  UM_CHECK(um_sensitivity_forward_create(context, desk->path, &desk->analyst.options, measurements,
                                         UM_VARIANT_TIGHT, &forward));
  UM_CHECK(um_diagnosis_request_make(
      context, forward->model,
      &(struct um_diagnosis_request_texts){.nuisance = &c->world->nuisance,
                                           .nnuisance = c->world->nuisance != NULL ? 1 : 0},
      &request));
  struct um_diagnosis_options options = {
      .nuisance = request.nuisance, .nnuisance = request.nnuisance, .no_next = true};
  options.no_heat = c->pulse == NULL;
  UM_CHECK(um_diagnosis_create(context, forward, desk->candidates, &options, &d));
  describe(d, c, row);
  if (c->pulse != NULL) describe_pulse(d, c, truth->tables->t_first, row);
done:
  um_diagnosis_destroy(context, &d);
  um_diagnosis_request_release(context, &request);
  um_sensitivity_forward_destroy(context, &forward);
  um_compare_measurements_destroy(context, &measurements);
  return status;
}

void lab_examine(struct um_context *context, const struct lab_desk *desk,
                 const struct lab_truth *truth, const struct lab_case *c, struct lab_row *row)
{
  double start = now();
  *row = (struct lab_row){.seed = c->seed,
                          .verdict = "error",
                          .chi2_before = NAN,
                          .chi2_after = NAN,
                          .rms_before = NAN,
                          .rms_after = NAN,
                          .start_error_s = NAN};
  snprintf(row->part, sizeof row->part, "%s", c->part);
  snprintf(row->world, sizeof row->world, "%s", c->world->name);
  lab_case_hidden(c, row->hidden);
  lab_case_value(c, row->value);
  if (diagnose(context, desk, truth, c, row) != UM_OK) {
    snprintf(row->note, sizeof row->note, "%s", um_core_message(context));
    for (char *at = row->note; *at != '\0'; at++)
      if (*at == ',' || *at == '"') *at = ';';
    um_core_message_clear(context);
  }
  dash(row->first, sizeof row->first);
  dash(row->group, sizeof row->group);
  dash(row->found, sizeof row->found);
  dash(row->fitted, sizeof row->fitted);
  dash(row->sigma, sizeof row->sigma);
  dash(row->note, sizeof row->note);
  row->seconds = now() - start;
}
