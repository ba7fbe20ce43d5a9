/* The rows in use, in linear flux, each with a sigma. */
#include <math.h>

#include "compare/series.h"
#include "diagnosis/forward_impl.h"

static enum um_status allocate(struct um_context *context, struct um_diagnosis_forward *f)
{
  UM_TRY(um_core_allocate(context, f->nrow, sizeof *f->row, &f->row));
  UM_TRY(um_core_allocate(context, f->nrow, sizeof *f->channel, &f->channel));
  UM_TRY(um_core_allocate(context, f->nrow, sizeof *f->t, &f->t));
  UM_TRY(um_core_allocate(context, f->nrow, sizeof *f->measured, &f->measured));
  UM_TRY(um_core_allocate(context, f->nrow, sizeof *f->sigma, &f->sigma));
  return um_core_allocate(context, f->nrow, sizeof *f->cache->base, &f->cache->base);
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

enum um_status um_diagnosis_rows_create(struct um_context *context, struct um_diagnosis_forward *f)
{
  const struct um_compare_measurements *m = f->measurements;
  enum um_status status;
  double *sigma = NULL;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *sigma, &sigma));
  UM_CHECK(um_compare_noise_sigmas(context, f->model->scenario, m, f->cache->predicted, sigma));
  f->nrow = 0;
  for (size_t i = 0; i < m->count; i++)
    if (f->plan->observation[i] != UM_COMPARE_NOWHERE) f->nrow++;
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
    um_compare_linear(quantity, m->row[i].value, sigma[i], &f->measured[j], &f->sigma[j]);
    j++;
  }
done:
  um_core_free(context, sigma);
  return status;
}
