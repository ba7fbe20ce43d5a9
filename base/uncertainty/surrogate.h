/* A stand-in for a smooth function of a few parameters with many values: polynomials on a sparse
 * grid that grows where the function wants it (Gerstner & Griebel 2003, Computing 71:65), held
 * against points that it never saw.
 *
 * Axes are places in [0, 1] (um_uncertainty_distribution_place). On each axis Leja's points (x_0
 * the middle, x_1 and x_2 the ends, then each where the product of distances to those before it is
 * largest) carry h_k(x) = prod_(j < k) (x - x_j) / (x_k - x_j). A term with degrees nu adds to the
 * sum s_nu prod_i h_nu_i(x_i) with the surplus s_nu = f(x_nu) - the sum before it: one point a
 * term, and polynomials whose degrees are among the terms are exact (Chkifa, Cohen & Schwab 2014,
 * Found. Comput. Math. 14:601). */
#ifndef UMBRA_UNCERTAINTY_SURROGATE_H
#define UMBRA_UNCERTAINTY_SURROGATE_H

#include "base/core/context.h"
#include "base/uncertainty/distribution.h"

#define UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX 10
#define UM_UNCERTAINTY_HELD_OUT                 10  /* points, by default */
#define UM_UNCERTAINTY_EVALUATIONS_MAX          200 /* by default */
/* Held-out points have to agree within this share of the asked error before so many times as many
 * fresh ones state it (stated.h); it is good enough where they state no more than is asked. */
#define UM_UNCERTAINTY_HELD_OUT_SHARE 0.25
#define UM_UNCERTAINTY_STATING        2
/* Share of values elsewhere that may be off by more than is stated. */
#define UM_UNCERTAINTY_STATED_MISS 0.01
/* Of the points allowed so many are not grown on: what they say of a surrogate that falls short is
 * better than a term more of it. */
#define UM_UNCERTAINTY_STATED_RESERVE 0.25

/* Values first .. first + count - 1 and the error that is asked of them: |difference| <= absolute +
 * relative max(|f|, floor F), F the largest |f| of the group at the middle of all axes. */
struct um_uncertainty_group {
  const char *name; /* for messages, with value's number within the group; borrowed by create */
  size_t first, count;
  double absolute, relative, floor;
};

/* The function: value [n][nvalue] at place [n][d]. A point that fails is all NaN; a value that is
 * NaN at every point stays so and is asked nothing; other errors end the work and are passed on.
 * Called by one thread, with all points that are wanted at a time. */
typedef enum um_status um_uncertainty_evaluate(struct um_context *context, void *user,
                                               const double *place, size_t n, double *value);

struct um_uncertainty_surrogate_request {
  size_t d, nvalue;
  size_t ngroup; /* values in no group may be off by anything */
  const struct um_uncertainty_group *group;
  um_uncertainty_evaluate *evaluate;
  void *user;
  size_t held_out;        /* points, and twice as many to state; 0: UM_UNCERTAINTY_HELD_OUT */
  size_t evaluations_max; /* held-out points with them; 0: UM_UNCERTAINTY_EVALUATIONS_MAX */
  /* [nasked][d] places at which it will be asked, in random order: its error is stated for others
   * of their kind, by the first of them. None, or beyond them: Halton's, equally likely anywhere.
   */
  const double *asked_at;
  size_t nasked;
};

/* What held-out points say of a group. */
struct um_uncertainty_surrogate_error {
  double stated;   /* |difference| elsewhere over the error that was asked, by stated.h */
  double share;    /* largest |difference| over the error that was asked of that value */
  double absolute; /* largest |difference| */
  double relative; /* largest |difference| over max(|f|, floor F) */
  size_t value;    /* of the largest share, within the group; and its held-out point */
  size_t point;
};

struct um_uncertainty_surrogate; /* opaque */

/* Grow until the held-out points agree as said above and no newest term is larger than the asked
 * error. Where that takes more evaluations than allowed, or at the rate of the last doubling of
 * points would, it falls short: what is left of the allowed evaluations states its error, and
 * um_uncertainty_surrogate_short says why. UM_ERR_REFUSED: a point fails. UM_ERR_INPUT: d, a group
 * outside the values, an error that is not above 0, no more points allowed than are held out.
 * UM_ERR_MEMORY; errors of evaluate. The caller destroys. The same for any number of threads.
 * Tests: tests/base/uncertainty/surrogate.c. */
enum um_status
um_uncertainty_surrogate_create(struct um_context *context,
                                const struct um_uncertainty_surrogate_request *request,
                                struct um_uncertainty_surrogate **out);
/* Accepts NULL, sets NULL. */
void um_uncertainty_surrogate_destroy(struct um_context *context,
                                      struct um_uncertainty_surrogate **surrogate);

/* value [n][nvalue] at place [n][d], by the context's threads; 2 terms nvalue operations a point.
 * UM_ERR_INPUT: a place outside [0, 1]. UM_ERR_MEMORY. */
enum um_status um_uncertainty_surrogate_at(struct um_context *context,
                                           const struct um_uncertainty_surrogate *surrogate,
                                           const double *place, size_t n, double *value);

size_t um_uncertainty_surrogate_evaluations(const struct um_uncertainty_surrogate *surrogate);
size_t um_uncertainty_surrogate_terms(const struct um_uncertainty_surrogate *surrogate);
size_t um_uncertainty_surrogate_values(const struct um_uncertainty_surrogate *surrogate);
size_t um_uncertainty_surrogate_held_out(const struct um_uncertainty_surrogate *surrogate);
/* Of these the last ones, which had no say in it and state its error. */
size_t um_uncertainty_surrogate_stating(const struct um_uncertainty_surrogate *surrogate);
/* Why it is further off than asked, naming group, value, error and what was asked; NULL: it is not.
 * Borrowed. */
const char *um_uncertainty_surrogate_short(const struct um_uncertainty_surrogate *surrogate);
/* Highest degree along an axis. */
size_t um_uncertainty_surrogate_degree(const struct um_uncertainty_surrogate *surrogate,
                                       size_t axis);
/* [ngroup], in the order of the request; borrowed. */
const struct um_uncertainty_surrogate_error *
um_uncertainty_surrogate_errors(const struct um_uncertainty_surrogate *surrogate);

/* Mean, variance and Sobol' indices of the surrogate's values without sampling, by its expansion in
 * polynomials that are orthonormal under the distributions [d] of the parameters (Sudret 2008,
 * Reliab. Eng. Syst. Saf. 93:964). mean, variance [nvalue]; first, total [d][nvalue], NaN where the
 * variance is 0 or of the size of rounding. Any of the four may be NULL. UM_ERR_MEMORY,
 * UM_ERR_LIBRARY. */
enum um_status
um_uncertainty_surrogate_moments(struct um_context *context,
                                 const struct um_uncertainty_surrogate *surrogate,
                                 const struct um_uncertainty_distribution *distribution,
                                 double *mean, double *variance, double *first, double *total);

#endif
