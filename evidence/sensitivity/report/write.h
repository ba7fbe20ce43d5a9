/* The files of a matrix of sensitivities. */
#ifndef UMBRA_SENSITIVITY_REPORT_WRITE_H
#define UMBRA_SENSITIVITY_REPORT_WRITE_H

#include <stdio.h>

#include "base/core/file.h"
#include "evidence/sensitivity/what_if.h"

/* What is written beside the matrix; all borrowed. */
struct um_sensitivity_report {
  const struct um_sensitivity_matrix *matrix;
  bool elasticity; /* d ln(curve)/d ln(what the parameter changes), too */
  const struct um_sensitivity_what_if *what_if; /* [nwhat_if] */
  size_t nwhat_if;
  const char *command, *version; /* what files say they come from */
};

/* sensitivity.nc, parameters.csv, sensitivity.csv (the strongest of every minute), what_if.csv
 * where there is one (docs/files.md), report.html, and with `pictures` that of
 * um_sensitivity_report_plot. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_sensitivity_report_write(struct um_context *context,
                                           const struct um_sensitivity_report *report,
                                           bool pictures, struct um_core_folder *folder);
/* report.html alone, with sliders that move the curves (docs/files.md). UM_ERR_IO, UM_ERR_MEMORY.
 */
enum um_status um_sensitivity_report_write_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                struct um_core_folder *folder);
/* The same page as umbra serve brings it, with the token that its requests carry. UM_ERR_MEMORY. */
enum um_status um_sensitivity_report_serve_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                const char *token, FILE *file);
/* The same numbers as one object, but for curves. Errors of writing are the stream's. */
void um_sensitivity_report_write_json(const struct um_sensitivity_report *report, FILE *file);
/* sensitivity.nc alone. UM_ERR_IO. */
enum um_status um_sensitivity_report_write_netcdf(struct um_context *context,
                                                  const struct um_sensitivity_report *report,
                                                  FILE *file);
/* sensitivity.png: the strongest parameters of each curve of light over the times, in widths of
 * their priors; of the temperatures where there is no light. Errors as of um_plot_create. */
enum um_status um_sensitivity_report_plot(struct um_context *context,
                                          const struct um_sensitivity_matrix *matrix,
                                          const char *folder);

#endif
