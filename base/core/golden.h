/* Golden sections (Kiefer 1953, Proc. Am. Math. Soc. 4:502): the least or largest of a function
 * that has one between two arguments. Who searches evaluates it at both inner places, then narrows
 * and evaluates at the one place that is new:
 *
 *   struct um_core_golden g = um_core_golden(from, to);
 *   double f[2] = {at(g.x[0]), at(g.x[1])};
 *   while (g.to - g.from > width) {
 *     int k = um_core_golden_narrow(&g, f[0] < f[1]);
 *     f[1 - k] = f[k];
 *     f[k] = at(g.x[k]);
 *   } */
#ifndef UMBRA_CORE_GOLDEN_H
#define UMBRA_CORE_GOLDEN_H

#include <stdbool.h>

#define UM_GOLDEN 0.61803398874989484820 /* (sqrt(5) - 1)/2 */

struct um_core_golden {
  double from, to;
  double x[2]; /* from < x[0] < x[1] < to */
};

static inline struct um_core_golden um_core_golden(double from, double to)
{
  double part = UM_GOLDEN * (to - from);
  return (struct um_core_golden){from, to, {to - part, from + part}};
}

/* lower: what is sought lies below x[1], else above x[0]. Returns which x is new; the other one is
 * what the new one was. */
static inline int um_core_golden_narrow(struct um_core_golden *g, bool lower)
{
  if (lower) {
    g->to = g->x[1];
    g->x[1] = g->x[0];
    g->x[0] = g->to - UM_GOLDEN * (g->to - g->from);
    return 0;
  }
  g->from = g->x[0];
  g->x[0] = g->x[1];
  g->x[1] = g->from + UM_GOLDEN * (g->to - g->from);
  return 1;
}

#endif
