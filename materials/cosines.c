/* The angular grid that reflectances and albedos are tabulated on: cos = u^2, u uniform, cubic
 * Lagrange between the nodes (spectrum.c says why). */
#include "materials/cosines_impl.h"

#define COSINES UM_MATERIALS_COSINES

double um_materials_node_cosine(size_t j)
{
  double u = (double)j / (COSINES - 1);
  return u * u;
}

/* 4 int_0^1 X u^3 du by Simpson's rule, exact for constant X. */
double um_materials_hemispherical_mean(const double *x, size_t ncos)
{
  if (ncos == 1) return x[0];
  double sum = 0.0, weights = 0.0;
  for (size_t j = 0; j < COSINES; j++) {
    double u = (double)j / (COSINES - 1);
    double w = (j == 0 || j == COSINES - 1 ? 1.0 : (j % 2 == 1 ? 4.0 : 2.0)) * u * u * u;
    sum += w * x[j];
    weights += w;
  }
  return sum / weights;
}

double um_materials_along_cosines(const double row[COSINES], double u)
{
  double x = u * (COSINES - 1);
  size_t j = (size_t)x;
  j = j < 1 ? 1 : (j > COSINES - 3 ? COSINES - 3 : j);
  double s = x - (double)j;
  return -s * (s - 1.0) * (s - 2.0) / 6.0 * row[j - 1] +
         (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0 * row[j] -
         (s + 1.0) * s * (s - 2.0) / 2.0 * row[j + 1] +
         (s + 1.0) * s * (s - 1.0) / 6.0 * row[j + 2];
}
