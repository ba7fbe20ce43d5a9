/* Private: tables of what isotropic facets do toward a direction.
 *
 * By a = cos/(alpha sin), the variable of Smith's masking, such a quantity hardly changes with
 * alpha at small alpha, where it tends to a function of a alone. So a table stands over alpha = 0,
 * 0.05 .. 1.6 and s = a/(1 + a) = 0, 1/24 .. 1: cubic Lagrange in s, Catmull-Rom in alpha, even
 * about 0. */
#ifndef UMBRA_MATERIALS_FACET_TABLE_IMPL_H
#define UMBRA_MATERIALS_FACET_TABLE_IMPL_H

#include <math.h>
#include <stdlib.h>

#define UM_MATERIALS_FACET_ROUGHNESSES 33
#define UM_MATERIALS_FACET_PLACES      25
#define UM_MATERIALS_FACET_STEP        0.05 /* of alpha */
#define UM_MATERIALS_FACET_MOST        1.5  /* alpha, constant beyond */

static inline double um_materials_facet_along(const double row[UM_MATERIALS_FACET_PLACES],
                                              double place)
{
  double x = place * (UM_MATERIALS_FACET_PLACES - 1);
  size_t k = (size_t)x;
  k = k < 1 ? 1 : (k > UM_MATERIALS_FACET_PLACES - 3 ? UM_MATERIALS_FACET_PLACES - 3 : k);
  double f = x - (double)k;
  return -f * (f - 1.0) * (f - 2.0) / 6.0 * row[k - 1] +
         (f + 1.0) * (f - 1.0) * (f - 2.0) / 2.0 * row[k] -
         (f + 1.0) * f * (f - 2.0) / 2.0 * row[k + 1] +
         (f + 1.0) * f * (f - 1.0) / 6.0 * row[k + 2];
}

/* At a roughness >= 0 and place a/(1 + a) of 0 to 1. */
static inline double
um_materials_facet_at(const double table[UM_MATERIALS_FACET_ROUGHNESSES][UM_MATERIALS_FACET_PLACES],
                      double alpha, double place)
{
  double y = fmin(alpha, UM_MATERIALS_FACET_MOST) / UM_MATERIALS_FACET_STEP, value[4];
  int j = y < UM_MATERIALS_FACET_ROUGHNESSES - 3 ? (int)y : UM_MATERIALS_FACET_ROUGHNESSES - 3;
  for (int p = 0; p < 4; p++) value[p] = um_materials_facet_along(table[abs(j - 1 + p)], place);
  double t = y - j, low = 0.5 * (value[2] - value[0]), high = 0.5 * (value[3] - value[1]);
  double a = value[1], b = value[2];
  return a + t * (low + t * (3.0 * (b - a) - 2.0 * low - high + t * (2.0 * (a - b) + low + high)));
}

#endif
