/* A history of heat. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_HISTORY_IMPL_H
#define UMBRA_MISSING_HEAT_HISTORY_IMPL_H

#include "evidence/missing_heat/pulse_impl.h"

/* Heat of every bin and its sigma, both [nbin]. */
enum um_status um_missing_heat_history(struct um_context *context,
                                       const struct um_missing_heat_bins *bins,
                                       const double *residual, double *heat, double *sigma);

#endif
