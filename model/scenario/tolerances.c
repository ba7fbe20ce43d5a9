/* Tolerances of the integration in time from the accuracy that is wanted. Measured on ENVISAT's
 * pass against 1e-8 and 1e-6 K (docs/physics/heat-in-time.md): tolerances of 1e-4 / K and 1e-2 of
 * an accuracy leave it in the worst facet within a factor of 1.4, from 0.002 K to 0.1 K, and a
 * quarter of it in the means of parts. */
#include "model/scenario/tolerances.h"

#include <math.h>

#define PER_RELATIVE 1e4 /* accuracy over the relative tolerance [K] */
#define PER_ABSOLUTE 1e2 /* and over the absolute one [1] */

void um_model_tolerances(const struct um_scenario_thermal *thermal, double *relative,
                         double *absolute)
{
  *relative = isnan(thermal->relative_tolerance) ? thermal->accuracy_K / PER_RELATIVE
                                                 : thermal->relative_tolerance;
  *absolute = isnan(thermal->absolute_tolerance_K) ? thermal->accuracy_K / PER_ABSOLUTE
                                                   : thermal->absolute_tolerance_K;
}
