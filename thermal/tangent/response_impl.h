/* Private to thermal/tangent/: a run of responses; its steps of dS/dt = J S + b for many columns
 * with one factorisation. */
#ifndef UMBRA_THERMAL_RESPONSE_IMPL_H
#define UMBRA_THERMAL_RESPONSE_IMPL_H

#include "thermal/solver/system_group.h"
#include "thermal/tangent/response.h"

#define UM_THERMAL_ONE_TIME 1e-9 /* [s] nearer times are one */

struct um_thermal_response_run {
  struct um_context *context;
  struct um_thermal_system *system;
  struct um_thermal_stepper *stepper;
  const struct um_thermal_response_source *source; /* [nsource] */
  size_t nsource;
  size_t *order;   /* [nsource] source of a column */
  double *s;       /* [nsource][nunknown] by column [K/W] */
  double *inside;  /* [UM_THERMAL_INSIDE][nsource][nunknown] s at wanted times in a step */
  double *out;     /* [nsource][nnode] by source [K/W] */
  double *cluster; /* [n] scratch of an eliminated group */
  double *jacobian;
  double from;
  double begin, end; /* of the step [s from `from`] */
  double *grid;      /* [nstep + 1] [s from `from`] */
  size_t nstep;
  bool begun; /* every column moves from the start, whenever its source begins */
};

/* response_grid.c: grid and nstep for wanted times; how NULL: the default. */
enum um_status um_thermal_response_grid(struct um_thermal_response_run *r, const double *times,
                                        size_t ntime,
                                        const struct um_thermal_response_options *how);
/* Times at which the base is wanted: middles of steps and what the caller wants, ascending in all
 * [nstep + ntime]. place [ntime]: of the latter, middle [nstep]: of the former. */
void um_thermal_response_times(const struct um_thermal_response_run *r, const double *times,
                               size_t ntime, double *all, size_t *middle, size_t *place);

struct um_thermal_stepper;

enum um_status um_thermal_stepper_create(struct um_thermal_system *system,
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
