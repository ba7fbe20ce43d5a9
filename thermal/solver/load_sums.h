/* Heat loads as heat of the nodes at every row, kept for networks next to the one that they are of:
 * other optics on the same surfaces, under the same loads. What surfaces reflect to each other is
 * not in them. */
#ifndef UMBRA_THERMAL_LOAD_SUMS_H
#define UMBRA_THERMAL_LOAD_SUMS_H

#include "thermal/loads/loads.h"
#include "thermal/network/network.h"

struct um_thermal_load_sums;
/* Of surfaces that do not age; network and loads outlive it. *out NULL: too much to keep, above
 * 256 MiB, or loads with what the atmosphere brings. UM_ERR_INPUT: loads of fewer surfaces;
 * UM_ERR_MEMORY, UM_ERR_CANCELLED. The caller destroys. Tests: thermal/solver/load_sums. */
enum um_status um_thermal_load_sums_create(struct um_context *context,
                                           const struct um_thermal_network *network,
                                           const struct um_irradiation_loads *loads,
                                           struct um_thermal_load_sums **out);
/* Accepts NULL, sets NULL. */
void um_thermal_load_sums_destroy(struct um_context *context, struct um_thermal_load_sums **sums);

#endif
