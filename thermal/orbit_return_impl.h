/* What an orbit leaves of an error, turned round: 1/(1 - exp(-x)) ~ 1 + 1/x - SHARE/(x + SHIFT)
 * within 0.0254 for every x > 0, the nearest function of that form (periodic.c). ERROR: that, and
 * as much for a Jacobian that is not its mean all along the orbit. */
#ifndef UMBRA_THERMAL_ORBIT_RETURN_IMPL_H
#define UMBRA_THERMAL_ORBIT_RETURN_IMPL_H

#define UM_THERMAL_RETURN_SHARE 1.6446
#define UM_THERMAL_RETURN_SHIFT 3.1432
#define UM_THERMAL_RETURN_ERROR 0.05

#endif
