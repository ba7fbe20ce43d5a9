/* What an integration (integrator_group.h) holds, and its parts: what CVODES asks of it
 * (integrator_equations.c), where it stops (integrator_stops.c), its making (integrator_create.c)
 * and its words when it fails (integrator_fault.c). Private to integrator*.c. */
#ifndef UMBRA_THERMAL_INTEGRATOR_DATA_IMPL_H
#define UMBRA_THERMAL_INTEGRATOR_DATA_IMPL_H

#include <cvodes/cvodes.h>

#include "thermal/solver/linear_group.h"
#include "thermal/solver/sundials_impl.h"
#include "thermal/solver/system_group.h"

struct um_thermal_integrator {
  struct um_thermal_system *system; /* borrowed */
  SUNContext sun;
  N_Vector y, dense, quadrature;
  double content_before; /* heat content at the start [J] */
  SUNMatrix matrix;
  struct um_thermal_linear *linear;
  SUNLinearSolver solver;
  void *cvodes;
  double *stop; /* [nstop] ascending, the last one is the end [s] */
  size_t nstop, segment;
  double t;                /* [s] of y */
  double tolerance_factor; /* factor on the tolerances [1] */
  double gamma;            /* of Newton's matrix 1 - gamma J [s] */
  double exchange_share;   /* that iterations about the exchange leave of a right side [1] */
  bool initialized;        /* CVodeInit was done */
  double *cube, *power4;   /* [n] integrals of the caller; NULL: not wanted */
  double *cube_before, *power4_before;
  double *mean_slope, *slope_before; /* [nthermostat], with integrals */
  int *root;                         /* [nthermostat] which thermostats switch; their directions */
  bool switched;                     /* one did at t: a new start is due */
  bool *heating;                     /* [nthermostat] on during the last step */
  size_t steps, rhs_evaluations, jacobians, run_steps;
  bool balance_lost;             /* an eliminated node found no temperature */
  struct um_thermal_words words; /* of CVODES */
};

/* Return with what a call of SUNDIALS says in `integrator`. */
#define SUN_CHECK(call)                                                                            \
  do {                                                                                             \
    int sun_code_ = (call);                                                                        \
    if (sun_code_ < 0) return um_thermal_integrator_fail(integrator, sun_code_);                   \
  } while (0)

/* UM_ERR_NUMERIC, UM_ERR_MEMORY or UM_ERR_CANCELLED with time, place and cause. */
enum um_status um_thermal_integrator_fail(struct um_thermal_integrator *integrator, int code);

/* Callbacks; `self` is the integrator. dy/dt [K/s]; */
int um_thermal_integrator_rate(sunrealtype t, N_Vector y, N_Vector rate, void *self);
/* Newton's matrix; */
int um_thermal_integrator_newton(sunrealtype t, N_Vector y, N_Vector rate, SUNMatrix matrix,
                                 sunbooleantype kept, sunbooleantype *fresh, sunrealtype gamma,
                                 void *self, N_Vector work1, N_Vector work2, N_Vector work3);
/* sensor minus threshold of every thermostat [K]; */
int um_thermal_integrator_switches(sunrealtype t, N_Vector y, sunrealtype *out, void *self);
/* heat over the satellite's border now, by enum um_thermal_audit_term [W]. */
int um_thermal_integrator_audit_rate(sunrealtype t, N_Vector y, N_Vector out, void *self);

/* Fills stop and nstop. UM_ERR_MEMORY. */
enum um_status um_thermal_integrator_stops(struct um_thermal_integrator *integrator,
                                           double duration);
/* The longest step [s] in the window; 0: no limit. UM_ERR_MEMORY. */
enum um_status um_thermal_integrator_longest_step(struct um_thermal_system *system, double *out);

/* Does a thermostat switch on the way? */
bool um_thermal_integrator_has_switches(const struct um_thermal_system *system);
/* Tolerances as they are now. */
enum um_status um_thermal_integrator_tolerances(struct um_thermal_integrator *integrator);
/* Settings that need an initialised CVODES, and its initialisation at y. */
enum um_status um_thermal_integrator_set_up(struct um_thermal_integrator *integrator);

#endif
