/* A scenario's own observations: every band and every place at every instant, to be differentiated
 * where nothing was measured. */
#ifndef UMBRA_SENSITIVITY_OWN_H
#define UMBRA_SENSITIVITY_OWN_H

#include "evidence/measurements/set.h"
#include "evidence/sensitivity/forward.h"

/* Irradiance of every band where the satellite is seen, and the temperature of every place, at the
 * instants of the scenario's window. Values stand for nothing, and sigmas are so large that no
 * samples are added, until um_sensitivity_own_weigh. UM_ERR_INPUT: observations stand alone
 * (orbit.points). The caller destroys. */
enum um_status um_sensitivity_own_create(struct um_context *context, const struct um_model *model,
                                         struct um_compare_measurements **out);
/* Observations of a forward get a sigma of a thousandth of what their curve is large: the largest
 * value of their channel, of temperatures 100 K. own: they become what the scenario as it stands
 * says. */
void um_sensitivity_own_weigh(struct um_sensitivity_forward *forward, bool own);

#endif
