/* Inside of a surrogate. Private to base/uncertainty/. */
#ifndef UMBRA_UNCERTAINTY_SURROGATE_IMPL_H
#define UMBRA_UNCERTAINTY_SURROGATE_IMPL_H

#include "base/uncertainty/surrogate.h"

#define UM_UNCERTAINTY_LEVELS 33 /* degrees of an axis, 0 with them */

/* The points of an axis, and 1 / prod_(j < k) (x_k - x_j). */
struct um_uncertainty_axis {
  double x[UM_UNCERTAINTY_LEVELS], scale[UM_UNCERTAINTY_LEVELS];
};
void um_uncertainty_axis_make(struct um_uncertainty_axis *axis);
/* h_0 .. h_(levels - 1) at x. */
void um_uncertainty_axis_basis(const struct um_uncertainty_axis *axis, double x, size_t levels,
                               double *h);

struct um_uncertainty_term {
  unsigned char degree[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX];
  bool passed;     /* its neighbours of one degree more have been looked at */
  double size;     /* largest surplus over the asked error of its value */
  double *surplus; /* [nvalue] */
};

struct um_uncertainty_surrogate {
  size_t d, nvalue, ngroup, nterm, room, nheld, nstating, evaluations;
  char *falls_short;                                      /* why; NULL: it does not */
  size_t levels[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX]; /* highest degree + 1 */
  struct um_uncertainty_axis axis;
  bool *nowhere;                                /* [nvalue] values that are NaN at every point */
  struct um_uncertainty_term *term;             /* [nterm], each behind all those below it */
  struct um_uncertainty_surrogate_error *error; /* [ngroup] */
};

/* Basis functions of terms from .. to - 1 at a place [d], out [to - from]. */
void um_uncertainty_surrogate_basis(const struct um_uncertainty_surrogate *surrogate,
                                    const double *place, size_t from, size_t to, double *out);

#endif
