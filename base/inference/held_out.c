/* Observations held out: with r and J at the solution, every fold k is predicted by parameters that
 * have not seen it,
 *
 *   d_k = argmin over the observations outside k of |r - J d|^2, with priors, within the bounds,
 *   sum_k |r - J d_k|^2 over the observations of k.
 *
 * A parameter that only the held-out observations determine goes back to where the fit started:
 * that is a prior of its own, a thousand times wider than its sigma, which weighs a millionth
 * elsewhere. */
#include <math.h>

#include "base/inference/bounded_impl.h"
#include "base/inference/fit.h"

#define WIDER 1e3

struct folds {
  const struct um_inference_fit *fit;
  struct um_inference_rows rows;
  double *scale, *pull, *width, *lower, *upper, *u; /* [nparameter] */
};

/* Prior, or the prior of its own, of parameter j. */
static void prepare(const struct um_inference_fit_parameter *p, struct folds *f, size_t j)
{
  double sigma = f->fit->sigma[j], x = f->fit->x[j];
  f->scale[j] = p->step;
  f->lower[j] = fmin(0.0, (p->minimum - x) / p->step);
  f->upper[j] = fmax(0.0, (p->maximum - x) / p->step);
  bool prior = !isinf(p->prior_sigma);
  f->width[j] = prior ? p->prior_sigma : WIDER * (isfinite(sigma) ? sigma : p->step);
  f->pull[j] = (prior ? p->prior_mean : p->start) - x;
}

static enum um_status one_fold(struct um_context *context, struct folds *f, size_t fold,
                               double *sum)
{
  enum um_status status;
  struct um_inference_system system = {0};
  double left;
  f->rows.without = fold;
  UM_CHECK(um_inference_system_create(context, &f->rows, &system));
  UM_CHECK(um_inference_system_solve(context, &system, 0.0, f->lower, f->upper, f->u, &left));
  for (size_t i = 0; i < f->rows.nrow; i++) {
    if (f->rows.fold[i] != fold) continue;
    double r = f->rows.residual[i];
    for (size_t j = 0; j < f->rows.n; j++)
      r -= f->rows.jacobian[j * f->rows.nrow + i] * f->scale[j] * f->u[j];
    *sum += r * r;
  }
done:
  um_inference_system_release(context, &system);
  return status;
}

enum um_status um_inference_fit_held_out(struct um_context *context,
                                         const struct um_inference_fit_problem *problem,
                                         const struct um_inference_fit *fit, const size_t *fold,
                                         size_t nfold, double *out)
{
  enum um_status status;
  struct folds f = {.fit = fit};
  double *block = NULL;
  size_t n = fit->nparameter;
  *out = 0.0;
  if (n == 0) {
    *out = fit->chi2;
    return UM_OK;
  }
  UM_CHECK(um_core_allocate(context, 6 * n, sizeof *block, &block));
  f.scale = block;
  f.pull = block + n;
  f.width = block + 2 * n;
  f.lower = block + 3 * n;
  f.upper = block + 4 * n;
  f.u = block + 5 * n;
  for (size_t j = 0; j < n; j++) prepare(&problem->parameter[j], &f, j);
  f.rows = (struct um_inference_rows){.nrow = fit->nobservation,
                                      .n = n,
                                      .jacobian = fit->jacobian,
                                      .residual = fit->residual,
                                      .fold = fold,
                                      .scale = f.scale,
                                      .pull = f.pull,
                                      .width = f.width};
  for (size_t k = 0; k < nfold; k++) UM_CHECK(one_fold(context, &f, k, out));
done:
  um_core_free(context, block);
  return status;
}
