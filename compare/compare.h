/* Model beside measurements: how far off, when, and what the residual goes with. */
#ifndef UMBRA_COMPARE_COMPARE_H
#define UMBRA_COMPARE_COMPARE_H

#include "compare/comparison.h"
#include "core/file.h"

/* Compare; every residual is measured against sigma and model_sigma in quadrature. fitted: number
 * of parameters that were fitted to these rows; each channel takes its share by rows. The parts of
 * `run` outlive the comparison. Errors of um_compare_predict and um_compare_metrics_compute. The
 * caller destroys (um_compare_destroy). */
enum um_status um_compare_create(struct um_context *context, const struct um_compare_run *run,
                                 double fitted, struct um_compare_comparison **out);

/* compare.json, metrics.csv and residuals.csv into a folder in the making; docs/files.md tells what
 * stands in them. command and version: for the record. UM_ERR_IO. */
enum um_status um_compare_write(struct um_context *context,
                                const struct um_compare_comparison *comparison, const char *command,
                                const char *version, struct um_core_folder *folder);
/* compare.json to a stream; the caller looks for its errors. */
void um_compare_write_json(const struct um_compare_comparison *comparison, const char *command,
                           const char *version, FILE *file);
/* A picture per channel, drawn by gnuplot from residuals.csv, which lies in the folder: data with
 * error bars and model, residuals in sigma below, shadow shaded. UM_ERR_IO. */
enum um_status um_compare_plot(struct um_context *context,
                               const struct um_compare_comparison *comparison, const char *folder);

#endif
