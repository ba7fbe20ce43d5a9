/* Directions in which observations may move, whitened (value over sigma). */
#ifndef UMBRA_INFERENCE_DIRECTION_H
#define UMBRA_INFERENCE_DIRECTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

/* A group of columns that are tested as one. */
struct um_inference_direction {
  size_t ncolumn;
  const double *column;       /* [ncolumn][nobservation] whitened d(model)/d(parameter); borrowed */
  const double *minimum_step; /* [ncolumn] lowest and highest change of the parameter from null: */
  const double *maximum_step; /* 0 makes the test one-sided; +-INFINITY: none */
  const double *prior_sigma;  /* [ncolumn] INFINITY: none */
  size_t trials; /* directions that were tried, of which this is the best: p is that of the best of
                    so many; 0 and 1: it alone */
};

/* Directions that may be present anyway: calibration factors, accepted effects. prior_sigma
 * INFINITY: free; 0: known, hence none. They may be collinear or insensitive. */
struct um_inference_nuisance {
  size_t count;
  const double *column;      /* [count][nobservation] whitened; borrowed */
  const double *prior_sigma; /* [count] */
};

#endif
