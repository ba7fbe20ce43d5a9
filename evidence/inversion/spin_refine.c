/* Fit of one spin: two tilts of the axis, rate and phase, by least squares; first on the map, whose
 * own error is added to sigma, then with the whole model, the light between surfaces, which costs
 * most, last. */
#include <math.h>

#include "base/core/constants.h"
#include "base/inference/fit.h"
#include "evidence/inversion/spin_impl.h"

#define NPARAMETER 4
#define MAP_ERROR  0.1             /* of what is looked up [1] */
#define STEP       (0.25 * UM_DEG) /* of differences */

/* What a law is held against. */
enum stage { ON_MAP, ALONE, BETWEEN };

/* What the model is asked with. */
struct trial {
  const struct um_compare_spin_data *data;
  struct um_compare_spin_law start;
  struct um_vec3 across[2]; /* of the starting axis */
  enum stage stage;
  double *scratch; /* [nband] */
};

static struct um_compare_spin_law law_at(const struct trial *trial, const double *x)
{
  struct um_vec3 axis = um_vec3_axpy(trial->start.axis, tan(x[0]), trial->across[0]);
  axis = um_vec3_unit(um_vec3_axpy(axis, tan(x[1]), trial->across[1]));
  return (struct um_compare_spin_law){axis, trial->start.rate + x[2], trial->start.phase + x[3],
                                      trial->start.misfit};
}

static enum um_status evaluate(struct um_context *context, void *user, const double *x,
                               double *value)
{
  struct trial *trial = user;
  const struct um_compare_spin_data *d = trial->data;
  struct um_compare_spin_law law = law_at(trial, x);
  if (trial->stage != ON_MAP)
    return um_compare_spin_light_of(context, d, &law, trial->stage == BETWEEN, value);
  for (size_t i = 0; i < d->count; i++)
    value[i] = um_compare_spin_look_up(
        d, &d->row[i], um_compare_spin_attitude(d, &law, d->row[i].t), trial->scratch);
  return UM_OK;
}

static enum um_status fit(struct um_context *context, struct trial *trial, const double *measured,
                          double *sigma, struct um_inference_fit **out)
{
  const struct um_compare_spin_data *d = trial->data;
  const struct um_compare_spin_search *s = d->search;
  double turn = 2.0 * s->turn_step, rate = turn / (0.5 * fmax(d->span, 1.0));
  const double range[NPARAMETER] = {2.0 * s->axis_step, 2.0 * s->axis_step, rate, 2.0 * turn};
  const double step[NPARAMETER] = {STEP, STEP, STEP / (0.5 * fmax(d->span, 1.0)), STEP};
  struct um_inference_fit_parameter parameter[NPARAMETER];
  um_core_vec3_frame(trial->start.axis, &trial->across[0], &trial->across[1]);
  for (size_t k = 0; k < NPARAMETER; k++) {
    double most = fmin(range[k], k < 2 ? 0.4 * UM_PI : INFINITY);
    parameter[k] = (struct um_inference_fit_parameter){0.0, -most, most, 0.0, INFINITY, step[k]};
  }
  for (size_t i = 0; i < d->count; i++)
    sigma[i] =
        trial->stage == ON_MAP ? hypot(d->row[i].sigma, MAP_ERROR * measured[i]) : d->row[i].sigma;
  const struct um_inference_fit_problem problem = {.nobservation = d->count,
                                                   .nparameter = NPARAMETER,
                                                   .measured = measured,
                                                   .sigma = sigma,
                                                   .parameter = parameter,
                                                   .evaluate = evaluate,
                                                   .user = trial,
                                                   .iterations_max = 30};
  return um_inference_fit_create(context, &problem, out);
}

static void keep(const struct um_inference_fit *f, const struct um_compare_spin_law *law,
                 struct um_compare_spin *out)
{
  double turns = law->phase / (2.0 * UM_PI);
  *out = (struct um_compare_spin){.axis = law->axis,
                                  .period = 2.0 * UM_PI / law->rate,
                                  .phase = 2.0 * UM_PI * (turns - floor(turns)),
                                  .misfit = law->misfit,
                                  .chi2 = f->chi2,
                                  .axis_sigma = hypot(f->sigma[0], f->sigma[1]),
                                  .phase_sigma = f->sigma[3]};
  out->period_sigma = fabs(out->period / law->rate) * f->sigma[2];
}

enum um_status um_compare_spin_refine(struct um_context *context,
                                      const struct um_compare_spin_data *d,
                                      const struct um_compare_spin_law *start, bool between,
                                      struct um_compare_spin *out)
{
  enum um_status status;
  struct trial trial = {.data = d, .start = *start};
  struct um_inference_fit *f = NULL;
  double *measured = NULL, *sigma = NULL;
  UM_CHECK(um_core_allocate(context, d->count, sizeof *measured, &measured));
  UM_CHECK(um_core_allocate(context, d->count, sizeof *sigma, &sigma));
  UM_CHECK(um_core_allocate(context, d->model->nband, sizeof(double), &trial.scratch));
  for (size_t i = 0; i < d->count; i++) measured[i] = d->row[i].value;
  enum stage last = between ? BETWEEN : ALONE;
  for (trial.stage = between ? BETWEEN : ON_MAP; trial.stage <= last; trial.stage++) {
    UM_CHECK(fit(context, &trial, measured, sigma, &f));
    struct um_compare_spin_law law = law_at(&trial, f->x);
    keep(f, &law, out);
    trial.start = law;
    um_inference_fit_destroy(context, &f);
  }
done:
  um_inference_fit_destroy(context, &f);
  UM_FREE(context, measured, sigma, trial.scratch);
  return status;
}
