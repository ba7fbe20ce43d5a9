/* See residual.h. */
#include "evidence/comparison/residual.h"

#include <math.h>

struct um_compare_linear um_compare_measured(const struct um_compare_measurements *m, size_t row,
                                             double sigma)
{
  return um_compare_linear(m->channel[m->row[row].channel].quantity, m->row[row].value, sigma);
}

void um_compare_modelled(const struct um_compare_measurements *m, size_t n, const size_t *row,
                         const double *value, double *out)
{
  for (size_t j = 0; j < n; j++) {
    size_t i = row == NULL ? j : row[j];
    out[j] = um_compare_linear(m->channel[m->row[i].channel].quantity, value[i], NAN).value;
  }
}

struct um_compare_residual um_compare_residual_make(const struct um_compare_measurements *m,
                                                    size_t row, double model, double model_sigma)
{
  enum um_compare_quantity quantity = m->channel[m->row[row].channel].quantity;
  struct um_compare_linear measured = um_compare_measured(m, row, m->row[row].sigma);
  double modelled = um_compare_linear(quantity, model, NAN).value;
  return (struct um_compare_residual){measured.value, modelled, measured.sigma, model_sigma};
}

double um_compare_residual_sigma(double sigma, double model_sigma)
{
  return hypot(sigma, model_sigma);
}

double um_compare_residual_share(double sigma, double model_sigma)
{
  double part = model_sigma / um_compare_residual_sigma(sigma, model_sigma);
  return part * part;
}

double um_compare_residual_normalised(const struct um_compare_residual *r)
{
  double residual = r->measured - r->model;
  return isnan(r->sigma) ? residual
                         : residual / um_compare_residual_sigma(r->sigma, r->model_sigma);
}
