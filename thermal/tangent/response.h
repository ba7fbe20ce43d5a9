/* How temperatures answer to small heat: many sources along one base history, linear in each,
 *
 *   C_i dS_ik/dt = sum_j H_ij(T(t)) S_jk + w_ik  while source k is on,   H_ij = dH_i/dT_j,
 *
 * H_i the heat balance of network.h. S_ik is the change of temperature of node i per watt of source
 * k. One factorisation a step serves all sources; see response.c. */
#ifndef UMBRA_THERMAL_RESPONSE_H
#define UMBRA_THERMAL_RESPONSE_H

#include "thermal/solver/solve.h"

/* One watt from t_from to t_to, shared among nodes. */
struct um_thermal_response_source {
  const uint32_t *node; /* [nnode] */
  const double *weight; /* [nnode] of any sum; 1 W times the weight goes to the node */
  size_t nnode;
  double t_from, t_to; /* t_tai [s]; outside of the run they are cut */
};

struct um_thermal_response_options {
  /* Longest step [s]; 0: a quarter of the shortest source. Ends of sources and edges and jumps of
   * the loads end a step in any case; wanted times need not. */
  double longest_step;
  const double *start; /* [nsource][nnode] S at the start [K/W]; NULL: 0 */
};

/* Takes what is wanted at times[k]: temperature [nnode] [K] of the base history, response
 * [nsource][nnode] [K/W]; both borrowed for the call. Another status than UM_OK ends the run. */
typedef enum um_status um_thermal_response_take(void *user, size_t k, const double *temperature,
                                                const double *response);

/* Runs um_thermal_solve from `from` and start[nnode] for the base, then the
 * responses, and hands over times[ntime], ascending. Thermostats switch when they do in the base:
 * their answer to the change is not in S. UM_ERR_INPUT as um_thermal_solve, and sources on nodes
 * that are not there, with weights that are not finite, or that end before they begin.
 * Accuracy: order 5 in steps over time constants of what is heated (4 at wanted times inside),
 * order 2 in the change of H over a step; 1e-5 of the answer where steps are half a time constant
 * (tests/thermal/tangent/response.c). */
enum um_status um_thermal_response(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   const struct um_irradiation_loads *loads,
                                   const struct um_thermal_solve_options *options,
                                   const double *start, double from, const double *times,
                                   size_t ntime, const struct um_thermal_response_source *source,
                                   size_t nsource, const struct um_thermal_response_options *how,
                                   um_thermal_response_take *take, void *user);

#endif
