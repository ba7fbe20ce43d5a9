/* The model's own sampling error, kept small beside the error of the measurement. */
#ifndef UMBRA_COMPARE_REFINE_H
#define UMBRA_COMPARE_REFINE_H

#include "evidence/comparison/predict.h"
#include "model/run/thermal_solution.h"

/* Share of the variance sigma^2 + model_sigma^2, mean over a channel, that the model may have. All
 * instants look at the same points of the body, so the error moves slowly from observation to
 * observation and does not average out: a share of 0.02 moves a Durbin-Watson statistic by 0.04 at
 * most, what white noise of 2500 observations does. */
#define UM_COMPARE_MODEL_SHARE 0.02
/* A share that a person is told of: below it, nobody need think of samples. */
#define UM_COMPARE_SHARE_SHOWN 1e-3
/* No more points per facet, points of all instants and surfaces together: some minutes. Of paths
 * between surfaces no more, of all instants and surfaces together no more, but some in any case:
 * some seconds, as every variant of a diagnosis takes them again. */
#define UM_COMPARE_SAMPLES_MAX          65536
#define UM_COMPARE_POINTS_MAX           4e9
#define UM_COMPARE_INTERREFLECTION_MAX  4096
#define UM_COMPARE_PATHS_MAX            3e7
#define UM_COMPARE_INTERREFLECTION_SOME 32

/* What was done. */
struct um_compare_refinement {
  int samples_before, samples; /* optics.samples */
  int interreflection_before, interreflection;
  double share_before, share; /* of the worst channel [1]; NaN where no observation has a sigma */
};

/* Two runs that differ in their samples. */
struct um_compare_twice {
  const struct um_model_result *coarse, *finer;
};
/* Share of the model in the worst channel of what is looked at, from a run: by its standard error
 * or, with `twice` (NULL: not asked), by how far the values of the two are apart; sigma is the
 * run's. variance: times that of the model [1], as of 1/variance times the samples. */
typedef enum um_status um_compare_share_of(struct um_context *context, void *user,
                                           const struct um_model_tables *tables,
                                           const struct um_model_result *result,
                                           const struct um_compare_twice *twice, double variance,
                                           double *share);

/* Run the model on geometry tables; while the share that `share_of` finds is above
 * `limit`, look again with more samples and run again with the same heat, up to the bounds above. A
 * share below the limit is checked by what is seen directly with four times the samples, which are
 * taken where the values moved by more than the limit; otherwise the result is that of
 * um_model_run. What was done is said in the log; a share that stays above the limit is a warning.
 * limit: in (0, 1), UM_COMPARE_MODEL_SHARE. tables: its sampling is what was used.
 * Errors of the run, the geometry tables and share_of. The caller destroys *out. Tested by
 * law_compare_sampling. */
enum um_status um_compare_refine(struct um_context *context, const struct um_model *model,
                                 struct um_model_tables *tables, double limit,
                                 um_compare_share_of *share_of, void *user,
                                 struct um_model_result **out,
                                 struct um_compare_refinement *refinement);

/* The same with heat of the model that is at hand and stays the caller's. */
enum um_status um_compare_refine_with(struct um_context *context, const struct um_model *model,
                                      struct um_model_tables *tables,
                                      const struct um_model_thermal_solution *heat, double limit,
                                      um_compare_share_of *share_of, void *user,
                                      struct um_model_result **out,
                                      struct um_compare_refinement *refinement);

/* um_compare_share_of for measurements; user: their plan. Sigma of an observation is its own, or
 * that of the scenario's noise model. Temperatures have no share. */
struct um_compare_share_user {
  const struct um_model *model;
  const struct um_compare_plan *plan;
};
um_compare_share_of um_compare_share_of_plan;

/* Mean over each channel of model_sigma^2 / (sigma^2 + model_sigma^2), the largest of them;
 * observations without a sigma (NaN) do not count; NaN where none has one. sigma and model_sigma:
 * shape [count of the set], linear flux. For callers with observations of their own, as diagnosis.
 * UM_ERR_MEMORY. */
enum um_status um_compare_share(struct um_context *context,
                                const struct um_compare_measurements *measurements,
                                const double *sigma, const double *model_sigma, double *share);

#endif
