/* How temperatures answer to parameters: S_ik = dT_i / dp_k along a run, for any parameter p_k of
 * materials, loads, couplings or heat made inside, and for the power of pulses of heat,
 *
 *   dS_k/dt = J(T(t)) S_k + b_k(t),   f = dT/dt, J = df/dT.
 *
 * A parameter is stated as a variant: the network and loads as they are with p_k moved by a step
 * h_k. Its forcing b_k = (f_k(t, T) - f(t, T)) / h_k is a difference of heat balances at one state,
 * which has no noise of an integration. That of a pulse is its watt over the capacities. One
 * factorisation a stage serves all; see sensitivity.c and sensitivity_step.c. */
#ifndef UMBRA_THERMAL_SENSITIVITY_H
#define UMBRA_THERMAL_SENSITIVITY_H

#include "thermal/solver/solve.h"

/* One parameter moved by `step` [its unit], not 0. Same nodes of the same kinds in the same order,
 * as many thermostats and power histories, and loads with the same times and edges: what moves an
 * edge in time has no derivative there. Where surfaces exchange radiation, a parameter of their
 * optics brings options with the exchange of the variant's network. Start temperatures may differ.
 * A step of 1e-6 to 1e-4 of the parameter's size serves: it need only stay clear of rounding and,
 * being one-sided, of curvature.
 */
struct um_thermal_variant {
  const struct um_thermal_network *network;       /* borrowed */
  const struct um_irradiation_loads *loads;       /* borrowed; NULL: none, as the base */
  const struct um_thermal_solve_options *options; /* NULL: the base's; tolerances are not used */
  double step;
  const double *start; /* [nnode] its start temperatures [K]; NULL: those of its network */
};

/* One watt from t_from to t_to, shared among nodes; the parameter is its power [W]. */
struct um_thermal_pulse {
  const uint32_t *node; /* [nnode] */
  const double *weight; /* [nnode] of any sum; 1 W times the weight goes to the node */
  size_t nnode;
  double t_from, t_to; /* t_tai [s]; outside of the run they are cut */
};

/* What is differentiated by, in the order of the answers: variants, then pulses. Borrowed for a
 * call. */
struct um_thermal_forcings {
  const struct um_thermal_variant *variant; /* [nvariant] */
  size_t nvariant;
  const struct um_thermal_pulse *pulse; /* [npulse] */
  size_t npulse;
};

struct um_thermal_sensitivity_options {
  double tolerance;    /* error of a step over the largest answer so far, both root mean squares
                          over the nodes [1]; 0: 5e-5 */
  const double *start; /* [nforcing][nnode] S at the start; NULL: of the start temperatures */
};

/* Takes what is wanted at times[k]: temperature [nnode] [K] of the base (cubic between the steps of
 * its integration), sensitivity [nforcing][nnode] [K per unit of the parameter]; both borrowed for
 * the call. Another status than UM_OK ends the run. */
typedef enum um_status um_thermal_sensitivity_take(void *user, size_t k, const double *temperature,
                                                   const double *sensitivity);

/* Runs the base as um_thermal_solve does, from start[nnode], and the sensitivities beside it, and
 * hands over times[ntime], ascending. A thermostat's instants of switching move with the
 * parameters: dt =
 * -(dg/dT S + dg/dp) / (dg/dt), g = sensor - threshold, and S jumps by the change of dT/dt times
 * that; under a pulse they stay those of the base. At a time where a pulse begins or ends the
 * answer is as it is before that, at the start after it. UM_ERR_INPUT as um_thermal_solve, for
 * variants as above, for pulses on nodes that are not there, with weights that are not finite, or
 * that end before they begin; UM_ERR_NUMERIC. Accuracy: 1e-3 of the largest answer with the default
 * tolerance, against central differences of tight runs (tests/thermal/tangent/sensitivity.c,
 * sensitivity_pulse.c). Twenty parameters cost 3 to 8 runs (tests/bench/heat.c). */
enum um_status um_thermal_sensitivity(struct um_context *context,
                                      const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_solve_options *options,
                                      const double *start, double from, const double *times,
                                      size_t ntime, const struct um_thermal_forcings *forcings,
                                      const struct um_thermal_sensitivity_options *how,
                                      um_thermal_sensitivity_take *take, void *user);

/* Sensitivities [nvariant][nnode] of the periodic state start[nnode] (um_thermal_solve_periodic):
 * S(from + period) = S(from),
 * thermostats by their mean power. To how->tolerance (0: 2e-5) of the largest answer of each
 * parameter; how->start is a guess. UM_ERR_NUMERIC when that is not found in 20 orbits. */
enum um_status um_thermal_sensitivity_periodic(
    struct um_context *context, const struct um_thermal_network *network,
    const struct um_irradiation_loads *loads, const struct um_thermal_solve_options *options,
    const double *start, double from, double period, const struct um_thermal_variant *variant,
    size_t nvariant, const struct um_thermal_sensitivity_options *how, double *sensitivity);

#endif
