/* The order of numbers. */
#ifndef UMBRA_CORE_ORDER_H
#define UMBRA_CORE_ORDER_H

/* Two doubles, ascending, for qsort; no order with NaN. */
static inline int um_core_order_double(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

#endif
