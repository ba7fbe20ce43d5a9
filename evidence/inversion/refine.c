/* More samples where the model's own error is too large beside that of the measurement.
 *
 * The share of the model in the variance is the mean of v/(sigma^2 + v) over the observations of a
 * channel. With v ~ 1/n (the stated error is that of independent points; evenly spread ones do
 * better) of f n samples it is that of v/f: f is sought at which that is the limit, of each
 * observation's own v, since a mean of shares near 1 does not say how far off it is. What is stated
 * is then held against a run with four times the samples. */
#include "evidence/inversion/refine.h"

#include <math.h>

#include "evidence/comparison/residual.h"
#include "evidence/measurements/noise.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "model/run/thermal_solution.h"

#define STEP_MAX 64.0 /* times the samples, at once */
#define MARGIN   1.1  /* of the factor: an error that is estimated has one of its own */
#define TOGETHER 8    /* numbers of samples are multiples */
#define HALVINGS 12   /* of the logarithm of the factor */
#define CHECK    4    /* times the samples */
#define FINE     1024 /* samples that need no check: what slips between them is 1e-3 of a facet */

enum um_status um_compare_share(struct um_context *context, const struct um_compare_measurements *m,
                                const double *sigma, const double *model_sigma, double *share)
{
  double *sum = NULL;
  size_t *count = NULL;
  enum um_status status;
  *share = NAN;
  UM_CHECK(um_core_allocate(context, m->nchannel, sizeof *sum, &sum));
  UM_CHECK(um_core_allocate(context, m->nchannel, sizeof *count, &count));
  for (size_t i = 0; i < m->count; i++) {
    if (isnan(sigma[i]) || isnan(model_sigma[i])) continue;
    sum[m->row[i].channel] += um_compare_residual_share(sigma[i], model_sigma[i]);
    count[m->row[i].channel]++;
  }
  for (size_t c = 0; c < m->nchannel; c++)
    if (count[c] > 0) *share = fmax(*share, sum[c] / (double)count[c]); /* not NaN, if one is */
done:
  UM_FREE(context, sum, count);
  return status;
}

/* Model values of all observations in linear flux, and sigma of the measurements where it is
 * wanted. */
static enum um_status linear_values(struct um_context *context,
                                    const struct um_compare_share_user *u,
                                    const struct um_model_tables *tables,
                                    const struct um_model_result *result, double *value,
                                    double *sigma)
{
  const struct um_compare_measurements *m = u->plan->measurements;
  UM_TRY(um_compare_predict(context, u->plan, tables, result, value));
  if (sigma != NULL) UM_TRY(um_compare_noise_sigmas(context, u->model->scenario, m, value, sigma));
  for (size_t i = 0; sigma != NULL && i < m->count; i++)
    sigma[i] = um_compare_measured(m, i, sigma[i]).sigma;
  um_compare_modelled(m, m->count, NULL, value, value);
  return UM_OK;
}

enum um_status um_compare_share_of_plan(struct um_context *context, void *user,
                                        const struct um_model_tables *tables,
                                        const struct um_model_result *result,
                                        const struct um_compare_twice *twice, double variance,
                                        double *share)
{
  const struct um_compare_share_user *u = user;
  const struct um_compare_measurements *m = u->plan->measurements;
  double *value = NULL;
  enum um_status status;
  UM_TRY(um_core_allocate(context, 3 * m->count, sizeof *value, &value));
  double *sigma = value + m->count, *model_sigma = sigma + m->count;
  UM_CHECK(linear_values(context, u, tables, result, value, sigma));
  if (twice == NULL) {
    um_compare_predict_error(u->plan, result, model_sigma);
  } else {
    UM_CHECK(linear_values(context, u, tables, twice->coarse, value, NULL));
    UM_CHECK(linear_values(context, u, tables, twice->finer, model_sigma, NULL));
    for (size_t i = 0; i < m->count; i++) model_sigma[i] = fabs(model_sigma[i] - value[i]);
  }
  for (size_t i = 0; i < m->count; i++) model_sigma[i] *= sqrt(variance);
  UM_CHECK(um_compare_share(context, m, sigma, model_sigma, share));
done:
  um_core_free(context, value);
  return status;
}

static void report(struct um_context *context, const struct um_compare_refinement *r, double limit)
{
  if (r->samples != r->samples_before)
    um_core_log(context, UM_LOG_INFO,
                "optics.samples raised from %d to %d: the model's own sampling error was %.2g of "
                "the variance of a channel, it is %.2g now",
                r->samples_before, r->samples, r->share_before, r->share);
  if (r->share > limit)
    um_core_log(context, UM_LOG_WARNING,
                "the model's own sampling error is %.2g of the variance of a channel at "
                "optics.samples %d, more than the %.2g that comparisons take as small; it stands "
                "in sigma, but neighbouring observations share it",
                r->share, r->samples, limit);
}

/* A refinement in progress. */
struct job {
  const struct um_model *model;
  struct um_model_tables *tables;
  const struct um_model_thermal_solution *heat;
  um_compare_share_of *share_of;
  void *user;
  double limit;
  double most, most_paths; /* optics.samples, optics.interreflection_samples */
};

/* Look again and run; the result takes the place of the one before. */
static enum um_status look_again(struct um_context *context, const struct job *job, int samples,
                                 int rays, struct um_model_result **result)
{
  struct um_model_result *finer = NULL;
  UM_TRY(um_model_tables_resample(context, job->model, job->tables,
                                  (struct um_model_sampling){samples, rays}));
  UM_TRY(um_model_run_with(context, job->model, job->tables, job->heat, &finer));
  um_model_result_destroy(context, result);
  *result = finer;
  return UM_OK;
}

/* Least factor of the samples with which the share of a result falls to `wanted`; of it `stays` is
 * not theirs. */
static enum um_status factor_find(struct um_context *context, const struct job *job,
                                  const struct um_model_result *result, double wanted, double stays,
                                  double *factor)
{
  double low = 0.0, high = log(STEP_MAX);
  for (int k = 0; k < HALVINGS; k++) {
    double middle = 0.5 * (low + high), share;
    UM_TRY(job->share_of(context, job->user, job->tables, result, NULL, exp(-middle), &share));
    share += stays * (1.0 - exp(-middle));
    *(share > wanted ? &low : &high) = middle;
  }
  *factor = exp(high);
  return UM_OK;
}

/* The next number of samples above n; n itself where the bound is reached. */
static int next_number(int n, double factor, double most)
{
  double wanted = TOGETHER * ceil(MARGIN * factor * n / TOGETHER);
  wanted = fmin(fmax(wanted, n + TOGETHER), most);
  return wanted > n ? (int)wanted : n;
}

static bool has_light_between(const struct job *job, const struct um_compare_refinement *r)
{
  return job->model->environment.inter_reflection_on && r->interreflection > 0;
}

/* A run of what is seen directly, without light between surfaces, which costs a hundred times as
 * much where a few observations want hundreds of paths. */
static enum um_status run_direct(struct um_context *context, const struct job *job,
                                 struct um_model_result **out)
{
  struct um_model without = *job->model;
  without.environment.inter_reflection_on = false;
  return um_model_run_with(context, &without, job->tables, job->heat, out);
}

/* The share of what is seen directly, and the factor that it wants of the points. */
static enum um_status direct_share(struct um_context *context, const struct job *job,
                                   const struct um_compare_refinement *r,
                                   const struct um_model_result *result, double *share,
                                   double *factor)
{
  struct um_model_result *bare = NULL;
  enum um_status status = UM_OK;
  *share = r->share;
  if (has_light_between(job, r)) {
    UM_CHECK(run_direct(context, job, &bare));
    UM_CHECK(job->share_of(context, job->user, job->tables, bare, NULL, 1.0, share));
    *share = fmin(*share, r->share);
  }
  *factor = 1.0;
  if (*share > 0.5 * job->limit)
    UM_CHECK(factor_find(context, job, bare != NULL ? bare : result,
                         bare != NULL ? 0.5 * job->limit : job->limit, 0.0, factor));
done:
  um_model_result_destroy(context, &bare);
  return status;
}

/* Raise until the stated share is small: points where they make it, paths where those do. Where
 * both do, each is left half. */
static enum um_status raise(struct um_context *context, const struct job *job,
                            struct um_compare_refinement *r, struct um_model_result **result)
{
  while (r->share > job->limit) {
    int samples = r->samples, rays = r->interreflection;
    double direct, factor;
    UM_TRY(direct_share(context, job, r, *result, &direct, &factor));
    if (direct > 0.5 * job->limit) samples = next_number(samples, factor, job->most);
    if (r->share - direct > 0.5 * job->limit) {
      UM_TRY(
          factor_find(context, job, *result, job->limit, fmin(direct, 0.5 * job->limit), &factor));
      rays = next_number(rays, factor, job->most_paths);
    }
    if (samples == r->samples && rays == r->interreflection) return UM_OK;
    UM_TRY(look_again(context, job, samples, rays, result));
    UM_TRY(job->share_of(context, job->user, job->tables, *result, NULL, 1.0, &r->share));
    r->samples = samples;
    r->interreflection = rays;
  }
  return UM_OK;
}

/* Does what was stated hold? With CHECK times the samples what is seen directly must stay; else the
 * finer run is the one to go on with. A surface whose few points are all seen states no error: this
 * is where a shadow that slips between them is found. Paths look for themselves: nothing slips
 * between them. */
static enum um_status check(struct um_context *context, const struct job *job,
                            struct um_compare_refinement *r, struct um_model_result **result,
                            bool *holds)
{
  enum um_status status;
  struct um_model_result *coarse = NULL, *finer = NULL;
  const struct um_model_sampling before = {r->samples, r->interreflection};
  int samples = (int)fmin(CHECK * (double)r->samples, job->most);
  double moved = NAN;
  *holds = true;
  if (r->samples >= FINE) return UM_OK;
  if (samples <= r->samples) return UM_OK;
  UM_CHECK(run_direct(context, job, &coarse));
  UM_CHECK(um_model_tables_resample(context, job->model, job->tables,
                                    (struct um_model_sampling){samples, r->interreflection}));
  UM_CHECK(run_direct(context, job, &finer));
  UM_CHECK(job->share_of(context, job->user, job->tables, *result,
                         &(struct um_compare_twice){coarse, finer}, 1.0, &moved));
  *holds = !(moved > job->limit);
  if (*holds) {
    status = um_model_tables_resample(context, job->model, job->tables, before);
    goto done;
  }
  UM_CHECK(look_again(context, job, samples, r->interreflection, result));
  r->share_before = fmax(r->share_before, moved);
  r->samples = samples;
  UM_CHECK(job->share_of(context, job->user, job->tables, *result, NULL, 1.0, &r->share));
done:
  um_model_result_destroy(context, &coarse);
  um_model_result_destroy(context, &finer);
  return status;
}

enum um_status um_compare_refine_with(struct um_context *context, const struct um_model *model,
                                      struct um_model_tables *tables,
                                      const struct um_model_thermal_solution *heat, double limit,
                                      um_compare_share_of *share_of, void *user,
                                      struct um_model_result **out,
                                      struct um_compare_refinement *refinement)
{
  const struct um_scenario_optics *optics = model->scenario->optics;
  struct um_compare_refinement r = {.share = NAN};
  struct um_model_result *result = NULL;
  struct job job = {model,
                    tables,
                    heat,
                    share_of,
                    user,
                    limit,
                    UM_COMPARE_SAMPLES_MAX,
                    UM_COMPARE_INTERREFLECTION_SOME};
  bool holds = false;
  enum um_status status;
  *out = NULL;
  r.samples = r.samples_before = optics->samples;
  r.interreflection = r.interreflection_before = optics->interreflection_samples;
  UM_CHECK(um_model_run_with(context, model, tables, heat, &result));
  UM_CHECK(share_of(context, user, tables, result, NULL, 1.0, &r.share));
  r.share_before = r.share;
  if (tables->view != NULL) {
    double points = (double)(tables->nobs * tables->nsub) * (double)tables->view->nsurface;
    job.most = fmin(job.most, UM_COMPARE_POINTS_MAX / points);
    job.most_paths = fmin(fmax(UM_COMPARE_PATHS_MAX / points, UM_COMPARE_INTERREFLECTION_SOME),
                          UM_COMPARE_INTERREFLECTION_MAX);
    while (!holds && !isnan(r.share)) {
      UM_CHECK(raise(context, &job, &r, &result));
      UM_CHECK(check(context, &job, &r, &result, &holds));
    }
  }
  report(context, &r, limit);
  if (refinement != NULL) *refinement = r;
  *out = result;
  result = NULL;
  status = UM_OK;
done:
  um_model_result_destroy(context, &result);
  return status;
}

enum um_status um_compare_refine(struct um_context *context, const struct um_model *model,
                                 struct um_model_tables *tables, double limit,
                                 um_compare_share_of *share_of, void *user,
                                 struct um_model_result **out,
                                 struct um_compare_refinement *refinement)
{
  struct um_model_thermal_solution *heat = NULL;
  *out = NULL;
  UM_TRY(um_model_thermal_solution_create(context, model, tables, NULL, 1.0, &heat));
  enum um_status status =
      um_compare_refine_with(context, model, tables, heat, limit, share_of, user, out, refinement);
  um_model_thermal_solution_destroy(context, &heat);
  return status;
}
