/* Finds the channel whose chi-square is furthest above its expectation, in units of its spread
 * sqrt(2 n), and the coordinate whose correlation with that channel has the smallest p. */
#include "evidence/missing_heat/residual.h"

#include <math.h>
#include <string.h>

#include "evidence/comparison/compare.h"

/* One channel, weighted by the sigma of the diagnosis. */
struct weighed {
  double chi2, mean, excess, count;
};

static struct weighed weigh(const struct um_sensitivity_forward *f,
                            const struct um_compare_comparison *comparison, size_t channel)
{
  struct weighed w = {0};
  for (size_t j = 0; j < f->observations.count; j++) {
    if (f->observations.channel[j] != channel) continue;
    const struct um_compare_residual *of = &comparison->residual[f->observations.row[j]];
    double r = (of->measured - of->model) / f->observations.sigma[j];
    w.chi2 += r * r;
    w.mean += r;
    w.count += 1.0;
  }
  w.mean /= w.count;
  w.excess = (w.chi2 - w.count) / sqrt(2.0 * w.count);
  return w;
}

/* The correlation of the smallest p; where p underflows, the largest correlation. */
static const struct um_compare_correlation *
strongest(const struct um_compare_channel_comparison *channel)
{
  const struct um_compare_correlation *most = NULL;
  for (size_t i = 0; i < channel->ncorrelation; i++) {
    const struct um_compare_correlation *c = &channel->correlation[i];
    if (isnan(c->p)) continue;
    if (most == NULL || c->p < most->p || (c->p == most->p && fabs(c->value) > fabs(most->value)))
      most = c;
  }
  return most;
}

enum um_status um_missing_heat_residual_describe(struct um_context *context,
                                                 const struct um_sensitivity_forward *forward,
                                                 const struct um_compare_run *run, double fitted,
                                                 struct um_missing_heat_residual *out)
{
  enum um_status status;
  const struct um_compare_measurements *m = run->plan->measurements;
  struct um_compare_comparison *comparison = NULL;
  const struct um_compare_channel_comparison *worst = NULL;
  struct weighed of_worst = {0};
  *out = (struct um_missing_heat_residual){.p = NAN, .chi2_reduced = NAN, .mean = NAN};
  UM_CHECK(um_compare_create(context, run, fitted, &comparison));
  for (size_t c = 0; c < comparison->nchannel; c++) {
    struct weighed w = weigh(forward, comparison, comparison->channel[c].channel);
    if (worst != NULL && !(w.excess > of_worst.excess)) continue;
    worst = &comparison->channel[c];
    of_worst = w;
  }
  if (worst == NULL) goto done;
  UM_CHECK(um_core_asprintf(context, &out->channel, "%s %s",
                            um_compare_quantity_name(m->channel[worst->channel].quantity),
                            m->channel[worst->channel].label));
  out->chi2_reduced = of_worst.chi2 / of_worst.count;
  out->mean = of_worst.mean;
  const struct um_compare_correlation *most = strongest(worst);
  if (most == NULL) goto done;
  out->p = most->p;
  UM_CHECK(um_core_strdup(context, most->name, &out->coordinate));
done:
  um_compare_destroy(context, &comparison);
  if (status != UM_OK) um_missing_heat_residual_release(context, out);
  return status;
}

enum um_status um_missing_heat_residual_of(struct um_context *context,
                                           const struct um_sensitivity_forward *forward,
                                           const struct um_model_addition *addition,
                                           size_t naddition, double fitted,
                                           struct um_missing_heat_residual *out)
{
  struct um_sensitivity_forward_run run = {.result = NULL};
  *out = (struct um_missing_heat_residual){0};
  UM_TRY(um_sensitivity_forward_run(context, forward, addition, naddition, NULL, &run));
  const struct um_compare_run compared = {run.variant.model, forward->plan, run.variant.tables,
                                          run.result};
  enum um_status status =
      um_missing_heat_residual_describe(context, forward, &compared, fitted, out);
  um_sensitivity_forward_run_release(context, &run);
  return status;
}

void um_missing_heat_residual_release(struct um_context *context,
                                      struct um_missing_heat_residual *residual)
{
  UM_FREE(context, residual->channel, residual->coordinate);
  *residual = (struct um_missing_heat_residual){0};
}
