/* Smooth curves along a coordinate: a sum of few functions, each times a number. */
#ifndef UMBRA_EFFECTS_CURVE_H
#define UMBRA_EFFECTS_CURVE_H

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"

enum um_effect_curve_kind {
  UM_CURVE_HATS, /* n values at even places from a to b, joined by lines, held beyond */
  UM_CURVE_BUMP, /* exp(-((u - a) / b)^2 / 2), n 1 */
  UM_CURVE_EDGE, /* (1 + tanh((u - a) / b)) / 2, n 1; b below 0: on below a */
  UM_CURVE_FALL, /* exp(-(u - a) / b), n 1; b below 0: it grows with u */
  UM_CURVE_WAVES /* of a circle: cos and sin of 1, 2 .. n / 2 times 2 pi u */
};
struct um_effect_curve {
  enum um_effect_curve_kind kind;
  size_t n;     /* numbers that multiply its functions */
  double a, b;  /* in the unit of the coordinate */
  int circular; /* u is in turns */
};

/* Function i at u [1]; 0 where u is not a number. */
static inline double um_effect_curve_function(const struct um_effect_curve *c, size_t i, double u)
{
  double away = u - c->a;
  if (isnan(u)) return 0.0;
  if (c->circular) away -= round(away);
  switch (c->kind) {
  case UM_CURVE_HATS: {
    if (c->n == 1) return 1.0;
    double at = fmax(0.0, fmin((u - c->a) / (c->b - c->a), 1.0)) * (double)(c->n - 1);
    return fmax(0.0, 1.0 - fabs(at - (double)i));
  }
  case UM_CURVE_BUMP:
    return exp(-0.5 * away * away / (c->b * c->b));
  case UM_CURVE_EDGE:
    return 0.5 * (1.0 + tanh(away / c->b));
  case UM_CURVE_FALL:
    return exp(fmin(-away / c->b, 40.0));
  case UM_CURVE_WAVES:
    break;
  }
  size_t wave = i / 2 + 1;
  double angle = 2.0 * UM_PI * (double)wave * u;
  return i % 2 == 0 ? cos(angle) : sin(angle);
}

/* The curve with these numbers [n]. */
static inline double um_effect_curve_at(const struct um_effect_curve *c, const double *value,
                                        double u)
{
  double sum = 0.0;
  for (size_t i = 0; i < c->n; i++) sum += value[i] * um_effect_curve_function(c, i, u);
  return sum;
}

#endif
