/* The steady balance of a system whose loads are held (steady.c). Private to thermal/solver/. */
#ifndef UMBRA_THERMAL_STEADY_IMPL_H
#define UMBRA_THERMAL_STEADY_IMPL_H

#include "thermal/solver/system_group.h"

/* temperature[n] [K] at which every node of a steady system keeps residual[n] of the heat that
 * reaches it [W], NULL: nothing, from the system's own temperatures; loads are those at its time 0.
 * UM_ERR_NUMERIC, UM_ERR_INPUT: a node that nothing holds. */
enum um_status um_thermal_steady_solve(struct um_thermal_system *system, const double *residual,
                                       double *temperature);

#endif
