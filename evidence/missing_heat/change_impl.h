/* Heat by the model itself. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_CHANGE_IMPL_H
#define UMBRA_MISSING_HEAT_CHANGE_IMPL_H

#include "evidence/missing_heat/fit_impl.h"
#include "evidence/missing_heat/observations_impl.h"

/* Run the model with heat in a place: change[nleft], what it does to the observations after the
 * nuisances. end: until when [t_tai]. Errors of the run: UM_ERR_REFUSED where the model takes no
 * source there. */
enum um_status um_missing_heat_change(struct um_context *context,
                                      const struct um_missing_heat_base *base,
                                      struct um_inference_projection *projection,
                                      const struct um_missing_heat_place *place,
                                      const struct um_missing_heat_fit *fit, double end,
                                      double *change);

#endif
