/* Model beside measurements: how far off, when, and what the residual goes with. */
#ifndef UMBRA_COMPARE_COMPARE_H
#define UMBRA_COMPARE_COMPARE_H

#include "evidence/comparison/comparison.h"

/* Compare; every residual is measured against sigma and model_sigma in quadrature. fitted: number
 * of parameters that were fitted to these observations; each channel takes its share by
 * observations. The parts of `run` outlive the comparison. Errors of um_compare_predict and
 * um_compare_metrics_compute. The caller destroys (um_compare_destroy). */
enum um_status um_compare_create(struct um_context *context, const struct um_compare_run *run,
                                 double fitted, struct um_compare_comparison **out);

#endif
