/* View factors that have closed forms (Howell, A Catalog of Radiation Heat Transfer Configuration
 * Factors). */
#ifndef UMBRA_TESTS_SUPPORT_VIEW_FACTOR_FORMS_H
#define UMBRA_TESTS_SUPPORT_VIEW_FACTOR_FORMS_H

#include <math.h>

#include "base/core/constants.h"

/* C-11: rectangles a x b, aligned, c apart. */
static inline double forms_opposite(double a, double b, double c)
{
  double x = a / c, y = b / c, p = 1 + x * x, q = 1 + y * y;
  return 2.0 / (UM_PI * x * y) *
         (0.5 * log(p * q / (p + y * y)) + x * sqrt(q) * atan(x / sqrt(q)) +
          y * sqrt(p) * atan(y / sqrt(p)) - x * atan(x) - y * atan(y));
}

/* C-14: rectangles of one common edge l at 90 deg, floor of depth w, wall of height h; floor to
 * wall. */
static inline double forms_common_edge(double l, double w, double h)
{
  double H = h / l, W = w / l, H2 = H * H, W2 = W * W, d = sqrt(H2 + W2);
  double product = (1 + W2) * (1 + H2) / (1 + W2 + H2) *
                   pow(W2 * (1 + W2 + H2) / ((1 + W2) * (W2 + H2)), W2) *
                   pow(H2 * (1 + H2 + W2) / ((1 + H2) * (H2 + W2)), H2);
  return (W * atan(1 / W) + H * atan(1 / H) - d * atan(1 / d) + 0.25 * log(product)) / (UM_PI * W);
}

/* Inside a box of size[3], face i to face j; faces +x -x +y -y +z -z. */
static inline double forms_box(const double size[3], int i, int j)
{
  int a = i / 2, b = j / 2;
  if (i == j) return 0.0;
  if (a == b) return forms_opposite(size[(a + 1) % 3], size[(a + 2) % 3], size[a]);
  /* the face across a runs along b and the third; the edge that they share is along the third */
  return forms_common_edge(size[3 - a - b], size[b], size[a]);
}

#endif
