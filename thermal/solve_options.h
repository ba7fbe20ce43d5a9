/* How exactly temperatures are found (um_thermal_solve_defaults). */
#ifndef UMBRA_THERMAL_SOLVE_OPTIONS_H
#define UMBRA_THERMAL_SOLVE_OPTIONS_H

#include <stdbool.h>

struct um_thermal_solve_options {
  double relative_tolerance; /* default 2e-7: errors of one sign add to some 5 mK in an orbit */
  double absolute_tolerance; /* [K], default 2e-5 */
  double space_temperature;  /* [K], default UM_SPACE_TEMPERATURE */
  bool albedo_on, planet_on; /* heat loads switched */
  /* Factor on both tolerances, default 1; above 1 without the care for the audit (Newton's
   * iteration ends as CVODES has it): for derivatives, of which many are wanted. */
  double tolerance_factor;
};

#endif
