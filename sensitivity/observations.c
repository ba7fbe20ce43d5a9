/* The observations in use, in linear flux, each with a sigma: that of the measurement and that of
 * the model's own sampling in quadrature. */
#include <math.h>

#include "compare/noise.h"
#include "sensitivity/forward_impl.h"

static enum um_status allocate(struct um_context *context, struct um_sensitivity_forward *f)
{
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->row, &f->row));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->channel, &f->channel));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->t, &f->t));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->measured, &f->measured));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->sigma, &f->sigma));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->stated_sigma, &f->stated_sigma));
  UM_TRY(um_core_allocate(context, f->nobservation, sizeof *f->model_sigma, &f->model_sigma));
  return um_core_allocate(context, f->nobservation, sizeof *f->cache->base, &f->cache->base);
}

static enum um_status refuse(struct um_context *context, const struct um_compare_measurements *m,
                             size_t row)
{
  const struct um_compare_channel *c = &m->channel[m->row[row].channel];
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: column 'sigma': empty; accepted: a number above 0, or a scenario "
                      "with measurements.noise for %s '%s'",
                      m->path, m->row[row].line, um_compare_quantity_name(c->quantity), c->of);
}

/* Sigma and the model's share in it, once both parts are there. */
static void add_model_error(struct um_sensitivity_forward *f)
{
  double sum = 0.0;
  for (size_t j = 0; j < f->nobservation; j++) {
    f->sigma[j] = hypot(f->stated_sigma[j], f->model_sigma[j]);
    double part = f->model_sigma[j] / f->sigma[j];
    sum += part * part;
  }
  f->model_share = sum / (double)f->nobservation;
}

enum um_status um_sensitivity_observations_create(struct um_context *context,
                                                  struct um_sensitivity_forward *f,
                                                  const struct um_model_result *result)
{
  const struct um_compare_measurements *m = f->measurements;
  enum um_status status;
  double *sigma = NULL, *model_sigma = NULL;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *sigma, &sigma));
  UM_CHECK(um_core_allocate(context, m->count, sizeof *model_sigma, &model_sigma));
  um_compare_predict_error(f->plan, result, model_sigma);
  UM_CHECK(um_compare_noise_sigmas(context, f->model->scenario, m, f->cache->predicted, sigma));
  f->nobservation = 0;
  for (size_t i = 0; i < m->count; i++)
    if (f->plan->observation[i] != UM_COMPARE_NOWHERE) f->nobservation++;
  UM_CHECK(allocate(context, f));
  for (size_t i = 0, j = 0; i < m->count; i++) {
    if (f->plan->observation[i] == UM_COMPARE_NOWHERE) continue;
    enum um_compare_quantity quantity = m->channel[m->row[i].channel].quantity;
    if (isnan(sigma[i])) {
      status = refuse(context, m, i);
      goto done;
    }
    f->row[j] = i;
    f->channel[j] = m->row[i].channel;
    f->t[j] = m->row[i].t_tai;
    um_compare_linear(quantity, m->row[i].value, sigma[i], &f->measured[j], &f->stated_sigma[j]);
    f->model_sigma[j] = model_sigma[i];
    j++;
  }
  add_model_error(f);
done:
  um_core_free(context, sigma);
  um_core_free(context, model_sigma);
  return status;
}
