/* SUNDIALS' serial vectors are built for any machine and any size, without vector instructions:
 * a quarter of a run with many nodes passed in their loops. */
#include "thermal/solver/vector_impl.h"

#include <math.h>
#include <nvector/nvector_serial.h>

/* sqrt(sum (x w)^2 / n), summed in four strands: a fifth of the run went into waiting for one. */
static sunrealtype weighted_norm(N_Vector x, N_Vector w)
{
  const double *a = N_VGetArrayPointer(x), *b = N_VGetArrayPointer(w);
  size_t n = (size_t)N_VGetLength(x), k = 0;
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  for (; k + 4 <= n; k += 4)
    for (size_t s = 0; s < 4; s++) sum[s] += a[k + s] * b[k + s] * (a[k + s] * b[k + s]);
  for (; k < n; k++) sum[0] += a[k] * b[k] * (a[k] * b[k]);
  return sqrt((sum[0] + sum[1] + sum[2] + sum[3]) / (double)n);
}

/* z = a x + b y; where both factors are one but for a sign it is drawn out, as in SUNDIALS. */
static void linear_sum(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z)
{
  const double *p = N_VGetArrayPointer(x), *q = N_VGetArrayPointer(y);
  double *out = N_VGetArrayPointer(z);
  size_t n = (size_t)N_VGetLength(x);
  if (a == b) {
#pragma omp simd
    for (size_t k = 0; k < n; k++) out[k] = a * (p[k] + q[k]);
  } else if (a == -b) {
#pragma omp simd
    for (size_t k = 0; k < n; k++) out[k] = a * (p[k] - q[k]);
  } else {
#pragma omp simd
    for (size_t k = 0; k < n; k++) out[k] = a * p[k] + b * q[k];
  }
}

static void scale(sunrealtype c, N_Vector x, N_Vector z)
{
  const double *p = N_VGetArrayPointer(x);
  double *out = N_VGetArrayPointer(z);
  size_t n = (size_t)N_VGetLength(x);
#pragma omp simd
  for (size_t k = 0; k < n; k++) out[k] = c * p[k];
}

N_Vector um_thermal_vector_create(size_t n, SUNContext sun)
{
  N_Vector out = N_VNew_Serial((sunindextype)n, sun);
  if (out == NULL) return NULL;
  out->ops->nvwrmsnorm = weighted_norm;
  out->ops->nvlinearsum = linear_sum;
  out->ops->nvscale = scale;
  return out;
}
