/* Which parameter rules which value: Sobol' indices and elementary effects, of values one by one (a
 * curve's indices over time). From the points of a design that is made for them (design.h), values
 * that are NaN with the rest of their group left out. */
#ifndef UMBRA_UNCERTAINTY_INDICES_H
#define UMBRA_UNCERTAINTY_INDICES_H

#include <stdint.h>

#include "base/core/context.h"

/* Sobol' indices and their standard errors, each [d][nvalue]; the caller owns the arrays, any may
 * be NULL. mean, variance [nvalue]. */
struct um_uncertainty_sobol {
  double *first, *first_error; /* share of the variance that goes when the parameter is known */
  double *total, *total_error; /* share that stays when all others are known */
  double *mean, *variance;
};

/* Of the values [n (d + 2)][nvalue] of um_uncertainty_saltelli's points, in its order:
 *   V_i  = V - 1/(2n) sum_j (f(B)_j - f(A_B^i)_j)^2      (Jansen 1999, Comput. Phys. Commun.
 * 117:35) V_Ti =     1/(2n) sum_j (f(A)_j - f(A_B^i)_j)^2      (ibid.; Saltelli et al. 2010, table
 * 2 e, f) with V of all f(A), f(B). The errors are those of the mean of UM_UNCERTAINTY_BATCHES
 * batches of following rows, for which n should be a multiple of it that is a power of two; they
 * are too large rather than too small, since the whole of a low-discrepancy sequence is better than
 * its parts. A value that does not vary has NaN. Whole rows are left out where one of their values
 * is NaN; fewer than 2 UM_UNCERTAINTY_BATCHES left: NaN. Does not depend on the number of threads.
 * UM_ERR_INPUT: n below 2 UM_UNCERTAINTY_BATCHES, d of 0. UM_ERR_MEMORY. Tests:
 * tests/base/uncertainty/indices.c. */
#define UM_UNCERTAINTY_BATCHES 16
enum um_status um_uncertainty_sobol_indices(struct um_context *context, size_t d, size_t n,
                                            size_t nvalue, const double *value,
                                            struct um_uncertainty_sobol *out);

/* Elementary effects (Morris 1991; mu* of Campolongo, Cariboni & Saltelli 2007, Environ. Model.
 * Softw. 22:1509), each [d][nvalue], per whole range of the parameter; any may be NULL. */
struct um_uncertainty_morris {
  double *mu;       /* mean effect, with its sign */
  double *mu_star;  /* mean of its absolute value .. */
  double *mu_error; /* .. and the standard error of that */
  double *sigma;    /* scatter of the effect over the ranges: not linear, or not alone */
};
/* Of the values [n (d + 1)][nvalue] at u [n (d + 1)][d] of um_uncertainty_morris_trajectories.
 * Effects with a NaN are left out; fewer than 2 left: NaN. UM_ERR_INPUT: n below 2, d of 0, points
 * that are no trajectories. */
enum um_status um_uncertainty_morris_effects(struct um_context *context, size_t d, size_t n,
                                             size_t nvalue, const double *u, const double *value,
                                             struct um_uncertainty_morris *out);

#endif
