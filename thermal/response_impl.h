/* Private to thermal/: steps of dS/dt = J S + b for many columns with one factorisation, the only
 * place that knows KLU itself. */
#ifndef UMBRA_THERMAL_RESPONSE_IMPL_H
#define UMBRA_THERMAL_RESPONSE_IMPL_H

#include "thermal/system_impl.h"

struct um_thermal_stepper;

enum um_status um_thermal_stepper_create(const struct um_thermal_system *system,
                                         struct um_thermal_stepper **out);
void um_thermal_stepper_destroy(struct um_thermal_stepper **stepper);
/* Factor for steps of h [s] with the Jacobian jacobian[nnonzero] [1/s]. */
enum um_status um_thermal_stepper_factor(struct um_thermal_stepper *stepper, const double *jacobian,
                                         double h);
/* Most instants inside a step. */
#define UM_THERMAL_INSIDE 16

/* What a step needs to know of its columns. */
struct um_thermal_step {
  /* Fills b[nunknown] [K/s per W] and returns true, or returns false where a source is off. */
  bool (*rate)(void *user, size_t column, double *b);
  void *user;
  double inside[UM_THERMAL_INSIDE]; /* instants wanted in the step, as shares of it, in (0, 1) */
  size_t ninside;
  double *taken; /* [ninside][stride] receives the columns there */
  size_t stride; /* [nunknown] times as many columns as there are at most */
};

/* Columns s[ncolumn][nunknown] one step on. */
enum um_status um_thermal_stepper_step(struct um_thermal_stepper *stepper, double *s,
                                       size_t ncolumn, const struct um_thermal_step *step);

#endif
