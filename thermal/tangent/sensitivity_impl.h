/* Private to thermal/tangent/: a run of sensitivities. */
#ifndef UMBRA_THERMAL_SENSITIVITY_IMPL_H
#define UMBRA_THERMAL_SENSITIVITY_IMPL_H

#include "thermal/solver/exchange_solve_group.h"
#include "thermal/solver/integrator_group.h"
#include "thermal/solver/linear_group.h"
#include "thermal/tangent/sensitivity.h"

#define UM_THERMAL_ONE_TIME 1e-9 /* [s] nearer times are one */

/* --- sensitivity_base.c: the base's temperatures along one stretch between stops and switchings --
 */
struct um_thermal_base {
  struct um_thermal_system *system; /* that is integrated; owned */
  struct um_thermal_integrator *integrator;
  struct um_thermal_advance last;
  double *t;         /* [npoint] ascending [s] */
  double *y, *slope; /* [npoint][nunknown] */
  size_t npoint, room;
  bool *heating; /* [nthermostat] in the stretch */
  bool ended;    /* the last point ends the stretch */
};
enum um_status um_thermal_base_create(struct um_context *context,
                                      const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_solve_options *options,
                                      const double *start, double from,
                                      enum um_thermal_system_kind kind, double duration,
                                      struct um_thermal_base *out);
void um_thermal_base_release(struct um_thermal_base *base);
/* Begin again at the start temperatures [n]. */
enum um_status um_thermal_base_start(struct um_thermal_base *base, const double *temperature);
/* Begin the stretch after the one that ended. */
enum um_status um_thermal_base_next(struct um_thermal_base *base);
/* Integrate until t is covered or the stretch ends. */
enum um_status um_thermal_base_reach(struct um_thermal_base *base, double t);
/* Points before t are no longer wanted. */
void um_thermal_base_drop(struct um_thermal_base *base, double t);
/* Unknowns y[nunknown] at t within what is covered. */
void um_thermal_base_at(const struct um_thermal_base *base, double t, double *y);
/* Length of the last internal step [s]. */
double um_thermal_base_step(const struct um_thermal_base *base);

/* --- sensitivity_pulse.c: heat of pulses ---------------------------------------------------- */
struct um_thermal_pulses {
  const struct um_thermal_pulse *pulse;
  size_t npulse;
  size_t *order;  /* [npulse] pulse of a column: by their begins */
  bool *acts;     /* [npulse] of a column, up to edge[next] */
  double *edge;   /* [nedge] where they begin and end, ascending [s from the start] */
  double *change; /* [nnode] of a group of eliminated nodes */
  double h;       /* first step after an edge [s] */
  size_t nedge, next;
};

/* --- sensitivity_step.c: columns through one stretch ---------------------------------------- */
struct um_thermal_sensitivity_run {
  struct um_context *context;
  double from; /* time 0 of what follows, t_tai [s] */
  struct um_thermal_base base;
  struct um_thermal_system *system;   /* the base's balance, evaluated where columns need it */
  struct um_thermal_system **variant; /* [nvariant] */
  size_t nvariant;
  struct um_thermal_pulses pulses;
  size_t ncolumn, nactive; /* variants, then pulses as they begin; those that may not be 0 */
  double *width;           /* [ncolumn] steps of the parameters; 1 W */
  size_t n;                /* unknowns */
  bool forced;             /* with the forcing; else what a start leaves alone */
  struct um_thermal_linear *linear;
  struct um_thermal_exchange_solver *exchange; /* NULL: none between surfaces */
  double share;                                /* of a right side that the next solution leaves */
  double *jacobian, *matrix;                   /* [nnonzero] */
  double *y, *rate, *moved;                    /* [n] */
  double *s, *next, *known, *error;            /* [ncolumn][n] */
  double *stage[4];                            /* [ncolumn][n] dS/dt */
  double *largest; /* [ncolumn] root mean square of S so far, the largest */
  double tolerance;
  double t, h;                    /* [s] where s is; the step to try */
  bool continued;                 /* stage[3] is the rate where the next step begins */
  bool opening;                   /* the next step is the first after an edge */
  double *mean_cube, *mean_slope; /* [nnode], [nthermostat] integrals over the run, or NULL */
  size_t steps, refused;
};
/* What a run is of. */
struct um_thermal_sensitivity_subject {
  struct um_context *context;
  const struct um_thermal_network *network;
  const struct um_irradiation_loads *loads;
  const struct um_thermal_solve_options *options;
  const double *start; /* [nnode] */
  double from;
};

/* --- sensitivity.c -------------------------------------------------------------------------- */

/* Freed with _free whatever it returns; *r starts zeroed. */
enum um_status um_thermal_sensitivity_run_create(const struct um_thermal_sensitivity_subject *of,
                                                 const struct um_thermal_forcings *forcings,
                                                 enum um_thermal_system_kind kind, double duration,
                                                 struct um_thermal_sensitivity_run *r);
void um_thermal_sensitivity_run_free(struct um_thermal_sensitivity_run *r);
/* From time 0 and r->s to `end` [s]. */
enum um_status um_thermal_sensitivity_follow(struct um_thermal_sensitivity_run *r, double end);
/* All nodes out[ncolumn][nnode] of columns[ncolumn][nunknown] at time t, the base's unknowns in
 * r->y. */
enum um_status um_thermal_sensitivity_nodes(struct um_thermal_sensitivity_run *r, double t,
                                            const double *columns, double *out);

/* --- sensitivity_pulse.c -------------------------------------------------------------------- */
enum um_status um_thermal_pulses_create(struct um_thermal_sensitivity_run *r,
                                        const struct um_thermal_forcings *forcings);
void um_thermal_pulses_release(struct um_thermal_sensitivity_run *r);
/* Which pulses act from r->t on, up to the next edge. */
void um_thermal_pulses_enter(struct um_thermal_sensitivity_run *r);
/* The next edge [s]; INFINITY: none. */
double um_thermal_pulses_end(const struct um_thermal_pulses *p);
/* b[n] of a column of a pulse, where the base is linearised. */
void um_thermal_pulses_force(struct um_thermal_sensitivity_run *r, size_t column, double *b);
/* To s[nnode] of such a column, its own heat in eliminated nodes. */
void um_thermal_pulses_nodes(struct um_thermal_sensitivity_run *r, size_t column, double *s);

/* --- sensitivity_check.c -------------------------------------------------------------------- */

/* What is refused of forcings and options. */
enum um_status um_thermal_sensitivity_check(const struct um_thermal_sensitivity_subject *of,
                                            const struct um_thermal_forcings *forcings,
                                            const struct um_thermal_sensitivity_options *how);

/* --- sensitivity_step.c --------------------------------------------------------------------- */

/* Systems begin a stretch [t, end) of smooth loads with the base's thermostats. */
enum um_status um_thermal_sensitivity_begin(struct um_thermal_sensitivity_run *r);
/* Pulses begin or end at r->t. */
enum um_status um_thermal_sensitivity_edge(struct um_thermal_sensitivity_run *r);
/* One step, not beyond `end` [s]; s before it is then in `next`, its rates before and after are in
 * stage[0] and stage[3]. */
enum um_status um_thermal_sensitivity_step(struct um_thermal_sensitivity_run *r, double end);
/* Root mean square over the unknowns of a column of x[ncolumn][n]. */
double um_thermal_sensitivity_size(const struct um_thermal_sensitivity_run *r, const double *x,
                                   size_t column);
/* x[nactive][n] <- (A - scale E)^-1 x, A = r->matrix as factored last, E as held last.
 * `share` may be left of what guess [nactive][n] (NULL: 0) leaves of each right side.
 * UM_ERR_NUMERIC with or without a message. */
enum um_status um_thermal_sensitivity_solve(struct um_thermal_sensitivity_run *r, double scale,
                                            double share, const double *guess, double *x);

#endif
