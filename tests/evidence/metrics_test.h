/* Metrics of arrays: what is measured and modelled in the quantity's unit with the measurement's
 * sigma, the model's own in the linear unit. NULL: none. */
#ifndef UMBRA_TESTS_COMPARE_METRICS_H
#define UMBRA_TESTS_COMPARE_METRICS_H

#include "compare_test.h"
#include "evidence/comparison/metrics.h"

static inline enum um_status metrics_of(enum um_compare_quantity quantity, size_t count,
                                        const double *y, const double *m, const double *s,
                                        const double *own, const size_t *label, size_t nlabel,
                                        double fitted, struct um_compare_metrics *segment,
                                        struct um_compare_metrics *all)
{
  struct um_compare_residual residual[64];
  assert_true(count <= 64);
  for (size_t i = 0; i < count; i++) {
    struct um_compare_linear of = um_compare_linear(quantity, y[i], s == NULL ? NAN : s[i]);
    residual[i] =
        (struct um_compare_residual){of.value, um_compare_linear(quantity, m[i], NAN).value,
                                     of.sigma, own == NULL ? 0.0 : own[i]};
  }
  return um_compare_metrics_compute(context, quantity, count, residual, label, nlabel, fitted,
                                    segment, all);
}

#endif
