/* Which points to compute: designs in the unit cube, u [n][d] in [0, 1]. What a coordinate means is
 * said by distribution.h. A design depends on its arguments alone. */
#ifndef UMBRA_UNCERTAINTY_DESIGN_H
#define UMBRA_UNCERTAINTY_DESIGN_H

#include <stdint.h>

#include "base/core/context.h"

#define UM_UNCERTAINTY_DIMENSIONS_MAX 20 /* of any design, so that Saltelli's fits GSL's 40 */
#define UM_UNCERTAINTY_NUMBERS_MAX    100000000 /* n d of a design */

/* All of these hand out *u [*n][d], which the caller frees by um_core_free. UM_ERR_INPUT: d of 0 or
 * above UM_UNCERTAINTY_DIMENSIONS_MAX, no points, more numbers than UM_UNCERTAINTY_NUMBERS_MAX,
 * what is said below. UM_ERR_MEMORY. Tests: tests/base/uncertainty/design.c. */

/* Level i of count on one axis: i / (count - 1) where the ends belong to it, otherwise (i + 1/2) /
 * count, the middles of equal shares, which are also the coordinates of a list's values. A single
 * level is 1/2. */
double um_uncertainty_level(size_t i, size_t count, bool ends);

/* Crossed: every level of an axis with every of the others, the last axis fastest. count [d] >= 1,
 * ends [d] as above. */
enum um_status um_uncertainty_grid(struct um_context *context, size_t d, const size_t *count,
                                   const bool *ends, double **u, size_t *n);
/* Paired: point i is level i of n on every axis at once, as the rows of lists of equal length. */
enum um_status um_uncertainty_paired(struct um_context *context, size_t d, size_t n, double **u);
/* Latin hypercube (McKay, Beckman & Conover 1979, Technometrics 21:239): of n equal shares of every
 * axis each holds one point, at random within it. */
enum um_status um_uncertainty_latin_hypercube(struct um_context *context, size_t d, size_t n,
                                              uint64_t seed, double **u);
/* Sobol' sequence (GSL, Bratley & Fox 1988), from its point 0 on, so that 2^m points are balanced.
 * seed 0: as it is, all coordinates of the first point 0; otherwise shifted modulo 1 by a vector
 * drawn from the seed (Cranley & Patterson 1976). The first m of n points are those of m. */
enum um_status um_uncertainty_sobol_sequence(struct um_context *context, size_t d, size_t n,
                                             uint64_t seed, double **u);
/* One at a time: point 0 is the centre [d]; then for each axis its `count` levels, ends included,
 * without a level that is the centre's own coordinate. *n <= 1 + d count. UM_ERR_INPUT also: a
 * centre outside [0, 1]. */
enum um_status um_uncertainty_one_at_a_time(struct um_context *context, size_t d, size_t count,
                                            const double *centre, double **u, size_t *n);
/* For Sobol' indices (Saltelli et al. 2010, Comput. Phys. Commun. 181:259): n groups of d + 2
 * points, group j: row j of A, row j of B, then for each axis i row j of A with coordinate i of B.
 * A and B are the two halves of a Sobol' sequence of 2 d axes, shifted by the seed, 0 like any
 * other. n (d + 2) points. */
enum um_status um_uncertainty_saltelli(struct um_context *context, size_t d, size_t n,
                                       uint64_t seed, double **u);
/* For elementary effects (Morris 1991, Technometrics 33:161): n trajectories of d + 1 points on a
 * grid of `levels` (even, >= 2) with steps of levels / (2 (levels - 1)), each axis moved once, in
 * random order, up or down. n (d + 1) points. */
enum um_status um_uncertainty_morris_trajectories(struct um_context *context, size_t d, size_t n,
                                                  size_t levels, uint64_t seed, double **u);
/* Halton's sequence (GSL), from its point `first` on: points that are on none of the others. */
enum um_status um_uncertainty_halton(struct um_context *context, size_t d, size_t first, size_t n,
                                     double **u);

#endif
