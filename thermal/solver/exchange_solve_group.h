/* Private to the rooms of thermal/: linear equations (A - s E) x = b, A on the pattern of the
 * Jacobian with a solver of its own, E the derivative of the exchange between surfaces, which is
 * full. */
#ifndef UMBRA_THERMAL_EXCHANGE_SOLVE_GROUP_H
#define UMBRA_THERMAL_EXCHANGE_SOLVE_GROUP_H

#include <sundials/sundials_linearsolver.h>

#include "thermal/solver/system_group.h"

/* What solves with A alone: x[count][nunknown] <- A^-1 x. */
struct um_thermal_inner {
  enum um_status (*solve)(void *self, size_t count, double *x);
  void *self;
};

struct um_thermal_exchange_solver;

/* lot: right-hand sides that are solved side by side: 1 or UM_THERMAL_LOT. */
enum um_status um_thermal_exchange_solver_create(struct um_thermal_system *system, size_t lot,
                                                 struct um_thermal_exchange_solver **out);
void um_thermal_exchange_solver_destroy(struct um_thermal_exchange_solver **solver);
/* x[count][nunknown]: b in, the solutions out, each by a flexible GMRES of its own (Saad 1993, SIAM
 * J. Sci. Comput. 14:461) preconditioned with A. value [nnonzero]: of A. Each residual falls below
 * tolerance times that of the guess [count][nunknown] (NULL: x = 0), or 1e-12 times b;
 * UM_ERR_NUMERIC when it does not within 300 products. */
enum um_status um_thermal_exchange_solve(struct um_thermal_exchange_solver *solver,
                                         const struct um_thermal_inner *inner, const double *value,
                                         double scale, double tolerance, const double *guess,
                                         size_t count, double *x);

/* The same around a SUNLinearSolver of A, which it takes over and frees; *scale is read at every
 * solution. NULL: out of memory. system->exchange is there. */
SUNLinearSolver um_thermal_exchange_sundials(struct um_thermal_system *system,
                                             SUNLinearSolver inner, const double *scale,
                                             const double *tolerance, SUNContext sun);

#endif
