/* Integration of the network in time by CVODES: BDF, analytic sparse Jacobian, stops at
 * eclipse edges; energy audit. */
#ifndef UMBRA_THERMAL_SOLVE_H
#define UMBRA_THERMAL_SOLVE_H

#include "thermal/loads/loads.h"
#include "thermal/network/network.h"
#include "thermal/network/solve_options.h"
#include "thermal/solver/audit.h"

void um_thermal_solve_defaults(struct um_thermal_solve_options *options);

struct um_thermal_history {
  size_t ntime, nnode;
  double *t;           /* [ntime] */
  double *temperature; /* [ntime][nnode] [K] */
  size_t nthermostat;
  bool *heating;                /* [ntime][nthermostat] which are on; NULL without thermostats */
  struct um_thermal_heat audit; /* integrals over the run [J], whole satellite */
  double audit_error;           /* |in - out - stored| / (in + out) [1] */
  double content;               /* largest heat content at an end of the run [J] */
  size_t steps, rhs_evaluations, jacobians;
};

/* Start temperatures, here and below: start[nnode] [K], of boundary nodes what they are held at;
 * NULL: those the network was built with. A network is never written to. */

/* The most that the audit's error of a run may be [1]: 1e-4, or as much as is 10 mK of the heat
 * content, at tolerances of 1e-5 and 1 mK or less, in proportion at looser ones; INFINITY where a
 * tolerance_factor above 1 leaves the care for it. */
double um_thermal_history_audit_limit(const struct um_thermal_history *history,
                                      const struct um_thermal_solve_options *options);
/* UM_ERR_NUMERIC where a run's audit is above it. */
enum um_status um_thermal_history_audit_check(struct um_context *context,
                                              const struct um_thermal_history *history,
                                              const struct um_thermal_solve_options *options);
/* The audit of a run that goes on where a stretch ended: of both. */
void um_thermal_history_audit_join(struct um_thermal_history *history,
                                   const struct um_thermal_audit *before);

/* Integrate from `from` and report at times[ntime] in
 * [from, last load time], ascending. loads may be NULL (none). Two grid times may be equal: a jump.
 * UM_ERR_NUMERIC when CVODES fails, with its words; NaN loads are refused first. */
enum um_status um_thermal_solve(struct um_context *context,
                                const struct um_thermal_network *network,
                                const struct um_irradiation_loads *loads,
                                const struct um_thermal_solve_options *options, const double *start,
                                double from, const double *times, size_t ntime,
                                struct um_thermal_history **out);
void um_thermal_history_destroy(struct um_context *context, struct um_thermal_history **history);

/* Start temperatures [nnode] such that the state repeats after one period: T(from + period) =
 * T(from) under the loads of [from, from + period]; KINSOL fixed point with Anderson acceleration
 * from the start temperatures. The estimated distance of every node from the periodic
 * state, not only its drift per orbit, falls below tolerance [K], or UM_ERR_NUMERIC: a node with a
 * time constant of 300 orbits that drifts 0.01 K is 3 K away. drift: that distance
 * [K].
 * The loads need not be periodic (a spin that is not commensurate): the window is always the same,
 * so nodes that follow the load within it settle in one pass. Thermostats act by their mean power:
 * the state that repeats is that of a heater which holds the middle of its band. */
enum um_status um_thermal_solve_periodic(struct um_context *context,
                                         const struct um_thermal_network *network,
                                         const struct um_irradiation_loads *loads,
                                         const struct um_thermal_solve_options *options,
                                         const double *start, double from, double period,
                                         double tolerance, double *temperature, double *drift);
/* What a periodic solution says about itself. */
struct um_thermal_periodic {
  double drift;      /* largest change of a node over an orbit, as said below [K] */
  size_t drift_node; /* that node */
  double distance;   /* estimated largest distance of a node from the periodic state [K] */
  size_t orbits;     /* integrated */
  struct um_thermal_audit audit; /* of that last orbit */
};
/* The same with the change of every node over an orbit [nnode] [K], its mean temperature, of the
 * fourth power [nnode] [K], and a report; each may be NULL. The change is that of the last orbit
 * or, where its end was corrected, what may be left of it at most, 0 of eliminated nodes. */
enum um_status um_thermal_solve_periodic_report(
    struct um_context *context, const struct um_thermal_network *network,
    const struct um_irradiation_loads *loads, const struct um_thermal_solve_options *options,
    const double *start, double from, double period, double tolerance, double *temperature,
    double *drift, double *mean, struct um_thermal_periodic *report);
/* Where a periodic state moves to when the model moves (orbit_mean.c). residual[nnode]: heat that
 * the orbit's mean balance leaves at mean[nnode], 0 but for what temperatures do within the orbit
 * [W]; mean: of the fourth power, as reported above [K]. Then, of a model next to that one, the
 * mean temperatures at which its mean balance leaves the same: mean, in: those of the first; out.
 * Loads as for the periodic state; no thermostats, whose mean power a residual does not know.
 * Errors of um_thermal_solve_steady. */
enum um_status um_thermal_orbit_mean_residual(struct um_context *context,
                                              const struct um_thermal_network *network,
                                              const struct um_irradiation_loads *loads,
                                              const struct um_thermal_solve_options *options,
                                              double from, double period, const double *mean,
                                              double *residual);
enum um_status um_thermal_orbit_mean_solve(struct um_context *context,
                                           const struct um_thermal_network *network,
                                           const struct um_irradiation_loads *loads,
                                           const struct um_thermal_solve_options *options,
                                           double from, double period, const double *residual,
                                           double *mean);
/* Steady state of the network under constant loads (row `time` of loads), thermostats by their mean
 * power; KINSOL Newton from the start temperatures. */
enum um_status um_thermal_solve_steady(struct um_context *context,
                                       const struct um_thermal_network *network,
                                       const struct um_irradiation_loads *loads, size_t time,
                                       const struct um_thermal_solve_options *options,
                                       const double *start, double *temperature);
/* The same under power[nnode] [W] in place of the loads and of what the network states. */
enum um_status um_thermal_solve_powered(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const double *power,
                                        const struct um_thermal_solve_options *options,
                                        double *temperature);
/* Heat flows of every node at given temperatures and load time; out[nnode] [W]. Power histories are
 * in `internal`; thermostats, whose state is not in the temperatures, are added by the function
 * below. */
enum um_status um_thermal_heat_of_nodes(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const struct um_irradiation_loads *loads,
                                        const struct um_thermal_solve_options *options, double t,
                                        const double *temperature, struct um_thermal_heat *out);
/* Add the heat of the thermostats that are on, heating[nthermostat], to out[nnode]. */
void um_thermal_heat_of_thermostats(const struct um_thermal_network *network, const bool *heating,
                                    struct um_thermal_heat *out);
/* How those of the surfaces answer where those of the nodes, at `node_temperature`, answer by
 * answer[nnode] [K per unit]: surface_answer [noutside], the derivative of the function below. */
void um_thermal_surface_answers(const struct um_thermal_network *network,
                                const double *node_temperature, const float *answer,
                                double *surface_answer);
/* The temperature at which a surface emits what its nodes do [K]; NaN of one on no node. */
double um_thermal_surface_temperature(const struct um_thermal_surface *surface,
                                      const double *node_temperature);
/* Temperatures of the surfaces that loads are for from those of the nodes [nnode]. */
void um_thermal_surface_temperatures(const struct um_thermal_network *network,
                                     const double *node_temperature, double *surface_temperature);

#endif
