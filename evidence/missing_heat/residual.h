/* Describes a residual: the channel that fits worst, the sign of its mean, and the physical
 * coordinate that it correlates with. */
#ifndef UMBRA_MISSING_HEAT_RESIDUAL_H
#define UMBRA_MISSING_HEAT_RESIDUAL_H

#include "evidence/comparison/comparison.h"
#include "evidence/sensitivity/forward.h"

struct um_missing_heat_residual {
  char *channel;       /* "temperature body.+y" where it is worst; NULL: nothing was compared */
  char *coordinate;    /* that it correlates with most there, "time_s"; NULL: none varies */
  double p;            /* of that correlation */
  double chi2_reduced; /* of that channel */
  double mean; /* of (measured - model) / sigma there: above 0 the model is too faint or cold */
};

/* Of a model that was run at the times of the measurements of `forward`, weighed by its sigma;
 * fitted: number of parameters. The caller releases. */
enum um_status um_missing_heat_residual_describe(struct um_context *context,
                                                 const struct um_sensitivity_forward *forward,
                                                 const struct um_compare_run *run, double fitted,
                                                 struct um_missing_heat_residual *out);
/* The same for a scenario with additions. Costs one run of the model. */
enum um_status um_missing_heat_residual_of(struct um_context *context,
                                           const struct um_sensitivity_forward *forward,
                                           const struct um_model_addition *addition,
                                           size_t naddition, double fitted,
                                           struct um_missing_heat_residual *out);
void um_missing_heat_residual_release(struct um_context *context,
                                      struct um_missing_heat_residual *residual);

#endif
