/* Pictures of a study. */
#ifndef UMBRA_STUDY_PLOT_H
#define UMBRA_STUDY_PLOT_H

#include "base/core/file.h"
#include "study/statistics.h"

/* Into a folder that is being written and holds um_study_report_write's tables:
 *   bands, temperatures, curves: quantiles of the curves, under each who rules it when;
 *   surface_*: response of each band (of each curve where there is no band) to the two parameters
 * that rule it; scatter_*: points against every single value, or where there is none the mean of
 * each band; posterior, fit_*: with weights [npoint] of measurements; NULL: none. With the tables
 * scatter.csv and surface.csv that they are drawn from. UM_ERR_IO, UM_ERR_MEMORY; what goes wrong
 * in gnuplot is a logged warning. */
enum um_status um_study_plot(struct um_context *context, const struct um_study_result *result,
                             const struct um_study_statistics *statistics, const double *weight,
                             struct um_core_folder *folder);

#endif
