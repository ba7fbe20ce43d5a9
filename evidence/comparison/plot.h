/* A comparison in pictures. */
#ifndef UMBRA_COMPARE_PLOT_H
#define UMBRA_COMPARE_PLOT_H

#include "evidence/comparison/comparison.h"

/* A picture per channel, drawn by gnuplot from residuals.csv, which lies in the folder: data with
 * error bars and model, residuals in sigma below, shadow shaded. UM_ERR_IO. */
enum um_status um_compare_plot(struct um_context *context,
                               const struct um_compare_comparison *comparison, const char *folder);

#endif
