/* A history of heat. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_HISTORY_IMPL_H
#define UMBRA_MISSING_HEAT_HISTORY_IMPL_H

#include "evidence/missing_heat/bins_impl.h"

/* All [nbin], in W. */
struct um_missing_heat_band {
  double *heat;       /* median */
  double *sigma;      /* standard deviation */
  double *low, *high; /* between which the heat is with probability UM_MISSING_HEAT_BAND */
};
/* scale: of the residual's variance, 1 or more. The same numbers every time. UM_ERR_MEMORY. */
enum um_status um_missing_heat_history(struct um_context *context,
                                       const struct um_missing_heat_bins *bins, double scale,
                                       const struct um_missing_heat_band *out);

#endif
