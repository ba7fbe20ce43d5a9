/* Cubic interpolation between the rows of a table. */
#ifndef UMBRA_OPTICS_LAGRANGE_IMPL_H
#define UMBRA_OPTICS_LAGRANGE_IMPL_H

#include <stddef.h>

/* Weights of the nodes at -1, 0, 1, 2 for the place f in [0, 1]. */
static inline void um_optics_lagrange_weights(double f, double w[4])
{
  w[0] = -f * (f - 1.0) * (f - 2.0) / 6.0;
  w[1] = (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0;
  w[2] = -(f + 1.0) * f * (f - 2.0) / 2.0;
  w[3] = (f + 1.0) * f * (f - 1.0) / 6.0;
}

/* row[i] = sum_k w[k] table[k * stride + i], i < n */
static inline void um_optics_lagrange_rows(const double w[4], const double *table, size_t stride,
                                           size_t n, double *row)
{
  const double *a = table, *b = a + stride, *c = b + stride, *d = c + stride;
  for (size_t i = 0; i < n; i++) row[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
}

#endif
