/* What a change of parameters makes of the curves: by the matrix, and by the model. */
#ifndef UMBRA_SENSITIVITY_WHAT_IF_H
#define UMBRA_SENSITIVITY_WHAT_IF_H

#include "evidence/sensitivity/matrix.h"

/* How a curve by the matrix differs from the true one, of the curve's size [1]. */
struct um_sensitivity_what_if_error {
  double largest, rms;
};

struct um_sensitivity_what_if {
  size_t nrow, row[UM_EFFECT_PARAMETERS_MAX]; /* of the matrix, that take a value */
  double to[UM_EFFECT_PARAMETERS_MAX];        /* [nrow] the values */
  double *linear, *exact;                     /* [ncurve][ntime]; NaN where nothing is observed */
  struct um_sensitivity_what_if_error *error; /* [ncurve] */
  /* Share of the way from the null values to these within which the matrix leaves a hundredth of
   * every curve's size, by the bend that the true answer shows [1]; may be above 1; INFINITY: none
   */
  double within;
  double seconds, seconds_exact; /* wall time of either [s] */
};

/* Values of an effect on a target; NaN: as in the scenario. A switch has none and is turned on.
 * UM_ERR_INPUT: the matrix has no row of the effect on that target, none of a value that is given,
 * or none is given; a value out of the range of its parameter. UM_ERR_REFUSED as of
 * um_sensitivity_forward_evaluate. The caller releases, after an error too. */
enum um_status um_sensitivity_what_if_create(struct um_context *context,
                                             const struct um_sensitivity_matrix *matrix,
                                             const struct um_model_addition *wanted,
                                             struct um_sensitivity_what_if *out);
void um_sensitivity_what_if_release(struct um_context *context,
                                    struct um_sensitivity_what_if *what_if);

/* Curves [ncurve][ntime] as the model has them when rows [n] take values; of a switch above 0.5 is
 * on. Others stand at their null values. UM_ERR_INPUT: a value out of the range of its parameter;
 * UM_ERR_REFUSED as of um_sensitivity_forward_evaluate. */
enum um_status um_sensitivity_exact(struct um_context *context,
                                    const struct um_sensitivity_matrix *matrix, const size_t *row,
                                    const double *to, size_t n, double *out);

#endif
