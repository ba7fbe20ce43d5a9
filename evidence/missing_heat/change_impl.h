/* A pulse by the model itself. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_CHANGE_IMPL_H
#define UMBRA_MISSING_HEAT_CHANGE_IMPL_H

#include "base/inference/projection.h"
#include "evidence/missing_heat/observations_impl.h"

/* Improve *power, which the linear response gave, with runs of the model. *chi2: what the pulse
 * then explains. residual: [nleft]. Errors of the runs. */
enum um_status um_missing_heat_change(struct um_context *context,
                                      const struct um_missing_heat_base *base,
                                      struct um_inference_projection *projection,
                                      const double *residual,
                                      const struct um_missing_heat_place *place, double from,
                                      double to, double *power, double *chi2);

#endif
