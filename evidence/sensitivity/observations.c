/* The observations in use, in linear flux, each with a sigma: that of the measurement and that of
 * the model's own sampling in quadrature. */
#include "evidence/sensitivity/observations_impl.h"

#include <math.h>

#include "evidence/comparison/residual.h"
#include "evidence/measurements/noise.h"

static enum um_status allocate(struct um_context *context, struct um_sensitivity_observations *o)
{
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->row, &o->row));
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->channel, &o->channel));
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->t, &o->t));
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->measured, &o->measured));
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->sigma, &o->sigma));
  UM_TRY(um_core_allocate(context, o->count, sizeof *o->stated_sigma, &o->stated_sigma));
  return um_core_allocate(context, o->count, sizeof *o->model_sigma, &o->model_sigma);
}

static enum um_status refuse(struct um_context *context, const struct um_compare_measurements *m,
                             size_t row)
{
  const struct um_compare_channel *c = &m->channel[m->row[row].channel];
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: column 'sigma': empty; accepted: a number above 0, or a scenario "
                      "with measurements.noise for %s '%s'",
                      um_compare_row_path(m, row), m->row[row].line,
                      um_compare_quantity_name(c->quantity), c->label);
}

/* Sigma and the model's share in it, once both parts are there. */
static void add_model_error(struct um_sensitivity_observations *o)
{
  double sum = 0.0;
  for (size_t j = 0; j < o->count; j++) {
    o->sigma[j] = um_compare_residual_sigma(o->stated_sigma[j], o->model_sigma[j]);
    sum += um_compare_residual_share(o->stated_sigma[j], o->model_sigma[j]);
  }
  o->model_share = sum / (double)o->count;
}

enum um_status um_sensitivity_observations_create(struct um_context *context,
                                                  const struct um_compare_plan *plan,
                                                  const struct um_scenario *scenario,
                                                  const struct um_model_result *result,
                                                  const double *predicted,
                                                  struct um_sensitivity_observations *o)
{
  const struct um_compare_measurements *m = plan->measurements;
  enum um_status status;
  double *sigma = NULL, *model_sigma = NULL;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *sigma, &sigma));
  UM_CHECK(um_core_allocate(context, m->count, sizeof *model_sigma, &model_sigma));
  um_compare_predict_error(plan, result, model_sigma);
  UM_CHECK(um_compare_noise_sigmas(context, scenario, m, predicted, sigma));
  o->count = 0;
  for (size_t i = 0; i < m->count; i++)
    if (plan->observation[i] != UM_COMPARE_NOWHERE) o->count++;
  UM_CHECK(allocate(context, o));
  for (size_t i = 0, j = 0; i < m->count; i++) {
    if (plan->observation[i] == UM_COMPARE_NOWHERE) continue;
    if (isnan(sigma[i])) {
      status = refuse(context, m, i);
      goto done;
    }
    o->row[j] = i;
    o->channel[j] = m->row[i].channel;
    o->t[j] = m->row[i].t_tai;
    struct um_compare_linear measured = um_compare_measured(m, i, sigma[i]);
    o->measured[j] = measured.value;
    o->stated_sigma[j] = measured.sigma;
    o->model_sigma[j] = model_sigma[i];
    j++;
  }
  add_model_error(o);
done:
  um_core_free(context, sigma);
  um_core_free(context, model_sigma);
  return status;
}

void um_sensitivity_observations_release(struct um_context *context,
                                         struct um_sensitivity_observations *observations)
{
  um_core_free(context, observations->row);
  um_core_free(context, observations->channel);
  um_core_free(context, observations->t);
  um_core_free(context, observations->measured);
  um_core_free(context, observations->sigma);
  um_core_free(context, observations->stated_sigma);
  um_core_free(context, observations->model_sigma);
}
