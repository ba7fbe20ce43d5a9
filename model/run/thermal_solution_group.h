/* Temperatures of a run. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_THERMAL_SOLUTION_GROUP_H
#define UMBRA_MODEL_THERMAL_SOLUTION_GROUP_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/solver_options_impl.h"
#include "thermal/solver/solve.h"

/* Temperatures at every instant of the geometry tables. history: rows
 * are an instant one orbit before the first (when `before`), then the geometry tables'
 * instants; its audit has the periodic orbit, too, where the history goes on from its end. */
struct um_model_heat_run {
  struct um_thermal_history *history;
  bool before;
  double from;     /* where the history begins, t_tai [s]; NaN: it is not followed */
  double *surface; /* [ninstant][nsurface] [K] */
};
struct um_model_thermal_solution {
  const struct um_model *model;         /* borrowed */
  const struct um_model_tables *tables; /* borrowed */
  struct um_model_solver_options solver;
  double *start;    /* [nnode] start temperatures [K] */
  double *mean;     /* [nnode] over the orbit of a periodic start, of the fourth power [K] */
  bool moved;       /* by a sensitivity, not solved: it has no exchange between surfaces */
  double *residual; /* [nnode] what the orbit's mean balance leaves there [W]; NULL: not asked */
  double periodic_distance; /* what the periodic start left [K]; NaN when isothermal */
  double
      *drift; /* [nnode] change over the orbit that was found periodic [K]; NULL: there is none */
  struct um_thermal_audit orbit; /* its audit */
  struct um_model_heat_run run;
};

/* Start temperatures as the scenario wants them, into heat->start, which holds those of the network
 * as built, and heat->solver.exchange for what follows. warm: NULL, or heat of a model with the
 * same nodes: a periodic state is looked for from there, and surfaces exchange as they do there
 * unless that state says otherwise; a stated start is not touched. Errors of the thermal solvers.
 */
enum um_status um_model_thermal_start(struct um_context *context,
                                      const struct um_model_thermal_solution *warm,
                                      double periodic_tolerance,
                                      struct um_model_thermal_solution *heat);
/* Is the periodic state one of a mean balance, by which its neighbours are extrapolated? */
bool um_model_thermal_can_extrapolate(const struct um_model_thermal_solution *heat);
/* residual[nnode] of it. Errors of um_thermal_orbit_mean_residual. */
enum um_status um_model_thermal_residual(struct um_context *context,
                                         const struct um_model_thermal_solution *heat,
                                         double *residual);
/* Temperatures of the surfaces at every instant, as the optics want them, from the history. */
enum um_status um_model_heat_run_surfaces(struct um_context *context,
                                          struct um_model_thermal_solution *heat);

#endif
