/* Private to the rooms of thermal/: one CVODES integration of a system, the only place that knows
 * CVODES. */
#ifndef UMBRA_THERMAL_INTEGRATOR_GROUP_H
#define UMBRA_THERMAL_INTEGRATOR_GROUP_H

#include "thermal/solver/audit.h"
#include "thermal/solver/system_group.h"

struct um_thermal_integrator;

/* Heat integrated along the way over the satellite (nodes that are not boundary) [J]. */
enum um_thermal_audit_term {
  UM_AUDIT_SOLAR,
  UM_AUDIT_ALBEDO,
  UM_AUDIT_PLANET,
  UM_AUDIT_INTERNAL,
  UM_AUDIT_RADIATED,  /* to space, negative when lost */
  UM_AUDIT_CONDUCTED, /* from boundary nodes by conduction */
  UM_AUDIT_EXCHANGED, /* from boundary nodes by radiation */
  UM_AUDIT_TERMS
};

/* duration: the run covers [0, duration] of the system's time [s]. */
enum um_status um_thermal_integrator_create(struct um_thermal_system *system, double duration,
                                            struct um_thermal_integrator **out);
void um_thermal_integrator_destroy(struct um_thermal_integrator **integrator);

/* From the next start on: tolerances times `factor`; above 1 without the care for the audit. */
void um_thermal_integrator_loosen(struct um_thermal_integrator *integrator, double factor);
/* Integrals over a run, of every node [n]. */
struct um_thermal_integrals {
  double *cube, *power4; /* of |T|^3 [K^3 s], of T^4 [K^4 s] */
};
/* Begin (again) at time 0 from node temperatures [n]; eliminated nodes are guesses. integrals:
 * where these go, or NULL. */
enum um_status um_thermal_integrator_start(struct um_thermal_integrator *integrator,
                                           const double *temperature,
                                           const struct um_thermal_integrals *integrals);
/* Integrals over the run of the slopes of mean thermostats [nthermostat] [W s/K]; with integrals.
 */
const double *um_thermal_integrator_mean_slopes(const struct um_thermal_integrator *integrator);
/* Go on to time t (not before the last one) and give all node temperatures there [n]. */
enum um_status um_thermal_integrator_run(struct um_thermal_integrator *integrator, double t,
                                         double *temperature);
/* One internal step on from where the integration stands. */
struct um_thermal_advance {
  double before, t;     /* [s] begin and end of the step */
  double *y;            /* [nunknown] state at t [K]; of the caller */
  double *slope_before; /* [nunknown] dT/dt at the begin, [K/s]; of the caller */
  double *slope;        /* and at the end, before what happens there */
  bool ends;            /* at a stop or a switching, where the integration begins anew */
  const bool *heating;  /* [nthermostat] on during the step, borrowed until the next */
};
enum um_status um_thermal_integrator_advance(struct um_thermal_integrator *integrator,
                                             struct um_thermal_advance *out);
/* The stop that ends the present stretch of smooth loads [s]. */
double um_thermal_integrator_stop(const struct um_thermal_integrator *integrator);
/* Which thermostats were on up to the time of the last run [nthermostat]. */
void um_thermal_integrator_heating(const struct um_thermal_integrator *integrator, bool *on);
/* From the start to now; valid after a run to `duration`. */
struct um_thermal_audit um_thermal_integrator_audit(const struct um_thermal_integrator *integrator);
void um_thermal_integrator_counts(const struct um_thermal_integrator *integrator, size_t *steps,
                                  size_t *rhs_evaluations, size_t *jacobians);

#endif
