/* How exactly temperatures are found (um_thermal_solve_defaults). */
#ifndef UMBRA_THERMAL_SOLVE_OPTIONS_H
#define UMBRA_THERMAL_SOLVE_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Surfaces whose optics change during a run: what is beside those of the network at every row of
 * the heat loads, linear between the rows as the loads are. */
struct um_thermal_aging {
  size_t ntime, nmaterial;
  const uint32_t *material;  /* [nsurface] */
  const double *absorptance; /* [ntime][nmaterial] added to a surface's [1] */
  const double *emittance;   /* [ntime][nmaterial] factor on a surface's [1] */
};

/* Whose factors solve the linear equations. */
enum um_thermal_factors {
  UM_THERMAL_FACTORS_BY_STRUCTURE, /* Cholesky where factors fill (solids, large shells), else LU */
  UM_THERMAL_LU,                   /* KLU */
  UM_THERMAL_CHOLESKY              /* CHOLMOD; GMRES around it where the balance is not symmetric */
};

struct um_thermal_exchange;
struct um_thermal_load_sums; /* thermal/solver/load_sums.h */

struct um_thermal_solve_options {
  double relative_tolerance; /* default 2e-7: errors of one sign add to some 5 mK in an orbit */
  double absolute_tolerance; /* [K], default 2e-5 */
  double space_temperature;  /* [K], default UM_SPACE_TEMPERATURE */
  bool albedo_on, planet_on; /* heat loads switched */
  /* Factor on both tolerances, default 1; above 1 without the care for the audit (Newton's
   * iteration ends as CVODES has it): for derivatives, of which many are wanted. */
  double tolerance_factor;
  bool no_audit; /* heat over the border is not added up: the audit is NaN; temperatures are the
                    same bits */
  const struct um_thermal_aging *aging; /* borrowed; NULL, the default: surfaces stay as they are */
  const struct um_thermal_exchange *exchange; /* between surfaces, borrowed; NULL: none */
  const struct um_thermal_load_sums *sums; /* of a network next to this one, borrowed; NULL: none */
  enum um_thermal_factors factors;         /* default by structure */
};

#endif
