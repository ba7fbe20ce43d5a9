/* A pulse by the model itself. Private to missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_CHANGE_IMPL_H
#define UMBRA_MISSING_HEAT_CHANGE_IMPL_H

#include "inference/projection.h"
#include "missing_heat/observations_impl.h"

/* Power of a pulse by the model itself, and the chi-square that it explains, from a power that the
 * linear response gave. residual: [nleft]. Errors of the runs. */
enum um_status um_missing_heat_change(struct um_context *context,
                                      const struct um_missing_heat_base *base,
                                      struct um_inference_projection *projection,
                                      const double *residual,
                                      const struct um_missing_heat_place *place, double from,
                                      double to, double *power, double *chi2);

#endif
